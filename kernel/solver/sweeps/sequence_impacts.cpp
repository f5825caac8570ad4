// SPDX-License-Identifier: MIT
#include "sequence_impacts.h"

#include "../../base/limits.h"
#include "../../math/sqrt.h"
#include "../../constraint/block_bodies.h"
#include "../../constraint/contact.h"
#include "../../constraint/jointed_view.h"
#include "../../constraint/locked_view.h"
#include "../../constraint/row_flight.h"
#include "note_impulses.h"
#include "passive_bounces.h"
#include "plan_islands.h"
#include "sweep_velocities.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

// What colours_of_body says of a body: how many of its contacts bounce, and two marks.
constexpr uint32_t leans = leaning_body;  ///< on something that does not bounce
constexpr uint32_t changed = 1u << 30;  ///< by the impact at hand
constexpr uint32_t bouncing = changed - 1;

constexpr scalar no_impact = limits::unbounded;  ///< no impact in this substep
constexpr scalar at_hand = -1;               ///< an impact of those that are solved now

/// When a contact has its next impact, s from the begin of the substep. Kept in `landing`, where a single bounce keeps the place at which it lands.
scalar& time_of(ContactBlock& block, int lane_i) { return block.row[0].landing[lane_i]; }

template <class Of>
void for_each_contact(const SolverView& solver, const Of& of) {
    for (int block_i = 0; block_i < solver.block_count; ++block_i)  // bound: max_manifolds, rounded up to whole blocks
        for (int lane_i = 0; lane_i < lanes; ++lane_i)
            if (!is_spare(solver.blocks[block_i].manifold[lane_i])) of(block_i, lane_i);
}

bool in_chain(const SolverView& solver, const ContactBlock& block, int lane_i) {
    if (!(block.e[lane_i] > 0)) return false;
    const uint32_t A = block.body_A[lane_i] != 0 ? solver.colours_of_body[block.body_A[lane_i]] : 0;
    const uint32_t B = block.body_B[lane_i] != 0 ? solver.colours_of_body[block.body_B[lane_i]] : 0;
    return ((A | B) & leans) == 0 && ((A & bouncing) > 1 || (B & bouncing) > 1);
}

template <class Of>
void for_each_in_chain(const SolverView& solver, const Island& island, const Of& of) {
    for (int member_i = 0; member_i < island.member_count; ++member_i) {  // bound: max_manifolds
        const int position = solver.members[island.member_begin + member_i];
        if (in_chain(solver, solver.blocks[position / lanes], position % lanes)) of(position / lanes, position % lanes);
    }
}

/// The next impact of a contact after `now`; with aim_rows its rows get their targets, in velocities of the begin of the
/// substep.
scalar next_impact(const SolverView& solver, ContactBlock& block, int lane_i, scalar now, scalar h, bool aim_rows) {
    const BlockFlight flight = flight_of(solver, block);
    scalar first = no_impact;
    for (int row = 0; row < block.rows; ++row) {  // bound: 4: block_rows
        const RowFlight<lane> from = flight_from(flight.row[row], splat<lane>(now));
        const RowImpact<lane> impact = impact_of(from, splat<lane>(h - now), solver.unit);
        scalar when[lanes], target[lanes];
        const mask bounces = both(bounces_off(impact, load(block.e)), is_used(block, row));
        store(when, select(bounces, splat<lane>(now) + impact.when, splat<lane>(no_impact)));
        if (when[lane_i] < first) first = when[lane_i];
        if (!aim_rows) continue;
        const lane leaving = -load(block.e) * impact.speed - flight.row[row].a * (splat<lane>(now) + impact.when);
        store(target, select(bounces, leaving, no_bound(flight.row[row], splat<lane>(h))));
        block.row[row].target[lane_i] = target[lane_i];
    }
    return first;
}

template <class View>
void drop_impulses(const View& solver, int block_i, int lane_i) {
    ContactConstraint<View>::Given::for_rows(solver, block_i, [lane_i](const SeenRow& row) { row.j[lane_i] = 0; });
}

/// Impulses given at the time `now` act from the begin of the substep: takes the displacement before `now` back. A point that met later, in the same
/// manifold, has its own time: else it would gain what gravity gives meanwhile.
template <class View>
void take_back(const View& solver, int block_i, int lane_i, scalar now, scalar h) {
    const ContactBlock& block = solver.blocks[block_i];
    const BlockFlight flight = flight_of(solver, block, gather_histories(solver, block, &SolverBodyHistory::v_sweep, &SolverBodyHistory::L_sweep));
    auto displaced = held_pair(solver, block, gather_bodies(solver, block, &SolverBody::dp, &SolverBody::dth));
    const lane inv_M_A = load(block.inv_M_A), inv_M_B = load(block.inv_M_B), since = splat<lane>(now);
    ContactConstraint<View>::Given::for_rows(solver, block_i, [&](const SeenRow& row) {
        lane when = since;
        if (row.number < block_rows) {
            const RowImpact<lane> impact = impact_of(flight_from(flight.row[row.number], since), splat<lane>(h) - since, solver.unit);
            when = when + select(bounces_off(impact, load(block.e)), impact.when, lane{});
        }
        push_along(displaced, row, -load(row.j) * when, inv_M_A, inv_M_B);
    });
    scatter_bodies(solver, block, static_cast<uint16_t>(1u << lane_i), displaced, &SolverBody::dp, &SolverBody::dth);
}

void keep_motion(const SolverView& solver, int body_i) {
    const SolverBody& body = solver.bodies[body_i];
    SolverBodyHistory& history = solver.histories[body_i];
    for (int i = 0; i < 4; ++i) history.v_sweep[i] = body.v_CM[i];
    for (int i = 0; i < 4; ++i) history.L_sweep[i] = body.L[i];
}

/// Solves the impacts at hand together, by sweeps over them alone.
template <class View>
void sweep_at_hand(const View& solver, Island& island, VisitsLeft& left) {
    const scalar settled = limits::settled_speed_of_small * solver.unit + rounding_of_speeds(island, solver.unit);
    island.settled = limits::unbounded;  // no body becomes active by this: the sweeps of the substep come later
    scalar residual = scalar_max;
    for (int sweep_i = 0; sweep_i < limits::sweeps_of_small && residual > settled && left.some(); ++sweep_i) {
        residual = 0;
        for_each_in_chain(solver, island, [&](int block_i, int lane_i) {
            if (time_of(solver.blocks[block_i], lane_i) != at_hand) return;
            if (!left.take(1)) return;
            const Index island_i = solver.blocks[block_i].island[lane_i];
            const Visit visit = {static_cast<Index>(block_i), static_cast<uint16_t>(1u << lane_i), lanes == 1 ? island_i : no_island};
            sweep_velocities(solver, &visit, 1, 1, true);
            residual = max(residual, solver.blocks[block_i].fastest[lane_i]);
        });
    }
}

template <bool notes_impulses, class View>
void solve_at_hand(const View& solver, Island& island, scalar now, scalar h, VisitsLeft& left, [[maybe_unused]] const StepNotes& notes) {
    for_each_in_chain(solver, island, [&](int block_i, int lane_i) {
        const ContactBlock& block = solver.blocks[block_i];
        if (time_of(solver.blocks[block_i], lane_i) != at_hand) return;
        keep_motion(solver, block.body_A[lane_i]);
        keep_motion(solver, block.body_B[lane_i]);
    });
    bool gains = true;
    for (int round = 0; round <= limits::bounce_rounds && gains && left.some(); ++round) {
        sweep_at_hand(solver, island, left);
        gains = false;
        for_each_in_chain(solver, island, [&](int block_i, int lane_i) {
            if (time_of(solver.blocks[block_i], lane_i) == at_hand && lower_impact(without_locks(solver), block_i, lane_i, now, h)) gains = true;
        });
    }
    for_each_in_chain(solver, island, [&](int block_i, int lane_i) {
        ContactBlock& block = solver.blocks[block_i];
        if (time_of(block, lane_i) != at_hand) return;
        take_back(solver, block_i, lane_i, now, h);
        if constexpr (notes_impulses) {
            if (notes.impacts != nullptr) notes.impacts[block.manifold[lane_i]].carried = true;
            if (notes.sums != nullptr) add_to_sum(solver, block, lane_i, notes.sums);
        }
        drop_impulses(solver, block_i, lane_i);
        solver.colours_of_body[block.body_A[lane_i]] |= changed;
        solver.colours_of_body[block.body_B[lane_i]] |= changed;
    });
    solver.colours_of_body[0] &= ~changed;
}

/// Contacts of bodies that were changed are looked at again.
void look_again(const SolverView& solver, const Island& island, scalar now, scalar h) {
    for_each_in_chain(solver, island, [&](int block_i, int lane_i) {
        ContactBlock& block = solver.blocks[block_i];
        if (((solver.colours_of_body[block.body_A[lane_i]] | solver.colours_of_body[block.body_B[lane_i]]) & changed) == 0)
            return;
        time_of(block, lane_i) = next_impact(solver, block, lane_i, now, h, false);
    });
    for_each_in_chain(solver, island, [&](int block_i, int lane_i) {
        const ContactBlock& block = solver.blocks[block_i];
        solver.colours_of_body[block.body_A[lane_i]] &= ~changed;
        solver.colours_of_body[block.body_B[lane_i]] &= ~changed;
    });
}

scalar first_impact(const SolverView& solver, const Island& island) {
    scalar first = no_impact;
    for_each_in_chain(solver, island, [&](int block_i, int lane_i) { first = min(first, time_of(solver.blocks[block_i], lane_i)); });
    return first;
}

/// Sets what the sweeps of the substep do with a contact after its last impact: nothing if it flies, else they hold it.
void aim_at_rest(const SolverView& solver, ContactBlock& block, int lane_i, scalar h) {
    const BlockFlight flight = flight_of(solver, block);
    const lane gap = scale_of(solver, block) * splat<lane>(limits::touching_gap);
    for (int row = 0; row < block.rows; ++row) {
        const RowFlight<lane>& from = flight.row[row];
        const lane resting = resting_target(from.s, gap, splat<lane>(1 / h));
        scalar target[lanes];
        store(target,
              select(meets(from, splat<lane>(h)), resting, no_bound(from, splat<lane>(h))));
        block.row[row].target[lane_i] = target[lane_i];
        block.row[row].landing[lane_i] = limits::unbounded;
    }
}

/// What the substep has beside its sweeps.
VisitsLeft visits_for_chains(const SolverView& solver, const Island& island) {
    if (solver.sweeps_of_step == no_budget) return VisitsLeft(no_budget);
    return VisitsLeft(spare_sweeps(solver, island) / solver.substeps_left * island.manifold_count);
}

/// The impacts of one island in a substep. True if there were any.
template <bool notes_impulses, class View>
bool sequence_impacts_of(const View& solver, Island& island, scalar h, const StepNotes& notes, StepReport& report) {
    int contacts = 0;
    bool some = false;
    for_each_in_chain(solver, island, [&](int block_i, int lane_i) {
        ContactBlock& block = solver.blocks[block_i];
        time_of(block, lane_i) = next_impact(solver, block, lane_i, 0, h, false);
        ++contacts;
    });
    VisitsLeft left = visits_for_chains(solver, island);
    const int before = left.count;
    // bound: limits::impacts_of_contact max_manifolds: contacts are counted. To look for the next impact counts as a visit to each
    for (int impact_i = 0; impact_i < limits::impacts_of_contact * contacts && left.take(contacts) && left.count >= contacts; ++impact_i) {
        const scalar now = first_impact(solver, island);
        if (!(now < no_impact)) break;
        for_each_in_chain(solver, island, [&](int block_i, int lane_i) {
            ContactBlock& block = solver.blocks[block_i];
            if (!(time_of(block, lane_i) <= now + limits::together * h)) return;
            (void)next_impact(solver, block, lane_i, now, h, true);
            time_of(block, lane_i) = at_hand;
            drop_impulses(solver, block_i, lane_i);
        });
        solve_at_hand<notes_impulses>(solver, island, now, h, left, notes);
        look_again(solver, island, now, h);
        count(report.impact_waves);
        some = true;
    }
    if (before != no_budget) island.sweeps += (before - left.count + island.manifold_count - 1) / island.manifold_count;
    for_each_in_chain(solver, island, [&](int block_i, int lane_i) {
        ContactBlock& block = solver.blocks[block_i];
        if (time_of(block, lane_i) < no_impact) count(report.impacts_deferred);
        aim_at_rest(solver, block, lane_i, h);
    });
    return some;
}

}  // namespace

bool find_impact_chains(SolverView& solver) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i) solver.islands[island_i].has_chains = false;  // bound: max_bodies
    solver.some_bounce = false;
    for (int block_i = 0; block_i < solver.block_count && !solver.some_bounce; ++block_i)
        solver.some_bounce = any(load(solver.blocks[block_i].e) > lane{});
    if (!solver.some_bounce) return false;
    bool some = false;
    solver.colours_of_body[0] = 0;
    for_bodies(solver, [&](int body_i) { solver.colours_of_body[body_i] = 0; });
    for_each_contact(solver, [&](int block_i, int lane_i) {
        const ContactBlock& block = solver.blocks[block_i];
        uint32_t &A = solver.colours_of_body[block.body_A[lane_i]], &B = solver.colours_of_body[block.body_B[lane_i]];
        if (block.e[lane_i] > 0) {
            ++A, ++B;
            Island& island = solver.islands[block.island[lane_i]];
            if ((block.body_A[lane_i] != 0 && (A & bouncing) > 1) || (block.body_B[lane_i] != 0 && (B & bouncing) > 1))
                some = island.has_chains = true;
            return;
        }
        const scalar gap = limits::touching_gap * scale_of(solver.unit, block.halvings[lane_i]);
        bool touches = false;
        for (int row = 0; row < block.rows; ++row)
            touches = touches || (static_cast<scalar>(row) < block.count[lane_i] && block.row[row].separation[lane_i] <= gap);
        if (touches) A |= leans, B |= leans;
    });
    return some;
}

template <bool notes_impulses, class View>
void sequence_impacts(const View& solver, scalar h, const StepNotes& notes, StepReport& report) {
    if (!solver.some_bounce) return;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {
        Island& island = solver.islands[island_i];
        if (!island.in_batch || !island.has_chains) continue;
        // An impact of a body with joints is one of its whole figure, and solved with it.
        if constexpr (View::articulates)
            if (solver.jointed.doublings_of[island_i] != 0) continue;
        if (sequence_impacts_of<notes_impulses>(solver, island, h, notes, report)) island.steady = false;
    }
}

// The linker takes the one that the scene calls.
#define INGOT_VIEW(View)                                                                       \
    template void sequence_impacts<false>(const View&, scalar, const StepNotes&, StepReport&); \
    template void sequence_impacts<true>(const View&, scalar, const StepNotes&, StepReport&)
INGOT_VIEW(SolverView);
INGOT_VIEW(JointedView);
INGOT_VIEW(LoopedView);
INGOT_VIEW(JointedMaterialView);
INGOT_VIEW(LoopedMaterialView);
INGOT_VIEW(LockedView);
INGOT_VIEW(BallView);
INGOT_VIEW(RollingView);
INGOT_VIEW(BeltView);
INGOT_VIEW(RollingBeltView);
#undef INGOT_VIEW

} }  // namespace ingot

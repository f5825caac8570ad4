// SPDX-License-Identifier: MIT
#include "gaining_figures.h"

#include "../../base/limits.h"
#include "../../constraint/contact.h"
#include "../../figure/joint_rows.h"
#include "../../figure/moving_joint.h"
#include "jointed_visits.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Marked by beta, the share of their impulses to give next: sweeps to come set it anew. 1: the island keeps what it has.
bool is_candidate(const Island& island) { return island.beta != 1; }

/// Of nothing finite, too.
scalar part_of(scalar j, scalar share) { return share == 0 ? scalar(0) : j * share; }

bool find_candidates(const SolverView& solver, const JointedBodies& jointed) {
    bool some = false;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        Island& island = solver.islands[island_i];
        const bool unsettled = island.in_batch && island.at_bound && island.residual > limits::gaining_residual * solver.unit;
        island.beta = unsettled && jointed.doublings_of[island_i] != 0 ? scalar(0.5) : scalar(1);
        some = some || is_candidate(island);
    }
    if (!some) return false;
    // bound: max_manifolds, rounded up to whole blocks
    for (int position = 0; position < solver.block_count * lanes; ++position) {
        const ContactBlock& block = solver.blocks[position / lanes];
        const int lane_i = position % lanes, last = solver.body_count - 1;
        if (block.manifold[lane_i] != no_manifold && (block.body_A[lane_i] > last || block.body_B[lane_i] > last))
            solver.islands[block.island[lane_i]].beta = 1;
    }
    some = false;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) some = some || is_candidate(solver.islands[island_i]);
    return some;
}

/// Of what contacts have changed of the motion of a body without joints.
void take_share(const SolverView& solver, int body_i, scalar share, scalar h) {
    SolverBody& body = solver.bodies[body_i];
    const SolverBodyHistory& history = solver.histories[body_i];
    for (int i = 0; i < 3; ++i) {
        const scalar v = history.v_begin[i] + history.a[i] * h, L = history.L_begin[i] + history.tau[i] * h;
        body.v_CM[i] = v + part_of(body.v_CM[i] - v, share);
        body.L[i] = L + part_of(body.L[i] - L, share);
    }
}

/// Impulses of the candidates become their shares, and all bodies move as these let them.
template <class Whole>
void give_shares(Whole& whole, scalar h) {
    auto& solver = without_rows(whole);
    using View = typename WithoutRows<Whole>::Type;
    // bound: max_manifolds, rounded up to whole blocks
    for (int position = 0; position < solver.block_count * lanes; ++position) {
        const ContactBlock& block = solver.blocks[position / lanes];
        const int lane_i = position % lanes;
        if (block.manifold[lane_i] == no_manifold || !is_candidate(solver.islands[block.island[lane_i]])) continue;
        const scalar share = solver.islands[block.island[lane_i]].beta;
        ContactConstraint<View>::Given::for_rows(solver, position / lanes,
                                                 [&](const SeenRow& row) { row.j[lane_i] = part_of(row.j[lane_i], share); });
    }
    const JointedBodies& jointed = solver.jointed;
    if constexpr (Whole::has_joint_rows) {
        const auto& rows = whole.joint_rows;
        for (int i = 0; i < rows.count; ++i) {  // bound: rows_of_joint max_joints
            const Index body_i = solver.local_of[jointed.figures.nodes[node_of(rows, rows.list[i])].slot];
            if (body_i != 0 && is_candidate(solver.islands[solver.island_of[body_i]])) {
                JointRow& row = rows.list[i];
                row.j = part_of(row.j, solver.islands[solver.island_of[body_i]].beta);
            }
        }
        give_joint_rows(jointed.figures, rows);
    }
    stand_unless(solver, true, is_candidate);
    pass_contact_impulses(solver);
    end_passing(solver);
    end_jointed_sweeps(solver, jointed);
    for_bodies(solver, [&](int body_i) {
        const Island& island = solver.islands[solver.island_of[body_i]];
        if (is_candidate(island) && !jointed.has_joints(static_cast<Index>(body_i))) take_share(solver, body_i, island.beta, h);
    });
}

/// J, of the candidates: in sums[i] of each.
void add_energies(const SolverView& solver, const BodyView& bodies, int i) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i) solver.islands[island_i].sums[i] = 0;  // bound: max_bodies
    for_bodies(solver, [&](int body_i) {
        Island& island = solver.islands[solver.island_of[body_i]];
        if (!is_candidate(island)) return;
        const SolverBody& body = solver.bodies[body_i];
        const Place at = place_of(solver.slot_of[body_i]);
        const Vector v = three_of(body.v_CM), L = three_of(body.L);
        island.sums[i] += (length_sq(v) / body.v_CM[3] + dot(L, lane_of(bodies.translation[at.tile].inv_I_world, at.lane) * L)) / 2;
    });
}

/// What an island has with all of its impulses, a half and a fourth of them.
struct ThreeEnergies {
    scalar all, half, fourth;

    scalar Q() const { return ((all - half) - 2 * (half - fourth)) * (scalar(8) / 3); }
    scalar D() const { return 2 * (all - half) - Q() * scalar(1.5); }
    /// The share to take. 1: as it is.
    scalar share() const {
        if (!is_finite(all)) return 0;
        const scalar d = D(), q = Q(), without = all - d - q;
        if (!(all > without * (1 + limits::figure_gain_allowed)) || !(q > 0)) return 1;
        return d < 0 ? min(-d / (2 * q), scalar(1)) : scalar(0);
    }
};

}  // namespace

template <class Whole>
void hold_gaining_figures(Whole& whole, const BodyView& bodies, scalar h) {
    auto& solver = without_rows(whole);
    if (!find_candidates(solver, solver.jointed)) return;
    add_energies(solver, bodies, 0);
    give_shares(whole, h);
    add_energies(solver, bodies, 1);
    give_shares(whole, h);
    add_energies(solver, bodies, 2);
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {
        Island& island = solver.islands[island_i];
        if (is_candidate(island)) island.beta = 4 * ThreeEnergies{island.sums[0], island.sums[1], island.sums[2]}.share();
    }
    give_shares(whole, h);
}

// The linker takes the one that the scene calls. Belts give energy.
template void hold_gaining_figures(JointedView&, const BodyView&, scalar);
template void hold_gaining_figures(LoopedView&, const BodyView&, scalar);
template void hold_gaining_figures(RowedView&, const BodyView&, scalar);
template void hold_gaining_figures(DrivenView&, const BodyView&, scalar);
template void hold_gaining_figures(LoopedRowedView&, const BodyView&, scalar);

} }  // namespace ingot

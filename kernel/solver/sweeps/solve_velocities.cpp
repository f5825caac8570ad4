// SPDX-License-Identifier: MIT
#include "solve_velocities.h"

#include "../../base/limits.h"
#include "../../figure/cursor.h"
#include "../../constraint/locked_view.h"
#include "../../figure/joint_rows.h"
#include "conjugate_gradients.h"
#include "jointed_visits.h"
#include "sweep_joint_rows.h"
#include "plan_islands.h"
#include "sweep_velocities.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

bool is_on(const SolverView& solver, Index island_i) { return island_i != no_island && solver.islands[island_i].sweeps_on; }

/// Adds the visit to the live ones, without the lanes of islands that are not swept.
void add_live(SolverView& solver, Visit visit) {
    if (has_one_island(visit)) {
        if (is_on(solver, visit.island)) solver.some_visits[solver.live_count++] = visit;
        return;
    }
    const ContactBlock& block = solver.blocks[visit.block];
    unsigned on = 0, spare = 0;
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        const unsigned bit = visit.lane_bits & 1u << lane_i;
        if (block.island[lane_i] == no_island) spare |= bit;
        if (is_on(solver, block.island[lane_i])) on |= bit;
    }
    if (on == 0) return;
    visit.lane_bits = (on | spare) == visit.lane_bits ? visit.lane_bits : static_cast<uint16_t>(on);
    solver.some_visits[solver.live_count++] = visit;
}

/// Drops the visits to islands that are not swept from the live ones. From the second time on in place: the list only gets shorter.
void drop_settled(SolverView& solver) {
    const int count = solver.live_count;
    solver.live_count = 0;
    // bound: max_manifolds: taken is 1 or more, for a block has room for one
    for (int visit_i = 0; visit_i < count; ++visit_i) add_live(solver, solver.live[visit_i]);
    solver.live = solver.some_visits;
}

/// After a sweep: which islands are settled, and how the others go on.
struct Settled {
    bool some, all;
};
Settled settle_islands(const SolverView& solver, int sweep_i) {
    Settled settled = {false, true};
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        Island& island = solver.islands[island_i];
        if (!island.in_batch || !island.sweeps_on) continue;
        if (sweep_i == island.sweeps_max || island.residual <= island.settled) {
            island.sweeps_on = false;
            island.sweeps += sweep_i;
            island.at_bound = sweep_i == island.sweeps_max && island.residual > limits::settled_speed * solver.unit;
            settled.some = true;
            continue;
        }
        settled.all = false;
        // A body that is not finite must not spread to those that it does not touch.
        const bool shrinks = sweep_i > 1 && island.size <= island.size_before && island.size_before > 0 && is_finite(island.size_before);
        island.beta = shrinks ? island.size / island.size_before : 0;
        island.size_before = island.size;
    }
    return settled;
}

/// Whether some island is not settled yet.
template <class Whole>
bool something_is_live(const Whole& solver) {
    if constexpr (Whole::has_joint_rows)
        return solver.live_count > 0 || are_joint_rows_live(solver, solver.jointed, solver.joint_rows);
    else
        return solver.live_count > 0;
}

}  // namespace

void select_live(SolverView& solver, bool some_stand) {
    bool all = !some_stand;
    for (int island_i = 0; island_i < solver.island_count; ++island_i)
        all = all && (!solver.islands[island_i].in_batch || solver.islands[island_i].sweeps_on);
    solver.live = solver.visits;
    solver.live_count = solver.visit_count;
    if (!all) drop_settled(solver);
}

template <class Whole, class Work>
void solve_velocities(Whole& whole, Work& work) {
    using View = typename WithoutRows<Whole>::Type;
    View& solver = without_rows(whole);
    if constexpr (View::articulates)
        select_live(solver, solver.jointed.some_stand);
    else
        select_live(solver);
    begin_sweeps(solver);
    const auto is_swept = [](const Island& island) { return island.sweeps_on; };
    if constexpr (View::articulates) {
        stand_unless(solver, true, is_swept);
        pass_contact_impulses(solver);
    }
    for (int sweep_i = 1; something_is_live(whole); ++sweep_i) {  // bound: plan.sweeps_max: no island is live after its sweeps_max
        const bool up = !is_large(solver.plan) || goes_up(solver.effort, sweep_i, solver.substeps_left);
        work.over_live(solver, up, [&solver, sweep_i, up](const Visit* visits, int count) { sweep_velocities(solver, visits, count, sweep_i, up); });
        if constexpr (Whole::has_joint_rows) sweep_joint_rows(solver, solver.jointed, whole.joint_rows, up);
        measure_sweep(solver);
        if constexpr (Whole::has_joint_rows) measure_joint_rows(solver, solver.jointed, whole.joint_rows);
        const Settled settled = settle_islands(solver, sweep_i);
        if (settled.all) {
            solver.live_count = 0;
            break;
        }
        if (settled.some) drop_settled(solver);
        work.over_batch(without_locks(without_belts(solver)), [](const auto& some) { extrapolate(some); });
        if constexpr (Whole::has_joint_rows) extrapolate_joint_rows(solver, solver.jointed, whole.joint_rows);
        if constexpr (View::articulates) {
            stand_unless(solver, false, is_swept);
            // The first sweep has no direction to go on along; with loops, sweeps gather roundings, which this takes out.
            if (decltype(solver.loops)::closes || sweep_i > 1) pass_contact_impulses(solver, Passes::again);
        }
    }
    if constexpr (View::articulates) {
        for (int island_i = 0; island_i < solver.island_count; ++island_i) solver.islands[island_i].sweeps_on = false;  // some had nothing to sweep
        // From the impulses alone: an island does not know how long others have gone on.
        if constexpr (Whole::has_joint_rows) give_joint_rows(solver.jointed.figures, whole.joint_rows);
        if constexpr (!decltype(solver.loops)::closes) pass_contact_impulses(solver, Passes::again);
        end_passing(solver);
        end_jointed_sweeps(solver, solver.jointed);
    }
}

// The linker takes the one that the scene calls.
template void solve_velocities(JointedView&, WorkAlone&);
template void solve_velocities(LoopedView&, WorkAlone&);
template void solve_velocities(JointedMaterialView&, WorkAlone&);
template void solve_velocities(LoopedMaterialView&, WorkAlone&);
template void solve_velocities(RowedView&, WorkAlone&);
template void solve_velocities(RowedMaterialView&, WorkAlone&);
template void solve_velocities(DrivenView&, WorkAlone&);
template void solve_velocities(DrivenMaterialView&, WorkAlone&);
template void solve_velocities(LoopedRowedView&, WorkAlone&);
template void solve_velocities(LoopedRowedMaterialView&, WorkAlone&);
template void solve_velocities(LockedView&, WorkAlone&);
template void solve_velocities(SolverView&, WorkAlone&);
template void solve_velocities(BallView&, WorkAlone&);
template void solve_velocities(RollingView&, WorkAlone&);
template void solve_velocities(BeltView&, WorkAlone&);
template void solve_velocities(RollingBeltView&, WorkAlone&);
template void solve_velocities(LockedView&, WorkTogether&);
template void solve_velocities(SolverView&, WorkTogether&);
template void solve_velocities(BallView&, WorkTogether&);
template void solve_velocities(RollingView&, WorkTogether&);
template void solve_velocities(BeltView&, WorkTogether&);
template void solve_velocities(RollingBeltView&, WorkTogether&);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#include "sweep_velocities.h"

#include "../../base/limits.h"
#include "../../constraint/block_bodies.h"
#include "../../constraint/contact.h"
#include "../../constraint/locked_view.h"
#include "jointed_visits.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

INGOT_INLINE BodyPairLanes chosen(mask m, const BodyPairLanes& a, const BodyPairLanes& b) {
    BodyPairLanes pair = {select(m, a.linear_A, b.linear_A), select(m, a.angular_A, b.angular_A), select(m, a.linear_B, b.linear_B),
                          select(m, a.angular_B, b.angular_B), {}};
    for (int i = 0; i < 4; ++i) pair.last[i] = select(m, a.last[i], b.last[i]);
    return pair;
}

/// The rows of the active lanes. `whole`: of all.
template <int rows, bool whole, class View, class Pair>
INGOT_INLINE void solve_rows(const View& solver, int block_i, Pair& pair, mask visited, mask active, scalar sweep, lane active_threshold) {
    RowVisit<rows, whole, View> at(solver, block_i, active);
    const BodyPairLanes before = pair;
    Change change{};
    ContactConstraint<View>::Solved::solve(at, pair, change);
    const mask moves = change.fastest > active_threshold;
    pair.last[1] = select(both(moves, at.inv_M_A > lane{}), splat<lane>(sweep), pair.last[1]);
    pair.last[3] = select(both(moves, at.inv_M_B > lane{}), splat<lane>(sweep), pair.last[3]);
    if (!whole) static_cast<BodyPairLanes&>(pair) = chosen(active, pair, before);
    store_if<whole>(at.block.change, visited, whole ? change.size : select(active, change.size, lane{}));
    store_if<whole>(at.block.fastest, visited, whole ? change.fastest : select(active, change.fastest, lane{}));
}

/// Solves the lanes of a visit, without those whose bodies neither this sweep nor the one before has changed.
template <int rows, class View>
INGOT_INLINE void visit_velocities(const View& solver, int block_i, ContactBlock& block, uint16_t lane_bits, int sweep_i, lane active_threshold) {
    const scalar sweep = static_cast<scalar>(sweep_i);
    const LaneQuad L_A = gather(solver.bodies, block.body_A, &SolverBody::L), L_B = gather(solver.bodies, block.body_B, &SolverBody::L);
    const mask visited = lanes_of(lane_bits);
    mask active = visited;
    if (sweep_i > 1) active = both(visited, max(L_A.at[3], L_B.at[3]) >= splat<lane>(sweep - 1));
    if (!any(active)) {
        store_if<false>(block.change, visited, lane{});
        store_if<false>(block.fastest, visited, lane{});
        return;
    }
    const LaneQuad v_A = gather(solver.bodies, block.body_A, &SolverBody::v_CM), v_B = gather(solver.bodies, block.body_B, &SolverBody::v_CM);
    auto pair = held_pair(
        solver, block, {vector_of(v_A), vector_of(L_A), vector_of(v_B), vector_of(L_B), {v_A.at[3], L_A.at[3], v_B.at[3], L_B.at[3]}});
    if (any(opposite(active)))
        solve_rows<rows, false>(solver, block_i, pair, visited, active, sweep, active_threshold);
    else
        solve_rows<rows, !View::locks_axes>(solver, block_i, pair, visited, active, sweep, active_threshold);
    scatter_bodies(solver, block, lane_bits, pair, &SolverBody::v_CM, &SolverBody::L);
}

/// The same of a visit whose bodies have joints: all of it, in every sweep, for what any contact of a figure does changes its other bodies.
template <int rows, class View>
INGOT_INLINE void visit_jointed(const View& solver, int block_i, ContactBlock& block, uint16_t lane_bits, int sweep_i, lane active_threshold) {
    bring_velocities(solver, solver.jointed, solver.loops, block, lane_bits);
    const mask visited = lanes_of(lane_bits);
    RowVisit<rows, false, View> at(solver, block_i, visited);
    JointedPairLanes pair(gather_bodies(solver, block, &SolverBody::v_CM, &SolverBody::L),
                          solver.jointed.blocks[block_i - solver.jointed.first_block]);
    Change change{};
    ContactConstraint<View>::Solved::solve(at, pair, change);
    const mask moves = change.fastest > active_threshold;
    const lane sweep = splat<lane>(static_cast<scalar>(sweep_i));
    pair.last[1] = select(both(moves, at.inv_M_A > lane{}), sweep, pair.last[1]);
    pair.last[3] = select(both(moves, at.inv_M_B > lane{}), sweep, pair.last[3]);
    store_if<false>(block.change, visited, change.size);
    store_if<false>(block.fastest, visited, change.fastest);
    scatter_bodies(solver, block, lane_bits, pair, &SolverBody::v_CM, &SolverBody::L);
    give_wrenches(solver.jointed, solver.loops, block, lane_bits, given_to(pair));
}

/// m/s; a body that a visit changes by more is visited by the next sweep too.
INGOT_INLINE lane active_threshold_of(const SolverView& solver, const Visit& visit, const ContactBlock& block) {
    if (has_one_island(visit)) return splat<lane>(limits::active_share * solver.islands[visit.island].settled);
    scalar of_lanes[lanes];
    for (int lane_i = 0; lane_i < lanes; ++lane_i)
        of_lanes[lane_i] = block.island[lane_i] == no_island ? 0 : limits::active_share * solver.islands[block.island[lane_i]].settled;
    return load(of_lanes);
}

/// Adds what a visit changed to the sums of its islands, lane by lane.
void add_lanes(const SolverView& solver, const Visit& visit, const ContactBlock& block) {
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        if ((visit.lane_bits >> lane_i & 1u) == 0 || block.island[lane_i] == no_island) continue;
        Island& island = solver.islands[block.island[lane_i]];
        island.sums[block.sum_i[lane_i]] += block.change[lane_i];
        island.residuals[lane_i] = max(island.residuals[lane_i], block.fastest[lane_i]);
    }
}

/// The same for a run of visits to one island, as vectors. Returns the visit after the run.
int add_run(const SolverView& solver, int begin) {
    const Index island_i = solver.live[begin].island;
    Island& island = solver.islands[island_i];
    lane residual = load(island.residuals);
    int visit_i = begin;
    for (; visit_i < solver.live_count && solver.live[visit_i].island == island_i; ++visit_i) {  // bound: max_manifolds
        const ContactBlock& block = solver.blocks[solver.live[visit_i].block];
        scalar* const sums = island.sums + block.sum_i[0];
        store(sums, load(sums) + load(block.change));
        residual = max(residual, load(block.fastest));
    }
    store(island.residuals, residual);
    return visit_i;
}

/// Calls each(island) for the islands of the batch that are not settled.
template <class Each>
void for_live_islands(const SolverView& solver, const Each& each) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i)  // bound: max_bodies
        if (solver.islands[island_i].in_batch && solver.islands[island_i].sweeps_on) each(solver.islands[island_i]);
}

}  // namespace

template <class View>
void sweep_velocities(const View& solver, const Visit* visits, int visit_count, int sweep_i, bool up) {
    Index island_before = no_island;
    lane active_threshold{};
    for (int visit_i = 0; visit_i < visit_count; ++visit_i) {  // bound: max_manifolds: a run has one visit or more
        const Visit visit = visits[up ? visit_i : visit_count - 1 - visit_i];
        ContactBlock& block = solver.blocks[visit.block];
        if (!has_one_island(visit) || visit.island != island_before) active_threshold = active_threshold_of(solver, visit, block);
        island_before = visit.island;
        if constexpr (View::articulates)
            if (is_jointed(solver.jointed, visit.block)) {
                if (has_one_row(solver, block))
                    visit_jointed<1>(solver, visit.block, block, visit.lane_bits, sweep_i, active_threshold);
                else
                    visit_jointed<View::points_max>(solver, visit.block, block, visit.lane_bits, sweep_i, active_threshold);
                continue;
            }
        if (has_one_row(solver, block))
            visit_velocities<fewest_rows<View>>(solver, visit.block, block, visit.lane_bits, sweep_i, active_threshold);
        else
            visit_velocities<View::points_max>(solver, visit.block, block, visit.lane_bits, sweep_i, active_threshold);
    }
}

// The linker takes the one that the scene calls.
template void sweep_velocities(const JointedView&, const Visit*, int, int, bool);
template void sweep_velocities(const LoopedView&, const Visit*, int, int, bool);
template void sweep_velocities(const JointedMaterialView&, const Visit*, int, int, bool);
template void sweep_velocities(const LoopedMaterialView&, const Visit*, int, int, bool);
template void sweep_velocities(const LockedView&, const Visit*, int, int, bool);
template void sweep_velocities(const SolverView&, const Visit*, int, int, bool);
template void sweep_velocities(const BallView&, const Visit*, int, int, bool);
template void sweep_velocities(const RollingView&, const Visit*, int, int, bool);
template void sweep_velocities(const BeltView&, const Visit*, int, int, bool);
template void sweep_velocities(const RollingBeltView&, const Visit*, int, int, bool);

void measure_sweep(const SolverView& solver) {
    for_live_islands(solver, [](Island& island) {
        for (scalar& sum : island.sums) sum = 0;
        for (scalar& residual : island.residuals) residual = 0;
    });
    for (int visit_i = 0; visit_i < solver.live_count;) {  // bound: max_manifolds: a run has one visit or more
        const Visit& visit = solver.live[visit_i];
        if (has_one_island(visit)) {
            visit_i = add_run(solver, visit_i);
        } else {
            add_lanes(solver, visit, solver.blocks[visit.block]);
            ++visit_i;
        }
    }
    for_live_islands(solver, [](Island& island) {
        const auto& sums = island.sums;
        island.size = ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
        island.residual = 0;
        for (const scalar residual : island.residuals) island.residual = residual > island.residual ? residual : island.residual;
    });
}

} }  // namespace ingot

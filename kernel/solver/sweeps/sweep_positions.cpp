// SPDX-License-Identifier: MIT
#include "sweep_positions.h"

#include "jointed_visits.h"
#include "visit_positions.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// visit_positions of bodies that have joints. Returns the lanes with points that land: the cursors of others stay where they are.
template <int rows, class View>
INGOT_INLINE uint16_t visit_jointed_positions(const View& solver, int block_i, ContactBlock& block, uint16_t lane_bits, scalar h, bool again) {
    bring_displacements(solver, solver.jointed, solver.loops, block, lane_bits);
    const mask active = lanes_of(lane_bits);
    const Vec3<lane> n = load(block.n);
    JointedPairLanes pair(gather_bodies(solver, block, &SolverBody::dp, &SolverBody::dth),
                          solver.jointed.blocks[block_i - solver.jointed.first_block]);
    Pushes due = Normals::pushes_due<rows, true>(block, n, pair, h, solver.unit);
    if (again) due.off = both(both(due.off, due.lands), is_used(block, 1));
    due.off = both(due.off, active);
    if (!any(due.off)) return 0;
    const Row4 q = Normals::push<rows>(block, due, limits::approach_slack * h * solver.unit, active);
    lane sum{};
    for (int row = 0; row < rows; ++row) {  // bound: 4: block_rows
        const lane push = select(due.off, q.at[row], lane{});
        turn_by_push(pair, block.row[row].levers, push);
        sum = sum + push;
    }
    add_linear(pair, n * sum, lane{}, lane{});
    settle_push(pair);
    // To no lane that is pushed nowhere: its cursor would move, for what other lanes need.
    const auto pushed = static_cast<uint16_t>(lane_bits & bits(due.off));
    scatter_bodies(solver, block, pushed, pair, &SolverBody::dp, &SolverBody::dth);
    give_wrenches(solver.jointed, solver.loops, block, pushed, given_to(pair));
    return static_cast<uint16_t>(lane_bits & bits(due.lands) & pushed);
}

/// A visit whose normals have no levers: displacements do all of it.
template <class View>
INGOT_INLINE void visit_central_positions(const View& solver, ContactBlock& block, uint16_t lane_bits, scalar h) {
    const Vec3<lane> n = load(block.n);
    auto pair = held_pair(solver, block, BodyPairLanes{});
    const LaneQuad dp_A = gather(solver.bodies, block.body_A, &SolverBody::dp), dp_B = gather(solver.bodies, block.body_B, &SolverBody::dp);
    pair.linear_A = vector_of(dp_A);
    pair.linear_B = vector_of(dp_B);
    const Pushes due = Normals::pushes_due<1, false>(block, n, pair, h, solver.unit);
    if (!any(due.off)) return;
    const Row4 q = Normals::push<1>(block, due, limits::approach_slack * h * solver.unit, lanes_of(lane_bits));
    add_linear(pair, n * select(due.off, q.at[0], lane{}), load(block.inv_M_A), load(block.inv_M_B));
    scatter_visited(solver, block.body_A, lane_bits, &SolverBody::dp, quad_of(pair.linear_A, dp_A.at[3]));
    scatter_visited(solver, block.body_B, lane_bits, &SolverBody::dp, quad_of(pair.linear_B, dp_B.at[3]));
}

}  // namespace

template <class View>
void sweep_positions(const View& solver, const Visit* visits, int visit_count, scalar h) {
    for (int visit_i = 0; visit_i < visit_count; ++visit_i) {  // bound: max_manifolds
        const Visit visit = visits[visit_i];
        ContactBlock& block = solver.blocks[visit.block];
        if constexpr (View::articulates)
            if (is_jointed(solver.jointed, visit.block)) {
                uint16_t land = visit.lane_bits;
                for (int push_i = 0; push_i < limits::landing_pushes && land != 0; ++push_i)
                    land = has_one_row(solver, block)
                               ? visit_jointed_positions<1>(solver, visit.block, block, land, h, push_i > 0)
                               : visit_jointed_positions<View::points_max>(solver, visit.block, block, land, h, push_i > 0);
                continue;
            }
        if (block.central) {
            visit_central_positions(solver, block, visit.lane_bits, h);
            continue;
        }
        if (has_one_row(solver, block)) {
            if constexpr (View::points_max == 1)
                visit_off_centre(solver, block, visit.lane_bits, h);
            else
                (void)visit_positions<fewest_rows<View>>(solver, block, visit.lane_bits, h, false);
            continue;
        }
        bool lands = true;
        for (int push_i = 0; push_i < limits::landing_pushes && lands; ++push_i)
            lands = visit_positions<View::points_max>(solver, block, visit.lane_bits, h, push_i > 0);
    }
}

// The linker takes the one that the scene calls.
template void sweep_positions(const JointedView&, const Visit*, int, scalar);
template void sweep_positions(const LoopedView&, const Visit*, int, scalar);
template void sweep_positions(const JointedMaterialView&, const Visit*, int, scalar);
template void sweep_positions(const LoopedMaterialView&, const Visit*, int, scalar);
template void sweep_positions(const LockedView&, const Visit*, int, scalar);
template void sweep_positions(const SolverView&, const Visit*, int, scalar);
template void sweep_positions(const BallView&, const Visit*, int, scalar);

} }  // namespace ingot

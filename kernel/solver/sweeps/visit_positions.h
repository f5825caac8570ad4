// SPDX-License-Identifier: MIT
// A visit of the position sweep, for the files that are compiled for some of the views.
#pragma once

#include "../../base/limits.h"
#include "../../constraint/block_bodies.h"
#include "../../constraint/locked_view.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// True if points of the visit land. One push leaves them 1 % of the way, so they are pushed `again`; then no other points are.
template <int rows, class View>
INGOT_INLINE bool visit_positions(const View& solver, ContactBlock& block, uint16_t lane_bits, scalar h, bool again) {
    const mask active = lanes_of(lane_bits);
    const Vec3<lane> n = load(block.n);
    auto pair = held_pair(solver, block, gather_bodies(solver, block, &SolverBody::dp, &SolverBody::dth));
    Pushes due = Normals::pushes_due<rows, false>(block, n, pair, h, solver.unit);
    // A single point lands by one push, and has no more in a block of one row. It has no more beside manifolds of several points either: the same
    // bits.
    if (again) due.off = both(both(due.off, due.lands), is_used(block, 1));
    if (!any(due.off)) return false;
    const Row4 q = Normals::push<rows>(block, due, limits::approach_slack * h * solver.unit, active);
    lane sum{};
    for (int row = 0; row < rows; ++row) {  // bound: 4: block_rows
        const lane push = select(due.off, q.at[row], lane{});
        turn_by_push(pair, block.row[row].levers, push);
        sum = sum + push;
    }
    add_linear(pair, n * sum, load(block.inv_M_A), load(block.inv_M_B));
    scatter_bodies(solver, block, lane_bits, pair, &SolverBody::dp, &SolverBody::dth);
    return any(both(due.lands, active));
}

/// The same of balls whose normal has a lever all the same: far from the origin, where places are coarse.
void visit_off_centre(const BallView& solver, ContactBlock& block, uint16_t lane_bits, scalar h);

} }  // namespace ingot

#pragma GCC diagnostic pop

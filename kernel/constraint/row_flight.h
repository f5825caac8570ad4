// SPDX-License-Identifier: MIT
// The flight of the points of a block under gravity and forces alone: see flight.h.
#pragma once

#include "block_bodies.h"
#include "flight.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

struct BlockFlight {
    RowFlight<lane> row[block_rows];
};

INGOT_LONG_HELPER Vec3<lane> gather_history(const SolverView& solver, const Index* index, scalar (SolverBodyHistory::*part)[4]) {
    scalar rows[3][lanes];
    for (int lane_i = 0; lane_i < lanes; ++lane_i)
        for (int axis = 0; axis < 3; ++axis) rows[axis][lane_i] = (solver.histories[index[lane_i]].*part)[axis];
    return load(rows);
}

using QuadOfHistory = scalar (SolverBodyHistory::*)[4];
INGOT_LONG_HELPER BodyPairLanes gather_histories(const SolverView& solver, const ContactBlock& block, QuadOfHistory linear, QuadOfHistory angular) {
    return {gather_history(solver, block.body_A, linear), gather_history(solver, block.body_A, angular),
            gather_history(solver, block.body_B, linear), gather_history(solver, block.body_B, angular), {}};
}

/// Of the points of a block at the begin of a substep, where its bodies have this motion.
INGOT_LONG_HELPER BlockFlight flight_of(const SolverView& solver, const ContactBlock& block, const BodyPairLanes& motion) {
    const Vec3<lane> n = load(block.n);
    const BodyPairLanes displaced = gather_bodies(solver, block, &SolverBody::dp, &SolverBody::dth);
    const BodyPairLanes forces = gather_histories(solver, block, &SolverBodyHistory::a, &SolverBodyHistory::tau);
    const lane apart = dot(n, displaced.linear_A - displaced.linear_B);
    const lane approach = dot(n, motion.linear_A - motion.linear_B), pull = dot(n, forces.linear_A - forces.linear_B);
    BlockFlight flight{};
    for (int row = 0; row < block.rows; ++row)  // bound: 4: block_rows
        flight.row[row] = {separation_now(block, row, apart, displaced), row_speed(block.row[row].levers, approach, motion),
                           row_speed(block.row[row].levers, pull, forces)};
    return flight;
}

INGOT_LONG_HELPER BlockFlight flight_of(const SolverView& solver, const ContactBlock& block) {
    return flight_of(solver, block, gather_bodies(solver, block, &SolverBody::v_CM, &SolverBody::L));
}

/// How fast points without restitution may approach. gap: m, touching_gap of the pair.
INGOT_INLINE lane resting_target(lane s, lane gap, lane inv_h) {
    return -resting_room(s, gap) * inv_h;
}

} }  // namespace ingot

#pragma GCC diagnostic pop

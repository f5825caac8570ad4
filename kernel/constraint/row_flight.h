// SPDX-License-Identifier: MIT
// The flight of contact points under gravity and forces alone, as parabolas in time: when they meet, and how fast.
#pragma once

#include "../base/limits.h"
#include "../math/sqrt.h"
#include "block_rows.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// Along a row: separation (m), speed (m/s), acceleration (m s^-2).
struct RowFlight {
    lane s, speed, a;
};
struct BlockFlight {
    RowFlight row[block_rows];
};

INGOT_INLINE Vec3<lane> gather_history(const SolverView& solver, const uint16_t* index, scalar (SolverBodyHistory::*part)[4]) {
    scalar rows[3][lanes];
    for (int lane_i = 0; lane_i < lanes; ++lane_i)
        for (int axis = 0; axis < 3; ++axis) rows[axis][lane_i] = (solver.histories[index[lane_i]].*part)[axis];
    return load(rows);
}

/// Of the points of a block at the begin of a substep.
INGOT_INLINE BlockFlight flight_of(const SolverView& solver, const ContactBlock& block) {
    const Vec3<lane> n = load(block.n);
    const BodyPairLanes displaced = gather_bodies(solver, block, &SolverBody::dp, &SolverBody::dth);
    const BodyPairLanes motion = gather_bodies(solver, block, &SolverBody::v_CM, &SolverBody::L);
    const BodyPairLanes forces = {gather_history(solver, block.body_A, &SolverBodyHistory::a),
                                  gather_history(solver, block.body_A, &SolverBodyHistory::tau),
                                  gather_history(solver, block.body_B, &SolverBodyHistory::a),
                                  gather_history(solver, block.body_B, &SolverBodyHistory::tau),
                                  {}};
    const lane apart = dot(n, displaced.linear_A - displaced.linear_B);
    const lane approach = dot(n, motion.linear_A - motion.linear_B), pull = dot(n, forces.linear_A - forces.linear_B);
    BlockFlight flight{};
    for (int row = 0; row < block.rows; ++row)  // bound: 4: block_rows
        flight.row[row] = {separation_now(block, row, apart, displaced), row_speed(block.row[row].levers, approach, motion),
                           row_speed(block.row[row].levers, pull, forces)};
    return flight;
}

/// The same flight as seen t later.
INGOT_INLINE RowFlight flight_from(const RowFlight& from, lane t) {
    return {from.s + from.speed * t + from.a * t * t * splat<lane>(scalar(0.5)), from.speed + from.a * t, from.a};
}

/// True where the surfaces meet within `rest` seconds.
INGOT_INLINE mask meets(const RowFlight& from, lane rest) {
    return from.s + from.speed * rest + from.a * rest * rest * splat<lane>(scalar(0.5)) < lane{};
}

struct RowImpact {
    lane when, speed;  ///< s, within the rest of the substep; m/s, negative
    lane rest_speed;   ///< m/s; what is no faster is no impact
    mask meets;
};
INGOT_INLINE RowImpact impact_of(const RowFlight& from, lane rest) {
    const lane two = splat<lane>(2), one = splat<lane>(1);
    RowImpact impact;
    impact.meets = meets(from, rest);
    const lane root = sqrt(max(from.speed * from.speed - two * from.a * from.s, lane{}));
    const lane divisor = root - from.speed;
    impact.when = select(both(from.s > lane{}, divisor > lane{}),
                         min(two * from.s / select(divisor > lane{}, divisor, one), rest), lane{});
    impact.speed = from.speed + from.a * impact.when;
    impact.rest_speed = max(splat<lane>(limits::bounce_speed_min), two * abs(from.a) * rest);
    return impact;
}
INGOT_INLINE mask bounces_off(const RowImpact& impact, lane e) {
    return both(both(impact.meets, -impact.speed > impact.rest_speed), e > lane{});
}

/// A target that stops nothing. A point that does not get there is left alone: to stop it as if it touched would take energy
/// from the bounce to come.
INGOT_INLINE lane no_bound(const RowFlight& from, lane h) {
    return -splat<lane>(2) * (abs(from.speed) + abs(from.a) * h) - max(from.s, lane{}) / h;
}

/// How fast points may approach that are to meet without restitution.
INGOT_INLINE lane resting_target(lane s, lane inv_h) {
    return -max(s - splat<lane>(limits::touching_gap), lane{}) * inv_h;
}

} }  // namespace ingot

#pragma GCC diagnostic pop

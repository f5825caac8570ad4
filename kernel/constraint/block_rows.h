// SPDX-License-Identifier: MIT
// What the sweeps over blocks share: the two bodies of each lane, and rows read and applied.
#pragma once

#include "../base/limits.h"
#include "../math/sqrt.h"
#include "solver_view.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// The two bodies of each lane while a block is visited: v_CM and L of the velocity sweep, dp and dth of its mirror image.
/// `last` keeps the fourth numbers of their quads.
struct BodyPairLanes {
    Vec3<lane> linear_A, angular_A, linear_B, angular_B;
    lane last[4];
};

/// The lanes of a visit.
INGOT_INLINE mask lanes_of(uint16_t lane_bits) { return is_all(lane_bits) ? splat<lane>(1) > lane{} : mask_from_bits(lane_bits); }

INGOT_INLINE Vec3<lane> vector_of(const LaneQuad& from) { return {from.at[0], from.at[1], from.at[2]}; }

INGOT_INLINE BodyPairLanes gather_bodies(const SolverView& solver, const ContactBlock& block, QuadOfBody linear, QuadOfBody angular) {
    const LaneQuad linear_A = gather(solver.bodies, block.body_A, linear), angular_A = gather(solver.bodies, block.body_A, angular);
    const LaneQuad linear_B = gather(solver.bodies, block.body_B, linear), angular_B = gather(solver.bodies, block.body_B, angular);
    return {vector_of(linear_A), vector_of(angular_A), vector_of(linear_B), vector_of(angular_B),
            {linear_A.at[3], angular_A.at[3], linear_B.at[3], angular_B.at[3]}};
}

INGOT_INLINE LaneQuad quad_of(const Vec3<lane>& v, lane last) { return {{v.x, v.y, v.z, last}}; }

/// Writes back the lanes of the visit: of one quad, or of all four.
INGOT_INLINE void scatter_visited(const SolverView& solver, const uint16_t* bodies, uint16_t lane_bits, QuadOfBody part, const LaneQuad& value) {
    if (is_all(lane_bits))
        scatter(solver.bodies, bodies, part, value);
    else
        scatter_some(solver.bodies, bodies, lane_bits, part, value);
}
INGOT_INLINE void scatter_bodies(const SolverView& solver, const ContactBlock& block, uint16_t lane_bits, const BodyPairLanes& pair,
                                 QuadOfBody linear, QuadOfBody angular) {
    scatter_visited(solver, block.body_A, lane_bits, linear, quad_of(pair.linear_A, pair.last[0]));
    scatter_visited(solver, block.body_A, lane_bits, angular, quad_of(pair.angular_A, pair.last[1]));
    scatter_visited(solver, block.body_B, lane_bits, linear, quad_of(pair.linear_B, pair.last[2]));
    scatter_visited(solver, block.body_B, lane_bits, angular, quad_of(pair.angular_B, pair.last[3]));
}

/// Speed along a row: direction . (v_A - v_B) + L_A.k_A + L_B.k_B.
INGOT_INLINE lane row_speed(const Levers& row, lane linear_speed, const BodyPairLanes& pair) {
    return linear_speed + dot(pair.angular_A, load(row.k_A)) + dot(pair.angular_B, load(row.k_B));
}
/// Displacement along a row: direction . (dp_A - dp_B) + dth_A.J_A + dth_B.J_B.
INGOT_INLINE lane row_displacement(const Levers& row, lane linear_displacement, const BodyPairLanes& pair) {
    return linear_displacement + dot(pair.angular_A, load(row.J_A)) + dot(pair.angular_B, load(row.J_B));
}

INGOT_INLINE void add_linear(BodyPairLanes& pair, const Vec3<lane>& impulse, lane inv_M_A, lane inv_M_B) {
    pair.linear_A += impulse * inv_M_A;
    pair.linear_B -= impulse * inv_M_B;
}
/// An impulse j along a row changes angular momenta by J j.
INGOT_INLINE void add_angular(BodyPairLanes& pair, const Levers& row, lane j) {
    pair.angular_A += load(row.J_A) * j;
    pair.angular_B += load(row.J_B) * j;
}
/// A push q along a row turns bodies by k q.
INGOT_INLINE void turn_by_push(BodyPairLanes& pair, const Levers& row, lane q) {
    pair.angular_A += load(row.k_A) * q;
    pair.angular_B += load(row.k_B) * q;
}
/// An angular impulse about n; what cannot move takes none.
INGOT_INLINE void add_torsion(BodyPairLanes& pair, const Vec3<lane>& n, lane torsion, lane inv_M_A, lane inv_M_B) {
    pair.angular_A += n * select(inv_M_A > lane{}, torsion, lane{});
    pair.angular_B -= n * select(inv_M_B > lane{}, torsion, lane{});
}

/// Stores where active; `whole`: everywhere.
template <bool whole>
INGOT_INLINE void store_if(scalar (&to)[lanes], mask active, lane value) {
    store(to, whole ? value : select(active, value, load(to)));
}

/// Compliance of a pair of rows, and its inverse. Pair: FrictionPair, RollingRows. Returns the larger of its principal values; 1 where there
/// is nothing.
template <class Pair>
INGOT_INLINE lane prepare_pair(Pair& pair, lane K_11, lane K_12, lane K_22, mask there) {
    const lane one = splat<lane>(1), half = splat<lane>(scalar(0.5)), difference = (K_11 - K_22) * half;
    const lane K_max = select(there, (K_11 + K_22) * half + sqrt(difference * difference + K_12 * K_12), one);
    const lane inv_K_max = select(there, one / K_max, lane{});
    // Of a lever beside which the mass is a rounding, one direction is all that is known of the pair: then both are taken as stiff as it is.
    const lane det = K_11 * K_22 - K_12 * K_12;
    const mask regular = both(there, det > splat<lane>(4 * epsilon) * (K_11 * K_22));
    const lane inv_det = one / select(regular, det, one);
    store(pair.K[0], K_11);
    store(pair.K[1], K_22);
    store(pair.inv_K[0], select(regular, K_22 * inv_det, inv_K_max));
    store(pair.inv_K[1], select(regular, -K_12 * inv_det, lane{}));
    store(pair.inv_K[2], select(regular, K_11 * inv_det, inv_K_max));
    store(pair.inv_K_max, inv_K_max);
    for (int axis = 0; axis < 2; ++axis) store(pair.direction[axis], lane{});
    return K_max;
}

/// Length of the friction impulse cut to the cone.
INGOT_INLINE void clamp_to_cone(lane& j_1, lane& j_2, lane limit) {
    const lane length_sq_of = j_1 * j_1 + j_2 * j_2;
    const mask slides = length_sq_of > limit * limit;
    if (!any(slides)) return;
    const lane cut = select(slides, limit / sqrt(select(slides, length_sq_of, splat<lane>(1))), splat<lane>(1));
    j_1 = j_1 * cut;
    j_2 = j_2 * cut;
}

/// The change of a pair's impulse that stops the motion u along its rows, on the circle of radius `limit`.
struct PairImpulse {
    lane d_1, d_2;
};
template <bool whole, class Pair>
INGOT_INLINE PairImpulse solve_pair(Pair& pair, lane u_1, lane u_2, lane limit, mask active) {
    const lane inv_K_11 = load(pair.inv_K[0]), inv_K_12 = load(pair.inv_K[1]), inv_K_22 = load(pair.inv_K[2]);
    const lane before_1 = load(pair.j[0]), before_2 = load(pair.j[1]);
    lane j_1 = before_1 - (inv_K_11 * u_1 + inv_K_12 * u_2), j_2 = before_2 - (inv_K_12 * u_1 + inv_K_22 * u_2);
    const mask slides = j_1 * j_1 + j_2 * j_2 > limit * limit;
    if (any(slides)) {
        // What sticks is found along inv_K u. What slides is pulled against u itself: only then does it end along the slip.
        const lane inv_K_max = load(pair.inv_K_max);
        lane slide_1 = before_1 - inv_K_max * u_1, slide_2 = before_2 - inv_K_max * u_2;
        clamp_to_cone(slide_1, slide_2, limit);
        j_1 = select(slides, slide_1, j_1);
        j_2 = select(slides, slide_2, j_2);
    }
    store_if<whole>(pair.j[0], active, j_1);
    store_if<whole>(pair.j[1], active, j_2);
    return {j_1 - before_1, j_2 - before_2};
}

/// True where a manifold has that point.
INGOT_INLINE mask is_used(const ContactBlock& block, int row) { return load(block.count) > splat<lane>(static_cast<scalar>(row)); }

INGOT_INLINE mask bounces(const ContactRow& row) { return load(row.landing) < splat<lane>(limits::unbounded); }

/// Where a point is now: its separation at the begin of the step, and what displacements have made of it.
INGOT_INLINE lane separation_now(const ContactBlock& block, int row, lane linear_displacement, const BodyPairLanes& displaced) {
    return load(block.row[row].separation) + row_displacement(block.row[row].levers, linear_displacement, displaced);
}

} }  // namespace ingot

#pragma GCC diagnostic pop

// SPDX-License-Identifier: MIT
// The two bodies of each lane of a block, gathered and scattered.
#pragma once

#include "solver_view.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// The lanes of a visit.
INGOT_INLINE mask lanes_of(uint16_t lane_bits) { return is_all(lane_bits) ? splat<lane>(1) > lane{} : mask_from_bits(lane_bits); }

INGOT_INLINE Vec3<lane> vector_of(const LaneQuad& from) { return {from.at[0], from.at[1], from.at[2]}; }

INGOT_LONG_HELPER BodyPairLanes gather_bodies(const SolverView& solver, const ContactBlock& block, QuadOfBody linear, QuadOfBody angular) {
    const LaneQuad linear_A = gather(solver.bodies, block.body_A, linear), angular_A = gather(solver.bodies, block.body_A, angular);
    const LaneQuad linear_B = gather(solver.bodies, block.body_B, linear), angular_B = gather(solver.bodies, block.body_B, angular);
    return {vector_of(linear_A), vector_of(angular_A), vector_of(linear_B), vector_of(angular_B),
            {linear_A.at[3], angular_A.at[3], linear_B.at[3], angular_B.at[3]}};
}

INGOT_INLINE LaneQuad quad_of(const Vec3<lane>& v, lane last) { return {{v.x, v.y, v.z, last}}; }

/// Writes back the lanes of the visit, of one side.
INGOT_INLINE void scatter_visited(const SolverView& solver, const Index* bodies, uint16_t lane_bits, QuadOfBody linear, const LaneQuad& of_linear) {
    if (!is_all(lane_bits)) return scatter_some(solver.bodies, bodies, lane_bits, linear, of_linear);
    WrittenBodies(solver.bodies, bodies).put(linear, of_linear);
}
INGOT_INLINE void scatter_visited(const SolverView& solver, const Index* bodies, uint16_t lane_bits, QuadOfBody linear, const LaneQuad& of_linear,
                                  QuadOfBody angular, const LaneQuad& of_angular) {
    if (is_all(lane_bits)) {
        const WrittenBodies to(solver.bodies, bodies);
        to.put(linear, of_linear);
        to.put(angular, of_angular);
        return;
    }
    scatter_some(solver.bodies, bodies, lane_bits, linear, of_linear);
    scatter_some(solver.bodies, bodies, lane_bits, angular, of_angular);
}
INGOT_LONG_HELPER void scatter_bodies(const SolverView& solver, const ContactBlock& block, uint16_t lane_bits, const BodyPairLanes& pair,
                                 QuadOfBody linear, QuadOfBody angular) {
    scatter_visited(solver, block.body_A, lane_bits, linear, quad_of(pair.linear_A, pair.last[0]), angular, quad_of(pair.angular_A, pair.last[1]));
    scatter_visited(solver, block.body_B, lane_bits, linear, quad_of(pair.linear_B, pair.last[2]), angular, quad_of(pair.angular_B, pair.last[3]));
}

} }  // namespace ingot

#pragma GCC diagnostic pop

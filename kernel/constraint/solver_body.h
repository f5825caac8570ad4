// SPDX-License-Identifier: MIT
// Bodies as the contact solver reads and writes them: packed, because bodies that touch are scattered over the tiles.
#pragma once

#include "../body/body_tiles.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// What sweeps gather and scatter: four quads, a cache line in float. World axes. An immovable body is all zero, and stays so.
struct alignas(4 * sizeof(scalar)) SolverBody {
    scalar v_CM[4];  ///< m/s; last: inv_M, kg^-1
    scalar L[4];     ///< kg m^2/s; last: 1 where the body was hit in the substep before
    scalar dp[4];    ///< m, displacement of the centre of mass since the step began; last: m s^-2, of gravity and forces
    scalar dth[4];   ///< rad, small rotation since then; last: how it turns, see below
};

/// How a body turns in a step, in SolverBody::dth: as its joints let it; little; so far that its inertia and its contacts are taken along, see
/// solver/sweeps/turning_bodies.h; and so that something hits it in the substep at hand.
inline constexpr scalar turns_with_figure = -1, turns_little = 0, turns_far = 1, turns_into_impact = 2;

/// The rest, which only loops over bodies use.
struct alignas(4 * sizeof(scalar)) SolverBodyHistory {
    scalar a[4];          ///< m s^-2, of gravity and forces
    scalar tau[4];        ///< N m
    scalar v_begin[4];    ///< of the substep
    scalar L_begin[4];
    scalar v_sweep[4];    ///< before the sweep at hand
    scalar L_sweep[4];
    scalar P_v[4];        ///< conjugate direction
    scalar P_L[4];
    scalar attitude[4];   ///< of a body that turns far: A as a quaternion; but for pushes of the substep before
    scalar turn[4];       ///< rad, of such a body in the substep before, without pushes: dth begins anew with each
    scalar L_sum[4];      ///< of the substeps: the drift of A goes by the mean; last: 1 where several cores have found that it accelerates
};

/// A quad without its last.
inline Vector three_of(const scalar (&from)[4]) { return {from[0], from[1], from[2]}; }
inline void set_three(scalar (&to)[4], const Vector& value) {
    to[0] = value.x;
    to[1] = value.y;
    to[2] = value.z;
}

/// One of the four quads.
using QuadOfBody = scalar (SolverBody::*)[4];

INGOT_INLINE LaneQuad gather(const SolverBody* bodies, const Index* index, QuadOfBody part) {
    return gather4([&](int lane_i) { return static_cast<const scalar*>(bodies[index[lane_i]].*part); });
}
/// Where the lanes of a visit are written to. No two share a body, other than the one that cannot move. That one is never written: all that touch the
/// ground read it, on other cores too, and what it would be given, 0 times an impulse, is no number where the impulse is not finite.
class WrittenBodies {
public:
    INGOT_INLINE WrittenBodies(SolverBody* bodies, const Index* index) {
        for (int lane_i = 0; lane_i < lanes; ++lane_i) to_[lane_i] = index[lane_i] == 0 ? &nowhere_ : bodies + index[lane_i];
    }
    INGOT_INLINE void put(QuadOfBody part, const LaneQuad& value) const {
        if (lanes == 1 && to_[0] == &nowhere_) return;
        scatter4(value, [&](int lane_i) { return static_cast<scalar*>(to_[lane_i]->*part); });
    }

private:
    SolverBody nowhere_;
    SolverBody* to_[lanes];
};
/// Writes only the lanes named by bits.
INGOT_INLINE void scatter_some(SolverBody* bodies, const Index* index, uint16_t lane_bits, QuadOfBody part, const LaneQuad& value) {
    scalar rows[4][lanes];
    for (int i = 0; i < 4; ++i) store(rows[i], value.at[i]);
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        if ((lane_bits >> lane_i & 1u) == 0 || index[lane_i] == 0) continue;
        for (int i = 0; i < 4; ++i) (bodies[index[lane_i]].*part)[i] = rows[i][lane_i];
    }
}

} }  // namespace ingot

#pragma GCC diagnostic pop

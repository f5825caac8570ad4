// SPDX-License-Identifier: MIT
// Bodies as the contact solver reads and writes them: packed, because what touches is scattered over the tiles.
#pragma once

#include "../body/body_tiles.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// What sweeps gather and scatter. World axes. An immovable body is all zero, and stays so.
struct alignas(4 * sizeof(scalar)) SolverBody {
    scalar v_CM[4];  ///< m/s, and inv_M, kg^-1
    scalar L[4];     ///< kg m^2/s
    scalar dp[4];    ///< m, displacement of the centre of mass since the step began
    scalar dth[4];   ///< rad, small rotation since then; its last number is 1 where the body was hit in the substep before
};

/// The rest, which only loops over bodies use.
struct alignas(4 * sizeof(scalar)) SolverBodyHistory {
    scalar a[4];          ///< m s^-2, of gravity and forces; last: its length
    scalar tau[4];        ///< N m
    scalar v_begin[4];    ///< of the substep
    scalar v_sweep[4];    ///< before the sweep at hand
    scalar L_sweep[4];
    scalar P_v[4];        ///< conjugate direction
    scalar P_L[4];
    scalar L_sum[4];      ///< of the substeps: the drift of A goes by the mean
    scalar dth_push[4];   ///< rad, the part of dth that position sweeps made
};

#if INGOT_LANES == 1

INGOT_INLINE Vec3<lane> gather(const SolverBody* bodies, const uint16_t* index, scalar (SolverBody::*part)[4]) {
    const scalar* from = bodies[*index].*part;
    return {from[0], from[1], from[2]};
}
INGOT_INLINE void scatter(SolverBody* bodies, const uint16_t* index, scalar (SolverBody::*part)[4], const Vec3<lane>& value) {
    scalar* to = bodies[*index].*part;
    to[0] = value.x;
    to[1] = value.y;
    to[2] = value.z;
}

#else

INGOT_INLINE Vec3<lane> gather(const SolverBody* bodies, const uint16_t* index, scalar (SolverBody::*part)[4]) {
    Vec3<lane> value;
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        const scalar* from = bodies[index[lane_i]].*part;
        value.x[lane_i] = from[0];
        value.y[lane_i] = from[1];
        value.z[lane_i] = from[2];
    }
    return value;
}
INGOT_INLINE void scatter(SolverBody* bodies, const uint16_t* index, scalar (SolverBody::*part)[4], const Vec3<lane>& value) {
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        scalar* to = bodies[index[lane_i]].*part;
        to[0] = value.x[lane_i];
        to[1] = value.y[lane_i];
        to[2] = value.z[lane_i];
    }
}

#endif

/// Writes only the lanes named by bits.
INGOT_INLINE void scatter_some(SolverBody* bodies, const uint16_t* index, uint16_t lane_bits, scalar (SolverBody::*part)[4], const Vec3<lane>& value) {
    scalar rows[3][lanes];
    store(rows, value);
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        if ((lane_bits >> lane_i & 1u) == 0) continue;
        scalar* to = bodies[index[lane_i]].*part;
        for (int axis = 0; axis < 3; ++axis) to[axis] = rows[axis][lane_i];
    }
}

} }  // namespace ingot

#pragma GCC diagnostic pop

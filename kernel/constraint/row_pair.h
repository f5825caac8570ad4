// SPDX-License-Identifier: MIT
// Two rows across each other whose impulse stays within a circle: friction in its cone, and the resistance to being rolled.
//
//     u + K (j - j_0) = 0      while |j| <= limit: nothing moves
//     j = -limit u / |u|       else: it slides, against the slip
//
// u: speeds along the two rows, K: their compliance, 2x2 and symmetric, limit: what the normals carry times mu, or times the lever.
// Source: Coulomb's law, as a projection onto the cone: Alart and Curnier, "A mixed formulation for frictional contact problems prone to
// Newton like solution methods", 1991.
#pragma once

#include "laws.h"
#include "rows.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

struct RowPair {
    LaneRow K[2];       ///< compliance: 11, 22
    LaneRow inv_K[3];   ///< inverse of the pair: 11, 12, 22
    LaneRow inv_K_max;  ///< inverse of the larger of its two principal values
    LaneRow j[2];       ///< N s, or N m s
    LaneRow j_sweep[2], direction[2];
};

/// Compliance of a pair of rows, and its inverse. Returns the larger of its principal values; 1 where there is nothing.
INGOT_INLINE lane prepare_pair(RowPair& pair, lane K_11, lane K_12, lane K_22, mask there) {
    const lane one = splat<lane>(1), half = splat<lane>(scalar(0.5)), difference = (K_11 - K_22) * half;
    const lane K_max = select(there, (K_11 + K_22) * half + sqrt(difference * difference + K_12 * K_12), one);
    const lane inv_K_max = select(there, one / K_max, lane{});
    // With a lever so long that the mass is a rounding beside it, only one direction of the pair is known. Both are then taken for as stiff as that
    // one.
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

/// Cut to the circle.
INGOT_INLINE void clamp_to_cone(lane& j_1, lane& j_2, lane limit) {
    const lane length_sq_of = j_1 * j_1 + j_2 * j_2;
    if (!any(length_sq_of > limit * limit)) return;
    const lane cut = cone_cut(length_sq_of, limit);
    j_1 = j_1 * cut;
    j_2 = j_2 * cut;
}

/// The change of a pair's impulse that stops the motion u along its rows, on the circle of radius `limit`.
struct PairImpulse {
    lane d_1, d_2;
};
template <bool whole>
INGOT_INLINE PairImpulse solve_pair(RowPair& pair, lane u_1, lane u_2, lane limit, mask active) {
    const lane inv_K_11 = load(pair.inv_K[0]), inv_K_12 = load(pair.inv_K[1]), inv_K_22 = load(pair.inv_K[2]);
    const lane before_1 = load(pair.j[0]), before_2 = load(pair.j[1]);
    lane j_1 = before_1 - (inv_K_11 * u_1 + inv_K_12 * u_2), j_2 = before_2 - (inv_K_12 * u_1 + inv_K_22 * u_2);
    const mask slides = j_1 * j_1 + j_2 * j_2 > limit * limit;
    if (any(slides)) {
        // A pair that sticks changes by -inv_K u. A pair that slides is pulled against u itself: only then does its force end along the slip.
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

} }  // namespace ingot

#pragma GCC diagnostic pop

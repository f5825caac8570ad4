// SPDX-License-Identifier: MIT
// The laws of contact, each written once: T is lane, scalar or wide_scalar, and they serve the sweeps, the sequential solver and the direct one.
#pragma once

#include "../base/limits.h"
#include "../math/sqrt.h"
#include "../math/wide.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// Room that a point has left before it rests, m: from touching_gap on points stop as if they touched. In a substep of h seconds it may be used up,
/// so A approaches B with -resting_room / h at most.
template <class T>
INGOT_INLINE T resting_room(T s) {
    return max(s - splat<T>(limits::touching_gap), T{});
}

/// How far from its place a point is, m, with s its separation: of an overlap, or of a gap between points that press each other, 0.4 is taken back
/// in a substep, up to `deepest` (which is negative); other points may come closer by all of their gap.
template <class T, class Mask>
INGOT_INLINE T position_target(T s, Mask pressed, T deepest) {
    return select(either(pressed, s < T{}), max(s * splat<T>(limits::position_share), deepest), s);
}

/// What counts of a point in the middle of a manifold, where friction takes hold: all up to the contact margin, nothing from twice as far on, where
/// this is negative.
template <class T>
INGOT_INLINE T nearness(T s) {
    return min(splat<T>(1), splat<T>(2) - s / splat<T>(limits::contact_margin));
}

/// What is given again of a normal's impulse, on a body that was hit: of an impact no more than twice what it was before, and what forces explain.
/// allowance: m/s, 2 h times the larger acceleration; K: compliance.
template <class T>
INGOT_INLINE T impulse_after_impact(T j, T j_before, T allowance, T K) {
    return min(j, splat<T>(2) * j_before + allowance / K);
}

/// The factor that cuts an impulse to a circle of this radius: 1 within it.
template <class T>
INGOT_INLINE T cone_cut(T length_sq_of, T limit) {
    const auto beyond = length_sq_of > limit * limit;
    return select(beyond, limit / sqrt(select(beyond, length_sq_of, splat<T>(1))), splat<T>(1));
}

} }  // namespace ingot

#pragma GCC diagnostic pop

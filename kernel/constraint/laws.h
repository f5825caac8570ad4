// SPDX-License-Identifier: MIT
// The laws of contact, each written once: T is lane, scalar or wide_scalar, and they serve the sweeps, the sequential solver and the direct one.
#pragma once

#include "../base/limits.h"
#include "../math/sqrt.h"
#include "../math/wide.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// The way that a point may still go before it rests, m: points stop at touching_gap as if they touched. In a substep of h seconds a point may go all
/// of that way, so A approaches B with -resting_room / h at most.
template <class T>
INGOT_INLINE T resting_room(T s) {
    return max(s - splat<T>(limits::touching_gap), T{});
}

/// How far a point is from its place, m; s: its separation. In a substep 0.4 of an overlap is taken back, up to `deepest` (which is negative), and
/// 0.4 of a gap between points that press each other. Other points may come closer by all of their gap.
template <class T, class Mask>
INGOT_INLINE T position_target(T s, Mask pressed, T deepest) {
    return select(either(pressed, s < T{}), max(s * splat<T>(limits::position_share), deepest), s);
}

/// How much a point counts in the middle of its manifold, where friction takes hold: 1 up to the contact margin, 0 at twice that. Further away this
/// is negative.
template <class T>
INGOT_INLINE T nearness(T s) {
    return min(splat<T>(1), splat<T>(2) - s / splat<T>(limits::contact_margin));
}

/// How much of a normal's impulse is given again to a body that was hit: no more than twice the impulse before the impact, and what forces explain.
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

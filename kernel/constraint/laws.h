// SPDX-License-Identifier: MIT
// The laws of contact, each written once: T is lane, scalar or wide_scalar, and they serve the sweeps, the sequential solver and the direct one.
#pragma once

#include "../base/limits.h"
#include "../math/sqrt.h"
#include "../math/wide.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// The way that a point may still go before it rests, m: points stop at a gap as if they touched, touching_gap of the pair. In a substep of h
/// seconds a point may go all of that way, so A approaches B with -resting_room / h at most.
template <class T>
INGOT_INLINE T resting_room(T s, T gap) {
    return max(s - gap, T{});
}

/// How far a point is from its place, m; s: its separation. In a substep 0.4 of an overlap is taken back, up to `deepest` (which is negative), and
/// 0.4 of a gap between points that press each other. Other points may come closer by all of their gap.
template <class T, class Mask>
INGOT_INLINE T position_target(T s, Mask pressed, T deepest) {
    return select(either(pressed, s < T{}), max(s * splat<T>(limits::position_share), deepest), s);
}

/// Whether an impulse presses, so that a gap there is drawn together: it changes the speed of the bodies by more than approach_slack. Impulses that
/// die away from substep to substep never quite reach zero: 1e-300 N s would draw bodies together over centimetres.
template <class T>
INGOT_INLINE auto presses(T j, T inv_M_of_both, T unit) {
    return j * inv_M_of_both > splat<T>(limits::approach_slack) * unit;
}

/// How much a point counts in the middle of its manifold, where friction takes hold: 1 up to the contact margin of the pair, 0 at twice that. Further
/// away this is negative.
template <class T>
INGOT_INLINE T nearness(T s, T margin) {
    return min(splat<T>(1), splat<T>(2) - s / margin);
}

/// How much of a normal's impulse is given again to a body that was hit: no more than twice the impulse before the impact, and what forces explain.
/// allowance: m/s, 2 h times the larger acceleration; K: compliance.
template <class T>
INGOT_INLINE T impulse_after_impact(T j, T j_before, T allowance, T K) {
    return min(j, splat<T>(2) * j_before + allowance / K);
}

/// Whether a point meets by more than forces explain, so that its impulse in the substep before says nothing of this one. u: m/s, n.(v_A - v_B);
/// target: m/s, that u is to reach; allowance: as above.
template <class T>
INGOT_INLINE auto is_impact(T u, T target, T allowance) {
    return u - target < -allowance;
}

/// Whether friction slides, by its square: it is as large as it can be.
template <class T>
INGOT_INLINE auto is_on_cone(T friction_sq, T limit) {
    return friction_sq >= splat<T>(limits::sliding_share_sq) * limit * limit;
}

/// When a slip turns round, as a share of the substep; 0: it does not. u_0: m/s, the slip as the substep begins; along: u_0 . u_1, where u_1 is the
/// slip at the end if friction goes on as before. Friction is against u_0 until then, and free again afterwards. So its impulse, with e along u_0, is
///
///     j = -share mu N e + i,   |i| <= (1 - share) mu N
///
/// With one circle for the whole substep, the impulse of what slides up a slope and back would be off by 2 mu N share for good.
template <class T>
INGOT_INLINE T reversal_share(T u_0_sq, T along, T unit) {
    const T least = splat<T>(limits::reversal_speed) * unit;
    const auto turns_round = both(u_0_sq > least * least, along < T{});
    return select(turns_round, u_0_sq / select(turns_round, u_0_sq - along, splat<T>(1)), T{});
}

/// By how much further friction takes a body than if it acted evenly all through the substep, times the mass: kg m. For its first part acts first.
/// given: N s, before the reversal; j: N s, of the whole substep of h seconds. Impulse: T, or a vector of them.
/// Only for bodies with no other contact: that would have a part in it.
template <class T, class Impulse>
INGOT_INLINE Impulse displacement_of_reversal(const Impulse& given, const Impulse& j, T share, T h) {
    return (given - j * share) * (h * splat<T>(scalar(0.5)));
}

/// The factor that cuts an impulse to a circle of this radius: 1 within it.
template <class T>
INGOT_INLINE T cone_cut(T length_sq_of, T limit) {
    const auto beyond = length_sq_of > limit * limit;
    return select(beyond, limit / sqrt(select(beyond, length_sq_of, splat<T>(1))), splat<T>(1));
}

} }  // namespace ingot

#pragma GCC diagnostic pop

// SPDX-License-Identifier: MIT
// Restitution: points fly on parabolas. When they meet, how fast, and where they are at the end of the substep. T: lane or scalar.
//
//     s(t) = s + u t + a t^2 / 2                     separation along n, of the begin of a substep of h seconds
//     t*   = 2 s / (sqrt(u^2 - 2 a s) - u)           they meet: the root that loses no digits
//     u*   = u + a t*  ->  -e u*                     they leave
//     target  -e u* + a (h - t*)                     speed at the end of the substep
//     landing -e u* (h - t*) + a (h - t*)^2 / 2      place at the end of the substep; below that by what is left of a deep overlap
//
// Source: time of impact within the substep, ours; Newton's law of restitution.
#pragma once

#include "laws.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// Along a row: separation (m), speed (m/s), acceleration (m s^-2).
template <class T>
struct RowFlight {
    T s, speed, a;
};

/// The same flight as seen t later.
template <class T>
INGOT_INLINE RowFlight<T> flight_from(const RowFlight<T>& from, T t) {
    return {from.s + from.speed * t + from.a * t * t * splat<T>(scalar(0.5)), from.speed + from.a * t, from.a};
}

/// True where the surfaces meet within `rest` seconds.
template <class T>
INGOT_INLINE auto meets(const RowFlight<T>& from, T rest) {
    return from.s + from.speed * rest + from.a * rest * rest * splat<T>(scalar(0.5)) < T{};
}

template <class T>
struct RowImpact {
    T when, speed;  ///< s, within the rest of the substep; m/s, negative
    T rest_speed;   ///< m/s; what is no faster is no impact
    decltype(T{} < T{}) meets;
};
template <class T>
INGOT_INLINE RowImpact<T> impact_of(const RowFlight<T>& from, T rest, scalar unit) {
    const T two = splat<T>(2), one = splat<T>(1);
    RowImpact<T> impact;
    impact.meets = meets(from, rest);
    const T root = sqrt(max(from.speed * from.speed - two * from.a * from.s, T{}));
    const T divisor = root - from.speed;
    impact.when = select(both(from.s > T{}, divisor > T{}),
                         min(two * from.s / select(divisor > T{}, divisor, one), rest), T{});
    impact.speed = from.speed + from.a * impact.when;
    impact.rest_speed = max(splat<T>(limits::bounce_speed_min * unit), two * abs(from.a) * rest);
    return impact;
}
template <class T>
INGOT_INLINE auto bounces_off(const RowImpact<T>& impact, T e) {
    return both(both(impact.meets, -impact.speed > impact.rest_speed), e > T{});
}

/// A target for points that do not reach the other body in this substep: it does not slow their own flight, but it stops what others push further.
template <class T>
INGOT_INLINE T flying_target(const RowFlight<T>& from, T resting, T h) {
    return min(resting, from.speed + from.a * h);
}

/// A target that stops nothing. A point that does not reach the other body in this substep is left alone: stopping it, as if it touched, would take
/// energy from the bounce to come.
template <class T>
INGOT_INLINE T no_bound(const RowFlight<T>& from, T h) {
    return -splat<T>(2) * (abs(from.speed) + abs(from.a) * h) - max(from.s, T{}) / h;
}

/// Of the separation s what a bounce leaves for later: it takes back no more of an overlap in a substep of h seconds than a rest does.
template <class T>
INGOT_INLINE T overlap_left(T s, T h, scalar unit) {
    return min(s + h * splat<T>(limits::push_speed_max * unit), T{});
}

/// Where a point that bounces is at the end of its substep, and how fast.
template <class T>
struct RowLanding {
    T speed, s;
};
template <class T>
INGOT_INLINE RowLanding<T> landing_of(const RowFlight<T>& from, const RowImpact<T>& impact, T e, T h, scalar unit) {
    const T leaving = -e * impact.speed, rest = h - impact.when;
    const T way = leaving * rest + from.a * rest * rest * splat<T>(scalar(0.5));
    return {leaving + from.a * rest, way + overlap_left(from.s, h, unit)};
}

} }  // namespace ingot

#pragma GCC diagnostic pop

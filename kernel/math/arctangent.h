// SPDX-License-Identifier: MIT
#pragma once

#include "lanes.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// The angle of a point from the x axis, -pi .. pi; of the origin 0. T: scalar or lane.
///
/// Units:  rad. y and x may be of any finite size at which their sum is finite, and one of them no denormal.
/// Error:  within 2 ulp of the result; the same bits on every target; see host_tests/maths. Cost: one division, 20 flops (double: 32).
/// Source: a minimax polynomial for |u| <= tan(pi/8), by Remez' exchange on the relative error of atan(u)/u, which is 2^-30 (float), 2^-59 (double);
///         beyond, atan(t) = pi/4 + atan((t - 1)/(t + 1)).
template <class T>
INGOT_INLINE T arctangent(T y, T x) {
    const T zero{}, one = splat<T>(1);
    const T across = abs(y), along = abs(x);
    const auto is_steep = across > along;
    const T least = select(is_steep, along, across), most = select(is_steep, across, along);
    const auto is_far = least > most * splat<T>(scalar(0.41421356237309504880));
    const T below = select(is_far, most + least, most);
    const T u = select(is_far, least - most, least) / select(below > zero, below, one), s = u * u;
#if INGOT_DOUBLE
    constexpr scalar terms[] = {-0.33333333333333129101, 0.19999999999942732968,  -0.14285714279416997026, 0.11111110752667793855,
                                -0.090908970191746570488, 0.076920488840811029902, -0.066629904124089593337, 0.058471477096981836065,
                                -0.05036270311796359096, 0.037993870504470600998, -0.017835673953462304573};
#else
    constexpr scalar terms[] = {-0.33333307625850770689f, 0.19998216947749218641f, -0.14240083008323319158f, 0.10573479797603923662f,
                                -0.060347903256142989586f};
#endif
    constexpr int term_count = static_cast<int>(sizeof terms / sizeof terms[0]);
    T tail = splat<T>(terms[term_count - 1]);
    for (int i = term_count - 2; i >= 0; --i) tail = tail * s + splat<T>(terms[i]);  // bound: 11: terms
    // pi/4 and pi/2 in two parts, so that the last addition alone rounds at the size of the result.
    constexpr scalar quarter = scalar(0.78539816339744830962), half = 2 * quarter;
#if INGOT_DOUBLE
    constexpr scalar quarter_low = 3.0616169978683829e-17;
#else
    constexpr scalar quarter_low = -2.1855694143368818e-08f;
#endif
    T low = u * (s * tail) + select(is_far, splat<T>(quarter_low), zero), high = select(is_far, splat<T>(quarter), zero);
    T angle = high + (u + low);
    angle = select(is_steep, splat<T>(half) - (angle - splat<T>(2 * quarter_low)), angle);
    angle = select(x < zero, splat<T>(2 * half) - (angle - splat<T>(4 * quarter_low)), angle);
    return select(y < zero, -angle, angle);
}

} }  // namespace ingot

#pragma GCC diagnostic pop

// SPDX-License-Identifier: MIT
#pragma once

#include "../base/config.h"

namespace ingot { inline namespace INGOT_ABI {

template <class T>
/// Both of one angle.
struct SinCosOf {
    T sin, cos;  ///< -1 to 1
};
using SinCos = SinCosOf<scalar>;  ///< of one angle

/// pi/2 in four parts, of which the first three are so short that a multiple of them by up to 1000 is exact.
#if INGOT_DOUBLE
inline constexpr scalar half_pi_parts[4] = {0x1.921fb54442cp+0, 0x1.18469898cc4p-44, 0x1.1701b839a24p-88, 0x1.2049c1114cf99p-132};
#else
inline constexpr scalar half_pi_parts[4] = {0x1.9218p+0f, 0x1.ed5p-14f, 0x1.10bp-30f, 0x1.184698p-44f};
#endif
inline constexpr scalar two_over_pi = scalar(0.63661977236758134308);

/// r + low = angle - q pi/2, with low below the last bit of r. T: scalar or lane.
template <class T>
struct ReducedAngle {
    T r, low;
};

/// Cody and Waite's reduction, its rounding errors kept: exact to 2^-50 (float) or 2^-120 (double) for |q| <= 640.
template <class T>
INGOT_INLINE constexpr ReducedAngle<T> reduced_angle(T angle, T q) {
    const T r_1 = angle - q * half_pi_parts[0];  // exact: the two are within a factor of 2, or q is 0
    const T part_2 = q * half_pi_parts[1], r_2 = r_1 - part_2, seen_2 = r_1 - r_2;
    const T error_2 = (r_1 - (r_2 + seen_2)) + (seen_2 - part_2);
    const T part_3 = q * half_pi_parts[2], r_3 = r_2 - part_3, seen_3 = r_2 - r_3;
    const T error_3 = (r_2 - (r_3 + seen_3)) + (seen_3 - part_3);
    const T low = (error_2 + error_3) - q * half_pi_parts[3];
    const T r = r_3 + low;
    return {r, (r_3 - r) + low};
}

/// Sine and cosine of r + low, |r| <= pi/4: the Taylor series, whose first term left out is below a quarter ulp, summed so
/// that the last addition is the only one to round at the size of the result. T: scalar or lane.
template <class T>
INGOT_INLINE constexpr SinCosOf<T> sin_cos_reduced(const ReducedAngle<T>& angle) {
    const T r = angle.r, low = angle.low, x = r * r;
    const scalar one = 1, half = scalar(0.5);
#if INGOT_DOUBLE
    const T sin_tail = r * x * (-one / 6 + x * (one / 120 + x * (-one / 5040 + x * (one / 362880 + x * (-one / 39916800 +
                       x * (one / 6227020800 + x * (-one / 1307674368000 + x * (one / 355687428096000))))))));
    const T cos_tail = x * x * (one / 24 + x * (-one / 720 + x * (one / 40320 + x * (-one / 3628800 +
                       x * (one / 479001600 + x * (-one / 87178291200 + x * (one / 20922789888000)))))));
#else
    const T sin_tail = r * x * (-one / 6 + x * (one / 120 + x * (-one / 5040 + x * (one / 362880))));
    const T cos_tail = x * x * (one / 24 + x * (-one / 720 + x * (one / 40320 + x * (-one / 3628800))));
#endif
    const T half_x = x * half, near_one = one - half_x;
    return {r + (sin_tail + low * (one - half_x)), near_one + (((one - near_one) - half_x) + (cos_tail - r * low))};
}

/// Sine and cosine of an angle, for set-up code: the step uses no trigonometry.
///
/// Units:  rad; valid for |angle| <= 1000, beyond it (and for NaN) both are NaN.
/// Error:  within 1 ulp of the larger of the result and 2^-20 (float) or 2^-50 (double), the same bits on every target; see host_tests/maths.
constexpr SinCos sin_cos(scalar angle) {
    if (!(angle >= -1000 && angle <= 1000)) return {(angle - angle) / (angle - angle), (angle - angle) / (angle - angle)};
    const scalar turns = angle * two_over_pi;
    const int quadrant = static_cast<int>(turns < 0 ? turns - scalar(0.5) : turns + scalar(0.5));
    const auto [s, c] = sin_cos_reduced(reduced_angle(angle, static_cast<scalar>(quadrant)));
    switch (quadrant & 3) {
        case 0: return {s, c};
        case 1: return {c, -s};
        case 2: return {-s, -c};
        default: return {-c, s};
    }
}

} }  // namespace ingot

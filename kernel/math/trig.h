// SPDX-License-Identifier: MIT
#pragma once

#include "../base/config.h"

namespace ingot { inline namespace INGOT_ABI {

template <class T>
struct SinCosOf {
    T sin, cos;
};
using SinCos = SinCosOf<scalar>;

/// Sine and cosine for |r| <= pi/4: the Taylor series, whose first term left out is below a quarter ulp. T: scalar or lane.
template <class T>
INGOT_INLINE constexpr SinCosOf<T> sin_cos_reduced(T r) {
    const T x = r * r;
    const scalar one = 1, half = scalar(0.5);
#if INGOT_DOUBLE
    const T s = r + r * x * (-one / 6 + x * (one / 120 + x * (-one / 5040 + x * (one / 362880 + x * (-one / 39916800 +
                x * (one / 6227020800 + x * (-one / 1307674368000 + x * (one / 355687428096000))))))));
    const T c = one - x * (half - x * (one / 24 + x * (-one / 720 + x * (one / 40320 + x * (-one / 3628800 +
                x * (one / 479001600 + x * (-one / 87178291200 + x * (one / 20922789888000))))))));
#else
    const T s = r + r * x * (-one / 6 + x * (one / 120 + x * (-one / 5040 + x * (one / 362880))));
    const T c = one - x * (half - x * (one / 24 + x * (-one / 720 + x * (one / 40320 + x * (-one / 3628800)))));
#endif
    return {s, c};
}

/// pi/2 in three parts (Cody and Waite). The first two are so short that a multiple of them by up to 1000 is exact.
#if INGOT_DOUBLE
inline constexpr scalar half_pi_1 = 0x1.921fb544p+0, half_pi_2 = 0x1.0b4611a6p-34, half_pi_3 = 0x1.3198a2e037073p-69;
#else
inline constexpr scalar half_pi_1 = 0x1.92p+0f, half_pi_2 = 0x1.fb4p-12f, half_pi_3 = 0x1.4442d2p-24f;
#endif

/// Sine and cosine of an angle, for set-up code: the step uses no trigonometry.
///
/// Units:  rad; valid for |angle| <= 1000, beyond it (and for NaN) both are NaN.
/// Error:  within 1 ulp of the larger of the result and 2^-20 (float) or 2^-50 (double), the same bits on every target; see host_tests/maths.
/// Method: reduction to |r| <= pi/4 by a three-part pi/2 (Cody and Waite), then the Taylor series, whose first term left
///         out is below a quarter ulp.
constexpr SinCos sin_cos(scalar angle) {
    if (!(angle >= -1000 && angle <= 1000)) return {(angle - angle) / (angle - angle), (angle - angle) / (angle - angle)};
    constexpr scalar two_over_pi = scalar(0.63661977236758134308);
    const scalar turns = angle * two_over_pi;
    const int quadrant = static_cast<int>(turns < 0 ? turns - scalar(0.5) : turns + scalar(0.5));
    const scalar q = static_cast<scalar>(quadrant);
    const scalar r = ((angle - q * half_pi_1) - q * half_pi_2) - q * half_pi_3;

    const auto [s, c] = sin_cos_reduced(r);
    switch (quadrant & 3) {
        case 0: return {s, c};
        case 1: return {c, -s};
        case 2: return {-s, -c};
        default: return {-c, s};
    }
}

} }  // namespace ingot

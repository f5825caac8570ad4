// SPDX-License-Identifier: MIT
#pragma once

#include "../base/config.h"

namespace ingot { inline namespace INGOT_ABI {

struct SinCos {
    scalar sin, cos;
};

/// Sine and cosine of an angle, for set-up code: the step uses no trigonometry.
///
/// Units:  rad; valid for |angle| <= 1000, beyond it (and for NaN) both are NaN.
/// Error:  within 1 ulp of the larger of the result and 2^-20 (float) or 2^-50 (double), the same bits on every target; see host_tests/maths.
/// Method: reduction to |r| <= pi/4 by a three-part pi/2 (Cody and Waite), then the Taylor series, whose first term left
///         out is below a quarter ulp.
constexpr SinCos sin_cos(scalar angle) {
    if (!(angle >= -1000 && angle <= 1000)) return {(angle - angle) / (angle - angle), (angle - angle) / (angle - angle)};
#if INGOT_DOUBLE
    // Each part has 32 or fewer significant bits, so that a whole multiple of it is exact.
    constexpr scalar half_pi_1 = 0x1.921fb544p+0, half_pi_2 = 0x1.0b4611a6p-34, half_pi_3 = 0x1.3198a2e037073p-69;
#else
    constexpr scalar half_pi_1 = 0x1.92p+0f, half_pi_2 = 0x1.fb4p-12f, half_pi_3 = 0x1.4442d2p-24f;
#endif
    constexpr scalar two_over_pi = scalar(0.63661977236758134308);
    const scalar turns = angle * two_over_pi;
    const int quadrant = static_cast<int>(turns < 0 ? turns - scalar(0.5) : turns + scalar(0.5));
    const scalar q = static_cast<scalar>(quadrant);
    const scalar r = ((angle - q * half_pi_1) - q * half_pi_2) - q * half_pi_3;

    const scalar x = r * r;
#if INGOT_DOUBLE
    const scalar s = r + r * x * (-1.0 / 6 + x * (1.0 / 120 + x * (-1.0 / 5040 + x * (1.0 / 362880 + x * (-1.0 / 39916800 +
                     x * (1.0 / 6227020800 + x * (-1.0 / 1307674368000 + x * (1.0 / 355687428096000))))))));
    const scalar c = 1 - x * (0.5 - x * (1.0 / 24 + x * (-1.0 / 720 + x * (1.0 / 40320 + x * (-1.0 / 3628800 +
                     x * (1.0 / 479001600 + x * (-1.0 / 87178291200 + x * (1.0 / 20922789888000))))))));
#else
    const scalar s = r + r * x * (-1.0f / 6 + x * (1.0f / 120 + x * (-1.0f / 5040 + x * (1.0f / 362880))));
    const scalar c = 1 - x * (0.5f - x * (1.0f / 24 + x * (-1.0f / 720 + x * (1.0f / 40320 + x * (-1.0f / 3628800)))));
#endif
    switch (quadrant & 3) {
        case 0: return {s, c};
        case 1: return {c, -s};
        case 2: return {-s, -c};
        default: return {-c, s};
    }
}

} }  // namespace ingot

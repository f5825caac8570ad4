// SPDX-License-Identifier: MIT
// The correctly rounded square root, without libm.
#pragma once

#include "lanes.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// Square root by shift and subtract, for cores without a floating-point unit: correctly rounded, so it gives the bits
/// that hardware gives. NaN and negative numbers give NaN, infinity gives infinity.
/// Cost: one bounded loop of 25 (float) or 54 (double) turns, about 300 instructions in float.
/// Source: the digit-by-digit method; agrees with the hardware for all 2^32 floats (host_tests/maths/sqrt_test.cpp).
scalar sqrt_by_digits(scalar x);

/// sqrt(x), correctly rounded on every target.
INGOT_INLINE scalar sqrt(scalar x) {
#if defined(__SOFTFP__) || (defined(__riscv) && !defined(__riscv_flen)) || defined(__mips_soft_float)
    return sqrt_by_digits(x);
#elif INGOT_DOUBLE
#if defined(__ARM_FP) && !(__ARM_FP & 8)
    return sqrt_by_digits(x);
#else
    return __builtin_sqrt(x);
#endif
#else
    return __builtin_sqrtf(x);
#endif
}

#if INGOT_LANES > 1
INGOT_INLINE lane sqrt(lane x) {
    for (int lane_i = 0; lane_i < lanes; ++lane_i) x[lane_i] = sqrt(static_cast<scalar>(x[lane_i]));
    return x;
}
#endif

} }  // namespace ingot

#pragma GCC diagnostic pop

// SPDX-License-Identifier: MIT
// The correctly rounded square root, without libm.
#pragma once

#include "lanes.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

// Whether the unit has the instruction for this scalar, and the compiler a word for it. Where the unit has not, compilers call the sqrt of libm, and
// C++17 has no other word; there, and on a target that is not known here, it is computed by digits, which is right everywhere.
#if INGOT_STANDARD_CPP
#define INGOT_SQRT_INSTRUCTION 0
#elif defined(__SSE2__) || defined(__aarch64__) || defined(__wasm__) || defined(__s390x__)
#define INGOT_SQRT_INSTRUCTION 1
#elif defined(__ARM_FP)
#define INGOT_SQRT_INSTRUCTION ((__ARM_FP & (INGOT_DOUBLE ? 8 : 4)) != 0)
#elif defined(__riscv_flen)
#define INGOT_SQRT_INSTRUCTION (__riscv_flen >= (INGOT_DOUBLE ? 64 : 32))
#elif defined(__mips_hard_float) && __mips >= 2 && !(INGOT_DOUBLE && defined(__mips_single_float))
#define INGOT_SQRT_INSTRUCTION 1
#elif defined(_ARCH_PPCSQ) && !defined(_SOFT_FLOAT)  // not the 603 and 750 families, to which GameCube and Wii belong
#define INGOT_SQRT_INSTRUCTION 1
#elif defined(__SH_FPU_DOUBLE__) || (defined(__SH4_SINGLE_ONLY__) && !INGOT_DOUBLE)
#define INGOT_SQRT_INSTRUCTION 1
#else
#define INGOT_SQRT_INSTRUCTION 0
#endif

/// Square root by shift and subtract, for cores without the instruction: correctly rounded, so it gives the bits that
/// hardware gives. NaN and negative numbers give NaN, infinity gives infinity.
/// Cost: one bounded loop of 25 (float) or 54 (double) turns, about 300 instructions in float.
/// Source: the digit-by-digit method; agrees with the hardware for all 2^32 floats (host_tests/maths/sqrt_test.cpp).
scalar sqrt_by_digits(scalar x);

/// sqrt(x), correctly rounded on every target.
INGOT_INLINE scalar sqrt(scalar x) {
#if !INGOT_SQRT_INSTRUCTION
    return sqrt_by_digits(x);
#elif INGOT_DOUBLE
    return __builtin_sqrt(x);
#else
    return __builtin_sqrtf(x);
#endif
}

#if INGOT_LANES > 1
/// The same in each lane.
INGOT_INLINE lane sqrt(lane x) {
    for (int lane_i = 0; lane_i < lanes; ++lane_i) x[lane_i] = sqrt(static_cast<scalar>(x[lane_i]));
    return x;
}
#endif

} }  // namespace ingot

#pragma GCC diagnostic pop

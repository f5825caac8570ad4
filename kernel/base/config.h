// SPDX-License-Identifier: MIT
// What is fixed when the library is built: the scalar type, the number of lanes, the floating-point contract.
#pragma once

#include <float.h>
#include <stdint.h>

/// Bodies advanced side by side by one instruction: 1, 2, 4, 8 or 16. Results do not depend on it.
#ifndef INGOT_LANES
#define INGOT_LANES 1
#endif

/// 0: the scalar is float; 1: double.
#ifndef INGOT_DOUBLE
#define INGOT_DOUBLE 0
#endif

#ifdef __FAST_MATH__
#error "ingot: -ffast-math changes results from compiler to compiler; build without it"
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error "ingot: this target rounds in registers wider than the type (x87, 68881); use -msse2 -mfpmath=sse or the like"
#endif

#define INGOT_JOIN_(a, b, c) a##b##c
#define INGOT_JOIN(a, b, c) INGOT_JOIN_(a, b, c)

/// Part of every symbol's name, so that objects built for other scalars or lane counts do not link.
#if INGOT_DOUBLE
#define INGOT_ABI INGOT_JOIN(f64x, INGOT_LANES, )
#else
#define INGOT_ABI INGOT_JOIN(f32x, INGOT_LANES, )
#endif

/// Helpers over lanes are inlined at every level: a vector passed by value across a call is an ABI trap. With one lane and
/// -Os the compiler may keep them apart, which halves the code of a core without a floating-point unit.
#if INGOT_LANES == 1 && defined(__OPTIMIZE_SIZE__)
#define INGOT_INLINE inline
#else
#define INGOT_INLINE inline __attribute__((always_inline))
#endif

namespace ingot { inline namespace INGOT_ABI {

#if INGOT_DOUBLE
using scalar = double;
inline constexpr scalar epsilon = DBL_EPSILON;
inline constexpr scalar scalar_max = DBL_MAX;
#else
using scalar = float;
inline constexpr scalar epsilon = FLT_EPSILON;
inline constexpr scalar scalar_max = FLT_MAX;
#endif

inline constexpr int lanes = INGOT_LANES;
static_assert(lanes == 1 || lanes == 2 || lanes == 4 || lanes == 8 || lanes == 16, "INGOT_LANES is 1, 2, 4, 8 or 16");
static_assert(sizeof(float) == 4 && sizeof(double) == 8, "ingot needs IEEE 754 single and double precision");

} }  // namespace ingot

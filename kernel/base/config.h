// SPDX-License-Identifier: MIT
// What is fixed when the library is built: the scalar type, the number of lanes, the floating-point contract.
#pragma once

#include "compiler.h"

#include <float.h>
#include <stdint.h>

/// Bodies advanced side by side by one instruction: 1, 2, 4, 8 or 16. Results do not depend on it.
#ifndef INGOT_LANES
#define INGOT_LANES 1
#endif

/// Bits of the numbers that name bodies, shapes, pairs and manifolds: 16, or 32 for worlds of more than 65535 of any of them.
#ifndef INGOT_INDEX_BITS
#define INGOT_INDEX_BITS 16
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

// Units that flush denormals whatever their control register says, and that compilers use unasked, at -O2 or with lanes.
#if defined(__ARM_FEATURE_MVE) && (__ARM_FEATURE_MVE & 2)
#error "ingot: the vector floats of this core (MVE) flush denormals; build for it without them: -mcpu=cortex-m55+nomve.fp"
#endif
#if defined(__ALTIVEC__) && !defined(__VSX__)
#error "ingot: the vector floats of this core (AltiVec) flush denormals; build without them: -mno-altivec"
#endif
#if defined(__clang__) && defined(__ARM_NEON) && !defined(__aarch64__)
#error "ingot: the vector floats of this core (NEON) flush denormals, and clang uses them; build for it without them: -mfpu=vfpv3-d16"
#endif

// Numbers whose exponents are 33 apart and whose difference loses its leading bit: __adddf3 of libgcc keeps one bit of the
// smaller one beyond the last place, where two are needed (0x1.fa8658p-16 - 0x1p17 is wrong by one place, GCC 12). The
// library of cores without Thumb-2 has another __adddf3, which is right. What needs doubles in float builds adds by itself there: math/wide.h.
#if defined(__arm__) && !(defined(__ARM_FP) && (__ARM_FP & 8)) && \
    (defined(__ARM_ARCH_ISA_ARM) || !defined(__ARM_ARCH_ISA_THUMB) || __ARM_ARCH_ISA_THUMB > 1)
#define INGOT_DOUBLES_ADD_WRONGLY 1
#if INGOT_DOUBLE
#error "ingot: without a double unit libgcc adds doubles on this core, and rounds wrongly; build for float"
#endif
#endif

#define INGOT_JOIN_(a, b, c) a##b##c
#define INGOT_JOIN(a, b, c) INGOT_JOIN_(a, b, c)

#if INGOT_INDEX_BITS == 16
#define INGOT_ABI_INDEX
#elif INGOT_INDEX_BITS == 32
#define INGOT_ABI_INDEX i32
#else
#error "ingot: INGOT_INDEX_BITS is 16 or 32"
#endif

/// Part of every symbol's name, so that objects built for other scalars, lane counts or widths of indices do not link.
#if INGOT_DOUBLE
#define INGOT_ABI INGOT_JOIN(f64x, INGOT_LANES, INGOT_ABI_INDEX)
#else
#define INGOT_ABI INGOT_JOIN(f32x, INGOT_LANES, INGOT_ABI_INDEX)
#endif

/// Helpers over lanes are inlined at every level: a vector passed by value across a call is an ABI trap. With one lane and
/// -Os the compiler may keep them apart, which halves the code of a core without a floating-point unit. With one, calls of helpers
/// are longer than helpers where much is computed: INGOT_INLINE_ALWAYS is set for those files. Sanitized builds of this project call
/// helpers, INGOT_CALLS_HELPERS: inlined and watched, a sweep takes thirty times as long to compile.
#if defined(INGOT_CALLS_HELPERS) || (INGOT_LANES == 1 && defined(__OPTIMIZE_SIZE__) && !defined(INGOT_INLINE_ALWAYS))
#define INGOT_INLINE inline
#else
#define INGOT_INLINE INGOT_ALWAYS_INLINE
#endif

/// A part of one function, that has a name of its own for readers: inlined on every target.
#define INGOT_PART INGOT_ALWAYS_INLINE

/// Code of sweeps that runs rarely. With one lane it is a function of its own, small, and one for all its callers; vectors do not
/// cross calls.
#if INGOT_LANES == 1 || defined(INGOT_CALLS_HELPERS)
#define INGOT_RARE INGOT_NOINLINE INGOT_COLD inline
#else
#define INGOT_RARE INGOT_INLINE
#endif
/// Helpers that are longer than their calls. With one lane, files that are compiled for size call them, and one copy serves all.
#if INGOT_LANES == 1 && defined(__OPTIMIZE_SIZE__)
#define INGOT_LONG_HELPER INGOT_NOINLINE inline
#else
#define INGOT_LONG_HELPER INGOT_INLINE
#endif
/// Code that is long, and called in several places. With one lane it is there once.
#if INGOT_LANES == 1 || defined(INGOT_CALLS_HELPERS)
#define INGOT_SHARED INGOT_NOINLINE inline
#else
#define INGOT_SHARED INGOT_INLINE
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

/// Of a body, shape, pair, manifold, contact, island; and how many there are. With 32 bits a world holds up to index_max of each, as far as there is
/// memory.
#if INGOT_INDEX_BITS == 16
using Index = uint16_t;
using PairKey = uint32_t;  ///< of two indices
inline constexpr int index_max = 65535;
#else
using Index = int32_t;
using PairKey = uint64_t;
inline constexpr int index_max = (1 << 24) - 1;
#endif

constexpr PairKey key_of(Index a, Index b) { return static_cast<PairKey>(a) << INGOT_INDEX_BITS | static_cast<PairKey>(b); }
static_assert(lanes == 1 || lanes == 2 || lanes == 4 || lanes == 8 || lanes == 16, "INGOT_LANES is 1, 2, 4, 8 or 16");
static_assert(sizeof(float) == 4 && sizeof(double) == 8, "ingot needs IEEE 754 single and double precision");

} }  // namespace ingot

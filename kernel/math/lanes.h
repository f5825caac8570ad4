// SPDX-License-Identifier: MIT
// The lane type: one number, or `lanes` numbers that one instruction works on. The only file that knows vector types; plain_lanes.h has the same
// without them, for compilers that have none.
//
// Written with the compiler's vectors, not with intrinsics, so that one source serves SSE, AVX, NEON and wasm, but for what
// no such vector says: which lanes of a mask are set. With one lane it is the plain scalar. Every function is documented by what
// it does in one lane. Control flow may depend on any() of a mask, data may not: a lane that is done is frozen with select(), so
// that its bits do not depend on its neighbours.
#pragma once

#include "../base/config.h"
#include "plain_lanes.h"

/// 1: lanes are a vector of the compiler's.
#define INGOT_VECTORS (INGOT_LANES > 1 && !INGOT_STANDARD_CPP)

// Vectors never cross a call that is not inlined, so it does not matter how such a call would pass them.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

namespace ingot { inline namespace INGOT_ABI {

/// a where m, else b.
INGOT_INLINE constexpr scalar select(bool m, scalar a, scalar b) { return m ? a : b; }
INGOT_INLINE constexpr bool any(bool m) { return m; }
/// One bit per lane of the mask, lane 0 lowest.
INGOT_INLINE constexpr uint16_t bits(bool m) { return m ? 1 : 0; }

#if INGOT_LANES == 1

using lane = scalar;
using mask = bool;

INGOT_INLINE lane load(const scalar* from) { return *from; }
INGOT_INLINE void store(scalar* to, lane value) { *to = value; }
INGOT_INLINE mask mask_from_bits(uint16_t b) { return (b & 1u) != 0; }

#elif INGOT_VECTORS

typedef scalar lane __attribute__((vector_size(sizeof(scalar) * lanes)));
using mask = decltype(lane{} < lane{});

INGOT_INLINE lane load(const scalar* from) {
    lane value;
    INGOT_COPY_BYTES(&value, from, sizeof value);
    return value;
}
INGOT_INLINE void store(scalar* to, lane value) { INGOT_COPY_BYTES(to, &value, sizeof value); }
INGOT_INLINE lane select(mask m, lane a, lane b) { return m ? a : b; }

// The signs of a mask, lane 0 lowest, by the one instruction that SSE and AVX have for it.
#if defined(__SSE__) && !INGOT_DOUBLE && INGOT_LANES == 4
#define INGOT_SIGNS_OF(m) __builtin_ia32_movmskps(reinterpret_cast<lane>(m))
#elif defined(__SSE2__) && INGOT_DOUBLE && INGOT_LANES == 2
#define INGOT_SIGNS_OF(m) __builtin_ia32_movmskpd(reinterpret_cast<lane>(m))
#elif defined(__AVX__) && !INGOT_DOUBLE && INGOT_LANES == 8
#define INGOT_SIGNS_OF(m) __builtin_ia32_movmskps256(reinterpret_cast<lane>(m))
#elif defined(__AVX__) && INGOT_DOUBLE && INGOT_LANES == 4
#define INGOT_SIGNS_OF(m) __builtin_ia32_movmskpd256(reinterpret_cast<lane>(m))
#endif
INGOT_INLINE bool any(mask m) {
#ifdef INGOT_SIGNS_OF
    return INGOT_SIGNS_OF(m) != 0;
#else
    uint64_t words[sizeof(mask) / 8];
    INGOT_COPY_BYTES(words, &m, sizeof m);
    uint64_t all = 0;
    for (uint64_t word : words) all |= word;
    return all != 0;
#endif
}
INGOT_INLINE uint16_t bits(mask m) {
#ifdef INGOT_SIGNS_OF
    return static_cast<uint16_t>(INGOT_SIGNS_OF(m));
#else
    uint16_t b = 0;
    if (!any(m)) return b;  // by far the most frequent answer, and lanes are looked at one by one
    for (int lane_i = 0; lane_i < lanes; ++lane_i) b = static_cast<uint16_t>(b | (m[lane_i] != 0 ? 1u << lane_i : 0u));
    return b;
#endif
}
INGOT_INLINE mask mask_from_bits(uint16_t b) {
    mask of_lane{};
    for (int lane_i = 0; lane_i < lanes; ++lane_i) of_lane[lane_i] = 1 << lane_i;
    return ((mask{} + static_cast<int>(b)) & of_lane) != 0;
}

#if INGOT_LANES == 4 || INGOT_LANES == 8
typedef scalar quad __attribute__((vector_size(4 * sizeof(scalar))));

/// Rows of four numbers become columns, and the other way round.
INGOT_INLINE void transpose(quad& a, quad& b, quad& c, quad& d) {
    const quad ab_0 = __builtin_shufflevector(a, b, 0, 4, 1, 5), ab_2 = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    const quad cd_0 = __builtin_shufflevector(c, d, 0, 4, 1, 5), cd_2 = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    a = __builtin_shufflevector(ab_0, cd_0, 0, 1, 4, 5);
    b = __builtin_shufflevector(ab_0, cd_0, 2, 3, 6, 7);
    c = __builtin_shufflevector(ab_2, cd_2, 0, 1, 4, 5);
    d = __builtin_shufflevector(ab_2, cd_2, 2, 3, 6, 7);
}
#endif

#endif

/// `lanes` numbers of a struct, aligned as vectors are: an instruction takes them from memory as they are.
struct alignas(sizeof(scalar) * static_cast<unsigned>(lanes)) LaneRow {
    scalar at[lanes];

    INGOT_INLINE scalar& operator[](int lane_i) { return at[lane_i]; }
    INGOT_INLINE const scalar& operator[](int lane_i) const { return at[lane_i]; }
};
#if !INGOT_VECTORS
INGOT_INLINE lane load(const LaneRow& from) { return load(from.at); }
INGOT_INLINE void store(LaneRow& to, lane value) { store(to.at, value); }
#else
typedef lane lane_of_row __attribute__((may_alias));
INGOT_INLINE lane load(const LaneRow& from) { return *reinterpret_cast<const lane_of_row*>(&from); }
INGOT_INLINE void store(LaneRow& to, lane value) { *reinterpret_cast<lane_of_row*>(&to) = value; }
#endif

/// Four numbers from each of `lanes` places, one place per lane.
struct LaneQuad {
    lane at[4];
};

/// place(lane_i) points to the four numbers of a lane.
template <class Place>
INGOT_INLINE LaneQuad gather4(const Place& place) {
    LaneQuad to;
#if INGOT_VECTORS && (INGOT_LANES == 4 || INGOT_LANES == 8)
    quad rows[lanes];
    for (int lane_i = 0; lane_i < lanes; ++lane_i) INGOT_COPY_BYTES(&rows[lane_i], place(lane_i), sizeof(quad));
    for (int lane_i = 0; lane_i < lanes; lane_i += 4) transpose(rows[lane_i], rows[lane_i + 1], rows[lane_i + 2], rows[lane_i + 3]);
    for (int i = 0; i < 4; ++i) {
#if INGOT_LANES == 8
        to.at[i] = __builtin_shufflevector(rows[i], rows[4 + i], 0, 1, 2, 3, 4, 5, 6, 7);
#else
        to.at[i] = rows[i];
#endif
    }
#else
    scalar rows[4][lanes];
    for (int lane_i = 0; lane_i < lanes; ++lane_i)
        for (int i = 0; i < 4; ++i) rows[i][lane_i] = place(lane_i)[i];
    for (int i = 0; i < 4; ++i) to.at[i] = load(rows[i]);
#endif
    return to;
}

/// The reverse. Lanes that share a place must hold the same numbers.
template <class Place>
INGOT_INLINE void scatter4(const LaneQuad& from, const Place& place) {
#if INGOT_VECTORS && (INGOT_LANES == 4 || INGOT_LANES == 8)
    quad rows[lanes];
    for (int i = 0; i < 4; ++i) {
#if INGOT_LANES == 8
        rows[i] = __builtin_shufflevector(from.at[i], from.at[i], 0, 1, 2, 3);
        rows[4 + i] = __builtin_shufflevector(from.at[i], from.at[i], 4, 5, 6, 7);
#else
        rows[i] = from.at[i];
#endif
    }
    for (int lane_i = 0; lane_i < lanes; lane_i += 4) transpose(rows[lane_i], rows[lane_i + 1], rows[lane_i + 2], rows[lane_i + 3]);
    for (int lane_i = 0; lane_i < lanes; ++lane_i) INGOT_COPY_BYTES(place(lane_i), &rows[lane_i], sizeof(quad));
#else
    scalar rows[4][lanes];
    for (int i = 0; i < 4; ++i) store(rows[i], from.at[i]);
    for (int lane_i = 0; lane_i < lanes; ++lane_i)
        for (int i = 0; i < 4; ++i) place(lane_i)[i] = rows[i][lane_i];
#endif
}

/// The same value in every lane.
template <class T>
INGOT_INLINE constexpr T splat(scalar value) {
    return value - T{};  // 0 + value would be an addition at run time, which turns -0 into +0; this is value
}

/// True where both, where either is true, where it is not. (Operators do not fit: && is for bool, & for vectors.)
INGOT_INLINE constexpr bool both(bool a, bool b) { return a && b; }
INGOT_INLINE constexpr bool either(bool a, bool b) { return a || b; }
INGOT_INLINE constexpr bool opposite(bool a) { return !a; }
#if INGOT_VECTORS
INGOT_INLINE mask both(mask a, mask b) { return a & b; }
INGOT_INLINE mask either(mask a, mask b) { return a | b; }
INGOT_INLINE mask opposite(mask a) { return ~a; }
#endif

#if INGOT_STANDARD_CPP
INGOT_INLINE constexpr scalar abs(scalar x) { return x < 0 ? -x : x == 0 ? scalar(0) : x; }  // of -0 too, which is not below 0
#elif INGOT_DOUBLE
INGOT_INLINE constexpr scalar abs(scalar x) { return __builtin_fabs(x); }
#else
INGOT_INLINE constexpr scalar abs(scalar x) { return __builtin_fabsf(x); }
#endif
INGOT_INLINE constexpr scalar min(scalar a, scalar b) { return a < b ? a : b; }
INGOT_INLINE constexpr scalar max(scalar a, scalar b) { return a > b ? a : b; }
/// To -limit .. limit.
INGOT_INLINE constexpr scalar clamp(scalar x, scalar limit) { return min(max(x, -limit), limit); }
#if INGOT_LANES > 1
INGOT_INLINE lane min(lane a, lane b) { return select(a < b, a, b); }
INGOT_INLINE lane max(lane a, lane b) { return select(a > b, a, b); }
INGOT_INLINE lane clamp(lane x, lane limit) { return min(max(x, -limit), limit); }
#endif

/// True where x is neither NaN nor infinite. Comparisons only: no unit raises a flag, and without a unit they are cheap.
INGOT_INLINE constexpr bool is_finite(scalar x) { return abs(x) <= scalar_max; }

#if INGOT_LANES > 1
INGOT_INLINE lane abs(lane x) {
#if INGOT_VECTORS
    const mask sign = reinterpret_cast<mask>(-lane{});  // the bits of -0
    return reinterpret_cast<lane>(reinterpret_cast<mask>(x) & ~sign);
#else
    return each_lane([&](int lane_i) { return abs(x.at[lane_i]); });
#endif
}
INGOT_INLINE mask is_finite(lane x) { return abs(x) <= splat<lane>(scalar_max); }
#endif

} }  // namespace ingot

#pragma GCC diagnostic pop

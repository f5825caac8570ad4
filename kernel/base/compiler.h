// SPDX-License-Identifier: MIT
// What the kernel asks of a compiler beyond C++17: one door each, and a plain way behind it.
//
// GCC and clang, clang-cl too, and what understands their words, take those: vectors, inlining that is certain, instructions by name. Any other takes
// plain C++17, and so does every compiler that is told so: -DINGOT_STANDARD_CPP=1, in all units of a program. Bits are the same.
//
// Without vectors one lane is the better choice: a pyramid of 210 cubes takes 2.4 times the instructions of 4 lanes of vectors, and 4.3 times with 4
// lanes that are none (GCC 12, x86-64, -O2).
#pragma once

#include <stddef.h>
#include <stdint.h>

/// 1: no word beyond C++17.
#ifndef INGOT_STANDARD_CPP
#if defined(__GNUC__) || defined(__clang__)
#define INGOT_STANDARD_CPP 0
#else
#define INGOT_STANDARD_CPP 1
#endif
#endif

#if INGOT_STANDARD_CPP

#include <limits>

#define INGOT_ALWAYS_INLINE inline
#define INGOT_NOINLINE
#define INGOT_COLD
#define INGOT_IS_BASE_OF(Base, T) ::ingot::plain::is_base_of<Base, T>
#define INGOT_NAN(scalar) ::std::numeric_limits<scalar>::quiet_NaN()
#define INGOT_COPY_BYTES(to, from, size) ::ingot::plain::copy_bytes(to, from, size)
#define INGOT_CLEAR_BYTES(to, size) ::ingot::plain::clear_bytes(to, size)
#define INGOT_SAME_BYTES(a, b, size) ::ingot::plain::same_bytes(a, b, size)
#define INGOT_LOWEST_BIT(word) ::ingot::plain::lowest_bit(word)
#define INGOT_ZEROS_ABOVE(word) ::ingot::plain::zeros_above(word)

/// Not within the namespace of INGOT_ABI: nothing here depends on scalar or lanes.
namespace ingot { namespace plain {

inline void copy_bytes(void* to, const void* from, size_t size) {
    // bound: size, of an object
    for (size_t i = 0; i < size; ++i) static_cast<unsigned char*>(to)[i] = static_cast<const unsigned char*>(from)[i];
}
inline void clear_bytes(void* to, size_t size) {
    for (size_t i = 0; i < size; ++i) static_cast<unsigned char*>(to)[i] = 0;  // bound: size, of an object
}
inline bool same_bytes(const void* a, const void* b, size_t size) {
    bool same = true;
    // bound: size, of an object
    for (size_t i = 0; i < size; ++i) same = same && static_cast<const unsigned char*>(a)[i] == static_cast<const unsigned char*>(b)[i];
    return same;
}

/// Of a word that is not 0.
inline int lowest_bit(uint32_t word) {
    int bit = 0;
    for (; (word & 1u) == 0; word >>= 1) ++bit;  // bound: 31: a bit is set
    return bit;
}
/// Bits above the highest one, of a word that is not 0.
inline int zeros_above(uint64_t word) {
    int zeros = 0;
    for (; word >> 63 == 0; word <<= 1) ++zeros;  // bound: 63: a bit is set
    return zeros;
}

struct Yes {
    char bytes[2];
};
template <class Base>
Yes converts(const volatile Base*);
template <class Base>
char converts(...);
template <class Base, class T>
constexpr bool is_base_of = sizeof(converts<Base>(static_cast<T*>(nullptr))) == sizeof(Yes);

} }  // namespace ingot::plain

#else

#define INGOT_ALWAYS_INLINE inline __attribute__((always_inline))
#define INGOT_NOINLINE __attribute__((noinline))
#define INGOT_COLD __attribute__((cold))
#define INGOT_IS_BASE_OF(Base, T) __is_base_of(Base, T)
#define INGOT_NAN(scalar) static_cast<scalar>(__builtin_nanf(""))
#define INGOT_COPY_BYTES(to, from, size) __builtin_memcpy(to, from, size)
#define INGOT_CLEAR_BYTES(to, size) __builtin_memset(to, 0, size)
#define INGOT_SAME_BYTES(a, b, size) (__builtin_memcmp(a, b, size) == 0)
#define INGOT_LOWEST_BIT(word) __builtin_ctz(word)
#define INGOT_ZEROS_ABOVE(word) __builtin_clzll(word)

#endif

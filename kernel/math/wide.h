// SPDX-License-Identifier: MIT
// Doubles for what solves in double whatever the scalar: the direct solver.
//
// Where libgcc adds doubles and rounds wrongly (base/config.h), sums are formed in integers, to the bits that hardware gives.
#pragma once

#include <stdint.h>

#include "../base/config.h"
#include "lanes.h"

namespace ingot { inline namespace INGOT_ABI {

/// a + b of doubles that are finite or not, rounded to nearest, ties to even, in integers; every NaN is the same one.
double sum_in_integers(double a, double b);

/// A double whose sums are formed by sum_in_integers. Products, quotients and comparisons are the compiler's.
struct OwnDouble {
    double value;

    OwnDouble() = default;
    constexpr OwnDouble(double x) : value(x) {}
    constexpr OwnDouble(float x) : value(static_cast<double>(x)) {}
    constexpr OwnDouble(int x) : value(static_cast<double>(x)) {}
    explicit constexpr operator double() const { return value; }
    explicit constexpr operator float() const { return static_cast<float>(value); }

    friend OwnDouble operator+(OwnDouble a, OwnDouble b) { return sum_in_integers(a.value, b.value); }
    friend OwnDouble operator-(OwnDouble a, OwnDouble b) { return sum_in_integers(a.value, -b.value); }
    friend constexpr OwnDouble operator-(OwnDouble a) { return -a.value; }
    friend constexpr OwnDouble operator*(OwnDouble a, OwnDouble b) { return a.value * b.value; }
    friend constexpr OwnDouble operator/(OwnDouble a, OwnDouble b) { return a.value / b.value; }
    OwnDouble& operator+=(OwnDouble b) { return *this = *this + b; }
    OwnDouble& operator-=(OwnDouble b) { return *this = *this - b; }
    OwnDouble& operator*=(OwnDouble b) { return *this = *this * b; }

    friend constexpr bool operator<(OwnDouble a, OwnDouble b) { return a.value < b.value; }
    friend constexpr bool operator>(OwnDouble a, OwnDouble b) { return a.value > b.value; }
    friend constexpr bool operator<=(OwnDouble a, OwnDouble b) { return a.value <= b.value; }
    friend constexpr bool operator>=(OwnDouble a, OwnDouble b) { return a.value >= b.value; }
    friend constexpr bool operator==(OwnDouble a, OwnDouble b) { return a.value == b.value; }
    friend constexpr bool operator!=(OwnDouble a, OwnDouble b) { return a.value != b.value; }
};

#if defined(INGOT_DOUBLES_ADD_WRONGLY)
using wide_scalar = OwnDouble;
#else
using wide_scalar = double;
#endif

#if !INGOT_DOUBLE || defined(INGOT_DOUBLES_ADD_WRONGLY)  // else they are those of the scalar: lanes.h
inline wide_scalar max(wide_scalar a, wide_scalar b) { return a > b ? a : b; }
inline wide_scalar abs(wide_scalar a) { return a < 0 ? -a : a; }
inline wide_scalar clamp(wide_scalar x, wide_scalar limit) { return x > limit ? limit : x < -limit ? -limit : x; }
#endif

} }  // namespace ingot

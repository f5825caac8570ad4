// SPDX-License-Identifier: MIT
#pragma once

#include "lanes.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// A column of three numbers. T is the scalar, or the lane: then one Vec3 holds a vector of each of `lanes` bodies.
template <class T>
struct Vec3 {
    T x, y, z;  ///< component

    INGOT_INLINE constexpr Vec3& operator+=(const Vec3& b) { return *this = *this + b; }  ///< by components
    INGOT_INLINE constexpr Vec3& operator-=(const Vec3& b) { return *this = *this - b; }  ///< by components

    INGOT_INLINE friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }  ///< by components
    INGOT_INLINE friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }  ///< by components
    INGOT_INLINE friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }  ///< the other way
    INGOT_INLINE friend constexpr Vec3 operator*(const Vec3& a, T s) { return {a.x * s, a.y * s, a.z * s}; }  ///< each component times s
    INGOT_INLINE friend constexpr Vec3 operator*(T s, const Vec3& a) { return a * s; }  ///< the same
};

using Vector = Vec3<scalar>;  ///< of one body, point or direction

/// a . b
template <class T>
INGOT_INLINE constexpr T dot(const Vec3<T>& a, const Vec3<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// a x b: at right angles to both; of the right hand. tilde(a) b, dr/dt = omega x r (Hecker 1997, Eq. 7).
template <class T>
INGOT_INLINE constexpr Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Component by component; the product of a diagonal matrix and a column.
template <class T>
INGOT_INLINE constexpr Vec3<T> scaled(const Vec3<T>& diagonal, const Vec3<T>& b) {
    return {diagonal.x * b.x, diagonal.y * b.y, diagonal.z * b.z};
}
/// The inverse of a diagonal matrix times b.
template <class T>
INGOT_INLINE constexpr Vec3<T> unscaled(const Vec3<T>& diagonal, const Vec3<T>& b) {
    return {b.x / diagonal.x, b.y / diagonal.y, b.z / diagonal.z};
}

/// Component by component.
template <class T>
INGOT_INLINE constexpr Vec3<T> min(const Vec3<T>& a, const Vec3<T>& b) {
    return {min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)};
}
/// The greater of each component.
template <class T>
INGOT_INLINE constexpr Vec3<T> max(const Vec3<T>& a, const Vec3<T>& b) {
    return {max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)};
}

/// |a|^2
template <class T>
INGOT_INLINE constexpr T length_sq(const Vec3<T>& a) {
    return dot(a, a);
}

/// True where all three components are neither NaN nor infinite.
template <class T>
INGOT_INLINE constexpr auto is_finite(const Vec3<T>& a) {
    return both(both(is_finite(a.x), is_finite(a.y)), is_finite(a.z));
}

/// a where m holds, else b; of one body, or in each lane.
template <class M, class T>
INGOT_INLINE constexpr Vec3<T> select(M m, const Vec3<T>& a, const Vec3<T>& b) {
    return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}

/// Three rows of `lanes` numbers: Row is LaneRow, or scalar[lanes].
template <class Row>
INGOT_INLINE Vec3<lane> load(const Row (&from)[3]) {
    return {load(from[0]), load(from[1]), load(from[2])};
}
template <class Row>
INGOT_INLINE void store(Row (&to)[3], const Vec3<lane>& value) {
    store(to[0], value.x);
    store(to[1], value.y);
    store(to[2], value.z);
}

} }  // namespace ingot

#pragma GCC diagnostic pop

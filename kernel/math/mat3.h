// SPDX-License-Identifier: MIT
#pragma once

#include "vec3.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// A 3x3 matrix by columns. As an orientation its columns are the body's axes seen from the world.
template <class T>
struct Mat3 {
    Vec3<T> c0, c1, c2;  ///< column

    INGOT_INLINE friend constexpr Mat3 operator+(const Mat3& a, const Mat3& b) { return {a.c0 + b.c0, a.c1 + b.c1, a.c2 + b.c2}; }  ///< by entries
    INGOT_INLINE friend constexpr Mat3 operator-(const Mat3& a, const Mat3& b) { return {a.c0 - b.c0, a.c1 - b.c1, a.c2 - b.c2}; }  ///< by entries
    INGOT_INLINE friend constexpr Mat3 operator*(const Mat3& a, T s) { return {a.c0 * s, a.c1 * s, a.c2 * s}; }  ///< each entry times s
    /// A v: what it turns v into.
    INGOT_INLINE friend constexpr Vec3<T> operator*(const Mat3& a, const Vec3<T>& v) {
        return a.c0 * v.x + a.c1 * v.y + a.c2 * v.z;
    }
    INGOT_INLINE friend constexpr Mat3 operator*(const Mat3& a, const Mat3& b) { return {a * b.c0, a * b.c1, a * b.c2}; }  ///< matrix product
};

using Matrix = Mat3<scalar>;  ///< of one body: as a rotation, body to world

/// A^T v: for an orientation, a world vector seen from the body.
template <class T>
INGOT_INLINE constexpr Vec3<T> transpose_times(const Mat3<T>& a, const Vec3<T>& v) {
    return {dot(a.c0, v), dot(a.c1, v), dot(a.c2, v)};
}

/// a^T, which of a rotation is the way back.
template <class T>
INGOT_INLINE constexpr Mat3<T> transposed(const Mat3<T>& a) {
    return {{a.c0.x, a.c1.x, a.c2.x}, {a.c0.y, a.c1.y, a.c2.y}, {a.c0.z, a.c1.z, a.c2.z}};
}

/// 1 of a rotation, -1 of a mirror.
template <class T>
INGOT_INLINE constexpr T determinant(const Mat3<T>& a) {
    return dot(a.c0, cross(a.c1, a.c2));
}

/// No turn.
template <class T>
INGOT_INLINE constexpr Mat3<T> identity_matrix() {
    const T zero{}, one = splat<T>(1);
    return {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
}

/// All entries are.
template <class T>
INGOT_INLINE constexpr auto is_finite(const Mat3<T>& a) {
    return both(both(is_finite(a.c0), is_finite(a.c1)), is_finite(a.c2));
}

/// a where m holds, else b; of one body, or in each lane.
template <class M, class T>
INGOT_INLINE constexpr Mat3<T> select(M m, const Mat3<T>& a, const Mat3<T>& b) {
    return {select(m, a.c0, b.c0), select(m, a.c1, b.c1), select(m, a.c2, b.c2)};
}

/// Nine rows of `lanes` numbers, column after column: Row is LaneRow, or scalar[lanes].
template <class Row>
INGOT_INLINE Mat3<lane> load(const Row (&from)[9]) {
    return {{load(from[0]), load(from[1]), load(from[2])},
            {load(from[3]), load(from[4]), load(from[5])},
            {load(from[6]), load(from[7]), load(from[8])}};
}
template <class Row>
INGOT_INLINE void store(Row (&to)[9], const Mat3<lane>& value) {
    const Vec3<lane> columns[3] = {value.c0, value.c1, value.c2};
    for (int column_i = 0; column_i < 3; ++column_i) {
        store(to[3 * column_i], columns[column_i].x);
        store(to[3 * column_i + 1], columns[column_i].y);
        store(to[3 * column_i + 2], columns[column_i].z);
    }
}

} }  // namespace ingot

#pragma GCC diagnostic pop

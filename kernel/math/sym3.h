// SPDX-License-Identifier: MIT
#pragma once

#include "mat3.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// A symmetric 3x3 matrix: an inertia tensor or its inverse. The entries are the tensor's own (products of inertia with
/// their minus sign inside).
template <class T>
struct Sym3 {
    T xx, yy, zz, xy, xz, yz;  ///< entry

    /// By entries.
    INGOT_INLINE friend constexpr Sym3 operator+(const Sym3& a, const Sym3& b) {
        return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
    }
    /// By entries.
    INGOT_INLINE friend constexpr Sym3 operator-(const Sym3& a, const Sym3& b) {
        return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy, a.xz - b.xz, a.yz - b.yz};
    }
    /// Each entry times s.
    INGOT_INLINE friend constexpr Sym3 operator*(const Sym3& a, T s) {
        return {a.xx * s, a.yy * s, a.zz * s, a.xy * s, a.xz * s, a.yz * s};
    }
    /// Matrix times vector.
    INGOT_INLINE friend constexpr Vec3<T> operator*(const Sym3& a, const Vec3<T>& v) {
        return {a.xx * v.x + a.xy * v.y + a.xz * v.z, a.xy * v.x + a.yy * v.y + a.yz * v.z, a.xz * v.x + a.yz * v.y + a.zz * v.z};
    }
};

using SymmetricMatrix = Sym3<scalar>;  ///< of one body: a tensor of inertia

/// A diag(d) A^T: a tensor known in its principal axes, seen from the world (Hecker 1997, Eq. 2).
template <class T>
INGOT_INLINE constexpr Sym3<T> rotated_diagonal(const Mat3<T>& a, const Vec3<T>& d) {
    const Vec3<T> c0 = a.c0 * d.x, c1 = a.c1 * d.y, c2 = a.c2 * d.z;
    return {c0.x * a.c0.x + c1.x * a.c1.x + c2.x * a.c2.x, c0.y * a.c0.y + c1.y * a.c1.y + c2.y * a.c2.y,
            c0.z * a.c0.z + c1.z * a.c1.z + c2.z * a.c2.z, c0.x * a.c0.y + c1.x * a.c1.y + c2.x * a.c2.y,
            c0.x * a.c0.z + c1.x * a.c1.z + c2.x * a.c2.z, c0.y * a.c0.z + c1.y * a.c1.z + c2.y * a.c2.z};
}

/// A^T A, for an A by columns.
template <class T>
INGOT_INLINE constexpr Sym3<T> gram(const Mat3<T>& a) {
    return {dot(a.c0, a.c0), dot(a.c1, a.c1), dot(a.c2, a.c2), dot(a.c0, a.c1), dot(a.c0, a.c2), dot(a.c1, a.c2)};
}

/// A S.
template <class T>
INGOT_INLINE constexpr Mat3<T> operator*(const Mat3<T>& a, const Sym3<T>& s) {
    return {a.c0 * s.xx + a.c1 * s.xy + a.c2 * s.xz, a.c0 * s.xy + a.c1 * s.yy + a.c2 * s.yz,
            a.c0 * s.xz + a.c1 * s.yz + a.c2 * s.zz};
}

/// A B A^T of a full symmetric tensor B (Hecker 1997, Eq. 2).
template <class T>
INGOT_INLINE constexpr Sym3<T> rotated(const Mat3<T>& a, const Sym3<T>& b) {
    const Mat3<T> ab = a * b;
    return {ab.c0.x * a.c0.x + ab.c1.x * a.c1.x + ab.c2.x * a.c2.x, ab.c0.y * a.c0.y + ab.c1.y * a.c1.y + ab.c2.y * a.c2.y,
            ab.c0.z * a.c0.z + ab.c1.z * a.c1.z + ab.c2.z * a.c2.z, ab.c0.x * a.c0.y + ab.c1.x * a.c1.y + ab.c2.x * a.c2.y,
            ab.c0.x * a.c0.z + ab.c1.x * a.c1.z + ab.c2.x * a.c2.z, ab.c0.y * a.c0.z + ab.c1.y * a.c1.z + ab.c2.y * a.c2.z};
}

/// Of a ball: 1 on the diagonal.
template <class T>
INGOT_INLINE constexpr Sym3<T> identity_sym3() {
    const T zero{}, one = splat<T>(1);
    return {one, one, one, zero, zero, zero};
}

/// True where all six entries are neither NaN nor infinite.
template <class T>
INGOT_INLINE constexpr auto is_finite(const Sym3<T>& a) {
    return both(is_finite(Vec3<T>{a.xx, a.yy, a.zz}), is_finite(Vec3<T>{a.xy, a.xz, a.yz}));
}

/// Six rows of `lanes` numbers: Row is LaneRow, or scalar[lanes].
template <class Row>
INGOT_INLINE void store(Row (&to)[6], const Sym3<lane>& value) {
    store(to[0], value.xx);
    store(to[1], value.yy);
    store(to[2], value.zz);
    store(to[3], value.xy);
    store(to[4], value.xz);
    store(to[5], value.yz);
}
template <class Row>
INGOT_INLINE Sym3<lane> load(const Row (&from)[6]) {
    return {load(from[0]), load(from[1]), load(from[2]), load(from[3]), load(from[4]), load(from[5])};
}

} }  // namespace ingot

#pragma GCC diagnostic pop

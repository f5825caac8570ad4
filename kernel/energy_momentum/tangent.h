// SPDX-License-Identifier: MIT
// 6x6 matrices without symmetry: what a small change (w, v) of the end of a step does to the balances (moment, force) of the step.
//
// Changes are taken at the end of the step, balances at the mean of its begin and end. So a matrix is taken from one point to another by two arms:
// `end` for its columns, `mean` for its rows.
#pragma once

#include "../figure/spatial.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// M tilde(d).
template <class T>
INGOT_INLINE Mat3<T> times_tilde(const Mat3<T>& M, const Vec3<T>& d) {
    return {M.c1 * d.z - M.c2 * d.y, M.c2 * d.x - M.c0 * d.z, M.c0 * d.y - M.c1 * d.x};
}
/// tilde(a) tilde(b) = b a^T - (a . b) 1.
template <class T>
INGOT_INLINE Mat3<T> tilde_tilde(const Vec3<T>& a, const Vec3<T>& b) {
    const T ab = dot(a, b);
    return {{b.x * a.x - ab, b.y * a.x, b.z * a.x}, {b.x * a.y, b.y * a.y - ab, b.z * a.y}, {b.x * a.z, b.y * a.z, b.z * a.z - ab}};
}
template <class T>
INGOT_INLINE Mat3<T> plus_diagonal(const Mat3<T>& M, T s) {
    return {{M.c0.x + s, M.c0.y, M.c0.z}, {M.c1.x, M.c1.y + s, M.c1.z}, {M.c2.x, M.c2.y, M.c2.z + s}};
}

/// R - 1 of the turn R by 2 atan(|theta| / 2) about a Cayley vector: with all the digits of a small turn.
template <class T>
INGOT_INLINE Mat3<T> turn_of(const Vec3<T>& theta) {
    const T one_half = splat<T>(scalar(0.5)), half = length_sq(theta) * one_half, f = splat<T>(1) / (splat<T>(1) + half * one_half);
    return plus_outer(plus_diagonal(tilde(theta), -half), theta * one_half, theta) * f;
}

/// [A B; C D].
template <class T>
struct Tangent {
    Mat3<T> A, B, C, D;

    INGOT_INLINE friend Spatial<T> operator*(const Tangent& N, const Spatial<T>& u) { return {N.A * u.w + N.B * u.v, N.C * u.w + N.D * u.v}; }
    INGOT_INLINE friend Tangent operator+(const Tangent& a, const Tangent& b) { return {a.A + b.A, a.B + b.B, a.C + b.C, a.D + b.D}; }
};
/// N^T z.
template <class T>
INGOT_INLINE Spatial<T> transpose_times(const Tangent<T>& N, const Spatial<T>& z) {
    return {transpose_times(N.A, z.w) + transpose_times(N.C, z.v), transpose_times(N.B, z.w) + transpose_times(N.D, z.v)};
}
/// N - a k^T.
template <class T>
INGOT_INLINE Tangent<T> minus_outer(const Tangent<T>& N, const Spatial<T>& a, const Spatial<T>& k) {
    return {plus_outer(N.A, -a.w, k.w), plus_outer(N.B, -a.w, k.v), plus_outer(N.C, -a.v, k.w), plus_outer(N.D, -a.v, k.v)};
}
/// As it is here, of a point that is further by `end` at the end of the step and by `mean` in the mean.
template <class T>
INGOT_INLINE Tangent<T> tangent_from(const Tangent<T>& N, const Vec3<T>& end, const Vec3<T>& mean) {
    const Mat3<T> A = N.A - times_tilde(N.B, end), C = N.C - times_tilde(N.D, end);
    return {A + cross(mean, C), N.B + cross(mean, N.D), C, N.D};
}

/// A 3x3 matrix by its factors L U, with the largest of a column as its pivot.
template <class T>
class Factored3 {
public:
    INGOT_INLINE explicit Factored3(const Mat3<T>& M)
        : rows_{{M.c0.x, M.c1.x, M.c2.x}, {M.c0.y, M.c1.y, M.c2.y}, {M.c0.z, M.c1.z, M.c2.z}},
          swaps_01_(abs(rows_[1].x) > abs(rows_[0].x)) {
        swap(swaps_01_, rows_[0], rows_[1]);
        swaps_02_ = abs(rows_[2].x) > abs(rows_[0].x);
        swap(swaps_02_, rows_[0], rows_[2]);
        for (int row = 1; row < 3; ++row) {
            rows_[row].x = rows_[row].x / rows_[0].x;
            rows_[row].y = rows_[row].y - rows_[row].x * rows_[0].y;
            rows_[row].z = rows_[row].z - rows_[row].x * rows_[0].z;
        }
        swaps_12_ = abs(rows_[2].y) > abs(rows_[1].y);
        swap(swaps_12_, rows_[1], rows_[2]);
        rows_[2].y = rows_[2].y / rows_[1].y;
        rows_[2].z = rows_[2].z - rows_[2].y * rows_[1].z;
        inv_pivot_ = {splat<T>(1) / rows_[0].x, splat<T>(1) / rows_[1].y, splat<T>(1) / rows_[2].z};
    }
    /// M^-1 b.
    INGOT_INLINE Vec3<T> solve(Vec3<T> b) const {
        swap(swaps_01_, b.x, b.y);
        swap(swaps_02_, b.x, b.z);
        swap(swaps_12_, b.y, b.z);
        const T y = b.y - rows_[1].x * b.x, z = (b.z - rows_[2].x * b.x) - rows_[2].y * y;
        Vec3<T> u;
        u.z = z * inv_pivot_.z;
        u.y = (y - rows_[1].z * u.z) * inv_pivot_.y;
        u.x = ((b.x - rows_[0].y * u.y) - rows_[0].z * u.z) * inv_pivot_.x;
        return u;
    }
    INGOT_INLINE Mat3<T> solve(const Mat3<T>& B) const { return {solve(B.c0), solve(B.c1), solve(B.c2)}; }

private:
    using Mask = decltype(T{} > T{});

    template <class V>
    INGOT_INLINE static void swap(Mask swaps, V& a, V& b) {
        const V kept = a;
        a = select(swaps, b, a);
        b = select(swaps, kept, b);
    }

    Vec3<T> rows_[3], inv_pivot_;
    Mask swaps_01_, swaps_02_, swaps_12_;
};

} }  // namespace ingot

#pragma GCC diagnostic pop

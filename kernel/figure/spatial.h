// SPDX-License-Identifier: MIT
// Numbers of six: twists, impulses and the inertia between them, an angular and a linear part each. World axes.
//
// Source: Featherstone, "Rigid Body Dynamics Algorithms", 2008, chapters 2 and 7, in his order: angular first.
#pragma once

#include "../math/rotation.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// A twist (spin w; velocity v of the point at which it is taken), or an impulse (moment w about that point; force v).
template <class T>
struct Spatial {
    Vec3<T> w, v;

    INGOT_INLINE friend Spatial operator+(const Spatial& a, const Spatial& b) { return {a.w + b.w, a.v + b.v}; }
    INGOT_INLINE friend Spatial operator-(const Spatial& a, const Spatial& b) { return {a.w - b.w, a.v - b.v}; }
    INGOT_INLINE friend Spatial operator*(const Spatial& a, T s) { return {a.w * s, a.v * s}; }
};

template <class T>
INGOT_INLINE T dot(const Spatial<T>& a, const Spatial<T>& b) {
    return dot(a.w, b.w) + dot(a.v, b.v);
}

/// A twist seen at a point that is d further: v + w x d.
template <class T>
INGOT_INLINE Spatial<T> twist_at(const Spatial<T>& u, const Vec3<T>& d) {
    return {u.w, u.v + cross(u.w, d)};
}
/// An impulse that acts at a point d further, as it acts here: its moment grows by d x v.
template <class T>
INGOT_INLINE Spatial<T> impulse_from(const Spatial<T>& f, const Vec3<T>& d) {
    return {f.w + cross(d, f.v), f.v};
}

/// A symmetric 6x6 matrix [A B; B^T C]: an inertia, (moment, momentum) = M (w, v), or its inverse.
template <class T>
struct Spatial6 {
    Sym3<T> A;
    Mat3<T> B;
    Sym3<T> C;

    INGOT_INLINE friend Spatial<T> operator*(const Spatial6& M, const Spatial<T>& u) {
        return {M.A * u.w + M.B * u.v, transpose_times(M.B, u.w) + M.C * u.v};
    }
    INGOT_INLINE friend Spatial6 operator+(const Spatial6& a, const Spatial6& b) { return {a.A + b.A, a.B + b.B, a.C + b.C}; }
};

/// S + s a a^T.
template <class T>
INGOT_INLINE Sym3<T> plus_square(const Sym3<T>& S, const Vec3<T>& a, T s) {
    const Vec3<T> b = a * s;
    return {S.xx + b.x * a.x, S.yy + b.y * a.y, S.zz + b.z * a.z, S.xy + b.x * a.y, S.xz + b.x * a.z, S.yz + b.y * a.z};
}
/// S + a b^T + b a^T.
template <class T>
INGOT_INLINE Sym3<T> plus_symmetric(const Sym3<T>& S, const Vec3<T>& a, const Vec3<T>& b) {
    const T two = splat<T>(2);
    return {S.xx + two * (a.x * b.x), S.yy + two * (a.y * b.y), S.zz + two * (a.z * b.z),
            S.xy + (a.x * b.y + a.y * b.x), S.xz + (a.x * b.z + a.z * b.x), S.yz + (a.y * b.z + a.z * b.y)};
}
/// M + a b^T.
template <class T>
INGOT_INLINE Mat3<T> plus_outer(const Mat3<T>& M, const Vec3<T>& a, const Vec3<T>& b) {
    return {M.c0 + a * b.x, M.c1 + a * b.y, M.c2 + a * b.z};
}
/// M + s a a^T.
template <class T>
INGOT_INLINE Spatial6<T> plus_square(const Spatial6<T>& M, const Spatial<T>& a, T s) {
    return {plus_square(M.A, a.w, s), plus_outer(M.B, a.w * s, a.v), plus_square(M.C, a.v, s)};
}
/// M + a b^T + b a^T.
template <class T>
INGOT_INLINE Spatial6<T> plus_symmetric(const Spatial6<T>& M, const Spatial<T>& a, const Spatial<T>& b) {
    return {plus_symmetric(M.A, a.w, b.w), plus_outer(plus_outer(M.B, a.w, b.v), b.w, a.v), plus_symmetric(M.C, a.v, b.v)};
}

/// The columns of a symmetric matrix.
template <class T>
INGOT_INLINE Mat3<T> full(const Sym3<T>& S) {
    return {{S.xx, S.xy, S.xz}, {S.xy, S.yy, S.yz}, {S.xz, S.yz, S.zz}};
}
/// tilde(d) M: column by column d x c.
template <class T>
INGOT_INLINE Mat3<T> cross(const Vec3<T>& d, const Mat3<T>& M) {
    return {cross(d, M.c0), cross(d, M.c1), cross(d, M.c2)};
}

/// tilde(d) C tilde(d)^T.
template <class T>
INGOT_INLINE Sym3<T> crossed_twice(const Vec3<T>& d, const Mat3<T>& d_C) {
    const Mat3<T> rows = transposed(d_C);  // its columns are the rows of tilde(d) C
    const Vec3<T> x = cross(d, rows.c0), y = cross(d, rows.c1), z = cross(d, rows.c2);
    return {x.x, y.y, z.z, x.y, x.z, y.z};
}

/// An inertia M of a point that is d further, as it is here: X^T M X with X u = twist_at(u, d).
template <class T>
INGOT_INLINE Spatial6<T> inertia_from(const Spatial6<T>& M, const Vec3<T>& d) {
    const Mat3<T> d_C = cross(d, full(M.C)), d_Bt = cross(d, transposed(M.B));
    const Sym3<T> both_ways = {d_Bt.c0.x + d_Bt.c0.x, d_Bt.c1.y + d_Bt.c1.y, d_Bt.c2.z + d_Bt.c2.z,
                               d_Bt.c0.y + d_Bt.c1.x, d_Bt.c0.z + d_Bt.c2.x, d_Bt.c1.z + d_Bt.c2.y};
    return {M.A + both_ways + crossed_twice(d, d_C), M.B + d_C, M.C};
}
/// An inverse inertia, which gives twists for impulses, at a point that is d further: X Q X^T.
template <class T>
INGOT_INLINE Spatial6<T> compliance_at(const Spatial6<T>& Q, const Vec3<T>& d) {
    // X = [1 0; -d~ 1]: B' = B + A d~^T... by the transposed of inertia_from with A and C in each other's place.
    const Mat3<T> d_A = cross(d, full(Q.A)), d_B = cross(d, Q.B);
    const Mat3<T> minus_d_B = {-d_B.c0, -d_B.c1, -d_B.c2};
    const Sym3<T> both_ways = {minus_d_B.c0.x + minus_d_B.c0.x, minus_d_B.c1.y + minus_d_B.c1.y, minus_d_B.c2.z + minus_d_B.c2.z,
                               minus_d_B.c0.y + minus_d_B.c1.x, minus_d_B.c0.z + minus_d_B.c2.x, minus_d_B.c1.z + minus_d_B.c2.y};
    return {Q.A, Q.B - transposed(d_A), Q.C + both_ways + crossed_twice(d, d_A)};
}

/// The inverse of a positive definite matrix, by its factors L D L^T.
///
/// By cofactors, differences of products lose the digits of what is slender or far from its joint: a chain with a hundred times its mass at the end
/// was NaN in float after 1.3 s. Cost: 3 divisions, 25 flops.
template <class T>
INGOT_INLINE Sym3<T> inverse_of(const Sym3<T>& S) {
    const T one = splat<T>(1);
    const T i_1 = one / S.xx, l_21 = S.xy * i_1, l_31 = S.xz * i_1;
    const T i_2 = one / (S.yy - l_21 * S.xy), rest = S.yz - l_31 * S.xy, l_32 = rest * i_2;
    const T i_3 = one / ((S.zz - l_31 * S.xz) - l_32 * rest);
    const T k_31 = l_21 * l_32 - l_31;  // of the inverse of L; its others are -l_21 and -l_32
    const T k_i = k_31 * i_3, l_i = l_32 * i_3, m_i = l_21 * i_2;
    return {i_1 + l_21 * m_i + k_31 * k_i, i_2 + l_32 * l_i, i_3, -m_i - l_32 * k_i, k_i, -l_i};
}

} }  // namespace ingot

#pragma GCC diagnostic pop

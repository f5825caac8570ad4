// SPDX-License-Identifier: MIT
// The tilde operator, rotation about an axis, and what keeps a matrix a rotation.
#pragma once

#include "../base/limits.h"
#include "../base/status.h"
#include "sqrt.h"
#include "sym3.h"
#include "trig.h"

namespace ingot { inline namespace INGOT_ABI {

/// The skew-symmetric matrix with tilde(w) r = w x r (Hecker 1997, Eq. 9).
template <class T>
INGOT_INLINE constexpr Mat3<T> tilde(const Vec3<T>& w) {
    const T zero{};
    return {{zero, w.z, -w.y}, {-w.z, zero, w.x}, {w.y, -w.x, zero}};
}

/// Rotation by `angle` about the unit vector n: R = n n^T + cos (1 - n n^T) + sin tilde(n).
///
/// Units:   angle in rad, |angle| <= 1000.
/// Needs:   |n| = 1; an n that is not of unit length gives a matrix that is no rotation. rotation_about checks.
/// Cost:    one sin_cos and 27 flops; for set-up, not for the step.
/// Source:  Hecker 1997, Eqs. 3 to 6.
constexpr Matrix axis_angle(const Vector& n, scalar angle) {
    const SinCos a = sin_cos(angle);
    const Vector m = n * (1 - a.cos), s = n * a.sin;
    return {{n.x * m.x + a.cos, n.x * m.y + s.z, n.x * m.z - s.y},
            {n.y * m.x - s.z, n.y * m.y + a.cos, n.y * m.z + s.x},
            {n.z * m.x + s.y, n.z * m.y - s.x, n.z * m.z + a.cos}};
}

/// axis_angle for input that may be wrong.
/// Errors: not_finite, bad_direction (|n| off 1 by more than limits::unit_length), out_of_range (|angle| > 1000).
constexpr Result<Matrix> rotation_about(const Vector& n, scalar angle) {
    if (!is_finite(n) || !is_finite(angle)) return {Status::not_finite, {}};
    if (abs(length_sq(n) - 1) > limits::unit_length) return {Status::bad_direction, {}};
    if (abs(angle) > 1000) return {Status::out_of_range, {}};
    return {Status::ok, axis_angle(n, angle)};
}

/// Largest entry of |A^T A - 1|: how far the columns are from orthonormal.
constexpr scalar orthogonality_error(const Matrix& A) {
    const Vector columns[3] = {A.c0, A.c1, A.c2};
    scalar worst = 0;
    for (int i = 0; i < 3; ++i)
        // bound: 2: of a symmetric matrix
        for (int k = 0; k <= i; ++k) {
            const scalar entry = abs(dot(columns[i], columns[k]) - (i == k ? 1 : 0));
            worst = entry > worst ? entry : worst;
        }
    return worst;
}

/// What one Newton step towards the polar factor of A adds to A: A (1 - A^T A) / 2.
///
/// The nearest rotation in the sense of Frobenius is the fixed point; the defect d of A^T A becomes 3/4 d^2.
/// Cost:    63 multiplications and 45 additions, no division, no square root.
/// Source:  Higham, "Computing the polar decomposition", 1986 (Newton-Schulz form).
template <class T>
INGOT_INLINE constexpr Mat3<T> polar_correction(const Mat3<T>& A) {
    // In a loop, so that a core that keeps its code small has the code of one column.
    const T zero{}, one = splat<T>(1);
    const Vec3<T> columns[3] = {A.c0, A.c1, A.c2}, axes[3] = {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
    Vec3<T> correction[3] = {};
    for (int i = 0; i < 3; ++i) correction[i] = A * ((axes[i] - transpose_times(A, columns[i])) * splat<T>(scalar(0.5)));
    return {correction[0], correction[1], correction[2]};
}

/// Gram-Schmidt on the columns: the first keeps its direction, the third is the cross product of the two.
///
/// Cost:    2 square roots, 2 divisions, 36 flops.
/// Source:  "reorthogonalise A" of Hecker 1997, Listing 1.
template <class T>
INGOT_INLINE Mat3<T> reorthogonalized(const Mat3<T>& A) {
    const Vec3<T> c0 = A.c0 * (splat<T>(1) / sqrt(dot(A.c0, A.c0)));
    const Vec3<T> p1 = A.c1 - c0 * dot(c0, A.c1);
    const Vec3<T> c1 = p1 * (splat<T>(1) / sqrt(dot(p1, p1)));
    return {c0, c1, cross(c0, c1)};
}

} }  // namespace ingot

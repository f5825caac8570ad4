// SPDX-License-Identifier: MIT
// Points of a moving body (Hecker 1997, Eqs. 10 to 13) and the auxiliary state (Eqs. 18 and 20).
#pragma once

#include "../math/rotation.h"

namespace ingot { inline namespace INGOT_ABI {

/// World position of a point fixed in the body: b = o + A r_body (Eq. 11). Units: m.
template <class T>
INGOT_INLINE constexpr Vec3<T> point_position(const Vec3<T>& o, const Mat3<T>& A, const Vec3<T>& r_body) {
    return o + A * r_body;
}

/// Velocity of a point of the body: v + omega x r (Eq. 12); r from the point that moves with v, world axes. Units: m s^-1.
template <class T>
INGOT_INLINE constexpr Vec3<T> point_velocity(const Vec3<T>& v, const Vec3<T>& omega, const Vec3<T>& r) {
    return v + cross(omega, r);
}

/// Acceleration of a point of the body: a + alpha x r + omega x (omega x r) (Eq. 13). Units: m s^-2.
template <class T>
INGOT_INLINE constexpr Vec3<T> point_acceleration(const Vec3<T>& a, const Vec3<T>& alpha, const Vec3<T>& omega, const Vec3<T>& r) {
    return a + cross(alpha, r) + cross(omega, cross(omega, r));
}

/// Rate of the orientation: dA/dt = tilde(omega) A (Eq. 10), column by column.
template <class T>
INGOT_INLINE constexpr Mat3<T> orientation_rate(const Vec3<T>& omega, const Mat3<T>& A) {
    return {cross(omega, A.c0), cross(omega, A.c1), cross(omega, A.c2)};
}

/// World-space inverse inertia from the body-space one: I^-1 = A Ibar^-1 A^T.
///
/// Shapes:  A 3x3 rotation, body to world; inv_I_body 3 (principal axes); result symmetric, 6 numbers.
/// Units:   kg^-1 m^-2.
/// Needs:   A orthonormal to limits::orthogonality.
/// Errors:  none; a non-finite input gives a non-finite result.
/// Source:  Hecker 1997, Eq. 20.
template <class T>
INGOT_INLINE constexpr Sym3<T> inverse_inertia_world(const Mat3<T>& A, const Vec3<T>& inv_I_body) {
    return rotated_diagonal(A, inv_I_body);
}

/// omega = A Ibar^-1 A^T L (Eqs. 18 and 20). Units: inv_I_body kg^-1 m^-2 (principal axes), L in world axes; result rad s^-1.
template <class T>
INGOT_INLINE constexpr Vec3<T> spin_of(const Mat3<T>& A, const Vec3<T>& inv_I_body, const Vec3<T>& L) {
    return A * scaled(inv_I_body, transpose_times(A, L));
}

/// True where the spin omega, in any axes, has not run away: limits::spin_runaway. False for NaN.
template <class T>
INGOT_INLINE constexpr auto is_within_runaway(const Vec3<T>& omega) {
    return length_sq(omega) <= splat<T>(limits::spin_runaway * limits::spin_runaway);
}

/// Angular momentum of a body that spins with omega: L = A Ibar A^T omega (Eqs. 17 and 2).
///
/// Units:   I_body kg m^2 (principal moments), omega rad s^-1 in world axes; result kg m^2 s^-1 in world axes.
template <class T>
INGOT_INLINE constexpr Vec3<T> angular_momentum_of_spin(const Mat3<T>& A, const Vec3<T>& I_body, const Vec3<T>& omega) {
    return A * scaled(I_body, transpose_times(A, omega));
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// From the frame in which the user models a body to the body frame of the kernel, and back. The first has its origin and axes
// where the user put them; the second has its origin at the centre of mass and lies along the principal axes.
//
//     BodyDef def;
//     def.mass = mass;                                                                  // of principal()
//     def.state = body_state(mass, {{0, 0, 2}, axis_angle({0, 0, 1}, 0.5f)}, {{1, 0, 0}, {0, 0, 3}});
//     ...
//     const UserPose pose = user_pose(mass, world.state(id).value);                     // draw the model here
//
// A point p of the model is at point_position(pose.r, pose.A, p) of body/kinematics.h.
#pragma once

#include "../math/quaternion.h"
#include "check_body.h"
#include "kinematics.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where the user's frame is.
struct UserPose {
    Vector r{};                              ///< m, its origin, world
    Matrix A = identity_matrix<scalar>();    ///< its axes: user's frame to world; a rotation
};

/// How the user's frame moves.
struct UserMotion {
    Vector v{};    ///< m/s, of its origin, world
    Vector omega{};  ///< rad/s, world
};

/// The pose of the user's frame, from the state of the body: A = A_body A_principal^T, r = r_CM - A r_CM_user (Eq. 11).
///
/// Errors: none; the mass is that of the body (the default MassProperties of an immovable body will do).
/// Cost:   60 flops.
constexpr UserPose user_pose(const MassProperties& mass, const BodyState& state) {
    const Matrix A = state.A * transposed(mass.A_principal);
    return {state.r_CM - A * mass.r_CM, A};
}

/// The motion of the user's frame, from the state of the body: omega = A_body I_body^-1 A_body^T L (Eqs. 18 and 20), and the
/// velocity of its origin (Eq. 12).
///
/// Errors: none; a moment of zero, which an immovable body may have, gives no omega.
/// Error:  L is kept to a rounding of its largest component; about an axis of a small moment that is one of omega times the
///         largest over that moment.
/// Cost:   3 divisions and 100 flops.
constexpr UserMotion user_motion(const MassProperties& mass, const BodyState& state) {
    const Vector I = mass.I_body, L_body = transpose_times(state.A, state.L);
    const Vector omega_body = {I.x > 0 ? L_body.x / I.x : 0, I.y > 0 ? L_body.y / I.y : 0, I.z > 0 ? L_body.z / I.z : 0};
    const Vector omega = state.A * omega_body;
    const Vector r_CM_to_origin = -(state.A * transpose_times(mass.A_principal, mass.r_CM));
    return {point_velocity(state.v_CM, omega, r_CM_to_origin), omega};
}

/// The state of a body whose user's frame has this pose and motion: what World::add and World::set_state take.
///
/// A_body = A A_principal, r_CM = r + A r_CM_user (Eq. 11), v_CM = v + omega x (r_CM - r) (Eq. 12), L = I omega (Eq. 17).
/// Needs:  A a rotation to limits::orthogonality; the world makes it orthonormal.
/// Errors: none here; what is not finite, out of range or no rotation is refused by the world: see check_state.
/// Cost:   120 flops.
constexpr BodyState body_state(const MassProperties& mass, const UserPose& pose, const UserMotion& motion = {}) {
    const Matrix A = pose.A * mass.A_principal;
    const Vector r_origin_to_CM = pose.A * mass.r_CM;
    return {pose.r + r_origin_to_CM, point_velocity(motion.v, motion.omega, r_origin_to_CM), A,
            angular_momentum_of_spin(A, mass.I_body, motion.omega)};
}

// For drawing between two steps: fraction 0 is `from` and 1 is `to`, bit for bit; beyond them it is the nearer end, for NaN `from`. r goes along a
// line; A turns about one axis at a constant rate, and each of its entries is that of a rotation to 17 roundings.
// Needs:  rotations to rounding, as those of a world are; a body that turns by more than half a turn in a step seems to turn the other way.
// Cost:   3 square roots and divisions, 200 flops; of two turns that are nearly the opposite, 500 in float.

/// Of a frame. One that lies beside the centre of mass of a fast spinning body is better made of the state between, by user_pose.
inline UserPose interpolated(const UserPose& from, const UserPose& to, scalar fraction) {
    if (!(fraction > 0)) return from;
    if (!(fraction < 1)) return to;
    const Quaternion p = quaternions::from_rotation(from.A), q = quaternions::from_rotation(to.A);
    return {from.r * (1 - fraction) + to.r * fraction, quaternions::to_rotation(quaternions::slerp(p, q, fraction))};
}

/// Of a body: what the state was after the step before, and what it is now. v_CM and L go along a line too.
inline BodyState interpolated(const BodyState& from, const BodyState& to, scalar fraction) {
    if (!(fraction > 0)) return from;
    if (!(fraction < 1)) return to;
    const UserPose pose = interpolated(UserPose{from.r_CM, from.A}, UserPose{to.r_CM, to.A}, fraction);
    return {pose.r, from.v_CM * (1 - fraction) + to.v_CM * fraction, pose.A, from.L * (1 - fraction) + to.L * fraction};
}

} }  // namespace ingot

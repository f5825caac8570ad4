// SPDX-License-Identifier: MIT
// A drive as the child of its joint has it.
#pragma once

#include "../math/quaternion.h"
#include "moving_joint.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where a driven direction is beyond its target, how fast it goes beyond the rate of that, and what is added, of the child against its parent.
struct DriveError {
    scalar angle, rate, feedforward;  ///< rad, rad/s, N m; m, m/s, N
};

/// The rotation vector of a rotation, up to half a turn.
INGOT_INLINE Vector rotation_vector_of(const Matrix& A) {
    const Quaternion q = quaternions::from_rotation(A);
    const Vector v = {q.x, q.y, q.z};
    const scalar sine = sqrt(length_sq(v));
    return sine > 0 ? v * (2 * arctangent(sine, q.w) / sine) : Vector{};
}
/// The rotation of a rotation vector.
INGOT_INLINE Matrix rotation_by(const Vector& turn) {
    const scalar angle = sqrt(length_sq(turn));
    return angle > 0 ? axis_angle(turn * (1 / angle), angle) : identity_matrix<scalar>();
}
/// The same rotation, of half a turn at most.
INGOT_INLINE Vector least_turn(const Vector& turn) {
    const scalar angle = sqrt(length_sq(turn));
    if (!(angle > whole_turn / 2)) return turn;
    int32_t turns = 0;
    return turn * (nearest_turn(0, angle, turns) > 0 ? (angle - static_cast<scalar>(turns) * whole_turn) / angle : scalar(1));
}
INGOT_INLINE Matrix triad_of(const Vector& axis, const Vector& side) { return {axis, side, cross(axis, side)}; }
INGOT_INLINE Matrix times_transposed(const Matrix& a, const Matrix& b) { return a * transposed(b); }

/// Of a ball joint: three of them, in world axes.
template <class Joint>
void ball_errors(const Joint& joint, const DrivenRowView& all, DriveError (&errors)[3]) {
    const FigureNode& node = joint.node();
    const DriveRecord* const of = drives_of(node, all);
    const JointSides<scalar> sides = joint.sides();
    const Matrix own = triad_of(sides.axis, sides.side), parent = triad_of(sides.axis_of_parent, sides.side_of_parent);
    const Matrix A_of_A = node.is_A ? joint.A_of_child() : joint.A_of_parent();
    const auto vector = [&](scalar JointDrive::*part) { return A_of_A * Vector{of[0].drive.*part, of[1].drive.*part, of[2].drive.*part}; };
    const Vector target_rate = vector(&JointDrive::target_rate), target = vector(&JointDrive::target) + target_rate * joint.view().elapsed;
    const Vector feedforward = vector(&JointDrive::feedforward);
    const scalar sign = node.is_A ? scalar(-1) : scalar(1);
    const Vector off = rotation_vector_of(times_transposed(node.is_A ? parent : own, rotation_by(target) * (node.is_A ? own : parent))) * sign;
    const Vector rate = joint.rates() - target_rate * sign;
    errors[0] = {off.x, rate.x, feedforward.x * sign};
    errors[1] = {off.y, rate.y, feedforward.y * sign};
    errors[2] = {off.z, rate.z, feedforward.z * sign};
}

/// Of a direction of another joint.
template <class Joint>
DriveError error_of(const Joint& joint, const DrivenRowView& all, int direction_i) {
    const FigureNode& node = joint.node();
    const JointDrive& drive = drive_of(node, all, direction_i);
    const scalar sign = of_record(node, direction_i).sign;
    const Vector rates = joint.rates();
    const scalar target = (drive.target + drive.target_rate * joint.view().elapsed) * sign, feedforward = drive.feedforward * sign;
    if (direction_i == 2) {
        const scalar off = steering_of(node.kind, joint.sides()) - target;
        int32_t turns = 0;
        return {nearest_turn(off, 0, turns), rates.z - drive.target_rate * sign, feedforward};
    }
    return {value_of(node, all.motions[node.joint], direction_i) - target, (direction_i == 0 ? rates.x : rates.y) - drive.target_rate * sign,
            feedforward};
}

} }  // namespace ingot

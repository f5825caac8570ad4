// SPDX-License-Identifier: MIT
// The part of World that drives joints.
#pragma once

#include "world_joints.h"

namespace ingot { inline namespace INGOT_ABI {

/// Calls of World, see world.h.
template <class S>
class WorldDrives : public WorldJoints<S> {
protected:
    using Base = WorldJoints<S>;
    using Base::storage_;
    using Base::find;

    static constexpr bool drives_only() {
        static_assert(has_joints<S>, "this scene names no joints: set joints and max_joints");
        static_assert(!has_joints<S> || S::joints::has_drives, "this scene's joints are not driven: name WithDrives among its joints");
        return true;
    }

public:
    // Drives of joints, in scenes that name WithDrives among their joints: see joint/drives.h.

    /// Drives a hinge, a slider, a servo, a universal joint about the axis of A, or, with which = 1, of B, or of a wheel the spin, the travel or the
    /// steering, see WheelJoint, from now on; {}: no more. Wakes its bodies.
    /// Errors: those of ids and of check_drive, not_in_scene (a kind without such a direction, or a ball joint or ball servo).
    Status set_joint_drive(JointId id, const JointDrive& drive, int which = 0) {
        static_assert(drives_only());
        const Result<int> joint = find_direction(id, which);
        if (!joint.ok()) return joint.status;
        const Status status = check_drive(drive);
        if (status != Status::ok) return status;
        storage_.drive_of(joint.value, which) = {drive, 0};
        this->wake_sides(joint.value);
        return Status::ok;
    }
    /// Drives a ball joint towards a turn of B against A, as a vector in the axes of A, rad; 0: as they were joined, with the axis in the middle of
    /// its cone; of a ball servo read the world for A. target_rate, rad/s, and feedforward, N m: in the same axes. Stiffness, damping, kind and
    /// max_torque are those of `drive`; its target, target_rate and feedforward are not looked at. max_torque is of all three turns together: what is
    /// cut keeps the direction that the law asks for. What is tuned is so for the mean inertia of the three turns.
    /// Errors: those of ids and of check_drive, not_in_scene (another kind), out_of_range (a target of more than limits::joint_swing_max).
    Status set_ball_drive(JointId id, const JointDrive& drive, const Vector& target = {}, const Vector& target_rate = {},
                          const Vector& feedforward = {}) {
        static_assert(drives_only());
        const Result<int> joint = find_driven_ball(id);
        if (!joint.ok()) return joint.status;
        JointDrive of[3] = {drive, drive, drive};
        of[0].feedforward = feedforward.x;
        of[1].feedforward = feedforward.y;
        of[2].feedforward = feedforward.z;
        const Status status = set_targets(of, target, target_rate);
        if (status != Status::ok) return status;
        for (int i = 0; i < 3; ++i) storage_.drive_of(joint.value, i) = {of[i], 0};
        this->wake_sides(joint.value);
        return Status::ok;
    }

    /// Moves the target of a drive, and leaves the rest of it. Wakes its bodies. Errors: those of set_joint_drive.
    Status set_joint_target(JointId id, scalar target, scalar target_rate = 0, int which = 0) {
        static_assert(drives_only());
        const Result<int> joint = find_direction(id, which);
        if (!joint.ok()) return joint.status;
        JointDrive drive = storage_.drive_of(joint.value, which).drive;
        drive.target = target;
        drive.target_rate = target_rate;
        const Status status = check_drive(drive);
        if (status != Status::ok) return status;
        storage_.drive_of(joint.value, which).aim(drive);
        this->wake_sides(joint.value);
        return Status::ok;
    }
    /// The same of a ball joint. Errors: those of set_ball_drive.
    Status set_ball_target(JointId id, const Vector& target, const Vector& target_rate = {}) {
        static_assert(drives_only());
        const Result<int> joint = find_driven_ball(id);
        if (!joint.ok()) return joint.status;
        JointDrive of[3];
        for (int i = 0; i < 3; ++i) of[i] = storage_.drive_of(joint.value, i).drive;
        const Status status = set_targets(of, target, target_rate);
        if (status != Status::ok) return status;
        for (int i = 0; i < 3; ++i) storage_.drive_of(joint.value, i).aim(of[i]);
        this->wake_sides(joint.value);
        return Status::ok;
    }

    /// The drive of a direction, with its target as it is now. Errors: those of ids, not_in_scene.
    Result<JointDrive> joint_drive(JointId id, int which = 0) const {
        static_assert(drives_only());
        const Result<int> joint = find_direction(id, which);
        if (!joint.ok()) return {joint.status, {}};
        return {Status::ok, storage_.drive_of(joint.value, which).drive};
    }
    /// What a drive has given in the last step, on B, mean of the step: N m, of a slider, and of a wheel's travel, N.
    /// Errors: those of ids, not_in_scene.
    Result<scalar> drive_torque(JointId id, int which = 0) const {
        static_assert(drives_only());
        const Result<int> joint = find_direction(id, which);
        if (!joint.ok()) return {joint.status, 0};
        return {Status::ok, storage_.drive_of(joint.value, which).torque};
    }
    /// The same of a ball joint, N m, in the axes of A. Errors: those of ids, not_in_scene.
    Result<Vector> ball_torque(JointId id) const {
        static_assert(drives_only());
        const Result<int> joint = find_driven_ball(id);
        if (!joint.ok()) return {joint.status, {}};
        const auto of = [&](int i) { return storage_.drive_of(joint.value, i).torque; };
        return {Status::ok, {of(0), of(1), of(2)}};
    }

private:
    Result<int> find_direction(JointId id, int which) const {
        const Result<int> joint = find(id);
        if (!joint.ok()) return joint;
        const JointKind kind = this->kind_of(joint.value);
        const bool has = !is_ball_or_servo(kind) && which >= 0 && which < driven_directions(kind);
        return has ? joint : Result<int>{Status::not_in_scene, 0};
    }
    Result<int> find_driven_ball(JointId id) const {
        const Result<int> joint = find(id);
        if (!joint.ok() || is_ball_or_servo(this->kind_of(joint.value))) return joint;
        return {Status::not_in_scene, 0};
    }
    /// All of whose turns are driven as one.
    static bool is_ball_or_servo(JointKind kind) { return kind == JointKind::ball || (has_servos<S> && kind == JointKind::ball_servo); }
    static Status set_targets(JointDrive (&of)[3], const Vector& target, const Vector& target_rate) {
        const scalar targets[3] = {target.x, target.y, target.z}, rates[3] = {target_rate.x, target_rate.y, target_rate.z};
        for (int i = 0; i < 3; ++i) {
            of[i].target = targets[i];
            of[i].target_rate = rates[i];
            const Status status = check_drive(of[i]);
            if (status != Status::ok) return status;
        }
        return length_sq(target) <= limits::joint_swing_max * limits::joint_swing_max ? Status::ok : Status::out_of_range;
    }
};

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// What drives joints: springs and dampers, servos, motors. In scenes that name WithDrives among their joints.
#pragma once

#include "../base/limits.h"
#include "../math/lanes.h"
#include "joints.h"

namespace ingot { inline namespace INGOT_ABI {

/// Which law a JointDrive follows: that of SpringDrive, TunedDrive or MotorDrive.
enum class DriveKind : uint8_t { none, spring, tuned, motor };

/// Of one free direction of a joint, or of all turns of a ball joint; the kinds below convert to it. Of B against A.
///
/// Torque: feedforward - stiffness (angle - target) - damping (rate - target_rate), with angle and rate as they are at the end of each substep, so
/// that no stiffness rings or gains energy; cut at max_torque in every substep. Of a slider read force and travel.
///
/// A target that goes on is a sum of steps, which keeps what it rounds off: a clock's hand is off by the roundings of its own angle and of its rate,
/// and not by one more with each step. World::set_joint_target begins a sum anew.
struct JointDrive {
    DriveKind kind{};                ///< by which of the kinds below it was made; none: it does nothing
    scalar stiffness = 0;            ///< N m/rad, N/m, 0 to limits::drive_gain_max; tuned: Hz, 0 to limits::drive_hertz_max
    scalar damping = 0;              ///< N m s/rad, N s/m, 0 to limits::drive_gain_max; tuned: the damping ratio, 0 to limits::damping_ratio_max
    scalar target = 0;               ///< rad, m, as the next step begins; it goes on with target_rate
    scalar target_rate = 0;          ///< rad/s, m/s
    scalar feedforward = 0;          ///< N m, N
    scalar max_torque = unlimited;   ///< N m, N; 0 or more
};

/// A spring and a damper; a servo, where its target is set in every step.
struct SpringDrive {
    scalar stiffness = 0, damping = 0;  ///< N m/rad or N/m; N m s/rad or N s/m: see JointDrive
    scalar target = 0, target_rate = 0, feedforward = 0;  ///< see JointDrive
    scalar max_torque = unlimited;  ///< N m, N; 0 or more
    constexpr operator JointDrive() const { return {DriveKind::spring, stiffness, damping, target, target_rate, feedforward, max_torque}; }
};
/// The same by how it swings: the poles of a substep are those of the exact motion, for the inertia that the joint has in its figure. Above a quarter
/// of a turn a substep it swings no faster. The spring of a wheel is tuned for what the wheel carries: as A gives way at P, while the wheel stands
/// still. That is one corner of a car by itself; for a car of mass M on four wheels that bounces at f take SpringDrives of the stiffness
/// M (2 pi f)^2 / 4.
struct TunedDrive {
    scalar hertz = 1, damping_ratio = 1;  ///< Hz, 0 to limits::drive_hertz_max; 0 to limits::damping_ratio_max
    scalar target = 0, target_rate = 0, feedforward = 0;  ///< see JointDrive
    scalar max_torque = unlimited;  ///< N m, N; 0 or more
    constexpr operator JointDrive() const { return {DriveKind::tuned, hertz, damping_ratio, target, target_rate, feedforward, max_torque}; }
};
/// Keeps a rate, with what torque it takes.
struct MotorDrive {
    scalar rate = 0;                 ///< rad/s, m/s
    scalar max_torque = unlimited;  ///< N m, N; 0 or more
    constexpr operator JointDrive() const { return {DriveKind::motor, 0, 0, 0, rate, 0, max_torque}; }
};

/// What a world keeps of the drive of a direction. Of a ball joint: target, rate and feedforward are components in the axes of A.
struct DriveRecord {
    JointDrive drive{DriveKind::none, 0, 0, 0, 0, 0, 0};  ///< zeros where there is none: a world is all zero as it begins
    scalar torque{};      ///< N m, N; mean of the last step
    scalar target_low{};  ///< rad, m; target + target_low is the sum of its steps

    /// The same drive, to another target.
    void aim(const JointDrive& at) {
        drive = at;
        target_low = 0;
    }
    /// To the target of the next step. Kahan: rounding does not add up over the steps.
    void go_on(scalar h) {
        const scalar due = drive.target_rate * h + target_low, target = drive.target + due;
        const scalar kept = max(-limits::position_max, min(limits::position_max, target));
        target_low = kept == target ? due - (target - drive.target) : scalar(0);
        drive.target = kept;
    }
};

} }  // namespace ingot

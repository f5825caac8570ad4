// SPDX-License-Identifier: MIT
#include "check_drive.h"

#include "../base/figure_limits.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

bool is_up_to(scalar value, scalar most) { return value >= 0 && value <= most; }
bool is_within(scalar value, scalar most) { return value >= -most && value <= most; }

}  // namespace

Status check_drive(const JointDrive& drive) {
    const scalar numbers[] = {drive.stiffness, drive.damping, drive.target, drive.target_rate, drive.feedforward, drive.max_torque};
    for (const scalar number : numbers)
        if (!is_finite(number)) return Status::not_finite;
    const bool is_tuned = drive.kind == DriveKind::tuned;
    bool good = drive.kind <= DriveKind::motor;
    good = good && is_up_to(drive.stiffness, is_tuned ? limits::drive_hertz_max : limits::drive_gain_max);
    good = good && is_up_to(drive.damping, is_tuned ? limits::damping_ratio_max : limits::drive_gain_max);
    good = good && is_within(drive.target, limits::position_max) && is_within(drive.target_rate, limits::drive_rate_max);
    good = good && is_within(drive.feedforward, limits::drive_gain_max) && drive.max_torque >= 0;
    return good ? Status::ok : Status::out_of_range;
}

bool is_valid(const DriveRecord& record) {
    // What a target rounds off is no more than that of the largest.
    return is_finite(record.torque) && is_within(record.target_low, epsilon * limits::position_max) && check_drive(record.drive) == Status::ok;
}

} }  // namespace ingot

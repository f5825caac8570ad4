// SPDX-License-Identifier: MIT
#include "check_target.h"

#include "../base/figure_limits.h"
#include "../body/check_body.h"

namespace ingot { inline namespace INGOT_ABI {

Status check_target_drive(const TargetDrive& drive) {
    const scalar numbers[] = {drive.hertz, drive.damping_ratio, drive.max_force, drive.max_torque};
    for (const scalar number : numbers)
        if (!is_finite(number)) return Status::not_finite;
    bool good = drive.hertz >= 0 && drive.hertz <= limits::drive_hertz_max;
    good = good && drive.damping_ratio >= 0 && drive.damping_ratio <= limits::damping_ratio_max;
    good = good && drive.max_force >= 0 && drive.max_torque >= 0;
    return good ? Status::ok : Status::out_of_range;
}

bool is_valid(const TargetRecord& record) {
    if (!is_finite(record.force) || !is_finite(record.torque) || check_target_drive(record.drive()) != Status::ok) return false;
    return check_vector(record.velocity, limits::speed_max) == Status::ok && check_vector(record.spin, limits::drive_rate_max) == Status::ok;
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "../base/status.h"
#include "drives.h"

namespace ingot { inline namespace INGOT_ABI {

/// Errors: not_finite, out_of_range (beyond what JointDrive says).
Status check_drive(const JointDrive& drive);

/// False for what no record of a drive can have become.
bool is_valid(const DriveRecord& record);

} }  // namespace ingot

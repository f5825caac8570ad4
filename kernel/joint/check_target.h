// SPDX-License-Identifier: MIT
#pragma once

#include "../base/status.h"
#include "target_record.h"

namespace ingot { inline namespace INGOT_ABI {

/// Errors: not_finite, out_of_range (beyond what TargetDrive says).
Status check_target_drive(const TargetDrive& drive);

/// False for what no joint can have become.
bool is_valid(const TargetRecord& record);

} }  // namespace ingot

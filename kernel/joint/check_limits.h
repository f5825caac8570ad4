// SPDX-License-Identifier: MIT
#pragma once

#include "../base/status.h"
#include "limit_record.h"

namespace ingot { inline namespace INGOT_ABI {

/// Errors: not_finite, bad_joint (lower above upper), out_of_range (an end that is beyond what the kind's may be: see the kinds,
///         limits::joint_angle_max, limits::position_max), bad_restitution.
Status check_limits(JointKind kind, const JointLimits& limits);

/// Whether some direction ends.
bool limits_something(const JointLimits& limits);

/// False for what no joint of the kind can have become.
bool is_valid(const LimitRecord& record, JointKind kind);
bool is_valid(const AngleRecord& record);

} }  // namespace ingot

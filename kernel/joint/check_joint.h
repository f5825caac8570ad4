// SPDX-License-Identifier: MIT
#pragma once

#include "../body/body_tiles.h"
#include "../base/status.h"
#include "joint_record.h"

namespace ingot { inline namespace INGOT_ABI {

/// What a definition may have wrong by itself.
/// Errors: not_finite, out_of_range (P beyond limits::position_max), bad_direction (an axis that the kind has is not of unit length), bad_joint
///         (axes of a universal joint or of a wheel that are not at right angles, to limits::orthogonality); out_of_range: the middle of a cone
///         that is opposite to the axis. Not of limits: see check_limits.h. balls_have_axes: of scenes whose joints may have limits.
Status check_joint(const JointDef& def, bool balls_have_axes);

/// The record of a checked joint, of the bodies as they are; slots: no_body is the world.
JointRecord record_of(const JointDef& def, const BodyView& bodies, Index slot_A, Index slot_B, bool balls_have_axes);

/// How far its sides are apart, m, along what it locks.
scalar gap_of(const JointRecord& joint, const BodyView& bodies);

/// False for what no joint can have become; slots: in use.
bool is_valid(const JointRecord& joint, int slots);

} }  // namespace ingot

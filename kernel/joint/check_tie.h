// SPDX-License-Identifier: MIT
#pragma once

#include "../base/status.h"
#include "gear_record.h"
#include "tie_record.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of a rod or a rope; unit: m, of length. Errors: not_finite, out_of_range (P_B beyond limits::position_max; a length beyond limits::tie_length_min
///         to limits::position_max, or ends that are so near where it has none given).
Status check_tie(const JointDef& def, scalar unit);
/// Errors: not_finite, out_of_range.
Status check_length(scalar length, scalar unit);

/// m: as given, or as far as the ends are apart.
scalar length_of(const JointDef& def);

/// unit_A, unit_B: what its ways are of, m of travel, else 1. Errors: not_finite, out_of_range (0, or beyond limits::gear_ratio_max either way).
Status check_ratio(scalar ratio, scalar unit_A, scalar unit_B);
/// joints: how many slots there are. False for what no gear can have become; or, of another kind, for what is not all zero.
bool is_valid(const GearRecord& gear, JointKind kind, int joints);

/// False for what no joint of the kind can have become.
bool is_valid(const TieRecord& record, JointKind kind, scalar unit);

} }  // namespace ingot

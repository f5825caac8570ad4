// SPDX-License-Identifier: MIT
#pragma once

#include "../base/status.h"
#include "tie_record.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of a rod or a rope; unit: m, of length. Errors: not_finite, out_of_range (P_B beyond limits::position_max; a length beyond limits::tie_length_min
///         to limits::position_max, or ends that are so near where it has none given).
Status check_tie(const JointDef& def, scalar unit);
/// Errors: not_finite, out_of_range.
Status check_length(scalar length, scalar unit);

/// m: as given, or as far as the ends are apart.
scalar length_of(const JointDef& def);

/// False for what no joint of the kind can have become.
bool is_valid(const TieRecord& record, JointKind kind, scalar unit);

} }  // namespace ingot

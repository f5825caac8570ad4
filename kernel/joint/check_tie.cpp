// SPDX-License-Identifier: MIT
#include "check_tie.h"

#include "../base/figure_limits.h"
#include "../body/check_body.h"
#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

Status check_length(scalar length, scalar unit) {
    if (!is_finite(length)) return Status::not_finite;
    return length >= limits::tie_length_min * unit && length <= limits::position_max ? Status::ok : Status::out_of_range;
}

scalar length_of(const JointDef& def) {
    const scalar given = def.joint.limits.range[0].upper;
    return given == 0 ? sqrt(length_sq(def.P_B - def.P)) : given;
}

Status check_tie(const JointDef& def, scalar unit) {
    if (!has_length(def.joint.kind)) return Status::ok;
    const Status status = check_vector(def.P_B, limits::position_max);
    return status == Status::ok ? check_length(length_of(def), unit) : status;
}

bool is_valid(const TieRecord& record, JointKind kind, scalar unit) {
    if (record.slack > 1 || !is_finite(record.length) || !is_finite(record.reeled)) return false;
    if (!has_length(kind)) return record.length == 0 && record.reeled == 0 && record.slack == 0;
    return check_length(record.length, unit) == Status::ok && record.reeled > 0 && record.reeled <= limits::position_max;
}

} }  // namespace ingot

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

Status check_ratio(scalar ratio, scalar unit_A, scalar unit_B) {
    if (!is_finite(ratio)) return Status::not_finite;
    const scalar size = abs(ratio) * unit_A;
    const bool is_in_range = size > 0 && size <= limits::gear_ratio_max * unit_B && size * limits::gear_ratio_max >= unit_B;
    return is_in_range ? Status::ok : Status::out_of_range;
}

bool is_valid(const GearRecord& gear, JointKind kind, int joints) {
    bool finite = is_finite(gear.ratio), none = gear.joint[0] == 0 && gear.joint[1] == 0 && gear.ratio == 0;
    for (int i = 0; i < 2; ++i) {
        finite = finite && is_finite(gear.begin[i]) && is_finite(gear.value[i].angle);
        none = none && gear.begin[i] == 0 && gear.value[i].angle == 0 && gear.value[i].turns == 0;
    }
    if (kind != JointKind::gear) return finite && none;
    return finite && gear.ratio != 0 && gear.joint[0] < joints && gear.joint[1] < joints && gear.joint[0] != gear.joint[1];
}

bool is_valid(const TieRecord& record, JointKind kind, scalar unit) {
    if (record.slack > 1 || !is_finite(record.length) || !is_finite(record.reeled)) return false;
    if (!has_length(kind)) return record.length == 0 && record.reeled == 0 && (record.slack == 0 || kind == JointKind::gear);
    return check_length(record.length, unit) == Status::ok && record.reeled > 0 && record.reeled <= limits::position_max;
}

} }  // namespace ingot

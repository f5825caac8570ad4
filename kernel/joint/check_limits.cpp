// SPDX-License-Identifier: MIT
#include "check_limits.h"

#include "../base/figure_limits.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// An end is none, or within these.
bool is_within(const JointRange& range, scalar lower, scalar upper) {
    const auto is_end = [&](scalar end, scalar none) { return end == none || (end >= lower && end <= upper); };
    return is_end(range.lower, -unlimited) && is_end(range.upper, unlimited);
}

bool is_in_range(JointKind kind, const JointLimits& limits) {
    const scalar turns = limits::joint_angle_max, swing = limits::joint_swing_max;
    const JointRange& first = limits.range[0];
    const JointRange& second = limits.range[1];
    switch (kind) {
        case JointKind::ball: return is_within(first, -swing, swing) && is_within(second, limits::joint_cone_min, swing);
        case JointKind::hinge: return is_within(first, -turns, turns);
        case JointKind::slider: return is_within(first, -limits::position_max, limits::position_max);
        case JointKind::wheel:
            return is_within(first, -turns, turns) && is_within(second, -limits::position_max, limits::position_max);
        case JointKind::universal: return is_within(first, -swing, swing) && is_within(second, -swing, swing);
        default: return true;
    }
}

}  // namespace

Status check_limits(JointKind kind, const JointLimits& limits) {
    for (const JointRange& range : limits.range)
        if (!is_finite(range.lower) || !is_finite(range.upper)) return Status::not_finite;
    if (!is_finite(limits.restitution)) return Status::not_finite;
    for (const JointRange& range : limits.range)
        if (range.lower > range.upper) return Status::bad_joint;
    if (!is_in_range(kind, limits)) return Status::out_of_range;
    return limits.restitution >= 0 && limits.restitution <= 1 ? Status::ok : Status::bad_restitution;
}

bool limits_something(const JointLimits& limits) {
    bool some = false;
    for (const JointRange& range : limits.range) some = some || range.lower > -unlimited || range.upper < unlimited;
    return some;
}

bool is_valid(const LimitRecord& record, JointKind kind) {
    for (int i = 0; i < 2; ++i)
        if (!is_finite(record.j[i]) || !is_finite(record.leave[i])) return false;
    return check_limits(kind, record.limits) == Status::ok;
}

bool is_valid(const AngleRecord& record) {
    const scalar most = scalar(3.1415926535897932385);  // pi
    return record.angle >= -most && record.angle <= most;
}

} }  // namespace ingot

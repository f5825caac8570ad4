// SPDX-License-Identifier: MIT
// Joints that are beyond their ends: the rows of their way back, for push_joint_rows.
#pragma once

#include "row_compliance.h"

namespace ingot { inline namespace INGOT_ABI {

/// How far a joint is pushed back that is so far beyond its end, rad or units of length.
struct WayBack {
    scalar most;  ///< where it returns from further away
    bool again;   ///< such a one has had its share

    scalar of(scalar beyond, scalar unit, bool returns) const { return beyond <= most * unit || !returns ? beyond : again ? 0 : most * unit; }
};

inline bool pushes(const JointRow& row, scalar unit) { return row.lower > limits::limit_slack * unit || row.upper < -limits::limit_slack * unit; }

/// Lists the directions of a joint that are near to their ends. True where one is beyond.
template <class Joint>
bool list_limits(const Joint& joint, JointRowView& all, const WayBack& way) {
    const FigureNode& node = joint.node();
    bool some = false;
    for (int i = 0; i < limited_directions(node.kind); ++i) {  // bound: 2
        const JointRange ends = ends_of(node, i, all.limits[node.joint].limits);
        const JointMotion& motion = all.motions[node.joint];
        const scalar value = value_of(node, motion, i), unit = unit_of_travel(node.kind, i, joint.view().unit), reach = limits::limit_reach * unit;
        if (value - ends.lower > reach && ends.upper - value > reach) continue;
        JointRow row{};
        joint.name(row);
        row.direction_i = static_cast<uint8_t>(i);
        row.most = scalar_max;
        row.lower = way.of(ends.lower - value, unit, motion.returns[i]);
        row.upper = -way.of(value - ends.upper, unit, motion.returns[i]);
        some = some || pushes(row, unit);
        all.list[all.count++] = row;
    }
    return some;
}

/// What a row is along, and how it gives way. Needs: factor_figures, and where bodies are now.
template <class Rows>
void aim_limit(const FigureView& view, const Rows& all, JointRow& row) {
    at_joint(view, all, row, [&](const auto& joint) {
        const JointKind kind = joint.node().kind;
        JointSides<scalar> sides{};
        if (is_ball(kind)) sides = joint.sides();
        row.along = along_direction(kind, row.direction_i, sides);
        row.K = compliance_of(joint, all, row.along);
    });
}

} }  // namespace ingot

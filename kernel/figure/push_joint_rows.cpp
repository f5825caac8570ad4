// SPDX-License-Identifier: MIT
#include "../base/limits.h"
#include "displace_rows.h"
#include "joint_motions.h"
#include "joint_rows.h"
#include "row_compliance.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// How far a joint is pushed back that is so far beyond its end, rad or units of length.
struct WayBack {
    scalar most;  ///< where it returns from further away
    bool again;   ///< such a one has had its share

    scalar of(scalar beyond, scalar unit, bool returns) const { return beyond <= most * unit || !returns ? beyond : again ? 0 : most * unit; }
};

bool pushes(const JointRow& row, scalar unit) { return row.lower > limits::limit_slack * unit || row.upper < -limits::limit_slack * unit; }

/// Lists the rows of a lane that are near to their ends; drops them again where none is beyond. False then.
template <unsigned width>
bool list_limits(const FigureRows<width>& rows, const OneLane<width>& at, JointRowView& all, const WayBack& way) {
    const int count = all.count;
    bool some = false;
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        const FigureNode& node = rows.node(row_i, at.lane_i);
        for (int i = 0; i < limited_directions(node.kind); ++i) {  // bound: 2
            const JointRange ends = ends_of(node, i, all.limits[node.joint].limits);
            const JointMotion& motion = all.motions[node.joint];
            const scalar value = value_of(node, motion, i), unit = unit_of_travel(node.kind, i, rows.view.unit), reach = limits::limit_reach * unit;
            if (value - ends.lower > reach && ends.upper - value > reach) continue;
            JointRow row{};
            row.node = static_cast<Index>(rows.figure(at.lane_i).first_node + row_i);
            row.direction_i = static_cast<uint8_t>(i);
            row.most = scalar_max;
            row.lower = way.of(ends.lower - value, unit, motion.returns[i]);
            row.upper = -way.of(value - ends.upper, unit, motion.returns[i]);
            some = some || pushes(row, unit);
            all.list[all.count++] = row;
        }
    }
    if (!some) all.count = count;
    return some;
}

/// Needs: factor_figures, and where bodies are now.
void aim_limits(const FigureView& view, JointRowView& all) {
    for (int i = 0; i < all.count; ++i) {  // bound: limits_of_joint max_joints
        JointRow& row = all.list[i];
        at_node(view, row.node, [&](const auto& rows, const auto& at, int row_i) {
            const JointKind kind = rows.node(row_i, at.lane_i).kind;
            JointSides<scalar> sides{};
            if (is_ball(kind)) sides = sides_now(rows, at, row_i, true);
            row.along = along_direction(kind, row.direction_i, sides);
            row.K = compliance_of(rows, at, all, row_i, row.along);
        });
    }
}

/// One push of the lanes of a group that have something beyond its end, or a gap that such a push has left. False: there is none.
template <unsigned width>
bool push_limits(const FigureRows<width>& rows, JointRowView& all, const WayBack& way) {
    using T = typename AllLanes<width>::T;
    scalar beyond[width], was_beyond[width];
    all.count = 0;
    for (int lane_i = 0; lane_i < static_cast<int>(width); ++lane_i) {  // bound: lanes
        Figure& figure = rows.figure(lane_i);
        was_beyond[lane_i] = way.again && figure.was_beyond ? 1 : 0;
        beyond[lane_i] = list_limits(rows, rows.one(lane_i), all, way) ? 1 : 0;
        figure.was_beyond = was_beyond[lane_i] + beyond[lane_i] > 0;
    }
    if (all.count == 0 && !way.again) return false;
    T gap_sq{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        write(rows.all, rows[row_i].bias, rows.no_twist());
        if (rows.node(row_i).kind != JointKind::none) gap_sq = max(gap_sq, set_push(rows, row_i));
    }
    const auto left = both(rows.all.get(was_beyond) > T{}, gap_sq > splat<T>(limits::joint_gap * limits::joint_gap));
    const auto off = either(rows.all.get(beyond) > T{}, left);
    if (!any(off)) return false;
    clear_impulses(rows);
    pass_from_none(rows);
    aim_limits(rows.view, all);
    settle_joint_rows(rows.view, all, limits::limit_slack / 4);
    for (int row_i = 0; row_i < rows.count(); ++row_i) write(rows.all, rows[row_i].impulse, rows.no_twist());
    pass_from_none(rows);
    move_by_change(rows, off);
    return true;
}

}  // namespace

void push_joint_rows(const FigureView& view, JointRowView& all, scalar h, scalar gone) {
    measure_joints(view, all, gone);
    bool some = all.limits != nullptr;
    for (int push_i = 0; push_i < limits::limit_pushes && some; ++push_i) {
        const WayBack way = {limits::limit_return * h, push_i > 0};
        some = false;
        for_groups(view, [&](const auto& rows) { some = push_limits(rows, all, way) || some; });
        if (some) measure_joints(view, all, 0);
    }
}

} }  // namespace ingot

#pragma GCC diagnostic pop

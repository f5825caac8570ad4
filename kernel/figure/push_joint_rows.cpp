// SPDX-License-Identifier: MIT
#include "displace_rows.h"
#include "joint_motions.h"
#include "joint_rows.h"
#include "limit_pushes.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Lists the rows of a lane that are near to their ends; drops them again where none is beyond. False then.
template <unsigned width>
bool list_limits(const FigureRows<width>& rows, const OneLane<width>& at, JointRowView& all, const WayBack& way) {
    const int count = all.count;
    bool some = false;
    for (int row_i = 0; row_i < rows.count(); ++row_i)  // bound: max_bodies
        some = list_limits(TreeJoint<width>{rows, at, row_i}, all, way) || some;
    if (!some) all.count = count;
    return some;
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
    for (int i = 0; i < all.count; ++i) aim_limit(rows.view, all, all.list[i]);  // bound: limits_of_joint max_joints
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

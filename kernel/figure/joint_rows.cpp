// SPDX-License-Identifier: MIT
#include "joint_rows.h"

#include "../base/limits.h"
#include "joint_drives.h"
#include "row_compliance.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Adds a row where the joint is near an end of the direction; else it forgets what it had there.
template <unsigned width>
void list_row(const FigureRows<width>& rows, const OneLane<width>& at, JointRowView& all, int row_i, int direction_i, scalar h) {
    const FigureNode& node = rows.node(row_i, at.lane_i);
    JointMotion& motion = all.motions[node.joint];
    const JointRange ends = ends_of(node, direction_i, all.limits[node.joint].limits);
    const scalar value = value_of(node, motion, direction_i);
    JointRow row{};
    bool is_near = motion.leave[direction_i] != 0;
    if (ends.lower > -unlimited || ends.upper < unlimited) {
        row.along = along_direction(node.kind, direction_i, sides_now(rows, at, row_i, true));
        row.rate_begin = dot(row.along, free_rates_now(rows, at, row_i));
        const scalar reach = limits::limit_reach * unit_of_travel(node.kind, direction_i, rows.view.unit) + 2 * h * abs(row.rate_begin);
        is_near = is_near || value - ends.lower < reach || ends.upper - value < reach;
    }
    if (!is_near) {
        motion.j[direction_i] = motion.leave[direction_i] = 0;
        return;
    }
    row.node = static_cast<Index>(rows.figure(at.lane_i).first_node + row_i);
    row.direction_i = static_cast<uint8_t>(direction_i);
    row.most = scalar_max;
    all.list[all.count++] = row;
}

/// Adds a row for each driven direction of a joint.
template <unsigned width>
void list_drives(const FigureRows<width>& rows, const OneLane<width>& at, DrivenRowView& all, int row_i) {
    const FigureNode& node = rows.node(row_i, at.lane_i);
    for (int i = 0; i < driven_directions(node.kind); ++i) {  // bound: 3
        if (!is_driven(node, all, i)) continue;
        JointRow row{};
        row.node = static_cast<Index>(rows.figure(at.lane_i).first_node + row_i);
        row.direction_i = static_cast<uint8_t>(i);
        row.is_drive = true;
        all.list[all.count++] = row;
    }
}

/// Where a direction will be at the end of the substep, as the sides are ahead. value: where it is.
scalar value_ahead(JointKind kind, const JointSides<scalar>& sides, const JointRow& row, scalar value, scalar h) {
    const scalar ahead = measure(kind, sides).of[row.direction_i];
    if (kind == JointKind::carriage && row.direction_i == 1) return value + ahead;  // its sides are taken where the wheel is
    int32_t turns = 0;
    return turns_round(kind, row.direction_i) ? nearest_turn(ahead, value + h * row.rate, turns) : ahead;
}

/// By how much a rate may change downwards, where the joint is `room` above its end, `room_ahead` if nothing acts. leave: rad/s, m/s, from the end;
/// slack: rad, m.
scalar rate_to_end(scalar room, scalar room_ahead, scalar rate, scalar leave, scalar slack, scalar h) {
    if (leave > 0) return leave - rate;
    return room <= slack ? -rate : -room_ahead / h;
}

template <unsigned width>
void aim_row(const FigureRows<width>& rows, const OneLane<width>& at, const JointRowView& all, int row_i, JointRow& row, scalar h) {
    const FigureNode& node = rows.node(row_i, at.lane_i);
    const JointMotion& motion = all.motions[node.joint];
    const JointRange ends = ends_of(node, row.direction_i, all.limits[node.joint].limits);
    const JointSides<scalar> sides = sides_ahead(rows, at, row_i, h, rows.figure(at.lane_i).resolved, true);
    if (is_ball(node.kind)) row.along = along_direction(node.kind, row.direction_i, sides);
    row.rate = dot(row.along, free_rates_now(rows, at, row_i));
    const scalar value = value_of(node, motion, row.direction_i), ahead = value_ahead(node.kind, sides, row, value, h);
    const scalar leave = motion.leave[row.direction_i], slack = limits::limit_slack * unit_of_travel(node.kind, row.direction_i, rows.view.unit);
    row.K = compliance_of(rows, at, all, row_i, row.along);
    row.lower = -unlimited;
    row.upper = unlimited;
    if (ends.upper < unlimited) row.upper = -rate_to_end(ends.upper - value, ends.upper - ahead, -row.rate, -leave, slack, h);
    if (ends.lower > -unlimited) row.lower = rate_to_end(value - ends.lower, ahead - ends.lower, row.rate, leave, slack, h);
    row.lower = min(row.lower, row.upper);
    row.rests = leave == 0 && (value - ends.lower <= slack || ends.upper - value <= slack);
    row.j = row.j_sweep = row.rests ? motion.j[row.direction_i] : 0;
    row.direction = 0;
    if (!(row.K > 0)) row.K = row.j = row.j_sweep = 0;
}

/// The speed with which a joint leaves the end that it met, as the midpoint rule has it: with the energy that it had there, times e^2. v: m/s, rad/s,
/// towards the end, if the end had not been there; a: its acceleration, m/s^2; room: m, rad, that was left. 0: it comes to rest.
scalar speed_after(scalar e, scalar v, scalar a, scalar room, scalar h) {
    const scalar v_sq = v * v + 2 * a * (room - h * v / 2);
    if (!(v_sq > 0)) return 0;
    const scalar gain = a * h, after = (sqrt(gain * gain + 4 * e * e * v_sq) - gain) / 2;
    return after > gain && after > 0 ? after : 0;
}

template <unsigned width>
void note_row(const FigureRows<width>& rows, const OneLane<width>& at, const JointRowView& all, int row_i, const JointRow& of, scalar h) {
    const FigureNode& node = rows.node(row_i, at.lane_i);
    JointMotion& motion = all.motions[node.joint];
    const LimitRecord& limit = all.limits[node.joint];
    const bool leaves = motion.leave[of.direction_i] != 0;  // what throws it back is no end that it meets
    motion.j[of.direction_i] = of.rests ? of.j : 0;
    motion.leave[of.direction_i] = 0;
    const scalar e = limit.limits.restitution;
    if (of.rests || leaves || of.j == 0 || !(e > 0)) return;
    const JointRange ends = ends_of(node, of.direction_i, limit.limits);
    const scalar side = of.j > 0 ? scalar(1) : scalar(-1), value = value_of(node, motion, of.direction_i);
    const scalar room = of.j > 0 ? value - ends.lower : ends.upper - value;
    motion.leave[of.direction_i] = side * speed_after(e, -side * of.rate, side * (of.rate_begin - of.rate) / h, max(room, 0), h);
}

}  // namespace

template <class Rows>
void list_joint_rows(const FigureView& view, Rows& all, scalar h) {
    all.count = 0;
    for_joints(view, [&](const auto& rows, const auto& at, int row_i) {
        const int directions = limits_of(rows.node(row_i, at.lane_i), all);
        for (int i = 0; i < directions; ++i) list_row(rows, at, all, row_i, i, h);  // bound: 2
        if constexpr (Rows::has_drives) list_drives(rows, at, all, row_i);
    });
}

template <class Rows>
void aim_joint_rows(const FigureView& view, const Rows& all, scalar h) {
    for (int i = 0; i < all.count; ++i) {  // bound: rows_of_joint max_joints
        JointRow& row = all.list[i];
        if (row.stands) continue;
        if constexpr (Rows::has_drives) {
            if (row.is_drive) {
                aim_drive(view, all, row, h);
                continue;
            }
        }
        at_node(view, row.node, [&](const auto& rows, const auto& at, int row_i) { aim_row(rows, at, all, row_i, row, h); });
    }
    give_joint_rows(view, all);
}

template <class Rows>
void note_joint_rows(const FigureView& view, const Rows& all, scalar h) {
    for (int i = 0; i < all.count; ++i) {  // bound: rows_of_joint max_joints
        const JointRow& row = all.list[i];
        if (row.is_drive) continue;
        at_node(view, row.node, [&](const auto& rows, const auto& at, int row_i) { note_row(rows, at, all, row_i, row, h); });
    }
    if constexpr (Rows::has_drives) note_drives(view, all);
}

void give_joint_rows(const FigureView& view, const JointRowView& all) {
    for_groups(view, [](const auto& rows) {
        for (int row_i = 0; row_i < rows.count(); ++row_i) write(rows.all, rows[row_i].drive, rows.no_twist().v);  // bound: max_bodies
    });
    for (int i = 0; i < all.count; ++i) {  // bound: rows_of_joint max_joints
        const JointRow& row = all.list[i];
        at_node(view, row.node, [&](const auto& rows, const auto& at, int row_i) {
            write(at, rows[row_i].drive, read(at, rows[row_i].drive) + row.along * row.j);
        });
    }
}

// The linker takes the one that the scene calls.
#define INGOT_ROWS(Rows)                                                    \
    template void list_joint_rows(const FigureView&, Rows&, scalar);        \
    template void aim_joint_rows(const FigureView&, const Rows&, scalar);   \
    template void note_joint_rows(const FigureView&, const Rows&, scalar)
INGOT_ROWS(JointRowView);
INGOT_ROWS(DrivenRowView);
#undef INGOT_ROWS

} }  // namespace ingot

#pragma GCC diagnostic pop

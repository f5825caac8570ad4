// SPDX-License-Identifier: MIT
#include "joint_rows.h"

#include "../base/figure_limits.h"
#include "joint_drives.h"
#include "row_compliance.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

void forget_free_rows(const FigureView& view, const LoopView& loops) {
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        for_loop_joints(loops, of, [](LoopJoint& loop) {
            for (int row = loop.row_count; row < loop.row_end; ++row) loop.j[row] = 0;  // bound: 3
        });
    });
}

/// Adds a row where the joint is near an end of the direction; else it forgets what it had there.
template <class Joint>
void list_row(const Joint& joint, JointRowView& all, int direction_i, scalar h) {
    const FigureNode& node = joint.node();
    JointMotion& motion = all.motions[node.joint];
    const JointRange ends = ends_of(node, direction_i, all.limits[node.joint].limits);
    const scalar value = value_of(node, motion, direction_i);
    JointRow row{};
    bool is_near = motion.leave[direction_i] != 0;
    if (ends.lower > -unlimited || ends.upper < unlimited) {
        row.along = along_direction(node.kind, direction_i, joint.sides());
        row.rate_begin = dot(row.along, joint.rates());
        const scalar reach = limits::limit_reach * unit_of_travel(node.kind, direction_i, joint.view().unit) + 2 * h * abs(row.rate_begin);
        is_near = is_near || value - ends.lower < reach || ends.upper - value < reach;
    }
    if (!is_near) {
        motion.j[direction_i] = motion.leave[direction_i] = 0;
        return;
    }
    joint.name(row);
    row.direction_i = static_cast<uint8_t>(direction_i);
    row.most = scalar_max;
    all.list[all.count++] = row;
}

/// Adds a row for each driven direction of a joint.
template <class Joint, class Rows>
void list_drives(const Joint& joint, Rows& all) {
    const FigureNode& node = joint.node();
    for (int i = 0; i < drives_in(node.kind, all); ++i) {  // bound: 3
        if (!is_driven(node, all, i)) continue;
        JointRow row{};
        joint.name(row);
        row.direction_i = static_cast<uint8_t>(i);
        row.is_drive = true;
        all.list[all.count++] = row;
    }
}

/// Where a direction will be at the end of the substep, as the sides are then. value: where it is.
template <class Joint>
scalar value_ahead(const Joint& joint, const JointSides<scalar>& sides, const JointRow& row, scalar value, scalar h) {
    const JointKind kind = joint.node().kind;
    const scalar ahead = measure(kind, sides).of[row.direction_i];
    if (joint.goes_on() && row.direction_i == 1) return value + ahead;
    int32_t turns = 0;
    return turns_round(kind, row.direction_i) ? nearest_turn(ahead, value + h * row.rate, turns) : ahead;
}

/// By how much a rate may change downwards, where the joint is `room` above its end, `room_ahead` if nothing acts. leave: rad/s, m/s, from the end;
/// slack: rad, m.
scalar rate_to_end(scalar room, scalar room_ahead, scalar rate, scalar leave, scalar slack, scalar h) {
    if (leave > 0) return leave - rate;
    return room <= slack ? -rate : -room_ahead / h;
}

template <class Joint, class Rows>
void aim_row(const Joint& joint, const Rows& all, JointRow& row, scalar h) {
    const FigureNode& node = joint.node();
    const JointMotion& motion = all.motions[node.joint];
    const JointRange ends = ends_of(node, row.direction_i, all.limits[node.joint].limits);
    const JointSides<scalar> sides = joint.sides_after(h);
    if (is_ball(node.kind)) row.along = along_direction(node.kind, row.direction_i, sides);
    row.rate = dot(row.along, joint.rates());
    const scalar value = value_of(node, motion, row.direction_i), ahead = value_ahead(joint, sides, row, value, h);
    const scalar leave = motion.leave[row.direction_i], slack = limits::limit_slack * unit_of_travel(node.kind, row.direction_i, joint.view().unit);
    row.K = compliance_of(joint, all, row.along);
    row.lower = -unlimited;
    row.upper = unlimited;
    if (ends.upper < unlimited) row.upper = -rate_to_end(ends.upper - value, ends.upper - ahead, -row.rate, -leave, slack, h);
    if (ends.lower > -unlimited) row.lower = rate_to_end(value - ends.lower, ahead - ends.lower, row.rate, leave, slack, h);
    row.lower = min(row.lower, row.upper);
    row.rests = leave == 0 && (value - ends.lower <= slack || ends.upper - value <= slack);
    const scalar j = motion.j[row.direction_i], room = j > 0 ? value - ends.lower : ends.upper - value;
    row.j = row.j_sweep = row.rests || (leave == 0 && room <= row.K * abs(j) * h) ? j : 0;
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

/// What a row that does not rest carries: its impulse without what has stopped the joint. Where sweeps end before they have settled it stays a little
/// off its end, and would else carry its load from nothing in each substep, which they would not settle either.
scalar load_of(const JointRow& of) {
    if (!(of.K > 0)) return 0;
    const scalar side = of.j > 0 ? scalar(1) : scalar(-1), load = abs(of.j) - max(-side * of.rate_begin, 0) / of.K;
    return load > 0 ? side * load : scalar(0);
}

void note_row(const FigureNode& node, const JointRowView& all, const JointRow& of, scalar h) {
    JointMotion& motion = all.motions[node.joint];
    const LimitRecord& limit = all.limits[node.joint];
    const bool leaves = motion.leave[of.direction_i] != 0;  // what throws it back is no end that it meets
    motion.j[of.direction_i] = of.rests ? of.j : leaves ? scalar(0) : load_of(of);
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
    for_moving_joints(view, all, [&](const auto& joint) {
        const int directions = limits_of(joint.node(), all);
        for (int i = 0; i < directions; ++i) list_row(joint, all, i, h);  // bound: 2
        if constexpr (Rows::has_drives) list_drives(joint, all);
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
        at_joint(view, all, row, [&](const auto& joint) { aim_row(joint, all, row, h); });
    }
    give_joint_rows(view, all);
}

template <class Rows>
void note_joint_rows(const FigureView& view, const Rows& all, scalar h) {
    for (int i = 0; i < all.count; ++i) {  // bound: rows_of_joint max_joints
        const JointRow& row = all.list[i];
        if (row.is_drive) continue;
        at_joint(view, all, row, [&](const auto& joint) { note_row(joint.node(), all, row, h); });
    }
    if constexpr (Rows::has_drives) note_drives(view, all);
}

template <class Rows>
void give_joint_rows(const FigureView& view, const Rows& all) {
    for_groups(view, [](const auto& rows) {
        for (int row_i = 0; row_i < rows.count(); ++row_i) write(rows.all, rows[row_i].drive, rows.no_twist().v);  // bound: max_bodies
    });
    if constexpr (Rows::closes) forget_free_rows(view, *all.loops);
    for (int i = 0; i < all.count; ++i) {  // bound: rows_of_joint max_joints
        const JointRow& row = all.list[i];
        at_joint(view, all, row, [&](const auto& joint) { joint.add_drive(row.along * row.j); });
    }
}

// The linker takes the one that the scene calls.
#define INGOT_ROWS(Rows)                                                    \
    template void list_joint_rows(const FigureView&, Rows&, scalar);        \
    template void aim_joint_rows(const FigureView&, const Rows&, scalar);   \
    template void note_joint_rows(const FigureView&, const Rows&, scalar);  \
    template void give_joint_rows(const FigureView&, const Rows&)
INGOT_ROWS(JointRowView);
INGOT_ROWS(DrivenRowView);
INGOT_ROWS(LoopedRowView);
#undef INGOT_ROWS

} }  // namespace ingot

#pragma GCC diagnostic pop

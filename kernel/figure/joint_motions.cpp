// SPDX-License-Identifier: MIT
#include "joint_motions.h"

#include "../base/figure_limits.h"
#include "moving_joint.h"
#include "row_motion.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// way: rad, that the joint has gone since.
void count_turns(JointMotion& motion, scalar angle, scalar way) {
    int32_t more = 0;
    (void)nearest_turn(angle, motion.value[0] + way, more);
    motion.turns += more;
}

/// What has no limits and no turns to count is not asked where it is.
bool is_measured(JointKind kind, const JointRowView& all) { return limited_directions(kind) > 0 && (all.limits != nullptr || !is_ball(kind)); }

/// Values of all lanes; angles of hinges beside h times their rates.
template <unsigned width>
void measure_row(const FigureRows<width>& rows, const JointRowView& all, int row_i, scalar h) {
    using T = typename AllLanes<width>::T;
    const JointKind kind = rows.node(row_i).kind;
    if (!is_measured(kind, all)) return;
    const JointValues<T> now = measure(kind, sides_now(rows, rows.all, row_i, true));
    T way{};
    if (turns_round(kind) && h > 0) way = free_rates_now(rows, rows.all, row_i).x * splat<T>(h);
    scalar values[2][width], ways[width];
    rows.all.put(values[0], now.of[0]);
    rows.all.put(values[1], now.of[1]);
    rows.all.put(ways, way);
    for (int lane_i = 0; lane_i < static_cast<int>(width); ++lane_i) {  // bound: lanes
        JointMotion& motion = all.motions[rows.node(row_i, lane_i).joint];
        if (turns_round(kind)) count_turns(motion, values[0][lane_i], ways[lane_i]);
        for (int i = 0; i < 2; ++i) motion.value[i] = values[i][lane_i];
    }
}

/// Of the joints that close loops.
void measure_loops(const FigureView&, const JointRowView&, scalar) {}
void measure_loops(const FigureView& view, const LoopedRowView& all, scalar h) {
    for_looped_figures(view, *all.loops, [&](const LoopFigure& of) {
        for_loop_joints(*all.loops, of, [&](LoopJoint& loop) {
            if (!is_measured(loop.kind, all)) return;
            const LoopedJoint joint{view, *all.loops, loop};
            const JointValues<scalar> now = measure(loop.kind, joint.sides());
            JointMotion& motion = all.motions[loop.joint];
            if (turns_round(loop.kind)) count_turns(motion, now.of[0], h > 0 ? joint.rates().x * h : scalar(0));
            for (int i = 0; i < 2; ++i) motion.value[i] = now.of[i];
        });
    });
}

/// Of a joint as its record has it.
JointMotion recalled(const FigureNode& node, const JointRowView& all, scalar share) {
    const AngleRecord& angle = all.angles[node.joint];
    JointMotion motion{};
    for (int i = 0; i < limits_of(node, all); ++i) {  // bound: 2
        const LimitRecord& limit = all.limits[node.joint];
        const DirectionOfRecord of = of_record(node, i);
        motion.j[i] = limit.j[of.direction_i] * (of.sign * share);
        motion.leave[i] = limit.leave[of.direction_i] * of.sign;
    }
    if (turns_round(node.kind)) {
        motion.value[0] = node.is_A ? -angle.angle : angle.angle;
        motion.turns = node.is_A ? -angle.turns : angle.turns;
    }
    return motion;
}

/// False for those of bodies that have gone bad.
bool is_good(const JointMotion& motion) {
    bool good = true;
    for (int i = 0; i < 2; ++i) good = good && is_finite(motion.value[i]) && is_finite(motion.j[i]) && is_finite(motion.leave[i]);
    return good;
}

}  // namespace

template <class Rows>
void begin_joint_motions(const FigureView& view, const Rows& all) {
    for_moving_joints(view, all, [&](const auto& joint) {
        const FigureNode& node = joint.node();
        const scalar share = 1 / static_cast<scalar>(1 << joint.figure().doublings);
        all.motions[node.joint] = recalled(node, all, share);
    });
    for_groups(view, [](const auto& rows) { set_spins(rows); });
    measure_joints(view, all, 0);
    for_moving_joints(view, all, [&](const auto& joint) {
        const FigureNode& node = joint.node();
        JointMotion& motion = all.motions[node.joint];
        for (int i = 0; i < limits_of(node, all); ++i) {  // bound: 2
            const JointRange ends = ends_of(node, i, all.limits[node.joint].limits);
            const scalar value = value_of(node, motion, i);
            const scalar slack = limits::limit_slack * unit_of_travel(node.kind, i, view.unit);
            motion.returns[i] = ends.lower - value > slack || value - ends.upper > slack;
        }
    });
}

template <class Rows>
void measure_joints(const FigureView& view, const Rows& all, scalar h) {
    for_groups(view, [&](const auto& rows) {
        for (int row_i = 0; row_i < rows.count(); ++row_i) measure_row(rows, all, row_i, h);  // bound: max_bodies
    });
    measure_loops(view, all, h);
}

template <class Rows>
void keep_joint_motions(const FigureView& view, const Rows& all, int doublings) {
    const auto scale = static_cast<scalar>(1 << doublings);
    for_moving_joints(view, all, [&](const auto& joint) {
        if (joint.figure().doublings > doublings) return;
        const FigureNode& node = joint.node();
        const JointMotion& motion = all.motions[node.joint];
        if (!is_good(motion)) return;
        for (int i = 0; i < limits_of(node, all); ++i) {  // bound: 2
            LimitRecord& limit = all.limits[node.joint];
            const DirectionOfRecord of = of_record(node, i);
            limit.j[of.direction_i] = motion.j[i] * (of.sign * scale);
            limit.leave[of.direction_i] = motion.leave[i] * of.sign;
        }
        if (!turns_round(node.kind)) return;
        AngleRecord& angle = all.angles[node.joint];
        angle.angle = node.is_A ? -motion.value[0] : motion.value[0];
        angle.turns = node.is_A ? -motion.turns : motion.turns;
    });
}

// The linker takes the one that the scene calls.
#define INGOT_ROWS(Rows)                                                       \
    template void begin_joint_motions(const FigureView&, const Rows&);         \
    template void measure_joints(const FigureView&, const Rows&, scalar);      \
    template void keep_joint_motions(const FigureView&, const Rows&, int)
INGOT_ROWS(JointRowView);
INGOT_ROWS(DrivenRowView);
INGOT_ROWS(LoopedRowView);
#undef INGOT_ROWS

} }  // namespace ingot

#pragma GCC diagnostic pop

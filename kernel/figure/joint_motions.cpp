// SPDX-License-Identifier: MIT
#include "joint_motions.h"

#include "../base/limits.h"
#include "measure_joint.h"
#include "row_motion.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Values of all lanes; angles of hinges beside h times their rates.
template <unsigned width>
void measure_row(const FigureRows<width>& rows, const JointRowView& all, int row_i, scalar h) {
    using T = typename AllLanes<width>::T;
    const JointKind kind = rows.node(row_i).kind;
    if (limited_directions(kind) == 0) return;
    const JointValues<T> now = measure(kind, sides_now(rows, rows.all, row_i, true));
    T way{};
    if (turns_round(kind) && h > 0) way = free_rates_now(rows, rows.all, row_i).x * splat<T>(h);
    scalar values[2][width], ways[width];
    rows.all.put(values[0], now.of[0]);
    rows.all.put(values[1], now.of[1]);
    rows.all.put(ways, way);
    for (int lane_i = 0; lane_i < static_cast<int>(width); ++lane_i) {  // bound: lanes
        JointMotion& motion = all.motions[rows.node(row_i, lane_i).joint];
        if (turns_round(kind)) {
            int32_t more = 0;
            (void)nearest_turn(values[0][lane_i], motion.value[0] + ways[lane_i], more);
            motion.turns += more;
        }
        for (int i = 0; i < 2; ++i) motion.value[i] = values[i][lane_i];
    }
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

void begin_joint_motions(const FigureView& view, const JointRowView& all) {
    for_joints(view, [&](const auto& rows, const auto& at, int row_i) {
        const FigureNode& node = rows.node(row_i, at.lane_i);
        const scalar share = 1 / static_cast<scalar>(1 << rows.figure(at.lane_i).doublings);
        all.motions[node.joint] = recalled(node, all, share);
    });
    for_groups(view, [](const auto& rows) { set_spins(rows); });
    measure_joints(view, all, 0);
    for_joints(view, [&](const auto& rows, const auto& at, int row_i) {
        const FigureNode& node = rows.node(row_i, at.lane_i);
        JointMotion& motion = all.motions[node.joint];
        for (int i = 0; i < limits_of(node, all); ++i) {  // bound: 2
            const JointRange ends = ends_of(node, i, all.limits[node.joint].limits);
            const scalar value = value_of(node, motion, i);
            const scalar slack = limits::limit_slack * unit_of_travel(node.kind, i, rows.view.unit);
            motion.returns[i] = ends.lower - value > slack || value - ends.upper > slack;
        }
    });
}

void measure_joints(const FigureView& view, const JointRowView& all, scalar h) {
    for_groups(view, [&](const auto& rows) {
        for (int row_i = 0; row_i < rows.count(); ++row_i) measure_row(rows, all, row_i, h);  // bound: max_bodies
    });
}

void keep_joint_motions(const FigureView& view, const JointRowView& all, int doublings) {
    const auto scale = static_cast<scalar>(1 << doublings);
    for_joints(view, [&](const auto& rows, const auto& at, int row_i) {
        if (rows.figure(at.lane_i).doublings > doublings) return;
        const FigureNode& node = rows.node(row_i, at.lane_i);
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

} }  // namespace ingot

#pragma GCC diagnostic pop

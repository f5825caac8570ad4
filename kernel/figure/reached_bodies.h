// SPDX-License-Identifier: MIT
// Bodies of figures that something reaches in a solve: contacts, rows of joints, loops; and all from there to the roots. Of the others each hands on
// to its parent the same in every sweep, and nobody asks how it answers an impulse: they are worked out once, or not at all. It changes no bit.
#pragma once

#include "gear_rows.h"
#include "measure_joint.h"

namespace ingot { inline namespace INGOT_ABI {

/// As FigureNode::towards, where no cursor comes.
inline constexpr Index not_reached = no_node;

/// Something reaches a body, or nothing any, of the batch: until reach says otherwise.
inline void reach_all(const FigureView& view, Index towards) {
    for_groups(view, [towards](const auto& rows) {
        for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i)  // bound: lanes
            for (int row_i = 0; row_i < rows.count(); ++row_i) rows.node(row_i, lane_i).towards = towards;  // bound: max_bodies
    });
}
inline void reach(const FigureView& view, Index node_i) {
    const Index first = view.figures[view.nodes[node_i].figure].first_node;
    while (view.nodes[node_i].towards == not_reached) {  // bound: max_bodies: a parent comes before its children
        FigureNode& node = view.nodes[node_i];
        node.towards = 0;
        if (node.parent != no_node) node_i = static_cast<Index>(first + node.parent);
    }
}
/// In some lane.
template <unsigned width, class Kinds>
INGOT_INLINE bool is_reached(const FigureRows<width, Kinds>& rows, int row_i) {
    bool some = false;
    for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i) some = some || rows.node(row_i, lane_i).towards != not_reached;  // bound: lanes
    return some;
}

/// By loops, and by ties.
inline void reach_loops(const FigureView&, const NoLoops&) {}
inline void reach_loops(const FigureView& view, const LoopView& loops) {
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        for_loop_joints(loops, of, [&](const LoopJoint& loop) {
            for_bodies_of(loops, loop, 0, [&](Index node_i, const Spatial<scalar>&) { reach(view, node_i); });
        });
    });
}

/// True of a direction whose row may be visited, or whose drive asks for what it moves.
inline bool may_have_row(const FigureNode& node, const JointRowView& all, int direction_i) {
    if (all.limits == nullptr || direction_i >= limited_directions(node.kind)) return false;
    const JointRange ends = ends_of(node, direction_i, all.limits[node.joint].limits);
    return ends.lower > -unlimited || ends.upper < unlimited;
}
template <class Rows>
bool may_be_driven_row(const FigureNode& node, const Rows& all, int direction_i) {
    if (direction_i >= drives_in(node.kind, all)) return false;
    const JointDrive& drive = drive_of(node, all, direction_i);
    return drive.kind != DriveKind::none && (drive.kind != DriveKind::spring || drive.max_torque < unlimited);
}
/// By rows of joints.
template <class Rows>
void reach_rows(const FigureView& view, const Rows& all) {
    for_joints(view, [&](const auto& rows, const auto& at, int row_i) {
        const FigureNode& node = rows.node(row_i, at.lane_i);
        bool some = is_wheel(node.kind);
        for (int i = 0; i < 3; ++i) {  // bound: 3
            some = some || may_have_row(node, all, i);
            if constexpr (Rows::has_drives) some = some || may_be_driven_row(node, all, i);
        }
        if (some) reach(view, static_cast<Index>(rows.figure(at.lane_i).first_node + row_i));
    });
}

} }  // namespace ingot

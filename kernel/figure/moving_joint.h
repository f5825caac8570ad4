// SPDX-License-Identifier: MIT
// A joint in its free directions, as its limits and drives see it: one of a tree, or one that closes a loop.
#pragma once

#include "loop_sides.h"
#include "measure_joint.h"
#include "respond_figures.h"
#include "tree_passes.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// Of a tree: the joint of a row of its figure.
template <unsigned width>
struct TreeJoint {
    static constexpr bool closes = false;

    const FigureRows<width>& rows;
    OneLane<width> at;
    int row_i;

    const FigureView& view() const { return rows.view; }
    const FigureNode& node() const { return rows.node(row_i, at.lane_i); }
    const Figure& figure() const { return rows.figure(at.lane_i); }
    FigureRow<width>& row() const { return rows[row_i]; }
    void name(JointRow& of) const { of.node = static_cast<Index>(figure().first_node + row_i); }

    JointSides<scalar> sides() const { return sides_now(rows, at, row_i, true); }
    JointSides<scalar> sides_after(scalar h) const { return sides_ahead(rows, at, row_i, h, figure().resolved, true); }
    /// The travel of sides_after is counted from where the joint is: see place_carriages.
    bool goes_on() const { return node().kind == JointKind::carriage; }
    Vector rates() const { return free_rates_now(rows, at, row_i); }
    Matrix A_of_child() const { return read(at, row().A); }
    Matrix A_of_parent() const { return node().parent == no_node ? ground_of(rows, at).A : read(at, rows[node().parent].A); }
    void add_drive(const Vector& drive) const { write(at, row().drive, read(at, row().drive) + drive); }
};

template <unsigned width>
TreeJoint<width> tree_joint(const FigureRows<width>& rows, const OneLane<width>& at, int row_i) {
    return {rows, at, row_i};
}

/// One that closes a loop: LoopJoint::other is the parent of its child.
struct LoopedJoint {
    static constexpr bool closes = true;

    const FigureView& of_figures;
    const LoopView& loops;
    LoopJoint& loop;

    const FigureView& view() const { return of_figures; }
    FigureNode node() const {
        FigureNode as_node{};
        as_node.joint = loop.joint;
        as_node.kind = loop.kind;
        as_node.is_A = loop.is_A;
        return as_node;
    }
    const Figure& figure() const { return of_figures.figures[of_figures.nodes[loop.child].figure]; }
    void name(JointRow& of) const {
        of.node = static_cast<Index>(&loop - loops.joints);
        of.closes = true;
    }

    JointSides<scalar> sides() const { return sides_of(of_figures, loop, 0).now(); }
    JointSides<scalar> sides_after(scalar h) const {
        const LoopSides of = sides_of(of_figures, loop, h);
        Vector moved;
        return ingot::sides_after(of, of.now(), is_exact(of_figures, loop), h, moved);
    }
    bool goes_on() const { return false; }
    Vector rates() const {
        const LoopSides of = sides_of(of_figures, loop, 0);
        const Vector v = of.child.v + cross(of.child.w, of.arm_of_child(loop.kind)) - of.other.v - cross(of.other.w, of.arm_of_other(loop.kind));
        const Spatial<scalar> u = {of.child.w - of.other.w, v};
        Spatial<scalar> s[3] = {};
        (void)free_directions(loop.kind, loop_sides_now(loop, of), s);
        return {dot(s[0], u), dot(s[1], u), dot(s[2], u)};
    }
    Matrix A_of_child() const { return sides_of(of_figures, loop, 0).child.A; }
    Matrix A_of_parent() const { return sides_of(of_figures, loop, 0).other.A; }
    void add_drive(const Vector& drive) const {
        scalar* const j = loop.j + loop.row_count;
        const scalar parts[3] = {drive.x, drive.y, drive.z};
        for (int i = 0; i < loop.row_end - loop.row_count; ++i) j[i] += parts[i];  // bound: 3
    }
};

/// Calls each(joint) for every joint of the batch that is no tie, machine by machine; those that close its loops come last.
template <class Each>
INGOT_INLINE void for_moving_joints(const FigureView& view, const JointRowView&, const Each& each) {
    for_joints(view, [&](const auto& rows, const auto& at, int row_i) { each(tree_joint(rows, at, row_i)); });
}
template <class Each>
INGOT_INLINE void for_moving_joints(const FigureView& view, const LoopedRowView& all, const Each& each) {
    const LoopView& loops = *all.loops;
    for (int figure_i = 0; figure_i < view.figure_count; ++figure_i) {  // bound: max_bodies
        if (!is_of_batch(view, static_cast<Index>(figure_i))) continue;
        const Figure& figure = view.figures[figure_i];
        for (int node_i = figure.first_node; node_i < figure.first_node + figure.node_count; ++node_i)  // bound: max_bodies
            at_node(view, static_cast<Index>(node_i), [&](const auto& rows, const auto& at, int row_i) {
                if (rows.node(row_i, at.lane_i).kind != JointKind::none) each(tree_joint(rows, at, row_i));
            });
        const Index loops_i = loops.of_figure[figure_i];
        if (loops_i == no_loop || figure_i + 1 < loops.figures[loops_i].figure + loops.figures[loops_i].figure_count) continue;
        for_loop_joints(loops, loops.figures[loops_i], [&](LoopJoint& loop) {
            if (!is_tie(loop.kind)) each(LoopedJoint{view, loops, loop});
        });
    }
}

/// Calls each(joint) for the joint of a row.
template <class Rows, class Each>
INGOT_INLINE auto at_joint(const FigureView& view, [[maybe_unused]] const Rows& all, const JointRow& row, const Each& each) {
    if constexpr (Rows::closes)
        if (row.closes) return each(LoopedJoint{view, *all.loops, all.loops->joints[row.node]});
    return at_node(view, row.node, [&](const auto& rows, const auto& at, int row_i) { return each(tree_joint(rows, at, row_i)); });
}
/// A body of it: its child.
INGOT_INLINE Index node_of(const JointRowView&, const JointRow& row) { return row.node; }
INGOT_INLINE Index node_of(const LoopedRowView& all, const JointRow& row) { return row.closes ? all.loops->joints[row.node].child : row.node; }
INGOT_INLINE JointKind kind_of(const FigureView& view, const JointRowView&, const JointRow& row) { return view.nodes[row.node].kind; }
INGOT_INLINE JointKind kind_of(const FigureView& view, const LoopedRowView& all, const JointRow& row) {
    return row.closes ? all.loops->joints[row.node].kind : view.nodes[row.node].kind;
}

} }  // namespace ingot

#pragma GCC diagnostic pop

// SPDX-License-Identifier: MIT
#include "note_reactions.h"

#include "joint_sides.h"
#include "tree_passes.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Calls each(joint_i, figure) for all joints of the batch.
template <class Each>
void for_all_joints(const FigureView& view, const NoLoops&, const Each& each) {
    for_groups(view, [&](const auto& rows) {
        for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i)  // bound: lanes
            for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
                const FigureNode& node = rows.node(row_i, lane_i);
                if (node.kind != JointKind::none) each(node.joint, rows.figure(lane_i));
            }
    });
}
template <class Each>
void for_all_joints(const FigureView& view, const LoopView& loops, const Each& each) {
    for_all_joints(view, NoLoops{}, each);
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        for_loop_joints(loops, of, [&](const LoopJoint& loop) { each(loop.joint, view.figures[of.figure]); });
    });
}

/// M' u of the parent.
template <unsigned width, class T = typename AllLanes<width>::T>
INGOT_INLINE Spatial<T> passed_down(const FigureRows<width>& rows, int row_i, JointKind kind) {
    const Spatial<T> u = change_of_parent(rows, rows.all, row_i);
    const Spatial6<T> M = read(rows.all, rows[row_i].inertia);
    return kind == JointKind::ball ? Spatial<T>{Vec3<T>{}, M.C * u.v} : M * u;
}

template <unsigned width, class T = typename AllLanes<width>::T>
void note_row(const FigureRows<width>& rows, ReactionView all, int row_i) {
    const JointKind kind = rows.node(row_i).kind;
    if (kind == JointKind::none) return;
    const FigureRow<width>& row = rows[row_i];
    Spatial<T> f;
    Vec3<T> gap{};
    if (rows.node(row_i).parent == no_node)
        f = rows.no_twist() - impulse_to_send(rows.all, row, kind);  // to the ground: no cursor goes there
    else
        f = passed_down(rows, row_i, kind) - read(rows.all, row.sent);
    if (kind == JointKind::slider) gap = sides_now(rows, rows.all, row_i, false).gap;
    add_reactions(rows, row_i, locked_part(rows.all, row, kind, f), gap, all);
}

Vector place_of_side(const FigureView& view, Index node_i, Index ground, const Vector& arm) {
    if (node_i == no_node) return ground_at(view, ground).r + arm;
    return at_node(view, node_i, [&](const auto& rows, const auto& at, int row_i) { return read(at, rows[row_i].r) + arm; });
}

void note_loop(const FigureView& view, const LoopJoint& loop, ReactionView all) {
    Spatial<scalar> on_child{};
    for (int row = 0; row < loop.row_count; ++row) {  // bound: rows_of_joint_max
        Vector& sum = loop.is_turn[row] ? on_child.w : on_child.v;
        sum = sum + loop.direction[row] * loop.j[row];
    }
    Vector gap{};
    if (loop.kind == JointKind::slider)
        gap = place_of_side(view, loop.child, no_body, loop.arm) - place_of_side(view, loop.other, loop.ground, loop.arm_of_other);
    add_reaction(all.of_joint[loop.joint], on_child, loop.is_A && loop.kind != JointKind::gear, gap);
}

void note_loops(const FigureView&, const NoLoops&, ReactionView) {}
void note_loops(const FigureView& view, const LoopView& loops, ReactionView all) {
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        for_loop_joints(loops, of, [&](const LoopJoint& loop) { note_loop(view, loop, all); });
    });
}

}  // namespace

template <class Loops>
void begin_reactions(const FigureView& view, const Loops& loops, ReactionView all) {
    for_all_joints(view, loops, [&](Index joint_i, const Figure&) { all.of_joint[joint_i] = {}; });
}

template <class Loops>
void note_reactions(const FigureView& view, const Loops& loops, ReactionView all) {
    for_groups(view, [&](const auto& rows) {
        for (int row_i = 0; row_i < rows.count(); ++row_i) note_row(rows, all, row_i);  // bound: max_bodies
    });
    note_loops(view, loops, all);
}

template <class Loops>
void keep_reactions(const FigureView& view, const Loops& loops, ReactionView all, int doublings) {
    for_all_joints(view, loops, [&](Index joint_i, const Figure& figure) {
        if (figure.doublings > doublings) return;
        JointReaction& reaction = all.of_joint[joint_i];
        reaction = mean_of_step(reaction, view.h);
    });
}

// The linker takes the one that the scene calls.
#define INGOT_LOOPS(Loops)                                                               \
    template void begin_reactions(const FigureView&, const Loops&, ReactionView); \
    template void note_reactions(const FigureView&, const Loops&, ReactionView);  \
    template void keep_reactions(const FigureView&, const Loops&, ReactionView, int)
INGOT_LOOPS(NoLoops);
INGOT_LOOPS(LoopView);
#undef INGOT_LOOPS

} }  // namespace ingot

#pragma GCC diagnostic pop

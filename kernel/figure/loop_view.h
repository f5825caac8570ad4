// SPDX-License-Identifier: MIT
// Joints that close loops: those that a tree leaves out, because both of their bodies are in it already, or because it is tied once before. And ties:
// rods, ropes and others that lock little, which are in no tree. What ties hold together is a machine of one tree or several.
//
// A tree is solved in one way up and down; a loop is not. So each loop is cut at one joint, whose locked directions are rows J beside the tree. With
// U = what the tree answers to J, and C = J U, impulses j = C^-1 r make up for what the rows lack, r, exactly. C = L L^T, and X = L^-1 U is kept of
// every body:
//
//     z = L^-1 r            what the rows of a figure lack; impulses j = L^-T z
//     u + X^T z             the twist of a body with its loops closed; u: by the tree alone
//     Q - X^T X             its response to an impulse
//     z -= X f              an impulse f on the body is felt by the rows
//
// so a contact of a figure with loops feels them at once, and the tree is passed through without them. Rows that say the same as others, as the
// second hinge of a door does, are left out: C is factored with the row first that gives way most by what those before it have left it, until none
// gives way by more than limits::loop_compliance of what its bodies would without joints. How such rows share their load is not determined.
//
// A rope has a row while it is taut. Whether it is turns out in the solve: those that would push are let go, those that would be too long are taken
// in, and the substep is solved again (settle_rows).
// Source: Featherstone 2008, chapter 8 (loop joints); columns by impulses as Mirtich 1996; pivoted Cholesky factors as Higham 2002, chapter 10.
#pragma once

#include "../joint/gear_record.h"
#include "../joint/target_record.h"
#include "../joint/tie_record.h"
#include "figure_view.h"

namespace ingot { inline namespace INGOT_ABI {

inline constexpr int rows_of_joint_max = 6;

/// A locked direction: what a unit impulse along it is on either body, at its q. Nothing on what cannot move.
struct LoopRow {
    Spatial<scalar> on_child, on_other;
};

/// A joint that closes a loop. Its bodies are called as if it were one of the tree, from the other to the child.
struct LoopJoint {
    Index joint;        ///< of FigureView::lists
    Index child, other; ///< nodes; other is no_node where it is what cannot move
    Index ground;       ///< slot of that, or no_body: the world
    Index next;         ///< of its figure; no_loop: none
    JointKind kind;
    bool is_A;          ///< the child is A of the joint
    bool is_slack;      ///< a rope that has no row in the substep at hand
    uint8_t first_row, row_count;  ///< of the rows of its figure
    uint8_t row_end;     ///< of its own: from row_count on those of its free directions, whose j are given by limits and drives; see place_free_rows
    bool is_turn[rows_of_joint_max];     ///< the row is of a turn
    Vector direction[rows_of_joint_max]; ///< world, unit; of a servo of three rows, [3]: what their rates answer to an impulse of 1 along each
    LoopRow rows[rows_of_joint_max];
    scalar target[rows_of_joint_max];    ///< m/s, rad/s; m, rad of a push: by how much the child's speed should change against the other's
    scalar j[rows_of_joint_max];         ///< N s, N m s
    scalar length;                       ///< m; of a rod or a rope: where it ends
    Vector arm, arm_of_other;            ///< m, from the centres of mass to the sides of the joint
    Vector given;                        ///< N s, that the child got in the last substep
};

/// Of a body that is drawn to a target, in the step at hand. [2]: of force and torque.
struct TargetMotion {
    scalar share;          ///< of what the body alone gives way by: so much gives way of the rows; p / (1 - p) of the poles of the substep
    scalar h;              ///< s, of the substep
    bool held[2];          ///< it is no row, but given as it is
    Vector force, torque;  ///< N s, N m s: given since the step began
};

/// Of a gear, in the step at hand. Its row is of up to four bodies: both sides of both of its joints.
struct GearMotion {
    int count;               ///< of those that can move
    Index node[4];
    Spatial<scalar> on[4];   ///< what a unit impulse of the row is on them, at q
    AngleRecord value[2];    ///< as GearRecord has it
    scalar elapsed;          ///< s, since the step began, as they were that
    scalar driven;           ///< m/s, that what moves as it is told asks for
};

/// The loops of a machine: of one figure, or of several that follow each other.
struct LoopFigure {
    Index figure;          ///< the first
    Index figure_count;
    Index first_node, node_count;
    Index first_joint;     ///< no_loop: none
    Index row_count;
    Index rank;            ///< of its rows, how many are independent
    scalar least;          ///< of what a row would give way without joints, the least that one does, once those before it hold; 1: has none
    bool was_apart;        ///< in some substep of the batch pushes have left a gap: with more substeps there is less to push
    bool is_settled;       ///< none of its ropes has come to its end, or was let go, since the substep was solved last
    bool in_solve;         ///< in contact: the sweeps at hand began with its island
    bool stands;           ///< in contact: sweeps go on without it: its impulses are left as they are
    int32_t first_row;     ///< of LoopView::z
    int32_t first_entry;   ///< of LoopView::L
    int32_t first_column;  ///< of LoopView::X: those of its first node
};

/// Of scenes that have none.
struct NoLoops {
    static constexpr bool closes = false;
    using Kinds = AnyKinds;
};
/// The same whose joints are hinges, all of them.
struct NoLoopsOfHinges : NoLoops {
    using Kinds = HingesAlone;
};
/// Without its capacities.
struct LoopView {
    static constexpr bool closes = true;
    using Kinds = AnyKinds;

    LoopJoint* joints;
    LoopFigure* figures;
    const TieRecord* ties;  ///< by joint; null: the scene names none
    Index* of_figure;       ///< by figure: its loops, or no_loop
    TargetRecord* targets;         ///< by joint; null: the scene names none
    TargetMotion* target_motions;  ///< by joint
    GearRecord* gears;             ///< by joint; null: the scene names none
    GearMotion* gear_motions;      ///< by joint
    Index* machine_of;      ///< by figure: the first of its machine; of scenes that name ties
    scalar* z;              ///< by row
    scalar* L;              ///< triangles by rows; the inverse of the diagonal in its place
    uint8_t* order;         ///< by row of L: which row of the figure it is
    Spatial<scalar>* X;     ///< at q, by node and row
    int joint_capacity, joint_count;
    int figure_count;
    int rows_max;           ///< of a figure

    Spatial<scalar>* X_of(const LoopFigure& of, int row_i) const { return X + of.first_column + row_i * of.row_count; }
    /// Of the figure of a node; null: it has none.
    LoopFigure* of_node(const FigureView& view, Index node_i) const {
        const Index loops_i = of_figure[view.nodes[node_i].figure];
        return loops_i == no_loop ? nullptr : &figures[loops_i];
    }
};

/// A servo: of its two bodies only the child is measured, in the world; the other gets the torque back.
INGOT_INLINE bool locks_nothing(const LoopJoint& loop) { return loop.row_count == 0; }

/// What a target gives at its most; and any row that is left out of the solve.
INGOT_INLINE bool is_given(const LoopView& loops, const LoopJoint& loop, int row) {
    return loop.kind == JointKind::target && loops.target_motions[loop.joint].held[row / 3];
}
INGOT_INLINE bool is_left_out(const LoopView& loops, const LoopJoint& loop, int row) { return loop.is_slack || is_given(loops, loop, row); }

/// Calls each(loop) for the joints of a figure that close its loops.
template <class Each>
INGOT_INLINE void for_loop_joints(const LoopView& loops, const LoopFigure& of, const Each& each) {
    for (Index loop_i = of.first_joint; loop_i != no_loop; loop_i = loops.joints[loop_i].next) each(loops.joints[loop_i]);  // bound: max_loops
}
/// Calls each(of, lane_i) where a figure of a group has loops.
template <unsigned width, class Kinds, class Each>
INGOT_INLINE void for_looped(const FigureRows<width, Kinds>& rows, const LoopView& loops, const Each& each) {
    for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i) {  // bound: lanes
        const Index loops_i = loops.of_figure[rows.group.figure[lane_i]];
        if (loops_i != no_loop) each(loops.figures[loops_i], lane_i);
    }
}
INGOT_INLINE bool is_of_batch(const FigureView& view, Index figure_i) {
    const Figure& figure = view.figures[figure_i];
    if (figure.group >= view.group_count) return false;
    const FigureGroup& group = view.groups[figure.group];
    const bool has_lane = figure.lane_i == 0 || group.is_wide;  // else what is there is of another batch
    return has_lane && group.figure[figure.lane_i] == figure_i;
}
/// Calls each(of) for those of the batch: all figures of a machine are in one.
template <class Each>
INGOT_INLINE void for_looped_figures(const FigureView& view, const LoopView& loops, const Each& each) {
    for (int loops_i = 0; loops_i < loops.figure_count; ++loops_i)  // bound: max_loops
        if (is_of_batch(view, loops.figures[loops_i].figure)) each(loops.figures[loops_i]);
}

/// Calls each(rows, at) for the figures of a machine.
template <class Each>
INGOT_INLINE void for_figures_of(const FigureView& view, const LoopFigure& of, const Each& each) {
    for (int i = 0; i < of.figure_count; ++i)  // bound: max_bodies
        at_node(view, view.figures[of.figure + i].first_node, [&](const auto& rows, const auto& at, int) { each(rows, at); });
}

} }  // namespace ingot

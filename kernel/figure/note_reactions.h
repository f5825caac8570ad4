// SPDX-License-Identifier: MIT
// What joints bear in a step, summed over its substeps. Of scenes that read it.
//
// A tree knows the impulse f that passes each joint: what a child answers with all that hangs on it, M' u - sent of tree_passes.h. Drives and limits
// are the part of it along free directions; the rest is what the joint locks. Joints that close loops know theirs by row.
#pragma once

#include "../joint/reactions.h"
#include "loop_view.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// By joint; N s and N m s while the step goes on.
struct ReactionView {
    JointReaction* of_joint;
};
struct NoReactions {};

/// Adds what the child of a joint got, at its own side; gap: m, of a slider, from the other side to that.
INGOT_INLINE void add_reaction(JointReaction& to, const Spatial<scalar>& on_child, bool child_is_A, const Vector& gap) {
    if (child_is_A) {
        to.force = to.force - on_child.v;
        to.torque = to.torque - (on_child.w + cross(gap, on_child.v));
    } else {
        to.force = to.force + on_child.v;
        to.torque = to.torque + on_child.w;
    }
}
/// The same of the joints of a row.
template <unsigned width, class T = typename AllLanes<width>::T>
void add_reactions(const FigureRows<width>& rows, int row_i, const Spatial<T>& on_child, const Vec3<T>& gap, ReactionView all) {
    SpatialRows<width> f;
    scalar gaps[3][width];
    write(rows.all, f, on_child);
    write(rows.all, gaps, gap);
    for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i) {  // bound: lanes
        const FigureNode& node = rows.node(row_i, lane_i);
        const OneLane<width> at{lane_i};
        add_reaction(all.of_joint[node.joint], read(at, f), node.is_A, read(at, gaps));
    }
}

// Loops: LoopView, or NoLoops.

/// The batch begins, or begins again. After group_figures.
template <class Loops>
void begin_reactions(const FigureView& view, const Loops& loops, ReactionView all);
/// After end_solve, before bodies move. Cost: about 60 flops a joint.
template <class Loops>
void note_reactions(const FigureView& view, const Loops& loops, ReactionView all);
/// The mean of the step, of figures that do not begin it again. doublings: of the batch.
template <class Loops>
void keep_reactions(const FigureView& view, const Loops& loops, ReactionView all, int doublings);

template <class Loops>
INGOT_INLINE void begin_reactions(const FigureView&, const Loops&, NoReactions) {}
template <class Loops>
INGOT_INLINE void note_reactions(const FigureView&, const Loops&, NoReactions) {}
template <class Loops>
INGOT_INLINE void keep_reactions(const FigureView&, const Loops&, NoReactions, int) {}

} }  // namespace ingot

#pragma GCC diagnostic pop

// SPDX-License-Identifier: MIT
// Both sides of a joint that closes a loop, as joint_sides.h has those of the trees.
#pragma once

#include "joint_sides.h"
#include "loop_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Both bodies of a joint, and how they move in a substep.
struct LoopSides {
    SideMotion<scalar> child, other;
    const JointFrame &of_child, &of_other;

    JointSides<scalar> now() const { return sides_at(child, of_child, other, of_other); }
    /// m, world, from the centres of mass: where both sides act on each other. On the child's side, but for a wheel: its own is where it touches its
    /// axle, whichever of the two it is.
    Vector arm_of_child(JointKind kind) const { return kind == JointKind::carriage ? other.r + arm_on_other() - child.r : arm_on_child(); }
    Vector arm_of_other(JointKind kind) const { return kind == JointKind::carriage ? arm_on_other() : child.r + arm_on_child() - other.r; }

private:
    Vector arm_on_child() const { return child.A * of_child.anchor; }
    Vector arm_on_other() const { return other.A * of_other.anchor; }
};

/// h: s, of the substep.
inline LoopSides sides_of(const FigureView& view, const LoopJoint& loop, scalar h) {
    const JointRecord& record = view.lists.joints[loop.joint];
    const auto motion_of = [&](Index node_i) {
        return at_node(view, node_i, [](const auto& rows, const auto& at, int row_i) { return motion_of_row(at, rows[row_i]); });
    };
    const bool is_tied = loop.other == no_node || locks_nothing(loop);
    const Index ground = locks_nothing(loop) ? no_body : loop.ground;
    return {motion_of(loop.child), is_tied ? motion_of_ground(ground_at(view, ground), h) : motion_of(loop.other),
            loop.is_A ? record.frame_A : record.frame_B, loop.is_A ? record.frame_B : record.frame_A};
}

/// A servo turns about the axis of the world.
inline JointSides<scalar> loop_sides_now(const LoopJoint& loop, const LoopSides& of) {
    JointSides<scalar> sides = of.now();
    if (locks_nothing(loop)) sides.axis = sides.axis_of_parent;
    return sides;
}

/// Where the sides will be at the end of a substep of h seconds, if nothing acts. moved: m, the gap.
inline JointSides<scalar> sides_after(const LoopSides& of, const JointSides<scalar>& now, bool is_exact, scalar h, Vector& moved) {
    const Turning<scalar, bool> child = {of.child.turn, of.child.w * h, is_exact}, other = {of.other.turn, of.other.w * h, is_exact};
    const Vector turned = child.shift(of.child.A * of.of_child.anchor) - other.shift(of.other.A * of.of_other.anchor);
    moved = (of.child.v - of.other.v) * h + turned;
    return {now.gap + moved, child.after(now.axis), other.after(now.axis_of_parent), child.after(now.side), other.after(now.side_of_parent)};
}

/// Turns are taken to second order.
inline bool is_exact(const FigureView& view, const LoopJoint& loop) {
    const auto is_resolved = [&](Index node_i) { return node_i == no_node || view.figures[view.nodes[node_i].figure].resolved; };
    return is_resolved(loop.child) && is_resolved(loop.other);
}

/// Its free directions, as of a joint of a tree: twists of the child against the other, at the child's side. Returns how many.
inline int free_directions(JointKind kind, const JointSides<scalar>& of, Spatial<scalar> (&s)[3]) {
    switch (kind) {
        case JointKind::ball:
        case JointKind::driven_ball:
            s[0] = {{1, 0, 0}, {}};
            s[1] = {{0, 1, 0}, {}};
            s[2] = {{0, 0, 1}, {}};
            return 3;
        case JointKind::hinge: s[0] = {of.axis, {}}; return 1;
        case JointKind::slider: s[0] = {{}, of.axis_of_parent}; return 1;
        case JointKind::universal:
            s[0] = {of.axis_of_parent, {}};
            s[1] = {of.axis, {}};
            return 2;
        default: break;
    }
    if (!is_wheel(kind)) return 0;
    const bool of_A = kind == JointKind::carriage;
    const Vector along = of_A ? of.axis : of.axis_of_parent;
    s[0] = {of_A ? of.axis_of_parent : of.axis, {}};
    s[1] = {{}, along};
    s[2] = {along, {}};
    return 3;
}

} }  // namespace ingot

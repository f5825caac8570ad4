// SPDX-License-Identifier: MIT
// Both sides of a joint in world axes, where they are and where they will be, and what takes them back to each other.
#pragma once

#include "ground.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// By how much a turn moves an arm: (R - 1) arm. The angle of R is that of the turn but for its fifth power / 120.
template <class T>
INGOT_INLINE Vec3<T> chord(const Vec3<T>& turn, const Vec3<T>& arm) {
    const Vec3<T> c = turn * (splat<T>(scalar(0.5)) + length_sq(turn) * splat<T>(scalar(1) / 24)), x = cross(c, arm);
    return (x + cross(c, x)) * (splat<T>(2) / (splat<T>(1) + length_sq(c)));
}

/// A body, or the ground, as it turns in the substep: arms move by their chords, or to first order.
template <class T, class M>
struct Turning {
    Vec3<T> turn, w_h;
    M is_exact;

    INGOT_INLINE Vec3<T> shift(const Vec3<T>& arm) const { return select(is_exact, chord(turn, arm), cross(w_h, arm)); }
    INGOT_INLINE Vec3<T> after(const Vec3<T>& arm) const { return arm + shift(arm); }
};

template <class T>
struct JointSides {
    Vec3<T> gap;                        ///< m, from the parent's side to the child's
    Vec3<T> axis, axis_of_parent;
    Vec3<T> side, side_of_parent;       ///< of joints that let nothing turn, and where angles are measured
};

inline bool locks_turns(JointKind kind) { return kind == JointKind::fixed || kind == JointKind::slider; }

/// The twist, times seconds, that takes a joint back to its place. Of an angle between axes that is small.
template <class T>
INGOT_INLINE Spatial<T> twist_back(JointKind kind, const JointSides<T>& of) {
    Spatial<T> back = {Vec3<T>{}, -of.gap};
    if (kind == JointKind::hinge) back.w = cross(of.axis, of.axis_of_parent);
    if (kind == JointKind::universal) {
        const Vec3<T> x = cross(of.axis_of_parent, of.axis);
        back.w = x * (dot(of.axis_of_parent, of.axis) / length_sq(x));
    }
    if (locks_turns(kind)) {
        const Vec3<T> third = cross(of.axis, of.side), third_of_parent = cross(of.axis_of_parent, of.side_of_parent);
        const Vec3<T> sum = cross(of.axis, of.axis_of_parent) + cross(of.side, of.side_of_parent) + cross(third, third_of_parent);
        back.w = sum * splat<T>(scalar(0.5));
    }
    if (kind == JointKind::slider) back.v = of.axis_of_parent * dot(of.gap, of.axis_of_parent) - of.gap;
    return back;
}

/// The parent of a node: a body of its figure, or the ground.
template <class T>
struct ParentMotion {
    Vec3<T> r;
    Mat3<T> A;
    Vec3<T> v, w, turn;  ///< turn: rad, in the substep
};
template <unsigned width, class At, class T = typename At::T>
INGOT_INLINE ParentMotion<T> parent_of(const FigureRows<width>& rows, const At& at, const FigureNode& node, scalar h) {
    if (node.parent == no_node) {
        const Ground<T> ground = ground_of(rows, at);
        return {ground.r, ground.A, ground.v, ground.w, ground.w * splat<T>(h)};
    }
    const FigureRow<width>& row = rows[node.parent];
    return {read(at, row.r), read(at, row.A), read(at, row.v), read(at, row.w), read(at, row.turn)};
}

/// Where the sides are. with_sides: JointSides::side too.
template <unsigned width, class At, class T = typename At::T>
INGOT_INLINE JointSides<T> sides_now(const FigureRows<width>& rows, const At& at, int row_i, bool with_sides) {
    const FigureRow<width>& row = rows[row_i];
    const FigureNode& node = rows.node(row_i);
    Vec3<T> r_parent;
    Mat3<T> A_parent;
    if (node.parent == no_node) {
        const Ground<T> ground = ground_of(rows, at);
        r_parent = ground.r;
        A_parent = ground.A;
    } else {
        r_parent = read(at, rows[node.parent].r);
        A_parent = read(at, rows[node.parent].A);
    }
    const Mat3<T> A = read(at, row.A);
    const auto own = [&](auto part) { return A * rows.gathered(at, row_i, [&](const FigureNode& of) { return rows.own_frame(of).*part; }); };
    const auto of_parent = [&](auto part) {
        return A_parent * rows.gathered(at, row_i, [&](const FigureNode& of) { return rows.frame_of_parent(of).*part; });
    };
    JointSides<T> sides = {(read(at, row.r) - r_parent) + (own(&JointFrame::anchor) - of_parent(&JointFrame::anchor)), {}, {}, {}, {}};
    if (node.kind != JointKind::ball || with_sides) {
        sides.axis = own(&JointFrame::axis);
        sides.axis_of_parent = of_parent(&JointFrame::axis);
    }
    if (with_sides) {
        sides.side = own(&JointFrame::side);
        sides.side_of_parent = of_parent(&JointFrame::side);
    }
    return sides;
}

/// Where they will be at the end of the substep of h seconds, if nothing acts any more. is_exact: turns to second order, else to first. Needs:
/// place_joints, FigureRow::turn.
template <unsigned width, class At, class M, class T = typename At::T>
INGOT_INLINE JointSides<T> sides_ahead(const FigureRows<width>& rows, const At& at, int row_i, scalar h, M is_exact, bool with_sides) {
    const FigureRow<width>& row = rows[row_i];
    const FigureNode& node = rows.node(row_i);
    const T h_lane = splat<T>(h);
    const ParentMotion<T> of = parent_of(rows, at, node, h);
    const Turning<T, M> own = {read(at, row.turn), read(at, row.w) * h_lane, is_exact}, parent = {of.turn, of.w * h_lane, is_exact};
    const Vec3<T> arm = -read(at, row.c), arm_of_parent = read(at, row.arm_of_parent);
    JointSides<T> sides = {(read(at, row.r) - of.r) + (arm - arm_of_parent) + (read(at, row.v) - of.v) * h_lane +
                               (own.shift(arm) - parent.shift(arm_of_parent)),
                           own.after(read(at, row.axis)), parent.after(read(at, row.axis_of_parent)), {}, {}};
    if (with_sides) {
        sides.side = own.after(read(at, row.A) * rows.gathered(at, row_i, [&](const FigureNode& node_of) { return rows.own_frame(node_of).side; }));
        sides.side_of_parent =
            parent.after(of.A * rows.gathered(at, row_i, [&](const FigureNode& node_of) { return rows.frame_of_parent(node_of).side; }));
    }
    return sides;
}

} }  // namespace ingot

#pragma GCC diagnostic pop

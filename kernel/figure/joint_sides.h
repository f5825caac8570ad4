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
    if (kind == JointKind::universal || is_wheel(kind)) {
        const Vec3<T> x = cross(of.axis_of_parent, of.axis);
        back.w = x * (dot(of.axis_of_parent, of.axis) / length_sq(x));
    }
    if (locks_turns(kind)) {
        const Vec3<T> third = cross(of.axis, of.side), third_of_parent = cross(of.axis_of_parent, of.side_of_parent);
        const Vec3<T> sum = cross(of.axis, of.axis_of_parent) + cross(of.side, of.side_of_parent) + cross(third, third_of_parent);
        back.w = sum * splat<T>(scalar(0.5));
    }
    if (kind == JointKind::slider || is_wheel(kind)) {
        const Vec3<T>& along = kind == JointKind::carriage ? of.axis : of.axis_of_parent;
        back.v = along * dot(of.gap, along) - of.gap;
    }
    return back;
}

/// A side of a joint: a body of a figure, or the ground.
template <class T>
struct SideMotion {
    Vec3<T> r;
    Mat3<T> A;
    Vec3<T> v, w, turn;  ///< turn: rad, in the substep
};
template <class T>
INGOT_INLINE SideMotion<T> motion_of_ground(const Ground<T>& ground, scalar h) {
    return {ground.r, ground.A, ground.v, ground.w, ground.w * splat<T>(h)};
}
template <class At, class T = typename At::T>
INGOT_INLINE SideMotion<T> motion_of_row(const At& at, const FigureRow<At::width>& row) {
    return {read(at, row.r), read(at, row.A), read(at, row.v), read(at, row.w), read(at, row.turn)};
}
/// Of the parent of a node. h: s, of the substep.
template <unsigned width, class Kinds, class At, class T = typename At::T>
INGOT_INLINE SideMotion<T> motion_of_parent(const FigureRows<width, Kinds>& rows, const At& at, const FigureNode& node, scalar h) {
    return node.parent == no_node ? motion_of_ground(ground_of(rows, at), h) : motion_of_row(at, rows[node.parent]);
}

/// Where the sides of one joint are.
inline JointSides<scalar> sides_at(const SideMotion<scalar>& child, const JointFrame& of_child, const SideMotion<scalar>& parent,
                                   const JointFrame& of_parent) {
    return {(child.r - parent.r) + (child.A * of_child.anchor - parent.A * of_parent.anchor), child.A * of_child.axis, parent.A * of_parent.axis,
            child.A * of_child.side, parent.A * of_parent.side};
}

/// The same of a row. with_sides: JointSides::side too.
template <unsigned width, class Kinds, class At, class T = typename At::T>
INGOT_INLINE JointSides<T> sides_now(const FigureRows<width, Kinds>& rows, const At& at, int row_i, bool with_sides) {
    const FigureRow<width>& row = rows[row_i];
    const FigureNode& node = rows.node(row_i);
    const SideMotion<T> parent = motion_of_parent(rows, at, node, 0);
    const Mat3<T> A = read(at, row.A);
    const auto own = [&](auto part) { return A * rows.gathered(at, row_i, [&](const FigureNode& of) { return rows.own_frame(of).*part; }); };
    const auto of_parent = [&](auto part) {
        return parent.A * rows.gathered(at, row_i, [&](const FigureNode& of) { return rows.frame_of_parent(of).*part; });
    };
    JointSides<T> sides = {(read(at, row.r) - parent.r) + (own(&JointFrame::anchor) - of_parent(&JointFrame::anchor)), {}, {}, {}, {}};
    if (rows.kind(row_i) != JointKind::ball || with_sides) {
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
template <unsigned width, class Kinds, class At, class M, class T = typename At::T>
INGOT_INLINE JointSides<T> sides_ahead(const FigureRows<width, Kinds>& rows, const At& at, int row_i, scalar h, M is_exact, bool with_sides) {
    const FigureRow<width>& row = rows[row_i];
    const FigureNode& node = rows.node(row_i);
    const T h_lane = splat<T>(h);
    const SideMotion<T> of = motion_of_parent(rows, at, node, h);
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

// SPDX-License-Identifier: MIT
// Where a joint is in its free directions, of its child against its parent.
#pragma once

#include "../base/figure_limits.h"
#include "../math/arctangent.h"
#include "joint_row.h"
#include "joint_sides.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

inline constexpr scalar whole_turn = scalar(6.28318530717958647693);  // rad

/// rad, m; of each direction that may end.
template <class T>
struct JointValues {
    T of[2];
};

/// The angle about a unit axis from one direction at right angles to it to another.
template <class T>
INGOT_INLINE T angle_about(const Vec3<T>& axis, const Vec3<T>& from, const Vec3<T>& to) {
    return arctangent(dot(axis, cross(from, to)), dot(from, to));
}

/// Of a ball joint: its twist is the turn of the child about its axis, once the least turn that takes that axis to the parent's is taken off.
template <class T>
INGOT_INLINE JointValues<T> twist_and_swing(const JointSides<T>& of) {
    const Vec3<T> x = cross(of.axis_of_parent, of.axis);
    const T cosine = dot(of.axis_of_parent, of.axis), one = splat<T>(1);
    const T share = dot(of.side, of.axis_of_parent) / max(one + cosine, splat<T>(scalar(1e-3)));
    const Vec3<T> side = of.side - (of.axis + of.axis_of_parent) * share;
    return {{angle_about(of.axis_of_parent, of.side_of_parent, side), arctangent(sqrt(length_sq(x)), cosine)}};
}

template <class T>
INGOT_INLINE JointValues<T> measure(JointKind kind, const JointSides<T>& of) {
    switch (kind) {
        case JointKind::ball:
        case JointKind::driven_ball: return twist_and_swing(of);
        case JointKind::hinge: return {{angle_about(of.axis_of_parent, of.side_of_parent, of.side), T{}}};
        case JointKind::slider: return {{dot(of.gap, of.axis_of_parent), T{}}};
        case JointKind::universal:
            return {{angle_about(of.axis_of_parent, of.side_of_parent, of.axis), angle_about(of.axis, of.axis_of_parent, of.side)}};
        case JointKind::wheel: return {{angle_about(of.axis, of.axis_of_parent, of.side), dot(of.gap, of.axis_of_parent)}};
        case JointKind::carriage: return {{angle_about(of.axis_of_parent, of.side_of_parent, of.axis), dot(of.gap, of.axis)}};
        default: return {};
    }
}

/// rad, how far a wheel is steered, in -pi .. pi.
INGOT_INLINE scalar steering_of(JointKind kind, const JointSides<scalar>& of) {
    if (kind == JointKind::carriage) return angle_about(of.axis, of.axis_of_parent, of.side);
    return angle_about(of.axis_of_parent, of.side_of_parent, of.axis);
}

/// What a drive of 1 along a direction is; of a cone whose axis is in its middle: none.
INGOT_INLINE Vector along_direction(JointKind kind, int direction_i, const JointSides<scalar>& of) {
    if (!is_ball(kind)) return direction_i == 0 ? Vector{1, 0, 0} : Vector{0, 1, 0};
    if (direction_i == 0) return (of.axis + of.axis_of_parent) * (1 / max(1 + dot(of.axis, of.axis_of_parent), scalar(1e-3)));
    const Vector x = cross(of.axis_of_parent, of.axis);
    const scalar sine_sq = length_sq(x);
    return sine_sq > 0 ? x * (1 / sqrt(sine_sq)) : Vector{};
}

/// The rates of the free directions in a twist of the child against its parent.
template <class At, class T = typename At::T>
INGOT_INLINE Vec3<T> free_rates(const At& at, const FigureRow<At::width>& row, JointKind kind, const Spatial<T>& u) {
    const T none{};
    switch (kind) {
        case JointKind::ball:
        case JointKind::driven_ball: return u.w;
        case JointKind::hinge: return {dot(read(at, row.axis), u.w), none, none};
        case JointKind::slider: return {dot(read(at, row.axis_of_parent), u.v), none, none};
        case JointKind::universal: return {dot(read(at, row.axis_of_parent), u.w), dot(read(at, row.axis), u.w), none};
        case JointKind::wheel:
        case JointKind::carriage: {
            const bool of_A = kind == JointKind::carriage;
            const Vec3<T> along = read(at, of_A ? row.axis : row.axis_of_parent), axle = read(at, of_A ? row.axis_of_parent : row.axis);
            return {dot(axle, u.w), dot(along, u.v), dot(along, u.w)};
        }
        default: return {none, none, none};
    }
}

/// The twist of a child against its parent as they move, at the child's q. Needs: place_joints, FigureRow::w.
template <unsigned width, class Kinds, class At, class T = typename At::T>
INGOT_INLINE Spatial<T> twist_of_joint(const FigureRows<width, Kinds>& rows, const At& at, int row_i) {
    const FigureRow<width>& row = rows[row_i];
    const FigureNode& node = rows.node(row_i);
    const Vec3<T> w = read(at, row.w), c = read(at, row.c);
    Vec3<T> w_parent, v_parent;
    if (node.parent == no_node) {
        const Ground<T> ground = ground_of(rows, at);
        w_parent = ground.w;
        v_parent = ground.v + cross(ground.w, read(at, row.r) - c - ground.r);
    } else {
        const FigureRow<width>& parent = rows[node.parent];
        w_parent = read(at, parent.w);
        v_parent = read(at, parent.v) + cross(w_parent, read(at, row.d) - read(at, parent.c));
    }
    return {w - w_parent, read(at, row.v) - cross(w, c) - v_parent};
}
/// The rates of its free directions.
template <unsigned width, class Kinds, class At, class T = typename At::T>
INGOT_INLINE Vec3<T> free_rates_now(const FigureRows<width, Kinds>& rows, const At& at, int row_i) {
    return free_rates(at, rows[row_i], rows.kind(row_i), twist_of_joint(rows, at, row_i));
}

/// Of a slot of a joint's record: a record is of B against A, and the child may be either.
struct DirectionOfRecord {
    int direction_i;
    scalar sign;
};
INGOT_INLINE DirectionOfRecord of_record(const FigureNode& node, int direction_i) {
    if (node.kind == JointKind::universal && node.is_A) return {1 - direction_i, -1};
    const bool is_cone = is_ball(node.kind) && direction_i == 1;
    return {direction_i, node.is_A && !is_cone ? scalar(-1) : scalar(1)};
}

/// Of a direction; of a ball joint the drive of all.
INGOT_INLINE const JointDrive& drive_of(const FigureNode& node, const DrivenRowView& all, int direction_i) {
    return drives_of(node, all)[is_ball(node.kind) ? 0 : of_record(node, direction_i).direction_i].drive;
}

INGOT_INLINE bool is_driven(const FigureNode& node, const DrivenRowView& all, int direction_i) {
    return drive_of(node, all, direction_i).kind != DriveKind::none;
}

/// Of a direction of the child against its parent.
INGOT_INLINE JointRange ends_of(const FigureNode& node, int direction_i, const JointLimits& limits) {
    const DirectionOfRecord of = of_record(node, direction_i);
    const JointRange& range = limits.range[of.direction_i];
    return of.sign < 0 ? JointRange{-range.upper, -range.lower} : range;
}

/// Whether a direction goes on over whole turns.
INGOT_INLINE bool turns_round(JointKind kind, int direction_i = 0) { return kind == JointKind::hinge || (is_wheel(kind) && direction_i == 0); }

/// rad, m; an angle of a hinge or of a wheel with its whole turns.
INGOT_INLINE scalar value_of(const FigureNode& node, const JointMotion& motion, int direction_i) {
    const scalar value = motion.value[direction_i];
    return turns_round(node.kind, direction_i) ? value + static_cast<scalar>(motion.turns) * whole_turn : value;
}

/// The angle that is whole turns from `angle` and nearest to `guess`.
INGOT_INLINE scalar nearest_turn(scalar angle, scalar guess, int32_t& turns) {
    scalar off = (guess - angle) * (1 / whole_turn);
    if (!(abs(off) <= limits::turns_max)) off = 0;  // of bodies that go bad
    turns = static_cast<int32_t>(off < 0 ? off - scalar(0.5) : off + scalar(0.5));
    return angle + static_cast<scalar>(turns) * whole_turn;
}

} }  // namespace ingot

#pragma GCC diagnostic pop

// SPDX-License-Identifier: MIT
// How the rate of a joint's direction answers an impulse on it.
#pragma once

#include "../base/figure_limits.h"
#include "moving_joint.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// An impulse of 1 along a row on both bodies of its joint, at their q.
struct ImpulseAlong {
    LoopRow row;
    Index child, other;  ///< nodes; no_node: what cannot move
};
template <unsigned width>
ImpulseAlong impulse_along(const TreeJoint<width>& joint, const Vector& along) {
    const FigureNode& node = joint.node();
    const Index first = joint.figure().first_node;
    Spatial<scalar> f = {along, {}}, s[3];
    if (!turns_freely(node.kind)) {
        const scalar parts[3] = {along.x, along.y, along.z};
        const int free = free_directions(joint.at, joint.row(), node.kind, s);
        f = {};
        for (int i = 0; i < free; ++i) f = f + s[i] * parts[i];  // bound: 3
    }
    const auto child = static_cast<Index>(first + joint.row_i);
    if (node.parent == no_node) return {{f, {}}, child, no_node};
    return {{f, impulse_from(f, read(joint.at, joint.row().d)) * scalar(-1)}, child, static_cast<Index>(first + node.parent)};
}
inline ImpulseAlong impulse_along(const LoopedJoint& joint, const Vector& along) {
    const LoopJoint& loop = joint.loop;
    const scalar parts[3] = {along.x, along.y, along.z};
    LoopRow row{};
    for (int i = 0; i < loop.row_end - loop.row_count; ++i) {  // bound: 3
        if (parts[i] == 0) continue;
        const LoopRow& of = loop.rows[loop.row_count + i];
        row = {row.on_child + of.on_child * parts[i], row.on_other + of.on_other * parts[i]};
    }
    return {row, loop.child, loop.other};
}

/// What the rows of a machine's loops feel of it: z is less by so much.
struct FeltByLoops {
    LoopFigure* of;  ///< null: the machine has no loops
    scalar parts[limits::loop_rows_max];
};
inline FeltByLoops felt_by_loops(const FigureView& view, const LoopView& loops, const ImpulseAlong& impulse) {
    FeltByLoops felt;
    felt.of = loops.of_node(view, impulse.child);
    if (felt.of == nullptr) return felt;
    const Spatial<scalar>* const of_child = loops.X_of(*felt.of, impulse.child - felt.of->first_node);
    const Spatial<scalar>* const of_other = impulse.other == no_node ? nullptr : loops.X_of(*felt.of, impulse.other - felt.of->first_node);
    for (int i = 0; i < felt.of->rank; ++i) {  // bound: limits::loop_rows_max
        felt.parts[i] = dot(of_child[i], impulse.row.on_child);
        if (of_other != nullptr) felt.parts[i] += dot(of_other[i], impulse.row.on_other);
    }
    return felt;
}

/// By how much a row gives way to an impulse of 1, once its loops hold, which without them gives way by K. 0: they hold it, but for rounding, which
/// is that of the terms of K: alone.
inline scalar compliance_with_loops(const FigureView& view, const LoopView& loops, const ImpulseAlong& impulse, scalar K, scalar alone) {
    const FeltByLoops felt = felt_by_loops(view, loops, impulse);
    if (felt.of == nullptr) return K;
    scalar left = K;
    for (int i = 0; i < felt.of->rank; ++i) left -= felt.parts[i] * felt.parts[i];  // bound: limits::loop_rows_max
    return left > limits::row_compliance * alone ? left : scalar(0);
}

/// The change of a row's rate by an impulse of 1 on it: up to the parent, which answers with all of its figure, and down over the joint.
template <unsigned width, class Rows>
scalar compliance_of(const TreeJoint<width>& joint, const Rows& all, const Vector& along) {
    const auto& at = joint.at;
    const FigureRow<width>& row = joint.row();
    const FigureNode& node = joint.node();
    const Spatial<scalar> none{};
    Spatial<scalar> of_parent{};
    if (node.parent != no_node) {
        const Vector d = read(at, row.d);
        const Spatial<scalar> sent = impulse_from(impulse_through(at, row, node.kind, none, along), d);
        of_parent = twist_at(read(at, joint.rows.response(all.responses, node.parent)) * sent, d);
    }
    const scalar K = dot(along, free_rates(at, row, node.kind, twist_through(at, row, node.kind, of_parent, none, along) - of_parent));
    if constexpr (Rows::closes)
        return compliance_with_loops(joint.view(), *all.loops, impulse_along(joint, along), K, K);
    else
        return K;
}
/// The same of the three rates of a ball joint, by an impulse of 1 along the i-th axis of the world. Zeros: loops hold it, but for rounding.
template <unsigned width, class Rows>
Vector answer_of_ball(const TreeJoint<width>& joint, const Rows& all, int axis_i) {
    const auto& at = joint.at;
    const FigureRow<width>& row = joint.row();
    const FigureNode& node = joint.node();
    const Spatial<scalar> none{};
    const Vector axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Spatial<scalar> of_parent{};
    if (node.parent != no_node) {
        const Vector d = read(at, row.d);
        const Spatial<scalar> sent = impulse_from(impulse_through(at, row, node.kind, none, axes[axis_i]), d);
        of_parent = twist_at(read(at, joint.rows.response(all.responses, node.parent)) * sent, d);
    }
    const Vector answer = free_rates(at, row, node.kind, twist_through(at, row, node.kind, of_parent, none, axes[axis_i]) - of_parent);
    if constexpr (!Rows::closes) {
        return answer;
    } else {
        const FeltByLoops felt = felt_by_loops(joint.view(), *all.loops, impulse_along(joint, axes[axis_i]));
        if (felt.of == nullptr) return answer;
        scalar left[3] = {answer.x, answer.y, answer.z};
        for (int k = 0; k < 3; ++k) {  // bound: 3
            const FeltByLoops of_other = felt_by_loops(joint.view(), *all.loops, impulse_along(joint, axes[k]));
            for (int i = 0; i < felt.of->rank; ++i) left[k] -= felt.parts[i] * of_other.parts[i];  // bound: limits::loop_rows_max
        }
        return left[axis_i] > limits::row_compliance * dot(axes[axis_i], answer) ? Vector{left[0], left[1], left[2]} : Vector{};
    }
}
/// Of a servo: what its child answers to what is on both. 0: it would turn the other way, or its figure holds it. Of one of three rows it is kept
/// what all three answer to it: see LoopJoint::direction.
inline scalar compliance_of_servo(const LoopedJoint& joint, const LoopedRowView& all, const ImpulseAlong& impulse, const Vector& along) {
    const FigureView& view = joint.view();
    LoopJoint& loop = joint.loop;
    const Spatial<scalar>& measured = impulse.row.on_child;
    Spatial<scalar> u = at_node(view, impulse.child, [&](const auto& rows, const auto& at, int row_i) {
        return read(at, rows.response(all.responses, row_i)) * measured;
    });
    const scalar alone = dot(measured, u);
    if (impulse.other != no_node) u = u + twist_across(view, all.responses, impulse.child, impulse.other, impulse.row.on_other);
    const FeltByLoops felt = felt_by_loops(view, joint.loops, impulse);
    if (felt.of != nullptr) {
        const Spatial<scalar>* const X = joint.loops.X_of(*felt.of, impulse.child - felt.of->first_node);
        for (int i = 0; i < felt.of->rank; ++i) u = u - X[i] * felt.parts[i];  // bound: limits::loop_rows_max
    }
    const scalar parts[3] = {along.x, along.y, along.z};
    if (loop.row_end == 3)
        for (int i = 0; i < 3; ++i)
            if (parts[i] == 1) loop.direction[i] = {dot(loop.rows[0].on_child, u), dot(loop.rows[1].on_child, u), dot(loop.rows[2].on_child, u)};
    const scalar K = dot(measured, u);
    return K > limits::row_compliance * alone ? K : scalar(0);
}

/// Of a joint that closes a loop, without its loops: both of its bodies answer, each to what is on either. alone: as if there were nothing between
/// them in the tree.
struct CompliancesInTree {
    scalar K, alone;

    /// Of less it is seen what roundings leave: the tree holds what the row is along, by its joints or by their drives, or the loops do.
    scalar least() const { return limits::row_compliance * alone; }
};
inline CompliancesInTree compliances_in_tree(const LoopedJoint& joint, const LoopedRowView& all, const ImpulseAlong& impulse) {
    const FigureView& view = joint.view();
    const auto own = [&](Index node_i, const Spatial<scalar>& f) {
        return at_node(view, node_i, [&](const auto& rows, const auto& at, int row_i) {
            return dot(f, read(at, rows.response(all.responses, row_i)) * f);
        });
    };
    scalar K = own(impulse.child, impulse.row.on_child);
    if (impulse.other == no_node) return {K, K};
    K += own(impulse.other, impulse.row.on_other);
    return {K + 2 * dot(impulse.row.on_child, twist_across(view, all.responses, impulse.child, impulse.other, impulse.row.on_other)), K};
}
inline scalar compliance_of(const LoopedJoint& joint, const LoopedRowView& all, const Vector& along) {
    const ImpulseAlong impulse = impulse_along(joint, along);
    if (locks_nothing(joint.loop)) return compliance_of_servo(joint, all, impulse, along);
    const CompliancesInTree in_tree = compliances_in_tree(joint, all, impulse);
    if (!(in_tree.K > in_tree.least())) return 0;
    return compliance_with_loops(joint.view(), joint.loops, impulse, in_tree.K, in_tree.alone);
}

/// The row of a drive, beside the tree, of what is held stiffer than its compliance can be seen: as by a drive of the tree that turns the same way.
/// Where it gives way more than that itself, it is taken for as stiff as can be seen, and visits find what it gives. Else each of the two would give
/// all that both should: false, it leaves that to the other.
template <unsigned width, class Rows>
bool shares_with_tree(const TreeJoint<width>&, const Rows&, JointRow&) {
    return true;
}
inline bool shares_with_tree(const LoopedJoint& joint, const LoopedRowView& all, JointRow& row) {
    if (row.K > 0 || locks_nothing(joint.loop)) return true;
    const scalar least = compliances_in_tree(joint, all, impulse_along(joint, row.along)).least();
    if (!(row.gamma > least)) return false;
    row.K = least;
    return true;
}

} }  // namespace ingot

#pragma GCC diagnostic pop

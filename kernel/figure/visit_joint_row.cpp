// SPDX-License-Identifier: MIT
#include "../base/figure_limits.h"
#include "close_loops.h"
#include "cursor.h"
#include "cursor_moves.h"
#include "joint_rows.h"
#include "row_compliance.h"
#include "torque_of_ball.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// The impulse that leaves the rate within its bounds, if it changes by `free` without: none where it is. Bounds of a drive give way, and it has a
/// largest impulse.
scalar impulse_within(const JointRow& row, scalar free, scalar most) {
    scalar j = 0;
    if (free < row.lower) j = (row.lower - free) / (row.K + row.gamma);
    if (free > row.upper) j = (row.upper - free) / (row.K + row.gamma);
    return max(-most, min(most, j));
}

/// Gives a row the impulse that it should have, at most so much, where its rate has changed so far by `change`. Returns by how much that is more.
scalar give_row(JointRow& row, scalar change, scalar most) {
    const scalar j = impulse_within(row, change - row.K * row.j, most), more = j - row.j;
    row.j = j;
    return more;
}

scalar lack_of_loops(const LoopView& loops, const FeltByLoops& felt) {
    scalar change = 0;
    if (felt.of == nullptr) return change;
    for (int i = 0; i < felt.of->rank; ++i) change += felt.parts[i] * loops.z[felt.of->first_row + i];  // bound: limits::loop_rows_max
    return change;
}
void feel(const LoopView& loops, const FeltByLoops& felt, scalar j) {
    if (felt.of == nullptr) return;
    for (int i = 0; i < felt.of->rank; ++i) loops.z[felt.of->first_row + i] -= felt.parts[i] * j;  // bound: limits::loop_rows_max
}

template <unsigned width, class Rows>
scalar visit(const TreeJoint<width>& joint, const Rows& all, JointRow& of, bool is_last) {
    const auto& [rows, at, row_i] = joint;
    FigureRow<width>& row = joint.row();
    const FigureNode& node = joint.node();
    const Spatial<scalar> of_parent = change_of_parent(rows, at, row_i);
    const Spatial<scalar> u = change_of_child(at, row, node.kind, of_parent);
    scalar change = dot(of.along, free_rates(at, row, node.kind, u - of_parent));
    [[maybe_unused]] FeltByLoops felt;
    if constexpr (Rows::closes) {
        felt = felt_by_loops(joint.view(), *all.loops, impulse_along(joint, of.along));
        change += lack_of_loops(*all.loops, felt);
    }
    const scalar more = give_row(of, change, of.most);
    if (more == 0) return 0;
    if constexpr (Rows::closes) feel(*all.loops, felt, more);
    joint.add_drive(of.along * more);
    if (is_last) return more * of.K;
    if (node.parent != no_node)
        climb(rows, at, all.responses, row_i);
    else
        write(at, row.change, change_of_child(at, row, node.kind, of_parent));
    return more * of.K;
}

/// An impulse on the body where the cursor comes.
void give_to(const FigureView& view, const LoopedRowView& all, Index node_i, const Spatial<scalar>& f) {
    bring_cursor(view, all.responses, node_i);
    at_node(view, node_i, [&](const auto& rows, const auto& at, int row_i) {
        write(at, rows[row_i].impulse, read(at, rows[row_i].impulse) + f);
        write(at, rows[row_i].change, read(at, rows[row_i].change) + read(at, rows.response(all.responses, row_i)) * f);
    });
}
Spatial<scalar> change_where(const FigureView& view, const LoopedRowView& all, Index node_i) {
    bring_cursor(view, all.responses, node_i);
    return at_node(view, node_i, [](const auto& rows, const auto& at, int row_i) { return read(at, rows[row_i].change); });
}

/// Gives three rows of a drive that is at its largest torque what they should have, where their rates have changed so far by `change`. Returns by how
/// much that is more. of: the first.
Vector give_three(JointRow* of, const AnswerOfThree& K, const Vector& change) {
    const Vector j = {of[0].j, of[1].j, of[2].j}, target = {of[0].upper, of[1].upper, of[2].upper};
    const Vector others = change - (K.of[0] * j.x + K.of[1] * j.y + K.of[2] * j.z);
    const Vector more = impulse_of_three(K, of[0].gamma, target - others, of[0].most) - j;
    const scalar parts[3] = {more.x, more.y, more.z};
    for (int i = 0; i < 3; ++i) {  // bound: 3
        of[i].j += parts[i];
        of[i].change = parts[i] * of[i].K;
    }
    return more;
}
AnswerOfThree answer_of_rows(const JointRow* of) {
    return {{{of[0].K, of[0].rate_begin, of[0].rate}, {of[1].rate, of[1].K, of[1].rate_begin}, {of[2].rate_begin, of[2].rate, of[2].K}}};
}

/// A ball joint's drive at its largest torque: all three rows, from the first on.
template <unsigned width, class Rows>
void visit_three(const TreeJoint<width>& joint, const Rows& all, JointRow* of, bool is_last) {
    const auto& [rows, at, row_i] = joint;
    FigureRow<width>& row = joint.row();
    const FigureNode& node = joint.node();
    const Spatial<scalar> of_parent = change_of_parent(rows, at, row_i);
    Vector change = free_rates(at, row, node.kind, change_of_child(at, row, node.kind, of_parent) - of_parent);
    if constexpr (Rows::closes) {
        const Vector axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        for (const Vector& axis : axes)
            change = change + axis * lack_of_loops(*all.loops, felt_by_loops(joint.view(), *all.loops, impulse_along(joint, axis)));
    }
    const Vector more = give_three(of, answer_of_rows(of), change);
    if (more.x == 0 && more.y == 0 && more.z == 0) return;
    if constexpr (Rows::closes) feel(*all.loops, felt_by_loops(joint.view(), *all.loops, impulse_along(joint, more)), 1);
    joint.add_drive(more);
    if (is_last) return;
    if (node.parent != no_node)
        climb(rows, at, all.responses, row_i);
    else
        write(at, row.change, change_of_child(at, row, node.kind, of_parent));
}

/// Both bodies of a joint that closes a loop, one after the other.
scalar visit(const LoopedJoint& joint, const LoopedRowView& all, JointRow& of, bool is_last) {
    const FigureView& view = joint.view();
    const ImpulseAlong impulse = impulse_along(joint, of.along);
    const FeltByLoops felt = felt_by_loops(view, joint.loops, impulse);
    scalar change = lack_of_loops(joint.loops, felt);
    change += dot(impulse.row.on_child, change_where(view, all, impulse.child));
    if (impulse.other != no_node) change += dot(impulse.row.on_other, change_where(view, all, impulse.other));
    const scalar more = give_row(of, change, of.most);
    if (more == 0) return 0;
    joint.add_drive(of.along * more);
    feel(joint.loops, felt, more);
    if (is_last) return more * of.K;
    if (impulse.other != no_node) give_to(view, all, impulse.other, impulse.row.on_other * more);
    give_to(view, all, impulse.child, impulse.row.on_child * more);
    return more * of.K;
}

/// What two of three rows at their largest torque leave for the third.
scalar most_beside(const JointRow* of, int row_i) {
    scalar left_sq = of[row_i].most * of[row_i].most;
    for (int i = 0; i < 3; ++i)  // bound: 3
        if (i != row_i) left_sq -= of[i].j * of[i].j;
    return sqrt(max(left_sq, scalar(0)));
}

/// All rows of a servo, from the first on: each sees those before it. What is measured is the child alone; the cursor ends at the other body.
void visit_servo(const LoopedJoint& joint, const LoopedRowView& all, JointRow* of, bool is_last) {
    const FigureView& view = joint.view();
    const LoopJoint& loop = joint.loop;
    const Spatial<scalar> u = change_where(view, all, loop.child) + twist_of_loops(view, joint.loops, loop.child);
    scalar rates[3] = {};
    for (int i = 0; i < loop.row_end; ++i) rates[i] = dot(loop.rows[i].on_child, u);  // bound: 3
    Vector rate = {rates[0], rates[1], rates[2]}, given{};
    const bool is_at_most = loop.row_end == 3 && drive_motion(joint.node(), all, 0).saturated, all_give = of[0].K > 0 && of[1].K > 0 && of[2].K > 0;
    if (is_at_most && all_give) given = give_three(of, {{loop.direction[0], loop.direction[1], loop.direction[2]}}, rate);
    for (int i = 0; i < loop.row_end && !(is_at_most && all_give); ++i) {  // bound: 3
        of[i].change = 0;
        if (!(of[i].K > 0)) continue;
        const scalar more = give_row(of[i], dot(of[i].along, rate), is_at_most ? most_beside(of, i) : of[i].most);
        of[i].change = more * of[i].K;
        rate = rate + loop.direction[i] * more;
        given = given + of[i].along * more;
    }
    if (given.x == 0 && given.y == 0 && given.z == 0) return;
    joint.add_drive(given);
    const ImpulseAlong impulse = impulse_along(joint, given);
    feel(joint.loops, felt_by_loops(view, joint.loops, impulse), 1);
    if (is_last) return;
    give_to(view, all, impulse.child, impulse.row.on_child);
    if (impulse.other != no_node) give_to(view, all, impulse.other, impulse.row.on_other);
}

/// Rows of a machine follow each other.
Index machine_of(const FigureView& view, const JointRowView&, const JointRow& row) { return view.nodes[row.node].figure; }
Index machine_of(const FigureView& view, const LoopedRowView& all, const JointRow& row) {
    const Index node_i = node_of(all, row);
    const LoopFigure* const of = all.loops->of_node(view, node_i);
    return of == nullptr ? view.nodes[node_i].figure : of->figure;
}

}  // namespace

template <class Rows>
scalar visit_joint_row(const FigureView& view, const Rows& all, JointRow& row, bool is_last) {
    if constexpr (Rows::closes)
        if (row.closes) {
            const LoopedJoint joint = {view, *all.loops, all.loops->joints[row.node]};
            if (locks_nothing(joint.loop)) {  // its rows follow each other, and are visited with the first
                if (row.direction_i == 0) visit_servo(joint, all, &row, is_last);
                return row.change;
            }
            return row.K > 0 ? visit(joint, all, row, is_last) : scalar(0);
        }
    if (!(row.K > 0)) return 0;
    const FigureNode& node = view.nodes[row.node];
    const bool is_of_three = row.is_drive && is_ball(node.kind);
    if (is_of_three && row.direction_i > 0) return row.change;  // visited with the first
    const Index parent = node.parent == no_node ? row.node : static_cast<Index>(view.figures[node.figure].first_node + node.parent);
    bring_cursor(view, all.responses, parent);
    return at_node(view, row.node, [&](const auto& rows, const auto& at, int row_i) {
        if constexpr (Rows::has_drives)
            if (is_of_three) {
                visit_three(tree_joint(rows, at, row_i), all, &row, is_last);
                return row.change;
            }
        return visit(tree_joint(rows, at, row_i), all, row, is_last);
    });
}

template <class Rows>
void settle_joint_rows(const FigureView& view, const Rows& all, scalar settled) {
    const auto figure_of = [&](int i) { return machine_of(view, all, all.list[i]); };
    const auto visited = [&](JointRow& row) {
        return abs(visit_joint_row(view, all, row)) / unit_of_travel(kind_of(view, all, row), row.direction_i, view.unit);
    };
    for (int begin = 0, end = 0; begin < all.count; begin = end) {  // bound: limits_of_joint max_joints
        while (end < all.count && figure_of(end) == figure_of(begin)) ++end;  // bound: limits_of_joint max_joints
        if (Rows::closes && all.list[begin].stands) continue;
        scalar most = scalar_max;
        for (int sweep_i = 0; sweep_i < limits::limit_sweeps_max && most > settled; ++sweep_i) {
            most = 0;
            for (int i = begin; i < end; ++i)  // bound: limits_of_joint max_joints; down and up the tree in turn
                most = max(most, visited(all.list[sweep_i % 2 == 0 ? i : begin + end - 1 - i]));
            if (end == begin + 1) break;  // one row is solved by one visit
        }
    }
}

// The linker takes the one that the scene calls.
#define INGOT_ROWS(Rows)                                                              \
    template scalar visit_joint_row(const FigureView&, const Rows&, JointRow&, bool); \
    template void settle_joint_rows(const FigureView&, const Rows&, scalar)
INGOT_ROWS(JointRowView);
INGOT_ROWS(DrivenRowView);
INGOT_ROWS(LoopedRowView);
#undef INGOT_ROWS

} }  // namespace ingot

#pragma GCC diagnostic pop

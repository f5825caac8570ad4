// SPDX-License-Identifier: MIT
#include "../base/limits.h"
#include "cursor.h"
#include "cursor_moves.h"
#include "joint_rows.h"
#include "measure_joint.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// The impulse that leaves the rate within its bounds, if it changes by `free` without: none where it is. Bounds of a drive give way, and it has a
/// largest impulse.
scalar impulse_within(const JointRow& row, scalar free) {
    scalar j = 0;
    if (free < row.lower) j = (row.lower - free) / (row.K + row.gamma);
    if (free > row.upper) j = (row.upper - free) / (row.K + row.gamma);
    return max(-row.most, min(row.most, j));
}

template <unsigned width>
scalar visit(const FigureRows<width>& rows, const OneLane<width>& at, const JointRowView& all, int row_i, JointRow& of) {
    FigureRow<width>& row = rows[row_i];
    const FigureNode& node = rows.node(row_i, at.lane_i);
    const Spatial<scalar> of_parent = change_of_parent(rows, at, row_i);
    const Spatial<scalar> u = change_of_child(at, row, node.kind, of_parent);
    const scalar change = dot(of.along, free_rates(at, row, node.kind, u - of_parent));
    const scalar j = impulse_within(of, change - of.K * of.j), more = j - of.j;
    if (more == 0) return 0;
    of.j = j;
    write(at, row.drive, read(at, row.drive) + of.along * more);
    if (node.parent != no_node)
        climb(rows, at, all.responses, row_i);
    else
        write(at, row.change, change_of_child(at, row, node.kind, of_parent));
    return more * of.K;
}

}  // namespace

scalar visit_joint_row(const FigureView& view, const JointRowView& all, JointRow& row) {
    if (!(row.K > 0)) return 0;
    const FigureNode& node = view.nodes[row.node];
    const Index parent = node.parent == no_node ? row.node : static_cast<Index>(view.figures[node.figure].first_node + node.parent);
    bring_cursor(view, all.responses, parent);
    return at_node(view, row.node, [&](const auto& rows, const auto& at, int row_i) { return visit(rows, at, all, row_i, row); });
}

void settle_joint_rows(const FigureView& view, const JointRowView& all, scalar settled) {
    const auto figure_of = [&](int i) { return view.nodes[all.list[i].node].figure; };
    const auto visited = [&](JointRow& row) {
        return abs(visit_joint_row(view, all, row)) / unit_of_travel(view.nodes[row.node].kind, row.direction_i, view.unit);
    };
    for (int begin = 0, end = 0; begin < all.count; begin = end) {  // bound: limits_of_joint max_joints
        while (end < all.count && figure_of(end) == figure_of(begin)) ++end;  // bound: limits_of_joint max_joints
        scalar most = scalar_max;
        for (int sweep_i = 0; sweep_i < limits::limit_sweeps_max && most > settled; ++sweep_i) {
            most = 0;
            for (int i = begin; i < end; ++i)  // bound: limits_of_joint max_joints; down and up the tree in turn
                most = max(most, visited(all.list[sweep_i % 2 == 0 ? i : begin + end - 1 - i]));
            if (end == begin + 1) break;  // one row is solved by one visit
        }
    }
}

} }  // namespace ingot

#pragma GCC diagnostic pop

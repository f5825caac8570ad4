// SPDX-License-Identifier: MIT
#include "cursor.h"

#include "cursor_moves.h"
#include "reached_bodies.h"
#include "row_motion.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

template <unsigned width>
void move_cursor(const FigureRows<width>& rows, const OneLane<width>& at, const Spatial6Rows<1>* responses, int from, int to) {
    int below = to;
    while (from != to) {  // bound: 2 max_bodies: the higher of the two goes to its parent, which comes before it
        if (from > to) {
            climb(rows, at, responses, from);
            from = rows.node(from).parent;
        } else {
            const Index parent = rows.node(to).parent;
            rows.node(parent, at.lane_i).towards = static_cast<Index>(to);
            to = parent;
        }
    }
    while (to != below) {  // bound: max_bodies: downwards
        to = rows.node(to, at.lane_i).towards;
        descend(rows, at, to);
    }
}

/// Down to the first `count` rows of each group.
template <class CountOf>
void pass_to_rows(const FigureView& view, bool again, const CountOf& count_of) {
    for_groups(view, [&](const auto& rows) {
        pass_up(rows, [&](int row_i) { return again && !is_reached(rows, row_i); });
        pass_down(rows, count_of(rows));
        for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i) rows.figure(lane_i).cursor = 0;  // bound: lanes
    });
}
/// The rows of a figure up to the last body that some row of its loops is of.
int looped_rows(const LoopView& loops, const LoopFigure& of, const Figure& figure) {
    int count = 1;
    if (of.row_count == 0) return count;
    if (of.figure_count > 1) return figure.node_count;
    for_loop_joints(loops, of, [&](const LoopJoint& loop) {
        if (loop.kind == JointKind::gear) count = figure.node_count;
        if (loop.kind == JointKind::gear || locks_nothing(loop)) return;
        const int child = loop.child - figure.first_node, other = loop.other == no_node ? 0 : loop.other - figure.first_node;
        count = count > child ? count : child + 1;
        count = count > other ? count : other + 1;
    });
    return count;
}

}  // namespace

void pass_to_roots(const FigureView& view, const NoLoops&, bool again) {
    pass_to_rows(view, again, [](const auto&) { return 1; });
}
void pass_to_roots(const FigureView& view, const LoopView& loops, bool again) {
    pass_to_rows(view, again, [&](const auto& rows) {
        int count = 1;
        for_looped(rows, loops, [&](const LoopFigure& of, int lane_i) {
            const int of_lane = looped_rows(loops, of, rows.figure(lane_i));
            count = count > of_lane ? count : of_lane;
        });
        return count;
    });
}

void bring_cursor(const FigureView& view, const Spatial6Rows<1>* responses, Index node_i) {
    Figure& figure = view.figures[view.nodes[node_i].figure];
    const auto row_of_node = static_cast<Index>(node_i - figure.first_node);
    if (figure.cursor != row_of_node && figure.cursor != no_node)
        at_node(view, node_i, [&](const auto& rows, const auto& at, int row_i) { move_cursor(rows, at, responses, figure.cursor, row_i); });
    figure.cursor = row_of_node;
}

Spatial<scalar> change_at_cursor(const FigureView& view, Index node_i) {
    return at_node(view, node_i, [](const auto& rows, const auto& at, int row_i) {
        return change_of_centre(at, rows[row_i]);
    });
}

void give_at_cursor(const FigureView& view, const Spatial6Rows<1>* responses, Index node_i, const Vector& F, const Vector& T) {
    at_node(view, node_i, [&](const auto& rows, const auto& at, int row_i) {
        auto& row = rows[row_i];
        const Spatial<scalar> f = {T + cross(read(at, row.c), F), F};
        write(at, row.impulse, read(at, row.impulse) + f);
        write(at, row.change, read(at, row.change) + read(at, rows.response(responses, row_i)) * f);
    });
}

void take_cursors_away(const FigureView& view, const Spatial6Rows<1>* responses) {
    for_groups(view, [responses](const auto& rows) {
        bool some = false;
        for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i) {  // bound: lanes
            Figure& figure = rows.figure(lane_i);
            if (figure.cursor == no_node) continue;
            move_cursor(rows, {lane_i}, responses, figure.cursor, 0);
            figure.cursor = no_node;
            some = true;
        }
        if (some) pass_down(rows);
    });
}

} }  // namespace ingot

#pragma GCC diagnostic pop

// SPDX-License-Identifier: MIT
// push_joint_rows where joints close loops: machines are pushed whole.
#include "joint_motions.h"
#include "joint_rows.h"
#include "limit_pushes.h"
#include "machine_pushes.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Figures with a joint beyond its end, or with a gap that such a push has left, are to be pushed: noted_turn 0.
bool mark_pushed(const FigureView& view, LoopedRowView& all, const WayBack& way) {
    for_groups(view, [&](const auto& rows) {
        using T = decltype(rows.all.get(note_of(rows, noted_gap)));
        rows.all.put(note_of(rows, noted_gap), set_pushes(rows));
        rows.all.put(note_of(rows, noted_turn), splat<T>(scalar(-1)));
        for (int lane_i = 0; lane_i < rows.lane_count && !way.again; ++lane_i) rows.figure(lane_i).was_beyond = false;  // bound: lanes
    });
    for_looped_figures(view, *all.loops, [&](const LoopFigure& of) { (void)share_most(view, of, noted_gap, aim_pushes(view, *all.loops, of)); });
    bool some = false;
    const auto mark = [&](Index node_i) {
        at_node(view, node_i, [&](const auto& rows, const auto& at, int) {
            rows.figure(at.lane_i).was_beyond = true;
            at.put(note_of(rows, noted_turn), scalar(0));
        });
        some = true;
    };
    all.count = 0;
    for_moving_joints(view, all, [&](const auto& joint) {
        const int first = all.count;
        if (list_limits(joint, all, way)) mark(node_of(all, all.list[first]));
    });
    if (way.again)
        for (int figure_i = 0; figure_i < view.figure_count; ++figure_i) {  // bound: max_bodies
            const Figure& figure = view.figures[figure_i];
            if (!is_of_batch(view, static_cast<Index>(figure_i)) || !figure.was_beyond) continue;
            const auto gap_of = [](const auto& rows, const auto& at, int) { return at.get(note_of(rows, noted_gap)); };
            if (at_node(view, figure.first_node, gap_of) > limits::joint_gap * limits::joint_gap) mark(figure.first_node);
        }
    if (some) for_looped_figures(view, *all.loops, [&](const LoopFigure& of) { (void)share_most(view, of, noted_turn, -1); });
    return some;
}

bool is_pushed(const FigureView& view, Index node_i) {
    return at_node(view, node_i, [](const auto& rows, const auto& at, int) { return at.get(note_of(rows, noted_turn)) >= 0; });
}

/// Impulses of the rows as they stand pass through the trees, and the loops close.
void pass_rows(const FigureView& view, const LoopedRowView& all, bool close) {
    for_groups(view, [](const auto& rows) {
        for (int row_i = 0; row_i < rows.count(); ++row_i) write(rows.all, rows[row_i].impulse, rows.no_twist());  // bound: max_bodies
    });
    add_free_impulses(view, *all.loops);
    for_groups(view, [](const auto& rows) { pass_from_none(rows); });
    for_looped_figures(view, *all.loops, [&](const LoopFigure& of) {
        if (!is_pushed(view, of.first_node)) return;
        find_lacks(view, *all.loops, of, false);
        if (close) close_loops(view, *all.loops, of);
    });
}

/// One push. False: there is none.
bool push_limits(const FigureView& view, LoopedRowView& all, const WayBack& way) {
    if (!mark_pushed(view, all, way)) return false;
    for (int i = 0; i < all.count; ++i)  // bound: limits_of_joint max_joints
        if (is_pushed(view, node_of(all, all.list[i]))) aim_limit(view, all, all.list[i]);
    give_joint_rows(view, all);  // nothing yet
    pass_rows(view, all, false);
    settle_joint_rows(view, all, limits::limit_slack / 4);
    pass_rows(view, all, true);
    end_pushes(view, *all.loops);
    return true;
}

}  // namespace

void push_joint_rows(const FigureView& view, LoopedRowView& all, scalar h, scalar gone) {
    measure_joints(view, all, gone);
    bool some = all.limits != nullptr;
    for (int push_i = 0; push_i < limits::limit_pushes && some; ++push_i) {
        some = push_limits(view, all, {limits::limit_return * h, push_i > 0});
        if (some) measure_joints(view, all, 0);
    }
}

} }  // namespace ingot

#pragma GCC diagnostic pop

// SPDX-License-Identifier: MIT
// Pushes: joints that are off their places are taken back to them, by displacements that no velocity sees.
#pragma once

#include "../base/limits.h"
#include "../math/sqrt.h"
#include "close_loops.h"
#include "displace_rows.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// The largest of each lane with those of its loops.
template <unsigned width, class T>
T with_loops(const FigureRows<width>&, const NoLoops&, T most) {
    return most;
}
template <unsigned width, class T>
T with_loops(const FigureRows<width>& rows, const LoopView& loops, T most) {
    scalar by_lane[width];
    rows.all.put(by_lane, most);
    for_looped(rows, loops, [&](const LoopFigure& of, int lane_i) { by_lane[lane_i] = max(by_lane[lane_i], aim_pushes(rows.view, loops, of)); });
    return rows.all.get(by_lane);
}

/// Lanes to push, of figures whose joints are off by `most`, units of length or rad, squared; before: the same before the last push. A figure that is good is left
/// alone, so that what it does does not depend on who is beside it. Pushes of loops do not get better once they have got worse: they are ended.
template <unsigned width, class T>
auto lanes_to_push(const FigureRows<width>&, const NoLoops&, T most, T, bool again) {
    return most > splat<T>(again ? limits::joint_gap * limits::joint_gap : scalar(-1));
}
template <unsigned width, class T>
auto lanes_to_push(const FigureRows<width>& rows, const LoopView& loops, T most, T before, bool again) {
    scalar allowed[width];
    rows.all.put(allowed, splat<T>(limits::joint_gap * limits::joint_gap));
    for_looped(rows, loops, [&](const LoopFigure&, int lane_i) { allowed[lane_i] = limits::loop_gap * limits::loop_gap; });
    return both(most > (again ? rows.all.get(allowed) : splat<T>(scalar(-1))), most < before);
}

/// Loops that are nearly straight ask for more than their rows, which are of first order, are good for: a push turns nothing by more than
/// limits::push_turn.
template <unsigned width>
void shorten_push(const FigureRows<width>&, const NoLoops&) {}
template <unsigned width>
void shorten_push(const FigureRows<width>& rows, const LoopView&) {
    using T = typename AllLanes<width>::T;
    T most{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) most = max(most, length_sq(read(rows.all, rows[row_i].change.w)));  // bound: max_bodies
    const T allowed = splat<T>(limits::push_turn * limits::push_turn);
    const auto is_long = most > allowed;
    if (!any(is_long)) return;
    const T share = select(is_long, sqrt(allowed / max(most, allowed)), splat<T>(1));
    for (int row_i = 0; row_i < rows.count(); ++row_i) write(rows.all, rows[row_i].change, read(rows.all, rows[row_i].change) * share);
}

/// One push of all rows; before: how far they were off before the last, and most: before this one. False where nothing is off by more than it may be,
/// and nothing was done.
template <unsigned width, class Loops, class T = typename AllLanes<width>::T>
bool push_rows(const FigureRows<width>& rows, const Loops& loops, T& before, T& most, bool again) {
    most = T{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) {
        const Spatial<T> none{};
        write(rows.all, rows[row_i].bias, none);
        if (rows.node(row_i).kind != JointKind::none) most = max(most, set_push(rows, row_i));
    }
    most = with_loops(rows, loops, most);
    const auto off = lanes_to_push(rows, loops, most, before, again);
    if (!any(off)) return false;
    before = most;
    clear_impulses(rows);
    pass_up(rows);
    pass_down(rows);
    close_rows(rows, loops);
    shorten_push(rows, loops);
    move_by_change(rows, off);
    return true;
}

/// Joints that no push brings together ask for what cannot be, as a chain does whose ends are drawn apart. Its places are pushed back then, while its
/// velocities would go on to gather what forces give: they are halved.
template <unsigned width, class T>
void slow_what_cannot_be(const FigureRows<width>&, const NoLoops&, T) {}
template <unsigned width, class T>
void slow_what_cannot_be(const FigureRows<width>& rows, const LoopView&, T most) {
    const auto is_apart = most > splat<T>(limits::parted_gap * limits::parted_gap);
    if (!any(is_apart)) return;
    const T share = select(is_apart, splat<T>(scalar(0.5)), splat<T>(1));
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        write(rows.all, rows[row_i].v, read(rows.all, rows[row_i].v) * share);
        write(rows.all, rows[row_i].L, read(rows.all, rows[row_i].L) * share);
    }
}

template <unsigned width, class Loops>
void push_group(const FigureRows<width>& rows, const Loops& loops, bool again) {
    typename AllLanes<width>::T before = splat<typename AllLanes<width>::T>(scalar_max), most{};
    // bound: limits::pushes_max
    for (int push_i = 0; push_i < limits::pushes_max && push_rows(rows, loops, before, most, again || push_i > 0); ++push_i) {}
    if (!again) slow_what_cannot_be(rows, loops, most);
}

} }  // namespace ingot

#pragma GCC diagnostic pop

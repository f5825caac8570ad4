// SPDX-License-Identifier: MIT
// What pushes of machines with loops have in common, be it joints that are apart or joints that are beyond their ends.
#pragma once

#include "../base/figure_limits.h"
#include "../math/sqrt.h"
#include "close_loops.h"
#include "displace_rows.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

// What a figure notes of its pushes stands in FigureRow::turn of its root, which the drift is done with.
enum PushNote : int {
    noted_gap = 0,   ///< units of length, rad, squared: how far its joints are off; the largest of its machine
    noted_before = 1,   ///< the same before the last push
    noted_turn = 2,   ///< rad, squared: the largest turn of this push; -1: it is not pushed
};
template <unsigned width, class Kinds>
scalar (&note_of(const FigureRows<width, Kinds>& rows, PushNote note))[width] {
    return rows[0].turn[note];
}

/// All figures of a machine have the largest of a note, and of `also`.
inline scalar share_most(const FigureView& view, const LoopFigure& of, PushNote note, scalar also) {
    for_figures_of(view, of, [&](const auto& rows, const auto& at) { also = max(also, at.get(note_of(rows, note))); });
    for_figures_of(view, of, [&](const auto& rows, const auto& at) { at.put(note_of(rows, note), also); });
    return also;
}

template <unsigned width, class Kinds>
auto lanes_off(const FigureRows<width, Kinds>& rows) {
    using T = typename AllLanes<width>::T;
    return rows.all.get(note_of(rows, noted_turn)) > splat<T>(scalar(-0.5));
}

template <unsigned width, class Kinds>
void note_turns(const FigureRows<width, Kinds>& rows) {
    using T = typename AllLanes<width>::T;
    const auto off = lanes_off(rows);
    if (!any(off)) return;
    T most{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) most = max(most, length_sq(read(rows.all, rows[row_i].change.w)));  // bound: max_bodies
    rows.all.put(note_of(rows, noted_turn), select(off, most, splat<T>(scalar(-1))));
}

/// Loops that are nearly straight ask for more than their rows, which are of first order, are good for: a push turns nothing by more than
/// limits::push_turn.
template <unsigned width, class Kinds>
void end_push(const FigureRows<width, Kinds>& rows) {
    using T = typename AllLanes<width>::T;
    const auto off = lanes_off(rows);
    if (!any(off)) return;
    const T most = rows.all.get(note_of(rows, noted_turn)), allowed = splat<T>(limits::push_turn * limits::push_turn);
    const auto is_long = most > allowed;
    if (any(is_long)) {
        const T share = select(is_long, sqrt(allowed / max(most, allowed)), splat<T>(1));
        for (int row_i = 0; row_i < rows.count(); ++row_i) write(rows.all, rows[row_i].change, read(rows.all, rows[row_i].change) * share);
    }
    move_by_change(rows, off);
}

/// All turns of a push are known: it is shortened where they are long, and done.
inline void end_pushes(const FigureView& view, const LoopView& loops) {
    for_groups(view, [](const auto& rows) { note_turns(rows); });
    for_looped_figures(view, loops, [&](const LoopFigure& of) { (void)share_most(view, of, noted_turn, -1); });
    for_groups(view, [](const auto& rows) { end_push(rows); });
}

} }  // namespace ingot

#pragma GCC diagnostic pop

// SPDX-License-Identifier: MIT
// Displacements of figures: from where their bodies are to where their joints want them.
#pragma once

#include "../base/figure_limits.h"
#include "joint_sides.h"
#include "row_motion.h"
#include "tree_passes.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// What a joint is off by, as the bias of a push. Returns the square of the largest, rad or units of length, of each lane.
template <unsigned width, class Kinds, class T = typename AllLanes<width>::T>
T set_push(const FigureRows<width, Kinds>& rows, int row_i) {
    const JointKind kind = rows.kind(row_i);
    const Spatial<T> back = twist_back(kind, sides_now(rows, rows.all, row_i, locks_turns(kind)));
    write(rows.all, rows[row_i].bias, back);
    return max(length_sq(back.v) * splat<T>(1 / (rows.view.unit * rows.view.unit)), length_sq(back.w));
}

/// The same of all joints of a group.
template <unsigned width, class Kinds, class T = typename AllLanes<width>::T>
INGOT_LONG_HELPER T set_pushes(const FigureRows<width, Kinds>& rows) {
    T most{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        write(rows.all, rows[row_i].bias, rows.no_twist());
        if (rows.node(row_i).kind != JointKind::none) most = max(most, set_push(rows, row_i));
    }
    return most;
}

/// Lanes with a joint that is further apart than pushes leave it, and than where bodies are may be rounded. As biases of a push.
template <unsigned width, class Kinds, class T = typename AllLanes<width>::T>
auto apart_lanes(const FigureRows<width, Kinds>& rows) {
    constexpr scalar rounding = 16 * epsilon / limits::parted_gap;
    T r_sq{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) r_sq = max(r_sq, length_sq(read(rows.all, rows[row_i].r)));  // bound: max_bodies
    const T allowed_sq = splat<T>(1) + r_sq * splat<T>(rounding * rounding / (rows.view.unit * rows.view.unit));
    return set_pushes(rows) * splat<T>(1 / (limits::parted_gap * limits::parted_gap)) > allowed_sq;
}

template <unsigned width, class Kinds>
void turn_body(const FigureRows<width, Kinds>& rows, FigureRow<width>& row, const Vec3<typename AllLanes<width>::T>& turn) {
    auto A = read(rows.all, row.A);
    A = {A.c0 + chord(turn, A.c0), A.c1 + chord(turn, A.c1), A.c2 + chord(turn, A.c2)};
    write(rows.all, row.A, A + polar_correction(A));
}

template <unsigned width, class Kinds>
void clear_impulses(const FigureRows<width, Kinds>& rows) {
    const Spatial<typename AllLanes<width>::T> none{};
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        write(rows.all, rows[row_i].impulse, none);
        write(rows.all, rows[row_i].drive, none.v);
    }
}

template <unsigned width, class Kinds>
void take_cursor(const FigureRows<width, Kinds>& rows) {
    for (int lane_i = 0; lane_i < rows.lane_count; ++lane_i) rows.figure(lane_i).cursor = no_node;  // bound: lanes
}

/// All impulses pass through the figures; the cursors are nowhere.
template <unsigned width, class Kinds>
void pass_from_none(const FigureRows<width, Kinds>& rows) {
    take_cursor(rows);
    pass_up(rows);
    pass_down(rows);
}

/// Displaces the lanes that are `off` by `change`.
template <unsigned width, class Kinds, class M, class T = typename AllLanes<width>::T>
void move_by_change(const FigureRows<width, Kinds>& rows, M off) {
    for (int row_i = 0; row_i < rows.count(); ++row_i) {  // bound: max_bodies
        FigureRow<width>& row = rows[row_i];
        const Spatial<T> u = change_of_centre(rows.all, row), none{};
        const Mat3<T> A = read(rows.all, row.A);
        write(rows.all, row.r, read(rows.all, row.r) + select(off, u.v, none.v));
        write(rows.all, row.turned, read(rows.all, row.turned) + select(off, u.w, none.w));
        turn_body(rows, row, u.w);
        write(rows.all, row.A, select(off, read(rows.all, row.A), A));
    }
}

} }  // namespace ingot

#pragma GCC diagnostic pop

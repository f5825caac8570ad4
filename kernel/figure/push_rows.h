// SPDX-License-Identifier: MIT
// Pushes: joints that are off their places are taken back to them, by displacements that no velocity sees.
#pragma once

#include "../base/figure_limits.h"
#include "displace_rows.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// One push of all rows. False where no joint is off by more than it may be, and nothing was done. A figure that is good is left alone, so that what
/// it does does not depend on who is beside it.
template <unsigned width, class Kinds, class T = typename AllLanes<width>::T>
bool push_rows(const FigureRows<width, Kinds>& rows, bool again) {
    const T most = set_pushes(rows);
    const auto off = most > splat<T>(again ? limits::joint_gap * limits::joint_gap : scalar(-1));
    if (!any(off)) return false;
    clear_impulses(rows);
    pass_up(rows);
    pass_down(rows);
    move_by_change(rows, off);
    return true;
}

template <unsigned width, class Kinds>
void push_group(const FigureRows<width, Kinds>& rows, bool again) {
    for (int push_i = 0; push_i < limits::pushes_max && push_rows(rows, again || push_i > 0); ++push_i) {}  // bound: limits::pushes_max
}

} }  // namespace ingot

#pragma GCC diagnostic pop

// SPDX-License-Identifier: MIT
#pragma once

#include "loop_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Finds the joints that build_figures has left out of its trees, in the order of their slots. Returns how many there was no room for: more than
/// LoopView::joint_capacity in the world, or than LoopView::rows_max rows in a figure. These hold nothing.
/// Cost: a few dozen instructions a joint.
int find_loops(const FigureView& view, LoopView& loops);
/// Where there is room for none.
int find_loops(const FigureView& view, NoLoops& loops);

/// For the batch at hand, after group_figures: what the joints remember of the last step. h: s, of its substeps.
void load_loops(const FigureView& view, const LoopView& loops, scalar h);

} }  // namespace ingot

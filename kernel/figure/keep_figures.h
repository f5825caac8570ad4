// SPDX-License-Identifier: MIT
#pragma once

#include "loop_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// After the last substep of the groups: how often the substeps of each figure should have been halved, in Figure::doublings. h: s, of a whole
/// substep; doublings: how often they were. Figures that ask for more have to begin again: their bodies are in the tiles as they were.
template <class Loops>
void ask_for_doublings(const FigureView& view, const Loops& loops, scalar h, int doublings);

/// Figures that ask for no more than they had: their bodies go to the tiles as they are at the end of the step, and joints keep their impulses.
/// Nothing else moves these bodies in the step.
void keep_figures(const FigureView& view, int doublings);

} }  // namespace ingot

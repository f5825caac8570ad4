// SPDX-License-Identifier: MIT
#pragma once

#include "../figure/loop_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Puts the bodies of the figures [first, end) of a machine to where their joints want them, from where their tiles say that they are: by
/// displacements that no velocity sees. What a joint has to make up for in the next step is then no part of its way. False where joints of trees
/// stay apart.
/// Needs:  build_figures, with loops find_loops.
/// Cost:   that of a substep of these figures without contacts.
template <class Loops>
bool close_figure(FigureView& view, const Loops& loops, int first, int end);

} }  // namespace ingot

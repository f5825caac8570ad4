// SPDX-License-Identifier: MIT
// A step of figures of one form, cut as often as it has to be.
#pragma once

#include "newton_row.h"

namespace ingot { inline namespace INGOT_ABI {

struct FigureAdvance {
    bool solved;   ///< rows hold the end of the step; else nothing of them counts
    int passes;
    int halvings_to_begin_with;  ///< of the next step
};

/// A try of the step in parts, 2^halvings. view.groups holds one group, loaded. was_seen: bodies are where the last such step left them.
/// Gives of each figure what has become of it: not solved, if its passes found no end, or it turned too far in a part of which there could be more.
/// Bound: passes, 2^halvings times limits::newton_steep_passes_max, five times that for order 4.
template <unsigned width>
void advance_figures(FigureView& view, const EnergyMomentumView& scheme, bool was_seen, int halvings, FigureAdvance (&advances)[width]);

} }  // namespace ingot

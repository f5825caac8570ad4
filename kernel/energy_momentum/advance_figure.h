// SPDX-License-Identifier: MIT
// A step of figures of one form, cut as often as it has to be.
#pragma once

#include "../figure/note_reactions.h"
#include "newton_row.h"

namespace ingot { inline namespace INGOT_ABI {

struct FigureAdvance {
    bool fits;    ///< its joints are together as it begins
    bool solved;  ///< rows hold the end of the step; else nothing in them counts
    int passes;   ///< of all parts
    int halvings_to_begin_with;  ///< of the next step
};

/// Tries the step in 2^halvings parts. view.groups holds one group, loaded. was_seen: bodies are where their last such step left them.
/// A figure is not solved if its passes found no end, or if it turned by more than limits::newton_turn in a part and more halvings are allowed.
/// reactions: ReactionView, of which it gives impulses of the step, or NoReactions.
/// Bound: 2^halvings times limits::newton_steep_passes_max passes, five times that for order 4.
template <unsigned width, class Reactions>
void advance_figures(FigureView& view, const EnergyMomentumView& scheme, Reactions reactions, bool was_seen, int halvings,
                     FigureAdvance (&advances)[width]);

} }  // namespace ingot

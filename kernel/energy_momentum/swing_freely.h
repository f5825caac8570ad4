// SPDX-License-Identifier: MIT
// A step of figures by the energy-momentum scheme.
#pragma once

#include "../base/report.h"
#include "../figure/note_reactions.h"
#include "newton_row.h"

namespace ingot { inline namespace INGOT_ABI {

/// Moves the figures that touch nothing and close no loop: the tiles of their bodies hold the end of the step afterwards, and nothing else moves them
/// in it. The others are left to the substeps, and so is a figure whose passes do not settle in the finest parts of a step.
/// Needs: build_figures; EnergyMomentumView::left: bodies that are awake. Afterwards it is those that the substeps move.
/// reactions: ReactionView, where it is told what joints bear, or NoReactions.
///
/// A figure that comes from the substeps, or that something else has moved or struck, is taken onto its joints first: see fit_to_joints. One that
/// goes to the substeps begins there with its joints to first order. Both lose some energy, so a figure that changes between the two gains none.
/// Cost: of a figure the same in any company, as are its bits.
template <class Reactions>
void swing_freely(FigureView& view, const EnergyMomentumView& scheme, Reactions reactions, StepReport& report);

} }  // namespace ingot

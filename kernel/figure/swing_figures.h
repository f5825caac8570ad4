// SPDX-License-Identifier: MIT
// A step of figures that touch nothing.
#pragma once

#include "build_figures.h"
#include "find_loops.h"
#include "joint_row.h"
#include "note_reactions.h"

namespace ingot { inline namespace INGOT_ABI {

/// Moves all figures by a step, in substeps: tiles of their bodies hold the end of the step afterwards, and nothing else moves them in it.
/// beside: NoLoops; LoopView, where some joints close loops; JointRowView, of joints that may have limits; DrivenRowView, or drives, too.
/// reactions: ReactionView, where it is told what joints bear, or NoReactions.
/// substeps: of a step, by the scene's effort. Figures under tension, and those whose bodies turn far, take up to eight times as many; one that turns
/// out to want more begins again.
///
/// Source: articulated-body impulses in small steps; the joints of a substep are solved exactly, at any mass ratio.
/// Cost:   about 1100 flops a body and substep.
template <class Beside, class Reactions>
void swing_figures(FigureView& view, Beside& beside, Reactions reactions, int substeps);

} }  // namespace ingot

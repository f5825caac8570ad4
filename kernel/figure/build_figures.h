// SPDX-License-Identifier: MIT
#pragma once

#include "loop_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Makes trees of all joints of bodies that can move.
///
/// A figure is tied to what cannot move by its first joint, by slot, that leads there; its body is the root. A figure that floats has its heaviest
/// body for a root. From there depth first, joints in the order of their slots.
/// Cost: a few dozen instructions a joint.
void build_figures(FigureView& view);
/// The same in scenes that name ties, which are in no tree: trees that they hold together are a machine, and follow each other. A body that has ties
/// alone is a figure of one, if they are not slack.
void build_figures(FigureView& view, const LoopView& loops);
inline void build_figures(FigureView& view, const NoLoops&) { build_figures(view); }

/// The next batch: figures that ask for so many doublings of the substeps. Those of one form that follow each other go side by side, as many as there
/// are lanes; the others alone. Their bodies are loaded.
void group_figures(FigureView& view, int doublings);

} }  // namespace ingot

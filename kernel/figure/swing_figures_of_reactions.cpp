// SPDX-License-Identifier: MIT
// In a file of its own: what compilers make of the others does not depend on it.
#include "swing_in_substeps.h"

namespace ingot { inline namespace INGOT_ABI {

// The linker takes the one that the scene calls.
template void swing_figures(FigureView&, NoLoops&, ReactionView, int);
template void swing_figures(FigureView&, LoopView&, ReactionView, int);
template void swing_figures(FigureView&, JointRowView&, ReactionView, int);
template void swing_figures(FigureView&, DrivenRowView&, ReactionView, int);
template void swing_figures(FigureView&, LoopedRowView&, ReactionView, int);

} }  // namespace ingot

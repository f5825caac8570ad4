// SPDX-License-Identifier: MIT
#include "swing_in_substeps.h"

namespace ingot { inline namespace INGOT_ABI {

// The linker takes the one that the scene calls.
template void swing_figures(FigureView&, NoLoops&, NoReactions, int);
template void swing_figures(FigureView&, NoLoopsOfHinges&, NoReactions, int);
template void swing_figures(FigureView&, LoopView&, NoReactions, int);
template void swing_figures(FigureView&, JointRowView&, NoReactions, int);
template void swing_figures(FigureView&, DrivenRowView&, NoReactions, int);
template void swing_figures(FigureView&, LoopedRowView&, NoReactions, int);

} }  // namespace ingot

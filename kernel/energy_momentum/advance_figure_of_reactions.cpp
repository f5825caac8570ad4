// SPDX-License-Identifier: MIT
// In a file of its own: what compilers make of the others does not depend on it.
#include "advance_parts.h"

namespace ingot { inline namespace INGOT_ABI {

// The linker takes the one that the scene calls.
template void advance_figures(FigureView&, const EnergyMomentumView&, ReactionView, bool, int, FigureAdvance (&)[1]);
#if INGOT_LANES > 1
template void advance_figures(FigureView&, const EnergyMomentumView&, ReactionView, bool, int, FigureAdvance (&)[lanes]);
#endif

} }  // namespace ingot

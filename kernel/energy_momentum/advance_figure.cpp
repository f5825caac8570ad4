// SPDX-License-Identifier: MIT
#include "advance_parts.h"

namespace ingot { inline namespace INGOT_ABI {

// The linker takes the one that the scene calls.
template void advance_figures(FigureView&, const EnergyMomentumView&, NoReactions, bool, int, FigureAdvance (&)[1]);
#if INGOT_LANES > 1
template void advance_figures(FigureView&, const EnergyMomentumView&, NoReactions, bool, int, FigureAdvance (&)[lanes]);
#endif

} }  // namespace ingot

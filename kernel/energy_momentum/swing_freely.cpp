// SPDX-License-Identifier: MIT
#include "free_figures.h"

namespace ingot { inline namespace INGOT_ABI {

// The linker takes the one that the scene calls.
template void swing_freely(FigureView&, const EnergyMomentumView&, NoReactions, StepReport&);

} }  // namespace ingot

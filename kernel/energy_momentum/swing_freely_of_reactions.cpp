// SPDX-License-Identifier: MIT
// In a file of its own: what compilers make of the others does not depend on it.
#include "free_figures.h"

namespace ingot { inline namespace INGOT_ABI {

// The linker takes the one that the scene calls.
template void swing_freely(FigureView&, const EnergyMomentumView&, ReactionView, StepReport&);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// A step of figures by the energy-momentum scheme.
#pragma once

#include "../base/report.h"
#include "newton_row.h"

namespace ingot { inline namespace INGOT_ABI {

/// Moves the figures that touch nothing and close no loop: tiles of their bodies hold the end of the step afterwards, and nothing else moves them in
/// it. The others, and those whose step has no end that passes find, are left to the substeps: EnergyMomentumView::left says which bodies may move.
/// Needs: build_figures; EnergyMomentumView::left: bodies that are awake.
///
/// A figure that comes from the substeps, or that somebody else has moved or struck, is taken onto its joints first, by displacements and by impulses
/// that take energy; one that goes to the substeps begins there with its joints to first order, which takes some. So no change gains energy.
/// Cost: of a figure the same in any company, as are its bits.
void swing_freely(FigureView& view, const EnergyMomentumView& scheme, StepReport& report);

} }  // namespace ingot

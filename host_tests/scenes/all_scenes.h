// SPDX-License-Identifier: MIT
// The scenes of tests, demo, budgets and firmware: each one header, used by all of them.
#pragma once

#include "compounds.h"
#include "drop.h"
#include "hulls.h"
#include "methods.h"
#include "satellite.h"
#include "stacked.h"
#include "t_handle.h"
#include "tumblers.h"

namespace scenes {

/// A step that a firmware takes for sound. Of a crowd of fast bodies some wait for others, and bullets that scrape along a wall spin
/// beyond the limit: that is what their reports are for.
template <class S>
bool went_well(ingot::StepReport report) {
    if (S::continuous) report.flights_cut = report.spins_clamped = 0;
    return report.clean();
}

}  // namespace scenes

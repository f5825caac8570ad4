// SPDX-License-Identifier: MIT
#pragma once

#include "../../base/report.h"
#include "direct_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Which islands of the step are to be solved directly: those with bodies of limits::direct_mass_ratio on each other or piled
/// limits::direct_levels high, and those whose sweeps have stopped at their bound for limits::unsettled_steps steps. Those that have more
/// manifolds than there is room for are left to the sweeps and told by DirectBits::refused.
/// Needs: plan_islands.
void choose_islands(const SolverView& solver, const DirectView& direct, StepReport& report);

/// After the last substep of a batch: counts the steps in a row in which sweeps at their bound still corrected a manifold.
void note_unsettled(const SolverView& solver, const DirectView& direct);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "../../base/report.h"
#include "direct_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Which islands of the step are to be solved directly: those with bodies of limits::direct_mass_ratio on each other, those
/// in which a body carries so many times its own mass (carried_loads.h), those that are limits::direct_levels high, and those whose sweeps have
/// stopped at their bound for limits::unsettled_steps steps. An island with more manifolds than there is room for is left to the sweeps; where its
/// contacts are uneven, the report says so: DirectBits::refused.
/// Needs: plan_islands.
template <class Direct>
void choose_islands(const SolverView& solver, const Direct& direct, StepReport& report);

/// After the last substep of a batch: counts the steps in a row in which sweeps at their bound still corrected a manifold.
template <class Direct>
void note_unsettled(const SolverView& solver, const Direct& direct);

} }  // namespace ingot

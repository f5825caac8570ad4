// SPDX-License-Identifier: MIT
#pragma once

#include "../sweeps/solve_manifolds.h"
#include "direct_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// As solve_manifolds, with islands that sweeps do not serve solved directly: see choose_islands and solve_island.
///
/// What the direct solve does not answer, the sweeps do: islands it does not settle are swept as well, and solved from where
/// the sweeps ended.
template <bool notes_impulses>
void solve_directly(SolverView& solver, DirectView& direct, const BodyView& bodies, const Vector& gravity, scalar h,
                    ImpactNote* notes, StepReport& report);

} }  // namespace ingot

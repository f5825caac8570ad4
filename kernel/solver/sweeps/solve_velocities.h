// SPDX-License-Identifier: MIT
#pragma once

#include "../../constraint/material_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// The velocities of a substep: sweeps over the islands whose sweeps are on, joined by nonlinear conjugate gradients, until nothing of an
/// island changes by more than its settled speed, or it has had its sweeps. An island that is settled is left alone while others are swept.
///
/// Needs: plan_sweeps.
template <class View>
void solve_velocities(View& solver);

/// The visits of a batch to islands whose sweeps are on, as live ones: other lanes are left out. The order stays.
void select_live(SolverView& solver);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "../../constraint/material_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Makes every contact's velocity right for the moment: normals as one block, then twist, rolling resistance, and the friction pair on its cone.
/// Sweeps of a substep count from 1. Those after the first visit only what has a body that the sweep before or this one has stirred: whose
/// contact took away more than `stirring`, m/s.
///
/// Returns: m/s; the largest speed that an impulse took away.
template <class View>
scalar sweep_velocities(const View& solver, int sweep_i, bool up, scalar active_threshold);

/// J; sum of (change of impulse)^2 times compliance, of the last sweep. It does not depend on lanes.
scalar sum_of_changes(const SolverView& solver);

} }  // namespace ingot

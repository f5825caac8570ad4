// SPDX-License-Identifier: MIT
#pragma once

#include "solver_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// What a sweep changed.
struct SweepResult {
    scalar size;      ///< J; sum of (change of impulse)^2 times compliance
    scalar residual;  ///< m/s; the largest speed that an impulse took away
};

/// Makes every contact's velocity right for the moment: normals as one block, then twist, then the friction pair on its cone.
SweepResult sweep_velocities(const SolverView& solver, bool up);

} }  // namespace ingot

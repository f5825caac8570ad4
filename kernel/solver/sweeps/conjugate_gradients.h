// SPDX-License-Identifier: MIT
#pragma once

#include "../../constraint/material_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Remembers motions before the first sweep of a substep, for extrapolate. (Impulses: warm_start has.)
void begin_sweeps(const SolverView& solver);

/// Between two sweeps: goes on by beta in the direction of the sweeps so far (nonlinear conjugate gradients).
template <class View>
void extrapolate(const View& solver, scalar beta);

} }  // namespace ingot

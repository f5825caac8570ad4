// SPDX-License-Identifier: MIT
#pragma once

#include "solver_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Remembers impulses and motions before a sweep, for extrapolate.
void begin_sweep(const SolverView& solver);

/// Goes on by beta in the direction of the sweeps so far (nonlinear conjugate gradients).
void extrapolate(const SolverView& solver, scalar beta);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "../../constraint/material_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Remembers motions of the batch before the first sweep of a substep, for extrapolate. (Impulses: warm_start has.)
void begin_sweeps(const SolverView& solver);

/// Between two sweeps: every island that is live goes on by its beta in the direction of its sweeps so far.
///
/// Source: nonlinear conjugate gradients around the sweep: Silcowitz-Hansen, Niebe and Erleben, "A nonlinear nonsmooth conjugate gradient
/// method for interactive contact force problems", The Visual Computer 26 (2010).
template <class View>
void extrapolate(const View& solver);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "../../constraint/material_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Remembers motions of the batch before the first sweep of a solve, for extrapolate. (Impulses: warm_start has.)
void begin_sweeps(const SolverView& solver);
/// The impulses, where a substep is solved once more: what the last sweep changed is no part of the direction that begins then. Bodies do not go on
/// along it, so impulses that did would not be what bodies get.
template <class View>
void begin_rows_again(const View& solver);

/// Between two sweeps: every island that is live goes on by its beta in the direction of its sweeps so far.
///
/// Source: nonlinear conjugate gradients around the sweep: Silcowitz-Hansen, Niebe and Erleben, "A nonlinear nonsmooth conjugate gradient
/// method for interactive contact force problems", The Visual Computer 26 (2010).
template <class View>
void extrapolate(const View& solver);

} }  // namespace ingot

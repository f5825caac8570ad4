// SPDX-License-Identifier: MIT
#pragma once

#include "solver_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Fills the rows of every manifold from its geometry and the bodies' masses, finds the impulses of the step before by the features of the
/// points, and counts the central manifolds of each island. Cost: about 900 flops and 11 divisions a manifold.
void prepare_blocks(const SolverView& solver, const BodyView& bodies);

/// Keeps the impulses for the next step, but for islands that begin again.
void remember_impulses(const SolverView& solver);

} }  // namespace ingot

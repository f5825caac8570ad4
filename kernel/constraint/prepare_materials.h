// SPDX-License-Identifier: MIT
#pragma once

#include "material_view.h"

namespace ingot { inline namespace INGOT_ABI {

// For views that have such rows; after prepare_blocks, whose directions they share.

/// Fills the rows of rolling resistance, and finds the impulses of the step before. Cost: about 150 flops and 4 divisions a manifold.
void prepare_rolling(const SolverView& solver, const BodyView& bodies, RollingRows* rolling, const RollingRecord* records);
void prepare_belts(const SolverView& solver, BeltRows* belts, const Vector* velocities);

/// Keeps the impulses for the next step.
void remember_rolling(const SolverView& solver, const RollingRows* rolling, RollingRecord* records);

} }  // namespace ingot

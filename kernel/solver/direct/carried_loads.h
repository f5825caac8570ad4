// SPDX-License-Identifier: MIT
#pragma once

#include "direct_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Marks islands of no more than manifold_capacity manifolds in which a body carries more than limits::direct_mass_ratio times its own mass:
/// Island::carries. What a body carries, it hands on to those that hold it against gravity and forces, to each in proportion to how far its normal
/// points against them. So a column in which each cube is four times as heavy as the one below is marked, though no contact is uneven.
///
/// Needs: plan_islands, before the first batch. Memory: conjugate directions of bodies, which are zero again afterwards.
/// Cost: nothing but a sum over bodies where no island is so heavy; else at most one pass over manifolds for each that an island has.
void mark_carrying(const SolverView& solver, int manifold_capacity);

} }  // namespace ingot

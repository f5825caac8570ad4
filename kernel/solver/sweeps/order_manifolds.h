// SPDX-License-Identifier: MIT
#pragma once

#include "../../constraint/solver_view.h"

namespace ingot { inline namespace INGOT_ABI {

inline constexpr uint16_t unreached_level = 65535;  ///< of a body that hangs free of what cannot move

/// Puts manifolds in the order of the sweeps, and into blocks: by level (contacts from the ground up), and by colour within a level (no two
/// of a colour share a body that can move, so one vector instruction solves `lanes` of them). The order does not depend on `lanes`.
///
/// The level of a body is its distance from what cannot move, in contacts; that of a manifold the lesser of its two bodies'. Sweeps that go up
/// and down the levels carry the weight of a pile to the ground and back in one pass each.
/// Bound: limits::level_passes_max passes over the manifolds for the levels (a quality, not a condition), then sorting by counting.
void order_manifolds(SolverView& solver);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "../../base/report.h"
#include "direct_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Finds which manifolds hang together through bodies that can move, and which of these islands are to be solved directly:
/// those with bodies of limits::direct_mass_ratio on each other or piled limits::direct_levels high, and those whose sweeps
/// have stopped at their bound for limits::unsettled_steps steps. Returns how many; those that have more manifolds than there
/// is room for are left to the sweeps and told by DirectBits::refused.
int choose_islands(const SolverView& solver, const DirectView& direct, StepReport& report);

/// The visits that islands which are not solved need: lanes of those that are, are left out. The same motion for any lanes.
SolverView left_to_sweeps(const SolverView& solver, const DirectView& direct);

/// After the last substep: counts the steps in a row in which sweeps at their bound still corrected a manifold.
void note_unsettled(const SolverView& solver, const DirectView& direct, bool at_bound);

/// A manifold's body that can move; 0: none can.
inline uint16_t dynamic_body(const SolverView& solver, int manifold_i) {
    const uint16_t A = solver.local_of[solver.pairs[manifold_i].body_A];
    return A != 0 ? A : solver.local_of[solver.pairs[manifold_i].body_B];
}

} }  // namespace ingot

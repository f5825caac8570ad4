// SPDX-License-Identifier: MIT
#pragma once

#include "../../constraint/material_view.h"
#include "work_together.h"

namespace ingot { inline namespace INGOT_ABI {

/// The velocities of a substep: sweeps over the islands whose sweeps are on, joined by nonlinear conjugate gradients. An island is settled when a
/// sweep changes nothing in it by more than its settled speed, or when it has had all its sweeps; then it is left alone while others are swept.
///
/// Needs: plan_sweeps. Work: WorkAlone, or WorkTogether.
template <class View, class Work>
void solve_velocities(View& solver, Work& work);
template <class View>
void solve_velocities(View& solver) {
    WorkAlone alone;
    solve_velocities(solver, alone);
}

/// Makes the visits of a batch to islands whose sweeps are on the live ones, without the lanes of other islands. The order stays. some_stand: islands
/// that have visits are not in the batch.
void select_live(SolverView& solver, bool some_stand = false);

} }  // namespace ingot

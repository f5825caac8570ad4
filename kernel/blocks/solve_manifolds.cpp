// SPDX-License-Identifier: MIT
#include "solve_manifolds.h"

#include "../base/limits.h"
#include "move_bodies.h"
#include "note_impulses.h"
#include "order_manifolds.h"
#include "predict_contacts.h"
#include "prepare_blocks.h"
#include "solve_velocities.h"
#include "sweep_positions.h"
#include "warm_start.h"

namespace ingot { inline namespace INGOT_ABI {

template <bool notes_impulses>
void solve_manifolds(SolverView& solver, const BodyView& bodies, const Vector& gravity, scalar h, [[maybe_unused]] ImpactNote* notes, StepReport& report) {
    take_in_bodies(solver, bodies, gravity);
    order_manifolds(solver);
    prepare_blocks(solver, bodies);

    const SweepPlan plan = plan_sweeps(solver);
    const scalar h_substep = h / limits::substeps;
    for (int substep_i = 0; substep_i < limits::substeps; ++substep_i) {
        predict_contacts(solver, h_substep);
        kick_bodies(solver, h_substep);
        warm_start(solver, h_substep);
        count(report.sweeps, solve_velocities(solver, plan, report.residual));
        if constexpr (notes_impulses) note_impulses(solver, notes);
        drift_bodies(solver, bodies, h_substep);
        sweep_positions(solver, h_substep);
    }
    remember_impulses(solver);
}

// The linker takes the one that the scene calls.
template void solve_manifolds<false>(SolverView&, const BodyView&, const Vector&, scalar, ImpactNote*, StepReport&);
template void solve_manifolds<true>(SolverView&, const BodyView&, const Vector&, scalar, ImpactNote*, StepReport&);

} }  // namespace ingot

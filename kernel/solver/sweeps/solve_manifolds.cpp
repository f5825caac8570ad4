// SPDX-License-Identifier: MIT
#include "solve_manifolds.h"

#include "../../base/limits.h"
#include "move_bodies.h"
#include "note_impulses.h"
#include "order_manifolds.h"
#include "predict_contacts.h"
#include "../../constraint/prepare_blocks.h"
#include "../../constraint/prepare_materials.h"
#include "sequence_impacts.h"
#include "solve_velocities.h"
#include "sweep_positions.h"
#include "warm_start.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Solves and displaces the substeps of a plan, from the state at the begin of the step. solver.steady tells whether nothing accelerated.
template <bool notes_impulses, bool bounces, class View>
void solve_substeps(View& solver, const BodyView& bodies, const SweepPlan& plan, scalar h_step, ImpactNote* notes, StepReport& report) {
    solver.substeps = plan.substeps;
    solver.steady = true;
    prepare_blocks(solver, bodies);
    if constexpr (View::rolls) prepare_rolling(solver, bodies, solver.rolling, solver.rolling_records);
    if constexpr (View::has_belts) prepare_belts(solver, solver.belts, solver.belt_velocities);
    if constexpr (notes_impulses) clear_impulse_notes(solver, notes);
    [[maybe_unused]] const bool has_chains = bounces && find_impact_chains(solver);
    const scalar h = h_step / static_cast<scalar>(plan.substeps);
    // bound: limits::substeps
    for (int substep_i = 0; substep_i < plan.substeps; ++substep_i) {
        predict_contacts(solver, h);
        if constexpr (bounces) {
            predict_bounces(solver, h);
            if (has_chains && sequence_impacts(solver, h, notes, report)) solver.steady = false;
        }
        kick_bodies(solver, h);
        if constexpr (View::rolls)
            warm_start(solver, h);
        else
            warm_start<SolverView>(solver, h);
        count(report.sweeps, solve_velocities(solver, plan, report.residual));
        if constexpr (notes_impulses) note_impulses(solver, notes);
        drift_bodies(solver, bodies, h);
        sweep_positions(solver, h);
    }
}

}  // namespace

template <bool notes_impulses, bool bounces, class View>
void solve_manifolds(View& solver, const BodyView& bodies, const Vector& gravity, scalar h, ImpactNote* notes, StepReport& report) {
    take_in_bodies(solver, bodies, gravity, h);
    order_manifolds(solver);
    const SweepPlan plan = plan_sweeps(solver);
    solve_substeps<notes_impulses, bounces>(solver, bodies, plan, h, notes, report);
    if (plan.substeps < limits::substeps && !solver.steady) {  // calm no more: the step begins again, with all of its substeps
        take_in_bodies(solver, bodies, gravity, h);
        solve_substeps<notes_impulses, bounces>(solver, bodies, with_all_substeps(plan), h, notes, report);
    }
    remember_impulses(solver);
    if constexpr (View::rolls) remember_rolling(solver, solver.rolling, solver.rolling_records);
}

// The linker takes the one that the scene calls.
#define INGOT_VIEW(View)                                                                                                          \
    template void solve_manifolds<false, false>(View&, const BodyView&, const Vector&, scalar, ImpactNote*, StepReport&);         \
    template void solve_manifolds<false, true>(View&, const BodyView&, const Vector&, scalar, ImpactNote*, StepReport&);          \
    template void solve_manifolds<true, false>(View&, const BodyView&, const Vector&, scalar, ImpactNote*, StepReport&);          \
    template void solve_manifolds<true, true>(View&, const BodyView&, const Vector&, scalar, ImpactNote*, StepReport&)
INGOT_VIEW(SolverView);
INGOT_VIEW(RollingView);
INGOT_VIEW(BeltView);
INGOT_VIEW(RollingBeltView);
#undef INGOT_VIEW

} }  // namespace ingot

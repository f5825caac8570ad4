// SPDX-License-Identifier: MIT
#include "solve_manifolds.h"

#include "../base/limits.h"
#include "conjugate_gradients.h"
#include "move_bodies.h"
#include "note_impulses.h"
#include "order_manifolds.h"
#include "predict_contacts.h"
#include "prepare_blocks.h"
#include "sequence_impacts.h"
#include "sweep_positions.h"
#include "sweep_velocities.h"
#include "warm_start.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// How a substep is swept. Where contacts are few, chains of them are long for their number, and sweeps are cheap: many are allowed, to a small
/// residual, and all go up, which serves heavy bodies on light ones. Where they are many the number is fixed, larger while many are young, and sweeps
/// go up and down in turn, which carries the weight of a pile to the ground and back.
struct SweepPlan {
    int sweeps_max;
    bool up_and_down;
    scalar settled_speed;  ///< m/s
};

SweepPlan plan_sweeps(const SolverView& solver) {
    if (solver.manifold_count <= limits::few_manifolds) return {limits::sweeps_of_few, false, limits::settled_speed_of_few};
    int young = 0;
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i)
        if (solver.records[solver.pairs[manifold_i].record].substeps < 4 * limits::substeps) ++young;
    return {4 * young > solver.manifold_count ? limits::sweeps_of_young : limits::sweeps, true, limits::settled_speed};
}

/// Sweeps until nothing changes by more than the plan's speed, or the rounding of the bodies' own. Returns how many.
int solve_velocities(const SolverView& solver, const SweepPlan& plan, scalar& residual) {
    const scalar settled = plan.settled_speed + 4 * epsilon * solver.speed_max;
    scalar size_before = 0;
    for (int sweep_i = 1;; ++sweep_i) {
        if (sweep_i < plan.sweeps_max) begin_sweep(solver);
        const SweepResult result = sweep_velocities(solver, !plan.up_and_down || sweep_i % 2 != 0);
        residual = result.residual;
        if (sweep_i == plan.sweeps_max || residual <= settled) return sweep_i;
        // A body that is not finite must not spread to those that it does not touch.
        const bool shrinks = sweep_i > 1 && result.size <= size_before && size_before > 0 && is_finite(size_before);
        const scalar beta = shrinks ? result.size / size_before : 0;
        size_before = result.size;
        extrapolate(solver, beta);
    }
}

}  // namespace

template <bool notes_impulses>
void solve_manifolds(SolverView& solver, const BodyView& bodies, const Vector& gravity, scalar h, ImpactNote* notes, StepReport& report) {
    take_in_bodies(solver, bodies, gravity);
    order_manifolds(solver);
    prepare_blocks(solver, bodies);

    const bool has_chains = find_impact_chains(solver);
    const SweepPlan plan = plan_sweeps(solver);
    const scalar h_substep = h / limits::substeps;
    for (int substep_i = 0; substep_i < limits::substeps; ++substep_i) {
        predict_contacts(solver, h_substep);
        if (has_chains) sequence_impacts(solver, h_substep, notes, report);
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

// SPDX-License-Identifier: MIT
#include "solve_manifolds.h"

#include "../base/limits.h"
#include "conjugate_gradients.h"
#include "move_bodies.h"
#include "note_impulses.h"
#include "order_manifolds.h"
#include "predict_contacts.h"
#include "prepare_blocks.h"
#include "sweep_positions.h"
#include "sweep_velocities.h"
#include "warm_start.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// How a step is cut and its substeps are swept. Where contacts are few, chains of them are long for their number, and sweeps are cheap: many are
/// allowed, to a small residual, and all go up, which serves heavy bodies on light ones. Where they are many the number is fixed, larger while many
/// are young, and sweeps go up and down in turn, which carries the weight of a pile to the ground and back.
struct SweepPlan {
    int substeps;
    int sweeps_max;
    bool up_and_down;
    scalar settled_speed;  ///< m/s
};

constexpr SweepPlan plan_of_few = {limits::substeps, limits::sweeps_of_few, false, limits::settled_speed_of_few};
constexpr SweepPlan plan_of_young = {limits::substeps, limits::sweeps_of_young, true, limits::settled_speed};
constexpr SweepPlan plan_of_many = {limits::substeps, limits::sweeps, true, limits::settled_speed};
constexpr SweepPlan plan_of_calm = {limits::calm_substeps, limits::calm_sweeps, true,
                                    limits::settled_speed * limits::substeps / limits::calm_substeps};

/// Calm: nothing that touches accelerated in the step before, and nothing has begun to touch since.
SweepPlan plan_sweeps(const SolverView& solver) {
    if (solver.manifold_count <= limits::few_manifolds) return plan_of_few;
    int young = 0, calm = 0;
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {
        const ManifoldRecord& record = solver.records[solver.pairs[manifold_i].record];
        if (age_of(record) < 4 * limits::substeps) ++young;
        if (is_calm(record)) ++calm;
    }
    if (calm == solver.manifold_count) return plan_of_calm;
    return 4 * young > solver.manifold_count ? plan_of_young : plan_of_many;
}

/// Sweeps until nothing changes by more than the plan's speed, or the rounding of the bodies' own. Returns how many.
int solve_velocities(const SolverView& solver, const SweepPlan& plan, scalar& residual) {
    const scalar settled = plan.settled_speed + 4 * epsilon * solver.speed_max;
    scalar size_before = 0;
    if (plan.sweeps_max > 1) begin_sweeps(solver);
    for (int sweep_i = 1;; ++sweep_i) {
        residual = sweep_velocities(solver, sweep_i, !plan.up_and_down || sweep_i % 2 != 0, limits::stirring_share * settled);
        if (sweep_i == plan.sweeps_max || residual <= settled) return sweep_i;
        // A body that is not finite must not spread to those that it does not touch.
        const scalar size = sum_of_changes(solver);
        const bool shrinks = sweep_i > 1 && size <= size_before && size_before > 0 && is_finite(size_before);
        extrapolate(solver, shrinks ? size / size_before : 0);
        size_before = size;
    }
}

/// Solves and displaces the substeps of a plan, from the state at the begin of the step. solver.calm tells whether nothing accelerated.
template <bool notes_impulses>
void solve_substeps(SolverView& solver, const BodyView& bodies, const SweepPlan& plan, scalar h_step, [[maybe_unused]] ImpactNote* notes, StepReport& report) {
    solver.substeps = plan.substeps;
    solver.calm = true;
    prepare_blocks(solver, bodies);
    if constexpr (notes_impulses) clear_impulse_notes(solver, notes);
    const scalar h = h_step / static_cast<scalar>(plan.substeps);
    for (int substep_i = 0; substep_i < plan.substeps; ++substep_i) {
        predict_contacts(solver, h);
        kick_bodies(solver, h);
        warm_start(solver, h);
        count(report.sweeps, solve_velocities(solver, plan, report.residual));
        if constexpr (notes_impulses) note_impulses(solver, notes);
        drift_bodies(solver, bodies, h);
        sweep_positions(solver, h);
    }
}

}  // namespace

template <bool notes_impulses>
void solve_manifolds(SolverView& solver, const BodyView& bodies, const Vector& gravity, scalar h, [[maybe_unused]] ImpactNote* notes, StepReport& report) {
    take_in_bodies(solver, bodies, gravity);
    order_manifolds(solver);
    const SweepPlan plan = plan_sweeps(solver);
    solve_substeps<notes_impulses>(solver, bodies, plan, h, notes, report);
    if (plan.substeps < limits::substeps && !solver.calm) {  // calm no more: the step begins again, with all of its substeps
        take_in_bodies(solver, bodies, gravity);
        solve_substeps<notes_impulses>(solver, bodies, plan_of_many, h, notes, report);
    }
    remember_impulses(solver);
}

// The linker takes the one that the scene calls.
template void solve_manifolds<false>(SolverView&, const BodyView&, const Vector&, scalar, ImpactNote*, StepReport&);
template void solve_manifolds<true>(SolverView&, const BodyView&, const Vector&, scalar, ImpactNote*, StepReport&);

} }  // namespace ingot

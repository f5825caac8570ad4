// SPDX-License-Identifier: MIT
#include "solve_velocities.h"

#include "../base/limits.h"
#include "conjugate_gradients.h"
#include "sweep_velocities.h"

namespace ingot { inline namespace INGOT_ABI {

SweepPlan plan_sweeps(const SolverView& solver) {
    if (solver.manifold_count <= limits::few_manifolds) return {limits::sweeps_of_few, false, limits::settled_speed_of_few};
    int young = 0;
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i)
        if (solver.records[solver.pairs[manifold_i].record].substeps < 4 * limits::substeps) ++young;
    return {4 * young > solver.manifold_count ? limits::sweeps_of_young : limits::sweeps, true, limits::settled_speed};
}

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

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#include "solve_velocities.h"

#include "../../base/limits.h"
#include "conjugate_gradients.h"
#include "sweep_velocities.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

constexpr SweepPlan plan_of_small = {limits::substeps, limits::sweeps_of_small, limits::sweeps_of_small, false, limits::settled_speed_of_small};
constexpr SweepPlan plan_of_small_steady = {limits::steady_substeps, limits::sweeps_of_small, limits::sweeps_of_small, false,
                                            limits::settled_speed_of_small};
constexpr SweepPlan plan_of_many = {limits::substeps, limits::sweeps, limits::sweeps_of_balls, true, limits::settled_speed};
constexpr SweepPlan plan_of_new = {limits::substeps, limits::sweeps_of_new, limits::sweeps_of_new, true, limits::settled_speed};
constexpr SweepPlan plan_of_steady = {limits::steady_substeps, limits::steady_sweeps, limits::steady_sweeps, true,
                                    limits::settled_speed * limits::substeps / limits::steady_substeps};

int sweeps_of(const SweepPlan& plan, const SolverView& solver) {
    const bool is_heap_of_balls = 4 * solver.central_count > 3 * solver.manifold_count;
    return is_heap_of_balls ? plan.sweeps_max_of_balls : plan.sweeps_max;
}

}  // namespace

SweepPlan plan_sweeps(const SolverView& solver) {
    int fresh = 0, steady = 0;
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {  // bound: max_manifolds
        const ManifoldRecord& record = solver.records[solver.pairs[manifold_i].record];
        if (age_of(record) < 4 * limits::substeps) ++fresh;
        if (was_steady(record)) ++steady;
    }
    const bool is_small = solver.manifold_count <= limits::small_island, is_steady = steady == solver.manifold_count;
    if (is_small) return is_steady && solver.level_count <= limits::steady_levels ? plan_of_small_steady : plan_of_small;
    if (is_steady) return plan_of_steady;
    return 4 * fresh > solver.manifold_count ? plan_of_new : plan_of_many;
}

SweepPlan with_all_substeps(const SweepPlan& steady) { return steady.up_and_down ? plan_of_many : plan_of_small; }

template <class View>
int solve_velocities(const View& solver, const SweepPlan& plan, scalar& residual) {
    const scalar settled = plan.settled_speed + 4 * epsilon * solver.speed_max;
    const int sweeps_max = sweeps_of(plan, solver);
    scalar size_before = 0;
    if (sweeps_max > 1) begin_sweeps(solver);
    // bound: plan.sweeps_max: left at sweep_i == sweeps_max, which is 1 or more
    for (int sweep_i = 1;; ++sweep_i) {
        residual = sweep_velocities(solver, sweep_i, !plan.up_and_down || sweep_i % 2 != 0, limits::active_share * settled);
        if (sweep_i == sweeps_max || residual <= settled) return sweep_i;
        // A body that is not finite must not spread to those that it does not touch.
        const scalar size = sum_of_changes(solver);
        const bool shrinks = sweep_i > 1 && size <= size_before && size_before > 0 && is_finite(size_before);
        const scalar beta = shrinks ? size / size_before : 0;
        if constexpr (View::rolls)
            extrapolate(solver, beta);
        else
            extrapolate<SolverView>(solver, beta);
        size_before = size;
    }
}

// The linker takes the one that the scene calls.
template int solve_velocities(const SolverView&, const SweepPlan&, scalar&);
template int solve_velocities(const RollingView&, const SweepPlan&, scalar&);
template int solve_velocities(const BeltView&, const SweepPlan&, scalar&);
template int solve_velocities(const RollingBeltView&, const SweepPlan&, scalar&);

} }  // namespace ingot

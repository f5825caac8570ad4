// SPDX-License-Identifier: MIT
#include "solve_sequentially.h"

#include "../../base/limits.h"
#include "move_point_bodies.h"
#include "sweep_points.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Notes which manifolds have carried an impulse at the end of a substep.
void note_impulses_of_points(const PointView& solver, ImpactNote* notes, bool first) {
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {  // bound: max_manifolds
        const ManifoldRecord& record = solver.records[solver.pairs[manifold_i].record];
        bool carried = !first && notes[manifold_i].carried;
        // bound: 4: Manifold::points_max
        for (int point_i = 0; point_i < record.manifold.count; ++point_i) carried = carried || record.j[point_i] > 0;
        notes[manifold_i].carried = carried;
    }
}

/// Where nothing accelerated in the step before, and no chain of contacts is long.
bool begins_steady(const PointView& solver) {
    bool steady = solver.manifold_count <= limits::steady_levels;
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i)
        steady = steady && was_steady(solver.records[solver.pairs[manifold_i].record]);
    return steady;
}

}  // namespace

template <bool notes_impulses>
void solve_points(PointView& solver, const BodyView& bodies, const Vector& gravity, scalar h_step, [[maybe_unused]] ImpactNote* notes,
                  StepReport& report) {
    const int substeps = begins_steady(solver) ? limits::steady_substeps : limits::substeps;
    const scalar h = h_step / static_cast<scalar>(substeps);
    take_in_bodies(solver, bodies, gravity, h_step);
    begin_contacts(solver, static_cast<scalar>(limits::substeps / substeps), h);
    bool given_again = false, steady = true;
    // bound: limits::substeps
    for (int substep_i = 0; substep_i < substeps; ++substep_i) {
        const scalar rounding = 4 * epsilon * (given_again ? kick_again(solver) : kick_bodies(solver, h));
        if (!given_again) warm_start(solver);
        scalar size_before = 0;
        // bound: limits::sweeps_of_points: left at sweep_i == limits::sweeps_of_points
        for (int sweep_i = 1;; ++sweep_i) {
            const SweepOfPoints sweep = sweep_point_velocities(solver, sweep_i % 2 != 0, limits::ignored_speed + rounding);
            count(report.sweeps);
            report.residual = sweep.fastest;
            if (sweep_i == limits::sweeps_of_points || sweep.fastest <= limits::settled_speed_of_points + rounding) break;
            const bool shrinks = sweep_i > 1 && sweep.size <= size_before;
            go_on_along(solver, shrinks ? sweep.size / size_before : 0);
            size_before = sweep.size;
        }
        if constexpr (notes_impulses) note_impulses_of_points(solver, notes, substep_i == 0);
        const SubstepOfPoints substep = drift_bodies(solver, h);
        given_again = !substep.some_hit;
        steady = steady && substep.steady;
        sweep_point_positions(solver, h);
    }
    end_contacts(solver, static_cast<scalar>(substeps) / limits::substeps, steady);
}
template void solve_points<false>(PointView&, const BodyView&, const Vector&, scalar, ImpactNote*, StepReport&);
template void solve_points<true>(PointView&, const BodyView&, const Vector&, scalar, ImpactNote*, StepReport&);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#include "plan_islands.h"

#include "../../base/limits.h"
#include "../../island/disjoint_sets.h"
#include "../../math/sqrt.h"
#include "move_bodies.h"
#include "order_manifolds.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Numbers the islands in the order of their first bodies.
void join_bodies(SolverView& solver) {
    const DisjointSets sets{solver.island_of};
    for (int body_i = 0; body_i < solver.body_count; ++body_i) sets.make_set(body_i);  // bound: max_bodies + 1
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {  // bound: max_manifolds
        const Index A = solver.local_of[solver.pairs[manifold_i].body_A], B = solver.local_of[solver.pairs[manifold_i].body_B];
        if (A != 0 && B != 0) sets.join(A, B);
    }
    for (int body_i = 1; body_i < solver.body_count; ++body_i) solver.island_of[body_i] = static_cast<Index>(sets.root(body_i));
    solver.island_count = 0;
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {  // a root is the lowest of its island, so it has its number already
        const Index root = solver.island_of[body_i];
        if (root == body_i) solver.islands[solver.island_count] = {};
        solver.island_of[body_i] = root == body_i ? static_cast<Index>(solver.island_count++) : solver.island_of[root];
    }
    solver.island_of[0] = no_island;
}

void count_manifolds(const SolverView& solver) {
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {
        const Index island_i = solver.island_at[manifold_i] = solver.island_of[dynamic_body(solver, manifold_i)];
        if (island_i == no_island) continue;  // between two bodies that cannot move: one has gone bad
        Island& island = solver.islands[island_i];
        const ManifoldRecord& record = solver.records[solver.pairs[manifold_i].record];
        const Index level = solver.level[manifold_i];
        ++island.manifold_count;
        if (age_of(record) < new_until(solver.effort)) ++island.new_count;
        if (was_steady(record)) ++island.steady_count;
        if (level >= island.level_count) island.level_count = static_cast<Index>(level + 1);
    }
}

SweepPlan plan_of(const Island& island, const Effort& effort) {
    const bool steady = island.steady_count == island.manifold_count && spares_substeps(effort);
    if (island.manifold_count > limits::small_island) return steady ? SweepPlan::large_steady : SweepPlan::large;
    return steady && island.level_count <= limits::steady_levels ? SweepPlan::small_steady : SweepPlan::small;
}

int sweeps_max_of(const Island& island, const Effort& effort) {
    const bool is_heap_of_balls = 4 * island.central_count > 3 * island.manifold_count;
    switch (island.plan) {
        case SweepPlan::large_steady: return steady_sweeps(effort);
        case SweepPlan::large:
            if (!island.begins_again && 4 * island.new_count > island.manifold_count) return sweeps_of_new(effort);
            return is_heap_of_balls ? sweeps_of_balls(effort) : effort.sweeps;
        default: return limits::sweeps_of_small;
    }
}

scalar settled_speed_of(SweepPlan plan, int substeps) {
    if (!is_large(plan)) return limits::settled_speed_of_small;
    return limits::settled_speed * limits::substeps / static_cast<scalar>(substeps);
}

}  // namespace

void plan_islands(SolverView& solver) {
    join_bodies(solver);
    count_manifolds(solver);
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        Island& island = solver.islands[island_i];
        island.plan = plan_of(island, solver.effort);
    }
}

bool begin_batch(SolverView& solver, SweepPlan plan, const BodyView& bodies, const Vector& gravity) {
    bool some = false, again = false;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {
        Island& island = solver.islands[island_i];
        island.in_batch = island.plan == plan;
        if (!island.in_batch) continue;
        island.steady = true;
        island.central_count = island.group = 0;
        some = true;
        again = again || island.begins_again;
    }
    if (!some) return false;
    solver.plan = plan;
    solver.substeps = solver.substeps_left = is_steady(plan) ? limits::steady_substeps : solver.effort.substeps;
    solver.some_hit = solver.some_turn = false;
    solver.batch_body_count = 0;
    for (int body_i = 1; body_i < solver.body_count; ++body_i)
        if (solver.islands[solver.island_of[body_i]].in_batch) solver.batch_bodies[solver.batch_body_count++] = static_cast<Index>(body_i);
    if (again) take_in_again(solver, bodies, gravity);
    order_manifolds(solver);
    return true;
}

scalar rounding_of_speeds(const Island& island, scalar unit) { return 4 * epsilon * min(sqrt(island.fastest_sq), limits::rounding_speed_max * unit); }

namespace {

/// Sweeps that a steady island needs where it begins again.
int kept_of(const SolverView& solver, const Island& island) { return is_steady(island.plan) ? solver.effort.substeps : 0; }

int within(int share, int most) { return share < most ? share : most; }

}  // namespace

int spare_sweeps(const SolverView& solver, const Island& island) {
    return solver.sweeps_of_step - island.sweeps - kept_of(solver, island) - solver.substeps_left;
}

bool sweep_again(const SolverView& solver, Island& island) {
    const int spare = spare_sweeps(solver, island) + 1;  // the one of this substep has been
    if (spare < 1) return false;
    island.sweeps_max = within(share_of_substep(spare, 0, solver.substeps_left), sweeps_max_of(island, solver.effort));
    island.sweeps_on = true;
    island.size_before = island.residual = 0;
    return true;
}

void plan_sweeps(const SolverView& solver) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {
        Island& island = solver.islands[island_i];
        if (!island.in_batch) continue;
        const int left = solver.sweeps_of_step - island.sweeps;
        island.sweeps_max = within(share_of_substep(left, kept_of(solver, island), solver.substeps_left), sweeps_max_of(island, solver.effort));
        island.settled = settled_speed_of(island.plan, solver.substeps) * solver.unit + rounding_of_speeds(island, solver.unit);
        island.sweeps_on = true;
        island.at_bound = false;
        island.size_before = 0;
        island.residual = 0;  // of one that is not swept
    }
}

namespace {

/// m/s, that a solve may leave of an island. Sweeps at their bound may leave a small share of what falls on contacts in a substep; of large islands,
/// which have few sweeps and settle over many steps, all of it.
scalar finished_speed_of(const SolverView& solver, const Island& island, scalar fall_speed) {
    const scalar least = max(limits::unsettled_speed * solver.unit, island.settled);
    if (!island.at_bound) return least;
    return max(least, is_large(island.plan) ? fall_speed : limits::unsettled_share * fall_speed);
}

}  // namespace

void end_batch(const SolverView& solver, scalar fall_speed, StepReport& report) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {
        Island& island = solver.islands[island_i];
        if (!island.in_batch) continue;
        const bool again = is_steady(island.plan) && !island.steady;
        const scalar finished = finished_speed_of(solver, island, fall_speed);
        island.plan = !again ? SweepPlan::solved : island.plan == SweepPlan::small_steady ? SweepPlan::small : SweepPlan::large;
        island.begins_again = again;
        if (!again) note_sweeps(report, island.sweeps, island.residual, finished);
    }
}

} }  // namespace ingot

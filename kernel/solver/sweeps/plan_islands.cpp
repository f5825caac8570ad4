// SPDX-License-Identifier: MIT
#include "plan_islands.h"

#include "../../base/figure_limits.h"
#include "../../body/turning_inertia.h"
#include "../../figure/build_figures.h"
#include "../../island/disjoint_sets.h"
#include "../../math/sqrt.h"
#include "move_bodies.h"
#include "order_manifolds.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

void join_figures(const DisjointSets&, const SolverView&, const NoJointedBodies&) {}
void join_figures(const DisjointSets& sets, const SolverView& solver, const JointedBodies& jointed) {
    for (int body_i = 1; body_i < solver.body_count; ++body_i) sets.join(body_i, jointed.leader_of[body_i]);  // bound: max_bodies
}

/// Numbers the islands in the order of their first bodies.
template <class Joints>
void join_bodies(SolverView& solver, const Joints& jointed) {
    const DisjointSets sets{solver.island_of};
    for (int body_i = 0; body_i < solver.body_count; ++body_i) sets.make_set(body_i);  // bound: max_bodies + 1
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {  // bound: max_manifolds
        const Index A = solver.local_of[solver.pairs[manifold_i].body_A], B = solver.local_of[solver.pairs[manifold_i].body_B];
        if (A != 0 && B != 0) sets.join(A, B);
    }
    join_figures(sets, solver, jointed);
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
        if (record.manifold.count > 2) ++island.face_count;
        if (age_of(record) < new_until(solver.effort)) ++island.new_count;
        if (was_steady(record)) ++island.steady_count;
        if (level >= island.level_count) island.level_count = static_cast<Index>(level + 1);
    }
}

bool is_large(const Island& island) { return island.manifold_count > limits::small_island; }

/// Whether faces lie on faces in it. A few sweeps a substep let a wall lean further with each, until it falls: of what leans over N levels a sweep
/// takes back a part of the order of 1 / N^3, and gravity adds to it. A heap touches at edges and corners as often, and has no such motion.
bool is_stack(const Island& island) { return limits::stack_faces * island.manifold_count < (limits::stack_faces + 1) * island.face_count; }

bool was_steady(const Island& island) { return island.steady_count == island.manifold_count; }

/// Counts the bodies of large stacks, and those that are faster than their forces make them in a substep of h seconds.
void count_moving(const SolverView& solver, scalar h) {
    bool some = false;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        const Island& island = solver.islands[island_i];
        some = some || (is_large(island) && is_stack(island));
    }
    for (int body_i = 1; some && body_i < solver.body_count; ++body_i) {  // bound: max_bodies + 1
        const SolverBody& body = solver.bodies[body_i];
        Island& island = solver.islands[solver.island_of[body_i]];
        const scalar falls = body.dp[3] * h;
        ++island.body_count;
        if (length_sq(three_of(body.v_CM)) > falls * falls) ++island.moving_count;
    }
}

/// Whether it stands, and may lean: most of it hardly moves, or all of it moves evenly. What falls or was hit is a heap.
bool stands(const Island& island) {
    return is_stack(island) && (was_steady(island) || limits::stack_faces * island.moving_count <= island.body_count - island.moving_count);
}

SweepPlan plan_of(const Island& island, const Effort& effort) {
    const bool steady = was_steady(island) && spares_substeps(effort);
    if (is_large(island) && !stands(island)) return steady ? SweepPlan::large_steady : SweepPlan::large;
    return steady && island.level_count <= limits::steady_levels ? SweepPlan::small_steady : SweepPlan::small;
}

/// More substeps for islands in which something spins fast that is not alike about all axes. h: s, of a substep.
void plan_spinning(const SolverView& solver, const BodyView& bodies, scalar h) {
    constexpr scalar turn_sq = limits::turn_of_substep * limits::turn_of_substep;
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {  // bound: max_bodies + 1
        const Place at = place_of(solver.slot_of[body_i]);
        const Vector L = three_of(solver.bodies[body_i].L);
        const scalar scale = bodies.rotation[at.tile].inv_I_scale[at.lane] * h;
        if (length_sq(L) * (scale * scale) <= turn_sq) continue;  // no ratio is beyond 1
        const Vector turn = lane_of(bodies.translation[at.tile].inv_I_world, at.lane) * L * h;
        if (!turns_inertia(lane_of(bodies.rotation[at.tile].inv_I_ratio, at.lane), turn)) continue;  // a ball, say
        const scalar turned_sq = length_sq(turn);
        Island& island = solver.islands[solver.island_of[body_i]];
        if (is_large(island)) continue;
        SweepPlan& plan = island.plan;
        if (plan == SweepPlan::small && turned_sq > turn_sq) plan = SweepPlan::small_twice;
        if (plan == SweepPlan::small_twice && turned_sq > 4 * turn_sq) plan = SweepPlan::small_four_times;
    }
}

int sweeps_max_of(const Island& island, const Effort& effort) {
    const bool is_heap_of_balls = 4 * island.central_count > 3 * island.manifold_count;
    switch (island.plan) {
        case SweepPlan::large_steady: return steady_sweeps(effort);
        case SweepPlan::large:
        case SweepPlan::jointed:
        case SweepPlan::jointed_twice:
        case SweepPlan::jointed_four_times:
        case SweepPlan::jointed_eight_times:
            if (island.manifold_count == 0) return limits::limit_sweeps_max;
            if (!island.begins_again && 4 * island.new_count > island.manifold_count) return sweeps_of_new(effort);
            return is_heap_of_balls ? sweeps_of_balls(effort) : effort.sweeps;
        default: return is_large(island) ? limits::sweeps_of_stack : limits::sweeps_of_small;
    }
}

scalar settled_speed_of(SweepPlan plan, int substeps) {
    if (!is_large(plan)) return limits::settled_speed_of_small;
    return limits::settled_speed * limits::substeps / static_cast<scalar>(substeps);
}

void plan_jointed(const SolverView&, NoJointedBodies&) {}
void plan_jointed(const SolverView& solver, JointedBodies& jointed) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i) jointed.doublings_of[island_i] = 0;
    spread_doublings(solver, jointed);
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {
        const uint8_t doublings = jointed.doublings_of[island_i];
        if (doublings > 0) solver.islands[island_i].plan = static_cast<SweepPlan>(static_cast<uint8_t>(SweepPlan::jointed) + doublings - 1);
    }
}

int substeps_of(SweepPlan plan, const Effort& effort) {
    if (is_steady(plan)) return limits::steady_substeps;
    if (plan == SweepPlan::small_twice) return effort.substeps << 1;
    if (plan == SweepPlan::small_four_times) return effort.substeps << 2;
    return is_of_joints(plan) ? effort.substeps << doublings_of(plan) : effort.substeps;
}

void begin_figures(NoJointedBodies&, SweepPlan) {}
void begin_figures(JointedBodies& jointed, SweepPlan plan) {
    jointed.figures.group_count = 0;
    jointed.figures.elapsed = 0;
    if (is_of_joints(plan)) group_figures(jointed.figures, doublings_of(plan));
}

}  // namespace

void spread_doublings(const SolverView& solver, const JointedBodies& jointed) {
    const auto for_figures = [&](const auto& each) {
        for (int figure_i = 0; figure_i < jointed.figures.figure_count; ++figure_i) {  // bound: max_joints
            Figure& figure = jointed.figures.figures[figure_i];
            each(figure, jointed.doublings_of[solver.island_of[solver.local_of[jointed.figures.nodes[figure.first_node].slot]]]);
        }
    };
    for_figures([](const Figure& figure, uint8_t& doublings) {
        if (figure.doublings >= doublings) doublings = static_cast<uint8_t>(figure.doublings + 1);
    });
    for_figures([](Figure& figure, uint8_t doublings) { figure.doublings = static_cast<uint8_t>(doublings - 1); });
}

template <class Joints>
void plan_islands(SolverView& solver, Joints& jointed, const BodyView& bodies, scalar h) {
    join_bodies(solver, jointed);
    count_manifolds(solver);
    count_moving(solver, h / static_cast<scalar>(solver.effort.substeps));
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        Island& island = solver.islands[island_i];
        island.plan = plan_of(island, solver.effort);
    }
    if (solver.sweeps_of_step == no_budget) plan_spinning(solver, bodies, h / static_cast<scalar>(solver.effort.substeps));
    plan_jointed(solver, jointed);
}

template <class Joints>
bool begin_batch(SolverView& solver, Joints& jointed, SweepPlan plan, const BodyView& bodies, const Vector& gravity) {
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
    solver.substeps = solver.substeps_left = substeps_of(plan, solver.effort);
    solver.some_hit = solver.some_turn = false;
    solver.batch_body_count = 0;
    for (int body_i = 1; body_i < solver.body_count; ++body_i)
        if (solver.islands[solver.island_of[body_i]].in_batch) solver.batch_bodies[solver.batch_body_count++] = static_cast<Index>(body_i);
    if (again) take_in_again(solver, bodies, gravity);
    order_manifolds(solver, jointed);
    begin_figures(jointed, plan);
    return true;
}

// The linker takes the one that the scene calls.
template void plan_islands(SolverView&, NoJointedBodies&, const BodyView&, scalar);
template void plan_islands(SolverView&, JointedBodies&, const BodyView&, scalar);
template bool begin_batch(SolverView&, NoJointedBodies&, SweepPlan, const BodyView&, const Vector&);
template bool begin_batch(SolverView&, JointedBodies&, SweepPlan, const BodyView&, const Vector&);

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
    return max(least, is_large(island) || is_large(island.plan) ? fall_speed : limits::unsettled_share * fall_speed);
}

SweepPlan plan_of_joints(const Island&, int, const NoJointedBodies&) { return SweepPlan::solved; }
SweepPlan plan_of_joints(const Island& island, int island_i, const JointedBodies& jointed) {
    const int doublings = jointed.doublings_of[island_i] - 1;
    if (!is_of_joints(island.plan) || doublings <= doublings_of(island.plan)) return SweepPlan::solved;
    return static_cast<SweepPlan>(static_cast<int>(SweepPlan::jointed) + doublings);
}
/// How an island begins again, if it has to.
template <class Joints>
SweepPlan plan_after(const Island& island, int island_i, const Joints& jointed) {
    if (!is_steady(island.plan)) return plan_of_joints(island, island_i, jointed);
    if (island.steady) return SweepPlan::solved;
    return island.plan == SweepPlan::small_steady ? SweepPlan::small : SweepPlan::large;
}

}  // namespace

template <class Joints>
void end_batch(const SolverView& solver, const Joints& jointed, scalar fall_speed, StepReport& report) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {
        Island& island = solver.islands[island_i];
        if (!island.in_batch) continue;
        const SweepPlan next = plan_after(island, island_i, jointed);
        const bool again = next != SweepPlan::solved;
        const scalar finished = finished_speed_of(solver, island, fall_speed);
        island.plan = next;
        island.begins_again = again;
        if (!again) note_sweeps(report, island.sweeps, island.residual, finished);
    }
}

template void end_batch(const SolverView&, const NoJointedBodies&, scalar, StepReport&);
template void end_batch(const SolverView&, const JointedBodies&, scalar, StepReport&);

} }  // namespace ingot

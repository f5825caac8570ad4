// SPDX-License-Identifier: MIT
#include "solve_directly.h"

#include "../../base/limits.h"
#include "../sweeps/move_bodies.h"
#include "../sweeps/note_impulses.h"
#include "../sweeps/order_manifolds.h"
#include "../sweeps/predict_contacts.h"
#include "../../constraint/prepare_blocks.h"
#include "../sweeps/sequence_impacts.h"
#include "../sweeps/solve_velocities.h"
#include "../sweeps/sweep_positions.h"
#include "../sweeps/warm_start.h"
#include "hold_energy.h"
#include "island_rows.h"
#include "choose_islands.h"
#include "solve_island.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

void keep_free_motion(const SolverView& solver, const DirectView& direct) {
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {  // bound: max_bodies + 1
        for (int axis = 0; axis < 3; ++axis) {
            direct.free_motion[body_i].v_CM[axis] = solver.bodies[body_i].v_CM[axis];
            direct.free_motion[body_i].L[axis] = solver.bodies[body_i].L[axis];
        }
    }
}

void load_island(const SolverView& solver, const BodyView& bodies, DirectView& direct, int root) {
    if (direct.loaded_root != root) load_rows(solver, bodies, direct, static_cast<uint16_t>(root));
}

int islands_of(const SolverView& solver, const DirectView& direct, IslandState state) {
    int count = 0;
    for (int root = 1; root < solver.body_count; ++root) count += direct.state[root] == state ? 1 : 0;
    return count;
}

/// Tries the islands of one state one by one, attempt(root) giving each a new one. Each has its share of the work, and what those before it left.
template <class Attempt>
void try_islands(const SolverView& solver, const BodyView& bodies, DirectView& direct, IslandState state, Attempt attempt) {
    int islands = islands_of(solver, direct, state), work = limits::direct_work_max;
    for (int root = 1; root < solver.body_count && islands > 0; ++root) {
        if (direct.state[root] != state) continue;
        load_island(solver, bodies, direct, root);
        const int share = direct.work_left = work / islands--;
        direct.state[root] = attempt();
        work -= share - (direct.work_left > 0 ? direct.work_left : 0);
    }
}

/// Velocities of the islands that are `chosen`. Returns how many are still.
int solve_islands(const SolverView& solver, const BodyView& bodies, DirectView& direct, scalar h, bool after_sweeps) {
    try_islands(solver, bodies, direct, IslandState::chosen, [&] {
        if (!after_sweeps) hold_energy(solver, direct);
        return solve_island(solver, direct, h, after_sweeps);
    });
    return islands_of(solver, direct, IslandState::chosen);
}

/// What the sweeps made of islands that were to be solved, and are not.
void hold_energy_of_rest(const SolverView& solver, const BodyView& bodies, DirectView& direct) {
    const IslandState unsolved[] = {IslandState::chosen, IslandState::left_to_sweeps};
    for (const IslandState state : unsolved) {
        try_islands(solver, bodies, direct, state, [&] {
            hold_energy(solver, direct);
            return state;
        });
    }
}

/// Positions of the islands that are solved; those that do not come out right are `chosen` again.
void place_islands(const SolverView& solver, const BodyView& bodies, DirectView& direct, scalar h) {
    try_islands(solver, bodies, direct, IslandState::solved,
                [&] { return place_island(solver, direct, h) ? IslandState::solved : IslandState::chosen; });
}

/// For the next substep, in which it is tried anew.
void choose_again(const SolverView& solver, const DirectView& direct) {
    for (int root = 1; root < solver.body_count; ++root)
        if (direct.state[root] != IslandState::swept) direct.state[root] = IslandState::chosen;
}

/// Solves and displaces the substeps of a plan, from the state at the begin of the step: solve_substeps of solve_manifolds.cpp, with `chosen`
/// islands. True where sweeps were at their bound in the last.
template <bool notes_impulses>
bool solve_substeps_directly(SolverView& solver, DirectView& direct, const BodyView& bodies, const SweepPlan& plan, int chosen, scalar h_step,
                             ImpactNote* notes, StepReport& report) {
    solver.substeps = plan.substeps;
    solver.steady = true;
    direct.loaded_root = 0;
    prepare_blocks(solver, bodies);
    if constexpr (notes_impulses) clear_impulse_notes(solver, notes);
    const bool has_chains = find_impact_chains(solver);
    const scalar h = h_step / static_cast<scalar>(plan.substeps);
    bool at_bound = false;
    // bound: limits::substeps
    for (int substep_i = 0; substep_i < plan.substeps; ++substep_i) {
        predict_contacts(solver, h);
        predict_bounces(solver, h);
        if (has_chains && sequence_impacts(solver, h, notes, report)) solver.steady = false;
        kick_bodies(solver, h);
        if (chosen != 0) keep_free_motion(solver, direct);
        warm_start(solver, h);

        const int left = chosen != 0 ? solve_islands(solver, bodies, direct, h, false) : 0;
        SolverView swept = chosen != left ? left_to_sweeps(solver, direct) : solver;
        if (swept.visit_count != 0) {
            const int sweeps = solve_velocities(swept, plan, report.residual);
            count(report.sweeps, sweeps);
            at_bound = sweeps == plan.sweeps_max && report.residual > limits::settled_speed;
        }
        if (left != 0 && solve_islands(solver, bodies, direct, h, true) != 0)
            report.direct = static_cast<uint8_t>(report.direct | DirectBits::unfinished);
        if (chosen != 0 && islands_of(solver, direct, IslandState::solved) != 0)
            report.direct = static_cast<uint8_t>(report.direct | DirectBits::solved);
        if (chosen != 0) hold_energy_of_rest(solver, bodies, direct);

        if constexpr (notes_impulses) note_impulses(solver, notes);
        drift_bodies(solver, bodies, h);
        if (chosen != 0) {
            place_islands(solver, bodies, direct, h);
            swept = left_to_sweeps(solver, direct);
            choose_again(solver, direct);
        }
        sweep_positions(swept, h);
    }
    return at_bound;
}

}  // namespace

template <bool notes_impulses>
void solve_directly(SolverView& solver, DirectView& direct, const BodyView& bodies, const Vector& gravity, scalar h, ImpactNote* notes,
                    StepReport& report) {
    take_in_bodies(solver, bodies, gravity, h);
    order_manifolds(solver);
    const SweepPlan plan = plan_sweeps(solver);
    const int chosen = choose_islands(solver, direct, report);
    bool at_bound = solve_substeps_directly<notes_impulses>(solver, direct, bodies, plan, chosen, h, notes, report);
    if (plan.substeps < limits::substeps && !solver.steady) {  // calm no more: the step begins again, with all of its substeps
        take_in_bodies(solver, bodies, gravity, h);
        at_bound = solve_substeps_directly<notes_impulses>(solver, direct, bodies, with_all_substeps(plan), chosen, h, notes, report);
    }
    note_unsettled(solver, direct, at_bound);
    remember_impulses(solver);
}

// The linker takes the one that the scene calls.
template void solve_directly<false>(SolverView&, DirectView&, const BodyView&, const Vector&, scalar, ImpactNote*, StepReport&);
template void solve_directly<true>(SolverView&, DirectView&, const BodyView&, const Vector&, scalar, ImpactNote*, StepReport&);

} }  // namespace ingot

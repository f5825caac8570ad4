// SPDX-License-Identifier: MIT
#include "solve_directly.h"

#include "../../base/limits.h"
#include "../sweeps/order_manifolds.h"
#include "hold_energy.h"
#include "hold_speeds.h"
#include "island_rows.h"
#include "solve_island.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Calls state = attempt(island) for the islands of the batch in a state, with the island loaded and its work before it.
template <class Attempt, class View, class Direct>
void try_islands(const View& solver, const BodyView& bodies, Direct& direct, IslandState state, const Attempt& attempt) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        if (!solver.islands[island_i].in_batch || direct.state[island_i] != state) continue;
        if (direct.loaded_island != island_i) load_rows(solver, bodies, direct, island_i);
        direct.work_left = limits::direct_work_max;
        direct.state[island_i] = attempt();
    }
}

template <class Direct>
bool has_some(const SolverView& solver, const Direct& direct, IslandState state) {
    bool some = false;
    for (int island_i = 0; island_i < solver.island_count; ++island_i)
        some = some || (solver.islands[island_i].in_batch && direct.state[island_i] == state);
    return some;
}

/// Islands in a state have no sweeps, all others have.
template <class Direct>
void switch_sweeps(const SolverView& solver, const Direct& direct, IslandState without) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i)
        if (solver.islands[island_i].in_batch) solver.islands[island_i].sweeps_on = direct.state[island_i] != without;
}

}  // namespace

template <class Direct>
void begin_direct_batch(const SolverView& solver, Direct& direct) {
    direct.loaded_island = -1;
    direct.some_chosen = has_some(solver, direct, IslandState::chosen);
    if (direct.some_chosen) list_members(solver);
}

template <class Direct>
void keep_free_motion(const SolverView& solver, const Direct& direct) {
    for_bodies(solver, [&](int body_i) {
        for (int axis = 0; axis < 3; ++axis) {
            direct.free_motion[body_i].v_CM[axis] = solver.bodies[body_i].v_CM[axis];
            direct.free_motion[body_i].L[axis] = solver.bodies[body_i].L[axis];
        }
    });
}

template <class Direct>
void add_to_free_motion(const SolverView& solver, const Direct& direct) {
    const auto add = [&](Index body_i, const Vector& impulse, const Vector& moment) {
        FreeMotion& motion = direct.free_motion[body_i];
        const scalar inv_M = solver.bodies[body_i].v_CM[3];
        const scalar linear[3] = {impulse.x, impulse.y, impulse.z}, angular[3] = {moment.x, moment.y, moment.z};
        for (int axis = 0; axis < 3; ++axis) {
            motion.v_CM[axis] += linear[axis] * inv_M;
            motion.L[axis] += angular[axis];
        }
    };
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {  // bound: max_manifolds, rounded up to whole blocks
        const ContactBlock& block = solver.blocks[block_i];
        const FrictionRows& friction = block.friction;
        if (!friction.turns_round) continue;
        for (int lane_i = 0; lane_i < lanes; ++lane_i)
            for (int axis = 0; axis < 2; ++axis) {
                const scalar j = friction.given[axis][lane_i];
                const Vector impulse = lane_of(axis == 0 ? block.t_1 : block.t_2, lane_i) * j;
                add(block.body_A[lane_i], impulse, lane_of(friction.levers[axis].J_A, lane_i) * j);
                add(block.body_B[lane_i], -impulse, lane_of(friction.levers[axis].J_B, lane_i) * j);
            }
    }
}

template <class View, class Direct>
void solve_before_sweeps(View& solver, Direct& direct, const BodyView& bodies, scalar h) {
    try_islands(solver, bodies, direct, IslandState::chosen, [&] {
        hold_energy(solver, direct);
        return solve_island(solver, direct, h, false);
    });
    switch_sweeps(solver, direct, IslandState::solved);
}

template <class View, class Direct>
void solve_after_sweeps(View& solver, Direct& direct, const BodyView& bodies, scalar h, StepReport& report) {
    try_islands(solver, bodies, direct, IslandState::chosen, [&] { return solve_island(solver, direct, h, true); });
    if (has_some(solver, direct, IslandState::chosen)) report.direct = static_cast<uint8_t>(report.direct | DirectBits::unfinished);
    if (has_some(solver, direct, IslandState::solved)) report.direct = static_cast<uint8_t>(report.direct | DirectBits::solved);
    constexpr IslandState states[] = {IslandState::chosen, IslandState::left_to_sweeps};
    for (const IslandState unsolved : states) {
        try_islands(solver, bodies, direct, unsolved, [&] {
            hold_energy(solver, direct);
            if constexpr (!View::has_belts) hold_speeds(solver, direct);
            return unsolved;
        });
    }
}

template <class View, class Direct>
void place_islands(View& solver, Direct& direct, const BodyView& bodies, scalar h) {
    try_islands(solver, bodies, direct, IslandState::solved,
                [&] { return place_island(solver, direct, h) ? IslandState::solved : IslandState::chosen; });
    switch_sweeps(solver, direct, IslandState::solved);
    for (int island_i = 0; island_i < solver.island_count; ++island_i)
        if (solver.islands[island_i].in_batch && direct.state[island_i] != IslandState::swept) direct.state[island_i] = IslandState::chosen;
}

// The linker takes those of the scene.
#define INGOT_VIEW(View)                                                                                        \
    template void solve_before_sweeps(View&, DirectOf<View>&, const BodyView&, scalar);                         \
    template void solve_after_sweeps(View&, DirectOf<View>&, const BodyView&, scalar, StepReport&);             \
    template void place_islands(View&, DirectOf<View>&, const BodyView&, scalar)
INGOT_VIEW(SolverView);
INGOT_VIEW(RollingView);
INGOT_VIEW(BeltView);
INGOT_VIEW(RollingBeltView);
INGOT_VIEW(KinematicViewOf<SolverView>);
INGOT_VIEW(KinematicViewOf<RollingView>);
INGOT_VIEW(KinematicViewOf<BeltView>);
INGOT_VIEW(KinematicViewOf<RollingBeltView>);
#undef INGOT_VIEW
template void begin_direct_batch(const SolverView&, DirectView&);
template void begin_direct_batch(const SolverView&, RollingDirectView&);
template void keep_free_motion(const SolverView&, const DirectView&);
template void keep_free_motion(const SolverView&, const RollingDirectView&);
template void add_to_free_motion(const SolverView&, const DirectView&);
template void add_to_free_motion(const SolverView&, const RollingDirectView&);

} }  // namespace ingot

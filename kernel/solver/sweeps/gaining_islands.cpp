// SPDX-License-Identifier: MIT
#include "gaining_islands.h"

#include "../../base/limits.h"
#include "plan_islands.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

bool is_unsettled(const Island& island, scalar unit) {
    return island.in_batch && island.at_bound && island.residual > limits::gaining_residual * unit &&
           island.fastest_sq > limits::gaining_speed * limits::gaining_speed * unit * unit;
}

/// J: what a body would have without contacts, and what it has.
struct Energies {
    scalar without, with;
};
Energies energies_of(const SolverView& solver, const BodyView& bodies, scalar h, int body_i) {
    const SolverBody& body = solver.bodies[body_i];
    const SolverBodyHistory& history = solver.histories[body_i];
    const Place at = place_of(solver.slot_of[body_i]);
    const SymmetricMatrix inv_I_world = lane_of(bodies.translation[at.tile].inv_I_world, at.lane);
    const auto energy = [&](const Vector& v, const Vector& L) { return (length_sq(v) / body.v_CM[3] + dot(L, inv_I_world * L)) / 2; };
    return {energy(three_of(history.v_begin) + three_of(history.a) * h, three_of(history.L_begin) + three_of(history.tau) * h),
            energy(three_of(body.v_CM), three_of(body.L))};
}

}  // namespace

bool find_gaining_islands(const SolverView& solver, const BodyView& bodies, scalar h) {
    bool some = false;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {  // bound: max_bodies
        Island& island = solver.islands[island_i];
        island.size = island.size_before = 0;
        some = some || is_unsettled(island, solver.unit);
    }
    if (!some) return false;
    for_bodies(solver, [&](int body_i) {
        Island& island = solver.islands[solver.island_of[body_i]];
        if (!is_unsettled(island, solver.unit)) return;
        const Energies energies = energies_of(solver, bodies, h, body_i);
        island.size += energies.with;
        island.size_before += energies.without;
    });
    some = false;
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {
        Island& island = solver.islands[island_i];
        if (!(island.size > island.size_before * (1 + limits::gain_allowed)) || !sweep_again(solver, island)) continue;
        some = true;
        island.at_bound = false;
    }
    return some;
}

} }  // namespace ingot

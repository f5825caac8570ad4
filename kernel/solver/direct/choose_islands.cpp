// SPDX-License-Identifier: MIT
#include "choose_islands.h"

#include "../../base/limits.h"
#include "../sweeps/order_manifolds.h"
#include "carried_loads.h"
#include "island_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Contacts of bodies of unlike masses, and those that sweeps have not settled.
template <class Direct>
void choose_by_contacts(const SolverView& solver, const Direct& direct) {
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {  // bound: max_manifolds
        const BodyPair& pair = solver.pairs[manifold_i];
        if (age_of(solver.records[pair.record]) == 0) direct.unsettled[pair.record] = 0;  // a new contact
        const Index island_i = solver.island_at[manifold_i];
        if (island_i == no_island) continue;
        if (are_uneven(solver, solver.local_of[pair.body_A], solver.local_of[pair.body_B]) ||
            direct.unsettled[pair.record] >= limits::unsettled_steps)
            direct.state[island_i] = IslandState::chosen;
    }
}

/// Where bodies carry many times their own mass, and there is room.
template <class Direct>
void choose_by_loads(const SolverView& solver, const Direct& direct) {
    mark_carrying(solver, direct.manifold_capacity);
    for (int island_i = 0; island_i < solver.island_count; ++island_i)  // bound: max_bodies
        if (solver.islands[island_i].carries) direct.state[island_i] = IslandState::chosen;
}

/// Tall towers, where there is room for them.
template <class Direct>
void choose_by_levels(const SolverView& solver, const Direct& direct) {
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {  // bound: max_bodies + 1
        const Index island_i = solver.island_of[body_i], level = solver.level_of_body[body_i];
        if (level != unreached_level && level >= limits::direct_levels && solver.islands[island_i].manifold_count <= direct.manifold_capacity)
            direct.state[island_i] = IslandState::chosen;
    }
}

}  // namespace

template <class Direct>
void choose_islands(const SolverView& solver, const Direct& direct, StepReport& report) {
    for (int island_i = 0; island_i < solver.island_count; ++island_i) direct.state[island_i] = IslandState::swept;  // bound: max_bodies
    choose_by_contacts(solver, direct);
    choose_by_loads(solver, direct);
    choose_by_levels(solver, direct);
    for (int island_i = 0; island_i < solver.island_count; ++island_i) {
        if (direct.state[island_i] == IslandState::swept || solver.islands[island_i].manifold_count <= direct.manifold_capacity) continue;
        direct.state[island_i] = IslandState::swept;
        report.direct = static_cast<uint8_t>(report.direct | DirectBits::refused);
    }
}

template <class Direct>
void note_unsettled(const SolverView& solver, const Direct& direct) {
    for (int position = 0; position < solver.lane_count; ++position) {  // bound: max_manifolds, rounded up to whole blocks
        const ContactBlock& block = solver.blocks[position / lanes];
        const int lane_i = position % lanes;
        if (is_spare(block.manifold[lane_i])) continue;
        const Island& island = solver.islands[block.island[lane_i]];
        if (direct.state[block.island[lane_i]] != IslandState::swept || island.begins_again || island.manifold_count > direct.manifold_capacity)
            continue;
        uint8_t& steps = direct.unsettled[solver.pairs[block.manifold[lane_i]].record];
        const scalar speed_sq = block.change[lane_i] * block.K[0][lane_i];  // change = speed^2 / compliance
        const bool moving = island.at_bound && speed_sq > limits::unsettled_speed * solver.unit * (limits::unsettled_speed * solver.unit);
        steps = static_cast<uint8_t>(!moving ? 0 : steps < limits::unsettled_steps ? steps + 1 : steps);
    }
}

// The linker takes those of the scene.
template void choose_islands(const SolverView&, const DirectView&, StepReport&);
template void choose_islands(const SolverView&, const RollingDirectView&, StepReport&);
template void note_unsettled(const SolverView&, const DirectView&);
template void note_unsettled(const SolverView&, const RollingDirectView&);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#include "choose_islands.h"

#include "island_rows.h"

#include "../../base/limits.h"
#include "../sweeps/order_manifolds.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// The root of a body's tree, which is made shorter on the way. Bound: the depth of the tree; roots are the lowest of their
/// bodies.
uint16_t root_of(uint16_t* root, uint16_t body_i) {
    // bound: max_bodies: body_i falls each turn: a root of join_bodies is lower than what it is the root of
    while (root[body_i] != body_i) {
        root[body_i] = root[root[body_i]];
        body_i = root[body_i];
    }
    return body_i;
}

void join_bodies(const SolverView& solver, const DirectView& direct) {
    for (int body_i = 0; body_i < solver.body_count; ++body_i) {  // bound: max_bodies + 1
        direct.root[body_i] = static_cast<uint16_t>(body_i);
        direct.size[body_i] = 0;
        direct.state[body_i] = IslandState::swept;
    }
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {  // bound: max_manifolds
        const uint16_t body_A = solver.local_of[solver.pairs[manifold_i].body_A],
                       body_B = solver.local_of[solver.pairs[manifold_i].body_B];
        if (body_A == 0 || body_B == 0) continue;
        const uint16_t A = root_of(direct.root, body_A), B = root_of(direct.root, body_B);
        (A < B ? direct.root[B] : direct.root[A]) = A < B ? A : B;
    }
    for (int body_i = 1; body_i < solver.body_count; ++body_i)
        direct.root[body_i] = root_of(direct.root, static_cast<uint16_t>(body_i));
}

/// Positions in solver.order of the members of chosen islands, island by island.
void list_members(const SolverView& solver, const DirectView& direct) {
    uint16_t sum = 0;
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {
        if (direct.state[body_i] != IslandState::chosen) continue;
        direct.begin[body_i] = sum;
        sum = static_cast<uint16_t>(sum + direct.size[body_i]);
        direct.size[body_i] = 0;
    }
    // bound: lanes of all blocks: block_capacity lanes of storage.h, about 3/2 max_manifolds
    for (int position = 0; position < solver.lane_count; ++position) {
        if (solver.order[position] == no_manifold) continue;
        const uint16_t root = direct.root[dynamic_body(solver, solver.order[position])];
        if (direct.state[root] != IslandState::chosen) continue;
        direct.members[direct.begin[root] + direct.size[root]++] = static_cast<uint16_t>(position);
    }
}

/// A visit for each run of lanes that are left: then its first manifold is known, and those that follow it are of the same colour.
void add_runs(SolverView& left, const Visit& visit, unsigned bits, unsigned solved) {
    unsigned before = 0, run = 0, run_first = 0;
    for (unsigned lane_i = 0; lane_i <= static_cast<unsigned>(lanes); ++lane_i) {  // bound: lanes
        const bool stays = (bits >> lane_i & 1u) != 0;
        if (stays && run == 0) run_first = before;
        if (stays) run |= 1u << lane_i;
        if (!stays && run != 0) {
            left.visits[left.visit_count++] = {visit.block, static_cast<uint16_t>(run), static_cast<uint16_t>(visit.first + run_first)};
            run = 0;
        }
        before += ((bits | solved) >> lane_i & 1u) != 0 ? 1u : 0u;
    }
}

}  // namespace

int choose_islands(const SolverView& solver, const DirectView& direct, StepReport& report) {
    join_bodies(solver, direct);
    for (int manifold_i = 0; manifold_i < solver.manifold_count; ++manifold_i) {
        const uint16_t record_i = solver.pairs[manifold_i].record;
        if (age_of(solver.records[record_i]) == 0) direct.unsettled[record_i] = 0;  // a new contact
        const uint16_t root = direct.root[dynamic_body(solver, manifold_i)];
        if (root == 0) continue;  // a body that has gone bad, on one that cannot move
        ++direct.size[root];
        if (are_uneven(solver, solver.local_of[solver.pairs[manifold_i].body_A], solver.local_of[solver.pairs[manifold_i].body_B]) ||
            direct.unsettled[record_i] >= limits::unsettled_steps)
            direct.state[root] = IslandState::chosen;
    }
    const auto fits = [&](int root) { return direct.size[root] <= direct.manifold_capacity; };
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {
        const uint16_t root = direct.root[body_i], level = solver.level_of_body[body_i];
        if (level != unreached_level && level >= limits::direct_levels && fits(root)) direct.state[root] = IslandState::chosen;
    }
    int chosen = 0;
    for (int body_i = 1; body_i < solver.body_count; ++body_i) {
        if (direct.state[body_i] != IslandState::chosen) continue;
        if (!fits(body_i)) {
            direct.state[body_i] = IslandState::swept;
            report.direct = static_cast<uint8_t>(report.direct | DirectBits::refused);
        } else {
            ++chosen;
        }
    }
    if (chosen != 0) list_members(solver, direct);
    return chosen;
}

SolverView left_to_sweeps(const SolverView& solver, const DirectView& direct) {
    SolverView left = solver;
    left.visits = direct.visits;
    left.visit_count = 0;
    for (int visit_i = 0; visit_i < solver.visit_count; ++visit_i) {  // bound: max_manifolds
        const Visit visit = solver.visits[visit_i];
        unsigned bits = 0, solved = 0;
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            if ((visit.lane_bits >> lane_i & 1u) == 0) continue;
            const uint16_t manifold_i = solver.blocks[visit.block].manifold[lane_i];
            if (manifold_i == no_manifold) continue;
            const bool is_solved = direct.state[direct.root[dynamic_body(solver, manifold_i)]] == IslandState::solved;
            (is_solved ? solved : bits) |= 1u << lane_i;
        }
        if (solved == 0)
            left.visits[left.visit_count++] = visit;
        else
            add_runs(left, visit, bits, solved);
    }
    return left;
}

void note_unsettled(const SolverView& solver, const DirectView& direct, bool at_bound) {
    for (int position = 0; position < solver.lane_count; ++position) {
        const uint16_t manifold_i = solver.order[position];
        if (manifold_i == no_manifold) continue;
        const uint16_t root = direct.root[dynamic_body(solver, manifold_i)];
        if (direct.state[root] != IslandState::swept || direct.size[root] > direct.manifold_capacity) continue;
        const ContactBlock& block = solver.blocks[position / lanes];
        const int lane_i = position % lanes;
        uint8_t& steps = direct.unsettled[solver.pairs[manifold_i].record];
        const scalar speed_sq = block.change[lane_i] * block.K[0][lane_i];  // change = speed^2 / compliance
        const bool moving = at_bound && speed_sq > limits::unsettled_speed * limits::unsettled_speed;
        steps = static_cast<uint8_t>(!moving ? 0 : steps < limits::unsettled_steps ? steps + 1 : steps);
    }
}

} }  // namespace ingot

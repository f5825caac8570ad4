// SPDX-License-Identifier: MIT
// Contacts without a world around them: what the solver's own stages work on.
#pragma once

#include <ingot/body/freeze_bad_bodies.h>
#include <ingot/constraint/solver_view.h>

#include <cstdint>
#include <vector>

namespace ingot_contact {

/// Bodies and manifolds as a world would have them, and all the memory of the solver.
struct Pile {
    int bodies;
    std::vector<ingot::RotationTile> rotation;
    std::vector<ingot::TranslationTile> translation;
    std::vector<ingot::BodyPair> pairs;
    std::vector<ingot::ManifoldRecord> records;
    std::vector<ingot::Vector> references;

    std::vector<ingot::ContactBlock> blocks;
    std::vector<ingot::Visit> visits, some_visits;
    std::vector<ingot::Island> islands;
    std::vector<std::uint8_t> colour;
    std::vector<ingot::Index> members, sorted, island_at, level, slot_of, local_of, level_of_body, island_of, batch_bodies;
    std::vector<ingot::SolverBody> solver_bodies;
    std::vector<ingot::SolverBodyHistory> histories;
    std::vector<std::uint32_t> colours;

    explicit Pile(int body_count) : bodies(body_count) {
        const std::size_t tiles = static_cast<std::size_t>((bodies + ingot::lanes - 1) / ingot::lanes);
        rotation.resize(tiles);
        translation.resize(tiles);
        for (int slot = 0; slot < static_cast<int>(tiles) * ingot::lanes; ++slot) ingot::set_identity_body(view(), slot);
    }
    ingot::BodyView view() { return {rotation.data(), translation.data(), nullptr, nullptr, static_cast<int>(rotation.size())}; }

    ingot::SolverView solver() {
        const std::size_t manifolds = pairs.size(), room = 2 * manifolds + 2, locals = static_cast<std::size_t>(bodies) + 1;
        blocks.assign(room, {});
        visits.assign(2 * manifolds + room, {});
        some_visits = visits;
        colour.assign(manifolds, 0);
        islands.assign(locals, {});
        for (auto* of_manifold : {&members, &sorted, &island_at, &level}) of_manifold->assign(manifolds, 0);
        for (auto* of_body : {&slot_of, &level_of_body, &island_of, &batch_bodies}) of_body->assign(locals, 0);
        local_of.assign(rotation.size() * ingot::lanes, 0);
        solver_bodies.assign(locals, {});
        histories.assign(locals, {});
        colours.assign(locals, 0);
        ingot::SolverView solver{};
        solver.pairs = pairs.data(), solver.records = records.data(), solver.manifold_count = static_cast<int>(manifolds);
        references.assign(records.size(), {});
        solver.friction_references = references.data();
        solver.bodies = solver_bodies.data(), solver.histories = histories.data();
        solver.slot_of = slot_of.data(), solver.local_of = local_of.data(), solver.level_of_body = level_of_body.data();
        solver.colours_of_body = colours.data(), solver.island_of = island_of.data(), solver.islands = islands.data();
        solver.blocks = blocks.data(), solver.visits = visits.data(), solver.some_visits = some_visits.data();
        solver.members = members.data(), solver.sorted = sorted.data(), solver.colour = colour.data();
        solver.island_at = island_at.data(), solver.level = level.data();
        solver.batch_bodies = batch_bodies.data(), solver.lane_capacity = static_cast<int>(room) * ingot::lanes;
        return solver;
    }
};

}  // namespace ingot_contact

// SPDX-License-Identifier: MIT
// A bug is seen once, by a tester: "a crate left the yard". What was pressed has been noted, and the world each second, in the portable form. So it
// is played again from the second before it, as often as one likes, and comes in the same step, with the same bits.
#include <ingot/ingot.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>

struct Yard : ingot::Scene {
    static constexpr int max_bodies = 8, max_manifolds = 30;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
static ingot::World<Yard> world, again;
static constexpr int steps = 600, seconds = steps / 60;
static std::uint8_t kept[seconds][ingot::snapshot_size<Yard>()];
static std::size_t size_of[seconds];  // a snapshot of few bodies has fewer bytes

/// What is pressed in a step: a kick for one of the crates, now and then.
static bool play(ingot::World<Yard>& in, int step_i) {
    const unsigned word = static_cast<unsigned>(step_i) * 2654435761u;
    if (step_i % 40 == 0) {
        const ingot::scalar way = static_cast<ingot::scalar>(word % 5) - 2, turn = static_cast<ingot::scalar>(word / 8 % 5) - 2;
        if (in.apply_central_impulse(in.body_at(1 + static_cast<int>(word / 64 % 6)), {way * 130, turn * 130, 200}) != ingot::Status::ok)
            return false;
    }
    return ingot::step(in, 1.0f / 60).status == ingot::Status::ok;
}

/// The bug: a crate is further than 4 m from where it all began.
static bool has_left(const ingot::World<Yard>& in) {
    for (int slot = 1; slot < 7; ++slot) {
        const ingot::Vector r = in.state(in.body_at(slot)).value.r_CM;
        if (r.x * r.x + r.y * r.y > 16) return true;
    }
    return false;
}

int main() {
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    bool good = world.set_gravity({0, 0, -9.81f}) == ingot::Status::ok && world.add(ground).ok();
    ingot::BodyDef crate;
    crate.mass = ingot::principal(ingot::solid_box(200, {0.4f, 0.4f, 0.4f})).value;
    crate.shape = ingot::Box{{0.4f, 0.4f, 0.4f}};
    for (int i = 0; i < 6; ++i) {
        crate.state.r_CM = {static_cast<ingot::scalar>(i % 3) - 1, static_cast<ingot::scalar>(i / 3) - 0.5f, 0.4f};
        good = good && world.add(crate).ok();
    }
    int seen = -1;
    for (int step_i = 0; good && seen < 0 && step_i < steps; ++step_i) {
        if (step_i % 60 == 0) size_of[step_i / 60] = ingot::save_snapshot(world, kept[step_i / 60], sizeof kept[0]).value;
        good = play(world, step_i);
        if (has_left(world)) seen = step_i;
    }
    const std::uint64_t hash = world.state_hash();
    for (int time = 0; good && seen >= 0 && time < 2; ++time) {
        good = ingot::load_snapshot(again, kept[seen / 60], size_of[seen / 60]) == ingot::Status::ok && !has_left(again);
        for (int step_i = seen / 60 * 60; good && step_i <= seen; ++step_i) good = play(again, step_i) && has_left(again) == (step_i == seen);
        good = good && again.state_hash() == hash;
    }
    std::printf("replay: left in step %d, and again, and again; hash %016llx\n", seen, static_cast<unsigned long long>(hash));
    return good && seen >= 60 ? 0 : 1;
}

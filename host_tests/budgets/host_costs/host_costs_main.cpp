// SPDX-License-Identifier: MIT
// Worlds whose steps are counted, in instructions, by valgrind: see host_costs.py, which runs this. Each run is one world:
//
//     valgrind --tool=callgrind --instr-atstart=no --collect-atstart=no --combine-dumps=yes host_costs WORLD
//
// Instructions are counted from the first step that is measured on; the way there costs little.
#include <ingot/ingot.h>

#include <cstring>

#include "counted.h"
#include "figure_dynamics.h"
#include "levels.h"
#include "queries.h"
#include "scenes/contact/stacks.h"

namespace {

using ingot::scalar;
using ingot::Vector;
using host_costs::add;
using host_costs::expect;
using host_costs::measure;

const scalar mu = scalar(0.6);

template <int bodies, int manifolds, bool falls_asleep>
struct Yard : ingot::Scene {
    static constexpr int max_bodies = bodies;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = manifolds;
    static constexpr int max_pairs = manifolds > 30000 ? 65535 : 0;
    static constexpr bool sleeps = falls_asleep;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    using broad_phase = ingot::SortedTree;
};

template <class S>
void begin(ingot::World<S>& world) {
    expect(world.set_gravity({0, 0, -scenes::standard_gravity}) == ingot::Status::ok, "gravity was refused");
    (void)add(world, scenes::flat_ground(mu));
}

/// Cubes 2 m apart, put to sleep where they lie: aisles of a metre run between them.
template <class S>
void add_sleepers(ingot::World<S>& world, int side, int count) {
    const scalar half = scalar(0.5);
    for (int i = 0; i < count; ++i) {
        const ingot::BodyId id = add(world, scenes::solid_box(1, {half, half, half}, {scalar(2 * (i % side)), scalar(2 * (i / side)), half}, mu));
        expect(world.sleep(id) == ingot::Status::ok, "it does not sleep");
    }
}
/// A ball that rolls down an aisle of these, without coming near enough to wake one.
template <class S>
void add_roller(ingot::World<S>& world, int aisle, scalar x) {
    const scalar radius = scalar(0.2);
    scenes::PlacedBody ball = scenes::solid_ball(1, radius, {x, scalar(2 * aisle + 1), radius}, mu);
    ball.move({3, 0, 0}, {0, 3 / radius, 0});
    (void)add(world, ball);
}

template <class S>
void expect_asleep(const ingot::World<S>& world, int count) {
    expect(world.asleep_count() == count, "other bodies sleep than should");
}

/// 4096 asleep, and a ball that rolls among them, or none.
void sleepers(int rollers) {
    static ingot::World<Yard<4200, 12000, true>> world;
    begin(world);
    add_sleepers(world, 64, 4096);
    if (rollers > 0) add_roller(world, 20, 5);
    measure(world, 5, 60);
    expect_asleep(world, 4096);
}

/// 64 balls that roll, each in an aisle of its own, among 60000 that sleep, or alone.
void crowd(int asleep) {
    static ingot::World<Yard<60100, 61000, true>> world;
    begin(world);
    add_sleepers(world, 250, asleep);
    for (int i = 0; i < 64; ++i) add_roller(world, 3 * i + 2, scalar(5 + 3 * i));
    measure(world, 5, 30);
    expect_asleep(world, asleep);
}

/// A wall of 210 cubes at rest, a ball that rolls 100 m away, or both.
void wall(bool with_wall, bool with_ball) {
    static ingot::World<Yard<220, 1000, false>> world;
    begin(world);
    if (with_wall)
        for (int body_i = 1; body_i < scenes::Pyramid<20>::body_count; ++body_i) (void)add(world, scenes::Pyramid<20>::body(body_i));
    if (with_ball) add_roller(world, 50, -40);
    measure(world, 240, 30);
}

}  // namespace

int main(int count, char** arguments) {
    const char* const name = count == 2 ? arguments[1] : "";
    const auto is = [&](const char* other) { return std::strcmp(name, other) == 0; };
    if (is("asleep_4096_one_rolls")) sleepers(1);
    else if (is("asleep_4096")) sleepers(0);
    else if (is("awake_64_asleep_60000")) crowd(60000);
    else if (is("awake_64")) crowd(0);
    else if (is("wall_210_ball_far_away")) wall(true, true);
    else if (is("wall_210")) wall(true, false);
    else if (is("ball")) wall(false, true);
    else expect(ask_queries(name) || ask_dynamics(name) || stand_on_levels(name), "no such world");
}

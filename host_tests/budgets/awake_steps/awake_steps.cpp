// SPDX-License-Identifier: MIT
// What a step costs beside bodies that sleep: worlds for awake_steps.py, which counts the instructions of counted_step().
//
//     awake_steps <scene> <steps>     prints how many sleep after the last
#include <ingot/ingot.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "scenes/contact/stacks.h"

namespace {

using namespace scenes;

template <int bodies>
struct Dormitory : ingot::Scene {
    static constexpr int max_bodies = bodies, max_manifolds = bodies > 30000 ? 65534 : 5 * bodies, max_pairs = 65535;
    static constexpr bool translates = true, sleeps = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    using broad_phase = ingot::SortedTree;
};
using Thousands = Dormitory<8192>;
using Most = Dormitory<65535>;

constexpr scalar mu = scalar(0.6);

template <class S>
ingot::BodyId put(ingot::World<S>& world, PlacedBody body) {
    body.def.friction = body.mu;
    const auto added = world.add(body.def);
    if (!added.ok()) std::exit(2);
    return added.value;
}
/// At rest, and taken for asleep from the start.
template <class S>
void put_asleep(ingot::World<S>& world, const PlacedBody& body) {
    if (world.sleep(put(world, body)) != ingot::Status::ok) std::exit(2);
}
template <class S>
void put_cubes(ingot::World<S>& world, int across, int along, int high, scalar apart) {
    for (int y = 0; y < along; ++y)
        for (int x = 0; x < across; ++x)
            for (int z = 0; z < high; ++z)
                put_asleep(world,
                           unit_cube({static_cast<scalar>(x) * apart, static_cast<scalar>(y) * apart, static_cast<scalar>(z) + scalar(0.5)}, mu));
}
template <class S>
void roll_ball(ingot::World<S>& world, scalar x, scalar y) {
    PlacedBody ball = solid_ball(1, scalar(0.5), {x, y, scalar(0.5)}, mu);
    ball.move({3, 0, 0}, {0, 6, 0});
    put(world, ball);
}

ingot::World<Thousands> thousands;
ingot::World<Most> most;
bool is_large = false;
ingot::StepReport report;

}  // namespace

// With a name that callgrind can be told.
extern "C" {
void counted_step();
[[gnu::noinline, gnu::noclone]] void counted_step() {
    report = is_large ? ingot::step(most, display_rate_h) : ingot::step(thousands, display_rate_h);
}
}

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    const char* name = argv[1];
    const auto is = [name](const char* other) { return std::strcmp(name, other) == 0; };
    is_large = is("64_among_60000") || is("64_alone");
    (void)thousands.set_gravity(OnEarth::gravity);
    (void)most.set_gravity(OnEarth::gravity);
    put(thousands, flat_ground(mu));
    put(most, flat_ground(mu));
    if (is("apart") || is("asleep")) put_cubes(thousands, 64, 64, 1, 4);    // 4096 islands
    if (is("columns")) put_cubes(thousands, 32, 32, 4, 4);                  // 1024 columns of four
    if (is("block")) put_cubes(thousands, 32, 32, 4, scalar(1.01));         // one island of 4096
    if (is("apart") || is("columns")) roll_ball(thousands, -2, 2);
    if (is("block")) roll_ball(thousands, -2, -3);
    if (is("64_among_60000")) put_cubes(most, 250, 240, 1, 4);
    if (is_large)
        for (int ball_i = 0; ball_i < 64; ++ball_i) roll_ball(most, -2, 2 + 4 * static_cast<scalar>(ball_i));

    for (int step_i = 0; step_i < 3; ++step_i) report = is_large ? ingot::step(most, display_rate_h) : ingot::step(thousands, display_rate_h);
    for (int step_i = 0; step_i < std::atoi(argv[2]); ++step_i) counted_step();
    std::printf("contacts %d lost %d asleep %d of %d\n", report.contacts, report.contacts_lost,
                is_large ? most.asleep_count() : thousands.asleep_count(), is_large ? most.body_count() : thousands.body_count());
    return 0;
}

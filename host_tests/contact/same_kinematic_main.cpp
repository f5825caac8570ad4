// SPDX-License-Identifier: MIT
// Prints what bodies at random come to between kinematic ones at random: the same whatever the lane count.
#include <ingot/ingot.h>

#include <cstdio>
#include <memory>
#include <vector>

#include "reference/random_input.h"

namespace {

using namespace ingot;
using ingot_reference::RandomInput;

template <class Solver, bool is_rich>
struct Yard : Scene {
    static constexpr int max_bodies = 40, max_manifolds = 300;
    static constexpr bool translates = true, kinematic_bodies = true, sleeps = is_rich, continuous = is_rich;
    static constexpr bool rolling_resistance = is_rich, surface_velocities = is_rich;
    using solver = Solver;
    using shapes = Shapes<Sphere, Capsule, Cylinder, Box, HalfSpace>;
};

Vector vector_of(RandomInput& random, double most) {
    const double x = random.real(-most, most), y = random.real(-most, most), z = random.real(-most, most);  // in this order with every compiler
    return {static_cast<scalar>(x), static_cast<scalar>(y), static_cast<scalar>(z)};
}
Shape shape_of(RandomInput& random) {
    const auto size = [&] { return static_cast<scalar>(random.real(0.15, 0.4)); };
    const int kind = random.integer(0, 3);
    const scalar a = size(), b = size(), c = size();
    if (kind == 0) return Sphere{a};
    if (kind == 1) return Capsule{a, b};
    if (kind == 2) return Cylinder{a, b};
    return Box{{a, b, c}};
}

/// Turntables, paddles and lifts that spin and go to and fro, and what falls on them.
template <class S>
void print(const char* name, int rate) {
    RandomInput random(static_cast<unsigned>(rate));
    const auto world = std::make_unique<World<S>>();
    bool sound = world->set_gravity({0, 0, scalar(-9.8125)}) == Status::ok;
    std::vector<BodyId> movers;
    const auto add = [&](const BodyDef& def) {
        const Result<BodyId> added = world->add(def);
        sound = sound && added.ok();
        return added.value;
    };
    BodyDef ground;
    ground.immovable = true;
    ground.shape = HalfSpace{{0, 0, 1}, 0};
    add(ground);
    for (int i = 0; i < 6; ++i) {
        BodyDef def;
        def.kinematic = true;
        def.shape = Box{{scalar(0.8), scalar(0.8), scalar(0.1)}};
        def.state.r_CM = {static_cast<scalar>(i % 3 - 1) * 2, static_cast<scalar>(i / 3) * 2, scalar(0.6)};
        def.state.L = vector_of(random, 3);
        movers.push_back(add(def));
    }
    for (int i = 0; i < 30; ++i) {
        BodyDef def;
        def.shape = shape_of(random);
        def.mass = principal(solid_box(500, {scalar(0.3), scalar(0.25), scalar(0.2)})).value;
        const Vector aside = vector_of(random, 0.1);
        const Vector above = {static_cast<scalar>(i % 3 - 1) * 2, static_cast<scalar>(i / 3 % 2) * 2, scalar(1.5) + static_cast<scalar>(i / 6)};
        def.state.r_CM = above + aside;
        def.state.v_CM = vector_of(random, 2);
        def.state.L = vector_of(random, 2);
        def.restitution = static_cast<scalar>(random.integer(0, 1)) / 2;
        add(def);
    }
    for (int step_i = 0; step_i < 3 * rate; ++step_i) {
        if (step_i % (rate / 2) == 0)  // each half second another way
            for (const BodyId id : movers) {
                const Vector v = vector_of(random, 1), omega = vector_of(random, 3);
                sound = sound && world->set_velocity(id, v, omega) == Status::ok;
            }
        (void)step(*world, scalar(1) / static_cast<scalar>(rate));
    }
    std::printf("%s %d %d %016llx\n", name, rate, sound ? 1 : 0, static_cast<unsigned long long>(world->state_hash()));
}

}  // namespace

int main() {
    for (const int rate : {30, 60, 240}) {
        print<Yard<BlockSweeps, false>>("sweeps", rate);
        print<Yard<BlockSweeps, true>>("rich", rate);
        print<Yard<HybridIslands<20, 10>, false>>("islands", rate);
        print<Yard<SequentialImpulses, true>>("points", rate);
    }
    return 0;
}

// SPDX-License-Identifier: MIT
// Fast bodies that come down on floors of flush boxes go on as on a floor that is one: no seam is met, however far they go in a step.
#include <gtest/gtest.h>

#include <ingot/ingot.h>

#include <cmath>
#include <memory>
#include <vector>

#include "reference/draws.h"
#include "reference/kernel_types.h"
#include "reference/random_input.h"

namespace {

using Eigen::Vector3d;
using ingot::BodyDef;
using ingot::BodyId;
using ingot::scalar;
using ingot::Status;
using ingot_reference::RandomInput;
using ingot_reference::to_eigen;
using ingot_reference::to_vector;

struct Tiled : ingot::Scene {
    static constexpr int max_bodies = 64, max_manifolds = 200;
    static constexpr bool translates = true, continuous = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::Capsule, ingot::HalfSpace>;
};
using World = ingot::World<Tiled>;

constexpr double eps = static_cast<double>(ingot::epsilon);

/// Tiles of all lengths, 0.1 to 1 m, along x, of one height; or a half space.
void add_floor(World& world, RandomInput& random, bool tiled, double e) {
    BodyDef def;
    def.immovable = true;
    def.restitution = static_cast<scalar>(e);
    if (!tiled) {
        def.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        ASSERT_TRUE(world.add(def).ok());
        return;
    }
    int edge = -96;  // in 1/64 m: so that each tile begins where the last ends, to the bit
    for (int i = 0; i < 40; ++i) {
        const int length = random.integer(4, 32) * 2;
        def.shape = ingot::Box{{static_cast<scalar>(length) / 128, 20, scalar(0.5)}};
        def.state.r_CM = {static_cast<scalar>(2 * edge + length) / 128, 0, scalar(-0.5)};
        edge += length;
        ASSERT_TRUE(world.add(def).ok());
    }
}

BodyDef thrown(RandomInput& random, double e) {
    BodyDef def;
    const auto size = static_cast<scalar>(random.real(0.03, 0.15));
    const int kind = random.integer(0, 2);
    if (kind == 0) {
        def.shape = ingot::Sphere{size};
        def.mass = ingot::principal(ingot::solid_sphere(1000, size)).value;
    } else if (kind == 1) {
        def.shape = ingot::Capsule{size, size};
        def.mass = ingot::principal(ingot::solid_capsule(1000, size, size)).value;
    } else {
        def.shape = ingot::Box{{size, size * scalar(0.7), size * scalar(1.5)}};
        def.mass = ingot::principal(ingot::solid_box(1000, def.shape.size)).value;
    }
    def.restitution = static_cast<scalar>(e);
    def.state.A = ingot_reference::to_matrix(random.rotation());
    def.state.r_CM = to_vector(Vector3d(random.real(0, 1), random.real(-1, 1), random.real(0.4, 1.5)));
    def.state.v_CM = to_vector(Vector3d(random.real(2, 12), random.real(-2, 2), -random.real(5, 60)));
    if (random.integer(0, 1) == 0) def.state.L = ingot::scaled(def.mass.I_body, to_vector(random.vector(5)));
    return def;
}

TEST(FastFloors, of_tiles_are_one) {
    int hits = 0, others = 0, parted = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(400); ++run_i) {
        RandomInput random(static_cast<std::uint64_t>(run_i));
        const double e = run_i % 2 == 0 ? 0 : random.real(0, 0.9);
        const auto tiles = std::make_unique<World>(), slab = std::make_unique<World>();
        add_floor(*tiles, random, true, e);
        add_floor(*slab, random, false, e);
        const BodyDef def = thrown(random, e);
        const BodyId of_tiles = tiles->add(def).value, of_slab = slab->add(def).value;
        const double rates[] = {30, 60, 120, 240};
        const auto h = static_cast<scalar>(1 / rates[run_i % 4]);
        double off = 0;
        for (int step_i = 0; step_i < 6; ++step_i) {
            (void)ingot::step(*tiles, h);
            (void)ingot::step(*slab, h);
            const ingot::BodyState a = tiles->state(of_tiles).value, b = slab->state(of_slab).value;
            off = std::max(off, (to_eigen(a.v_CM) - to_eigen(b.v_CM)).norm() / (to_eigen(def.state.v_CM).norm()));
        }
        hits += std::abs(slab->state(of_slab).value.v_CM.z - def.state.v_CM.z) > 1 ? 1 : 0;
        if (def.shape.kind == ingot::ShapeKind::sphere) {
            // Its normal is known to the roundings of places over its radius, in each of some bounces.
            const double size = 8 + to_eigen(slab->state(of_slab).value.r_CM).norm();
            EXPECT_LE(off, 32 * eps * size / static_cast<double>(def.shape.size.x)) << run_i;
        } else {
            ++others;
            parted += off > 1e-2 ? 1 : 0;
        }
    }
    // What comes down on an edge or a corner may turn either way by a rounding: few do.
    EXPECT_LE(parted, others / 8 + 1);
    EXPECT_GT(hits, ingot_reference::draws(400) / 2);
    EXPECT_GT(others, ingot_reference::draws(400) / 3);
}

}  // namespace

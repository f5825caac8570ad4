// SPDX-License-Identifier: MIT
// Figures that spin as fast as numbers go: whatever their joints make of it, rotations stay rotations, bodies that go too far freeze, and a snapshot
// that is taken then is one that loads and goes on with the same bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "joints/figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;
using ingot::Status;

struct Substeps : ingot::Scene {
    static constexpr int max_bodies = 8, max_joints = 8;
    static constexpr bool translates = true;
    using joints = AllJoints;
};
struct Smooth : Substeps {
    using figure_motion = ingot::EnergyMomentum<>;
};
struct Looped : Substeps {
    static constexpr int max_loops = 2;
};

template <class S>
class FastestSpins : public ::testing::Test {};
using Scenes = ::testing::Types<Substeps, Smooth, Looped>;
TYPED_TEST_SUITE(FastestSpins, Scenes);

/// A torque of a step that leads to a spin of so many rad/s, if nothing holds the body.
template <class World>
void spin_up(World& world, const Built& built, RandomInput& random, double spin, double rate) {
    for (const ingot::BodyId id : built.bodies) {
        const double torque = static_cast<double>(world.inertia(id).value.x) * spin * rate;
        (void)world.add_torque(id, to_vector(random.direction() * std::min(torque, static_cast<double>(ingot::limits::torque_max))));
    }
}

TYPED_TEST(FastestSpins, leave_rotations_that_are_rotations_and_snapshots_that_load) {
    RandomInput random(1);
    std::vector<uint8_t> bytes(ingot::snapshot_size<TypeParam>());
    int frozen = 0, fast = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(300); ++run_i) {
        const auto world = std::make_unique<ingot::World<TypeParam>>(), other = std::make_unique<ingot::World<TypeParam>>();
        ASSERT_TRUE(weigh(*world));
        Built built;
        const int count = random.integer(1, 6);
        add_figure(*world, random, {count, random.real(0.05, 1), 20, 0, random.integer(0, 1) == 1}, {0, 0, 3}, built);
        ASSERT_TRUE(built.sound);
        const double rate = rates[random.integer(0, 4)], spin = std::exp(random.real(std::log(1e3), std::log(1e9)));
        const auto h = static_cast<scalar>(1 / rate);
        SCOPED_TRACE(::testing::Message() << "run " << run_i << ", " << rate << " Hz, " << spin << " rad/s");
        for (int i = 0; i < 20; ++i) {
            if (i < 4) spin_up(*world, built, random, spin / 4, rate);
            frozen += ingot::step(*world, h).bodies_frozen;
            for (const ingot::BodyId id : built.bodies) {
                EXPECT_LE(ingot::orthogonality_error(world->state(id).value.A), ingot::limits::orthogonality_kept);
                fast += ingot::length_sq(world->omega(id).value) > scalar(1e10) ? 1 : 0;
            }
            const auto size = ingot::save_snapshot(*world, bytes.data(), bytes.size());
            ASSERT_TRUE(size.ok());
            ASSERT_EQ(ingot::load_snapshot(*other, bytes.data(), size.value), Status::ok);
            EXPECT_EQ(world->state_hash(), other->state_hash());
        }
        (void)ingot::step(*world, h);
        (void)ingot::step(*other, h);
        EXPECT_EQ(world->state_hash(), other->state_hash());
    }
    EXPECT_GT(frozen, 0);
    EXPECT_GT(fast, 0);
}

}  // namespace

// SPDX-License-Identifier: MIT
// Traits that a scene names beside joints.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "figures.h"

namespace {

using namespace figures;

template <bool rolls, bool moves>
struct Surfaced : ingot::Scene {
    static constexpr int max_bodies = 4, max_joints = 2, max_manifolds = 6;
    static constexpr bool translates = true, continuous = true, rolling_resistance = rolls, surface_velocities = moves;
    using joints = ingot::Joints<ingot::BallJoint>;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};

/// A box that falls onto the ground within a step of 1 to 33 ms, and how it goes on.
template <class S>
ingot::BodyState after_a_fast_fall(uint64_t seed) {
    RandomInput random(seed);
    const auto world = std::make_unique<ingot::World<S>>();
    ingot::BodyDef box;
    const Vector half = {scalar(0.1), scalar(0.2), static_cast<scalar>(random.real(0.1, 0.3))};
    box.mass = ingot::principal(ingot::solid_box(100, half)).value;
    box.shape = ingot::Box{half};
    box.state.A = ingot_reference::to_matrix(random.rotation());
    box.state.r_CM = {0, 0, static_cast<scalar>(random.real(1, 2))};
    box.state.v_CM = {static_cast<scalar>(random.real(-20, 20)), 0, static_cast<scalar>(random.real(-300, -200))};
    const auto id = world->add(box);
    EXPECT_TRUE(weigh(*world) && add_ground(*world) && id.ok());
    const auto h = static_cast<scalar>(1 / rates[random.integer(0, 4)]);
    for (int step_i = 0; step_i < 40; ++step_i) (void)ingot::step(*world, h);
    return world->state(id.value).value;
}
bool same(const ingot::BodyState& a, const ingot::BodyState& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

TEST(TraitsBesideJoints, fast_bodies_meet_by_one_material_as_by_both) {
    for (uint64_t seed = 1; seed <= 40; ++seed) {
        const ingot::BodyState both = after_a_fast_fall<Surfaced<true, true>>(seed);
        EXPECT_TRUE(same(after_a_fast_fall<Surfaced<true, false>>(seed), both)) << "rolling resistance alone, seed " << seed;
        EXPECT_TRUE(same(after_a_fast_fall<Surfaced<false, true>>(seed), both)) << "surface velocities alone, seed " << seed;
    }
}

struct ToldPendulum : ingot::Scene {
    static constexpr int max_bodies = 3, max_joints = 1, max_manifolds = 2, max_events = 4;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::BallJoint>;
    using figure_motion = ingot::EnergyMomentum<>;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};

TEST(TraitsBesideJoints, a_world_of_figures_that_swing_freely_keeps_who_touches) {
    const auto world = std::make_unique<ingot::World<ToldPendulum>>(), loaded = std::make_unique<ingot::World<ToldPendulum>>();
    ingot::BodyDef box;
    const Vector half = {scalar(0.5), scalar(0.5), scalar(0.5)};
    box.mass = ingot::principal(ingot::solid_box(100, half)).value;
    box.shape = ingot::Box{half};
    box.state.r_CM = {0, 0, scalar(0.5)};
    ASSERT_TRUE(weigh(*world) && add_ground(*world) && world->add(box).ok());
    (void)ingot::step(*world, scalar(1) / 60);
    ASSERT_EQ(world->events().count, 1);
    std::vector<uint8_t> bytes(ingot::snapshot_size<ToldPendulum>());
    const auto saved = ingot::save_snapshot(*world, bytes.data(), bytes.size());
    ASSERT_TRUE(saved.ok());
    ASSERT_EQ(ingot::load_snapshot(*loaded, bytes.data(), saved.value), ingot::Status::ok);
    (void)ingot::step(*loaded, scalar(1) / 60);
    EXPECT_EQ(loaded->events().count, 0) << "it touched before";
}

}  // namespace

// SPDX-License-Identifier: MIT
// Figures that touch nothing, in scenes whose room for manifolds is in use: an island each, and they move as they do alone.
#include <gtest/gtest.h>

#include <memory>

#include "figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;

struct OneManifold : ingot::Scene {
    static constexpr int max_bodies = 12, max_joints = 8, max_manifolds = 1, max_pairs = 66;
    static constexpr bool translates = true;
    using joints = AllJoints;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};

void add_rods(ingot::World<OneManifold>& world, RandomInput& random, int count, std::vector<ingot::BodyId>& rods) {
    for (int i = 0; i < count; ++i) {
        ingot::BodyDef rod;
        const ingot::Vector half = {scalar(0.5), scalar(0.05), static_cast<scalar>(random.real(0.05, 0.2))};
        rod.mass = ingot::principal(ingot::solid_box(500, half)).value;
        rod.shape = ingot::Box{half};
        rod.state.r_CM = {scalar(4 * i), 0, 10};
        rods.push_back(world.add(rod).value);
        ingot::JointDef joint;
        joint.body_B = rods.back();
        joint.joint = kinds[random.integer(0, 1)];
        joint.axis = {0, 1, 0};
        joint.P = {scalar(4 * i) - half.x, 0, 10};
        ASSERT_TRUE(world.add_joint(joint).ok());
    }
}

TEST(FiguresBesideContacts, move_as_they_do_alone) {
    for (int run_i = 0; run_i < ingot_reference::draws(320); ++run_i) {
        const int count = 1 + run_i % 8;
        const double rate = rates[run_i / 8 % 5];
        const auto alone = std::make_unique<ingot::World<OneManifold>>(), beside = std::make_unique<ingot::World<OneManifold>>();
        std::vector<ingot::BodyId> rods_alone, rods;
        for (auto* world : {alone.get(), beside.get()}) {
            RandomInput random(static_cast<uint64_t>(run_i));
            ASSERT_TRUE(weigh(*world) && add_ground(*world));
            add_rods(*world, random, count, world == alone.get() ? rods_alone : rods);
        }
        ingot::BodyDef box;
        box.mass = ingot::principal(ingot::solid_box(100, {scalar(0.5), scalar(0.5), scalar(0.5)})).value;
        box.shape = ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.5)}};
        box.state.r_CM = {0, 20, scalar(0.5)};
        ASSERT_TRUE(beside->add(box).ok());
        for (int step_i = 0; step_i < 30; ++step_i) {
            (void)ingot::step(*alone, static_cast<scalar>(1 / rate));
            ASSERT_EQ(ingot::step(*beside, static_cast<scalar>(1 / rate)).contacts, 1u);
            ASSERT_TRUE(are_same(*alone, *beside, rods_alone, rods)) << count << " figures, " << rate << " Hz, step " << step_i;
        }
    }
}

}  // namespace

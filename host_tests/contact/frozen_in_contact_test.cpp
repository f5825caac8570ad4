// SPDX-License-Identifier: MIT
// A body that freezes where it touches the ground is no trouble to others there. Found by fuzz_friction: neither of the two could move then, the
// inverse of their compliance was infinite, and what came of it stood in the solver's one body for all that cannot move.
#include <ingot/ingot.h>

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace {

using ingot::BodyDef;
using ingot::BodyId;
using ingot::scalar;
using ingot::Status;

template <class BroadPhase, class Solver = ingot::BlockSweeps>
struct Ground : ingot::Scene {
    static constexpr int max_bodies = 6;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 15;
    using broad_phase = BroadPhase;
    using solver = Solver;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};

BodyDef standing(const ingot::Shape& shape, scalar x) {
    BodyDef def;
    def.mass = {1, {1, 1, 1}, {}, ingot::identity_matrix<scalar>()};
    def.shape = shape;
    def.state.r_CM = {x, 0, scalar(0.5)};
    return def;
}

template <class S>
class FrozenInContact : public ::testing::Test {
protected:
    using World = ingot::World<S>;

    /// Steps two bodies on the ground, and beside them one that freezes there, or none; gives the two.
    static std::vector<ingot::BodyState> stood(const ingot::Shape& victim_shape, bool with_victim) {
        auto world = std::make_unique<World>();
        EXPECT_EQ(world->set_gravity({0, 0, -10}), Status::ok);
        BodyDef ground;
        ground.immovable = true;
        ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        EXPECT_TRUE(world->add(ground).ok());
        const ingot::Result<BodyId> victim = with_victim ? world->add(standing(victim_shape, 0)) : ingot::Result<BodyId>{Status::ok, {}};
        const ingot::Result<BodyId> box = world->add(standing(ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.5)}}, 10));
        const ingot::Result<BodyId> ball = world->add(standing(ingot::Sphere{scalar(0.5)}, 20));
        EXPECT_TRUE(victim.ok() && box.ok() && ball.ok());
        int frozen = 0;
        for (int step_i = 0; step_i < 60; ++step_i) {
            if (with_victim && step_i == 20) {
                EXPECT_EQ(world->add_torque(victim.value, {0, 0, ingot::limits::torque_max}), Status::ok);
            }
            const ingot::StepReport report = ingot::step(*world, scalar(1) / 60);
            EXPECT_EQ(report.status, Status::ok);
            frozen += report.bodies_frozen;
            if (step_i > 20) {
                EXPECT_EQ(report.contacts, 2) << "those of the two";
            }
        }
        EXPECT_EQ(frozen, with_victim ? 1 : 0);
        EXPECT_FALSE(world->is_frozen(box.value) || world->is_frozen(ball.value));
        return {world->state(box.value).value, world->state(ball.value).value};
    }
};

using Grounds = ::testing::Types<Ground<ingot::AllPairs>, Ground<ingot::SortedTree>, Ground<ingot::AllPairs, ingot::HybridIslands<4>>>;
TYPED_TEST_SUITE(FrozenInContact, Grounds);

TYPED_TEST(FrozenInContact, leaves_others_on_the_ground_as_they_are) {
    const auto alone = this->stood({}, false);
    for (const ingot::Shape& shape : {ingot::Shape(ingot::Sphere{scalar(0.5)}), ingot::Shape(ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.5)}})}) {
        const auto beside = this->stood(shape, true);
        for (std::size_t body_i = 0; body_i < 2; ++body_i) {
            // Sweeps end for all contacts at once, so that others round otherwise: at rest, by what a sweep may leave.
            const scalar slack = 100 * ingot::limits::settled_speed_of_small;
            EXPECT_LE(ingot::length_sq(beside[body_i].r_CM - alone[body_i].r_CM), slack * slack) << "body " << body_i;
            EXPECT_LE(ingot::length_sq(beside[body_i].v_CM - alone[body_i].v_CM), slack * slack) << "body " << body_i;
        }
    }
}

}  // namespace

// SPDX-License-Identifier: MIT
// Calls about joints: what is refused changes no bit.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <memory>

#include "figures.h"

namespace {

using namespace figures;
using ingot::Status;

struct Hinged : ingot::Scene {
    static constexpr int max_bodies = 4, max_joints = 3;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::UniversalJoint>;
};
using HingedWorld = ingot::World<Hinged>;

struct Setting {
    std::unique_ptr<HingedWorld> world = std::make_unique<HingedWorld>();
    ingot::BodyId post, A, B;

    Setting() {
        ingot::BodyDef def;
        def.mass = ingot::principal(ingot::solid_box(1000, {scalar(0.5), scalar(0.5), scalar(0.5)})).value;
        A = world->add(def).value;
        def.state.r_CM = {2, 0, 0};
        B = world->add(def).value;
        def.immovable = true;
        def.state.r_CM = {0, 5, 0};
        post = world->add(def).value;
    }
    ingot::JointDef hinge() const {
        ingot::JointDef def;
        def.body_A = A;
        def.body_B = B;
        def.joint = ingot::HingeJoint{};
        def.P = {1, 0, 0};
        return def;
    }
    /// The call is refused so, and the world is what it was.
    void expect_refused(const ingot::JointDef& def, Status status) {
        std::vector<unsigned char> before(sizeof *world);
        std::memcpy(before.data(), world.get(), sizeof *world);
        const auto id = world->add_joint(def);
        EXPECT_EQ(id.status, status) << ingot::name(id.status);
        EXPECT_EQ(std::memcmp(before.data(), world.get(), sizeof *world), 0) << ingot::name(status);
    }
};

TEST(JointCalls, bad_definitions_are_refused) {
    Setting setting;
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN(), infinity = std::numeric_limits<scalar>::infinity();
    const auto refused = [&](Status status, const auto& change) {
        ingot::JointDef def = setting.hinge();
        change(def);
        setting.expect_refused(def, status);
    };
    refused(Status::bad_joint, [&](ingot::JointDef& def) { def.body_B = def.body_A; });
    refused(Status::bad_joint, [&](ingot::JointDef& def) { def.body_A = def.body_B = {}; });
    refused(Status::stale_id, [&](ingot::JointDef& def) { def.body_A.generation += 2; });
    refused(Status::stale_id, [&](ingot::JointDef& def) { def.body_B.slot = 3, def.body_B.generation = 1; });
    refused(Status::foreign_id, [&](ingot::JointDef& def) { def.body_A.world_tag = 7; });
    refused(Status::not_finite, [&](ingot::JointDef& def) { def.P.x = nan; });
    refused(Status::not_finite, [&](ingot::JointDef& def) { def.P.y = infinity; });
    refused(Status::out_of_range, [&](ingot::JointDef& def) { def.P.z = 2 * ingot::limits::position_max; });
    refused(Status::bad_direction, [&](ingot::JointDef& def) { def.axis = {}; });
    refused(Status::bad_direction, [&](ingot::JointDef& def) { def.axis = {1, 1, 0}; });
    refused(Status::not_finite, [&](ingot::JointDef& def) { def.axis.x = nan; });
    refused(Status::not_in_scene, [&](ingot::JointDef& def) { def.joint = ingot::SliderJoint{}; });
    refused(Status::not_in_scene, [&](ingot::JointDef& def) { def.joint = {}; });
    refused(Status::bad_joint, [&](ingot::JointDef& def) { def.joint = ingot::UniversalJoint{}, def.axis_B = def.axis; });
    refused(Status::bad_direction, [&](ingot::JointDef& def) { def.joint = ingot::UniversalJoint{}, def.axis_B = {0, 2, 0}; });
    refused(Status::immovable, [&](ingot::JointDef& def) { def.body_A = {}, def.body_B = setting.post; });
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(setting.world->add_joint(setting.hinge()).ok());
    setting.expect_refused(setting.hinge(), Status::no_room);
}

TEST(JointCalls, ids_outlive_joints) {
    Setting setting;
    HingedWorld& world = *setting.world;
    const ingot::JointId first = world.add_joint(setting.hinge()).value;
    EXPECT_TRUE(world.is_alive(first));
    EXPECT_EQ(world.remove(first), Status::ok);
    EXPECT_FALSE(world.is_alive(first));
    EXPECT_EQ(world.remove(first), Status::stale_id);
    EXPECT_EQ(world.joint_gap(first).status, Status::stale_id);
    const ingot::JointId second = world.add_joint(setting.hinge()).value;
    EXPECT_EQ(second.slot, first.slot);
    EXPECT_NE(second, first);
    EXPECT_EQ(world.joint_count(), 1);
}

/// A body takes its joints along, and the other end of each goes on by itself.
TEST(JointCalls, a_body_takes_its_joints_along) {
    Setting setting;
    HingedWorld& world = *setting.world;
    const ingot::JointId between = world.add_joint(setting.hinge()).value;
    ingot::JointDef to_post = setting.hinge();
    to_post.body_A = setting.post;
    to_post.body_B = setting.A;
    const ingot::JointId other = world.add_joint(to_post).value;
    ASSERT_EQ(world.remove(setting.B), Status::ok);
    EXPECT_FALSE(world.is_alive(between));
    EXPECT_TRUE(world.is_alive(other));
    for (int step_i = 0; step_i < 10; ++step_i) EXPECT_TRUE(ingot::step(world, scalar(1) / 60).clean());
}

/// The world, an immovable body and a body with the mass of a moon hold alike.
TEST(JointCalls, what_cannot_move_holds) {
    Setting setting;
    HingedWorld& world = *setting.world;
    ASSERT_EQ(world.set_gravity({0, 0, -10}), Status::ok);
    ingot::JointDef def = setting.hinge();
    def.body_A = {};
    ASSERT_TRUE(world.add_joint(def).ok());
    def = setting.hinge();
    def.body_A = setting.post;
    def.body_B = setting.A;
    def.P = {0, 1, 0};
    def.axis = {1, 0, 0};
    ASSERT_TRUE(world.add_joint(def).ok());
    for (int step_i = 0; step_i < 120; ++step_i) ASSERT_TRUE(ingot::step(world, scalar(1) / 60).clean());
    const double of_B = ingot_reference::to_eigen(world.state(setting.B).value.r_CM - ingot::Vector{1, 0, 0}).norm();
    const double of_A = ingot_reference::to_eigen(world.state(setting.A).value.r_CM - ingot::Vector{0, 1, 0}).norm();
    EXPECT_NEAR(of_B, 1, 5e-5);
    EXPECT_NEAR(of_A, 1, 5e-5);
}

}  // namespace

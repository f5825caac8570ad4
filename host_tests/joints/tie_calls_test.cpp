// SPDX-License-Identifier: MIT
// Rods and ropes in company of contacts, asleep, saved, changed as they go; and what calls refuse.
#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;
using ingot::Status;

struct Yard : ingot::Scene {
    static constexpr int max_bodies = 40, max_joints = 40, max_loops = 30, max_manifolds = 80, max_pairs = 300;
    static constexpr bool translates = true, sleeps = true;
    using joints = ingot::Joints<ingot::BallJoint, ingot::RodJoint, ingot::RopeJoint>;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::HalfSpace>;
};
using YardWorld = ingot::World<Yard>;

ingot::BodyId add_ball(YardWorld& world, double M, double radius, const Vector& place) {
    ingot::BodyDef def;
    const auto R = static_cast<scalar>(radius);
    def.mass = ingot::principal(ingot::with_mass(ingot::solid_sphere(1, R), static_cast<scalar>(M))).value;
    def.shape = ingot::Sphere{R};
    def.state.r_CM = place;
    def.friction = scalar(0.5);
    return world.add(def).value;
}
ingot::Result<ingot::JointId> tie(YardWorld& world, ingot::BodyId A, ingot::BodyId B, const ingot::Joint& kind, const Vector& P_of_world = {}) {
    ingot::JointDef def;
    def.body_A = A;
    def.body_B = B;
    def.joint = kind;
    def.P = A == ingot::BodyId{} ? P_of_world : world.state(A).value.r_CM;
    def.P_B = world.state(B).value.r_CM;
    return world.add_joint(def);
}
void run(YardWorld& world, int steps) {
    for (int i = 0; i < steps; ++i) (void)ingot::step(world, scalar(1) / 60);
}
std::vector<uint8_t> saved(const YardWorld& world) {
    std::vector<uint8_t> bytes(ingot::snapshot_size<Yard>());
    bytes.resize(ingot::save_snapshot(world, bytes.data(), bytes.size()).value);
    return bytes;
}

/// Twenty rods from ball to ball over an edge, a load at either end: they stay as long as they are.
TEST(TieCalls, a_string_of_rods_goes_over_an_edge) {
    for (const double rate : {30.0, 60.0, 120.0}) {
        if (INGOT_TEST_BRIEF && rate != 60) continue;
        const auto world = std::make_unique<YardWorld>();
        ASSERT_TRUE(weigh(*world));
        ingot::BodyDef block;
        block.immovable = true;
        block.shape = ingot::Box{{2, 1, scalar(0.5)}};
        block.state.r_CM = {-2, 0, scalar(-0.5)};
        ASSERT_TRUE(world->add(block).ok());
        Built built;
        const int count = 21;
        for (int i = 0; i < count; ++i) {
            const double M = i == 0 ? 5 : i == count - 1 ? 10 : 0.1;
            built.bodies.push_back(add_ball(*world, M, M > 1 ? 0.1 : 0.05, {scalar(0.15) * static_cast<scalar>(i - 14), 0, scalar(0.06)}));
            if (i > 0) built.joints.push_back(tie(*world, built.bodies[static_cast<size_t>(i - 1)], built.bodies.back(), ingot::RodJoint{}).value);
        }
        double gap = 0;
        for (int step_i = 0; step_i < static_cast<int>(3 * rate); ++step_i) {
            const ingot::StepReport report = ingot::step(*world, static_cast<scalar>(1 / rate));
            ASSERT_EQ(report.bodies_frozen + report.contacts_lost + report.joints_lost, 0);
            gap = std::max(gap, worst_gap(*world, built));
        }
        std::printf("    %g Hz: %.4f mm\n", rate, gap * 1e3);
        EXPECT_LE(gap, 1e-4) << rate << " Hz";
    }
}

/// A load on a rope from the world hangs, rests and sleeps, and wakes where its length is changed; one that lies beside on a slack rope sleeps by
/// itself.
TEST(TieCalls, loads_sleep_and_wake) {
    const auto world = std::make_unique<YardWorld>();
    ASSERT_TRUE(add_ground(*world) && weigh(*world));
    const ingot::BodyId load = add_ball(*world, 10, 0.2, {0, 0, 2}), lying = add_ball(*world, 1, 0.2, {1, 0, scalar(0.2)});
    const ingot::JointId rope = tie(*world, {}, load, ingot::RopeJoint{}, {0, 0, 4}).value;
    const ingot::JointId slack = tie(*world, load, lying, ingot::RopeJoint{10}).value;
    int step_i = 0;
    while (!(world->is_asleep(load) && world->is_asleep(lying)) && ++step_i < 600) run(*world, 1);
    ASSERT_LT(step_i, 600);
    EXPECT_NEAR(static_cast<double>(world->state(load).value.r_CM.z), 2, 1e-3);
    ASSERT_EQ(world->set_joint_length(rope, 3), Status::ok);
    EXPECT_FALSE(world->is_asleep(load));
    EXPECT_TRUE(world->is_asleep(lying));
    run(*world, 60);
    EXPECT_NEAR(static_cast<double>(world->state(load).value.r_CM.z), 1, 2e-2);
    ASSERT_EQ(world->set_joint_length(rope, 1), Status::ok);  // drawn up by two metres
    run(*world, 240);
    EXPECT_NEAR(static_cast<double>(world->joint_distance(rope).value), 1, 1e-3);
    EXPECT_NEAR(static_cast<double>(world->joint_length(rope).value), 1, 8 * eps);
    // What lay is drawn along once its rope is taut, and wakes.
    ASSERT_EQ(world->set_joint_length(slack, 1), Status::ok);
    run(*world, 240);
    EXPECT_LE(world->joint_distance(slack).value, scalar(1.001));
    EXPECT_GT(world->state(lying).value.r_CM.z, scalar(1.5));
    ASSERT_EQ(world->remove(rope), Status::ok);
    run(*world, 120);
    EXPECT_LT(world->state(load).value.r_CM.z, scalar(0.5));
}

/// Lifted by a rod that becomes shorter, and let down again, no faster than limits::reel_speed.
TEST(TieCalls, rods_are_reeled) {
    for (const double rate : {30.0, 60.0, 240.0}) {
        const auto world = std::make_unique<YardWorld>();
        ASSERT_TRUE(weigh(*world));
        const ingot::BodyId load = add_ball(*world, 100, 0.2, {0, 0, -5});
        const ingot::JointId rod = tie(*world, {}, load, ingot::RodJoint{}, {0, 0, 0}).value;
        ASSERT_EQ(world->set_joint_length(rod, 1), Status::ok);
        double fastest = 0;
        for (int step_i = 0; step_i < static_cast<int>(3 * rate); ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
            fastest = std::max(fastest, std::abs(static_cast<double>(world->state(load).value.v_CM.z)));
            EXPECT_LE(world->joint_gap(rod).value, held);
        }
        EXPECT_NEAR(static_cast<double>(world->state(load).value.r_CM.z), -1, 1e-3) << rate;
        EXPECT_LE(fastest, static_cast<double>(ingot::limits::reel_speed) * 1.01) << rate;
    }
}

/// Saved with ropes taut, slack and being reeled, it goes on to the same bits; also after a roll back, as a copy of the world.
TEST(TieCalls, go_on_from_a_snapshot) {
    const auto world = std::make_unique<YardWorld>(), other = std::make_unique<YardWorld>();
    ASSERT_TRUE(add_ground(*world) && weigh(*world));
    std::vector<ingot::BodyId> bodies;
    std::vector<ingot::JointId> joints;
    RandomInput random(3);
    for (int i = 0; i < 8; ++i) {
        bodies.push_back(add_ball(*world, 1 + i, 0.2, to_vector(Eigen::Vector3d(i, random.real(0, 1), random.real(1, 3)))));
        if (i == 0) continue;
        ingot::Joint kind = ingot::RopeJoint{static_cast<scalar>(random.real(1, 3))};
        if (i % 3 == 0) kind = ingot::RodJoint{};
        joints.push_back(tie(*world, bodies[static_cast<size_t>(i - 1)], bodies.back(), kind).value);
    }
    joints.push_back(tie(*world, {}, bodies[0], ingot::RopeJoint{}, {0, 0, 5}).value);
    run(*world, 40);
    ASSERT_EQ(world->remove(joints[3]), Status::ok);
    ASSERT_EQ(world->set_joint_length(joints.back(), 1), Status::ok);
    run(*world, 5);
    const auto bytes = saved(*world);
    ASSERT_EQ(ingot::load_snapshot(*other, bytes.data(), bytes.size()), Status::ok);
    const auto copy = std::make_unique<YardWorld>(*world);
    run(*world, 60);
    run(*other, 60);
    run(*copy, 60);
    EXPECT_EQ(world->state_hash(), other->state_hash());
    EXPECT_EQ(world->state_hash(), copy->state_hash());
}

/// What is wrong is refused, and nothing has changed.
TEST(TieCalls, bad_ties_are_refused) {
    const auto world = std::make_unique<YardWorld>();
    const ingot::BodyId A = add_ball(*world, 1, 0.2, {0, 0, 0}), B = add_ball(*world, 1, 0.2, {1, 0, 0});
    const ingot::JointId ball = tie(*world, A, B, ingot::BallJoint{}).value, rope = tie(*world, {}, B, ingot::RopeJoint{2}, {0, 0, 1}).value;
    const auto nan = std::numeric_limits<scalar>::quiet_NaN();
    const auto refused = [&](Status status, const auto& change) {
        for (const ingot::Joint& kind : {ingot::Joint(ingot::RodJoint{2}), ingot::Joint(ingot::RopeJoint{2})}) {
            ingot::JointDef def;
            def.body_A = A;
            def.body_B = B;
            def.P_B = {1, 0, 0};
            def.joint = kind;
            change(def);
            const auto before = saved(*world);
            EXPECT_EQ(world->add_joint(def).status, status);
            EXPECT_EQ(saved(*world), before);
        }
    };
    refused(Status::not_finite, [&](ingot::JointDef& def) { def.P_B.y = nan; });
    refused(Status::not_finite, [&](ingot::JointDef& def) { def.joint.limits.range[0].upper = nan; });
    refused(Status::out_of_range, [&](ingot::JointDef& def) { def.P_B.x = 2 * ingot::limits::position_max; });
    refused(Status::out_of_range, [&](ingot::JointDef& def) { def.joint.limits.range[0].upper = -1; });
    refused(Status::out_of_range, [&](ingot::JointDef& def) { def.joint.limits.range[0].upper = ingot::limits::tie_length_min / 2; });
    refused(Status::out_of_range, [&](ingot::JointDef& def) { def.joint.limits.range[0].upper = 0, def.P_B = def.P; });
    refused(Status::bad_joint, [&](ingot::JointDef& def) { def.body_B = def.body_A; });
    refused(Status::bad_joint, [&](ingot::JointDef& def) { def.body_A = def.body_B = {}; });
    refused(Status::stale_id, [&](ingot::JointDef& def) { def.body_A.generation += 2; });
    refused(Status::not_in_scene, [&](ingot::JointDef& def) { def.joint.kind = ingot::JointKind::hinge, def.joint.limits = {}; });
    const auto same = [&](Status status, Status expected) {
        EXPECT_EQ(status, expected);
        EXPECT_EQ(world->joint_length(rope).value, scalar(2));
    };
    same(world->set_joint_length(rope, nan), Status::not_finite);
    same(world->set_joint_length(rope, 0), Status::out_of_range);
    same(world->set_joint_length(rope, 2 * ingot::limits::position_max), Status::out_of_range);
    same(world->set_joint_length(ball, 1), Status::not_in_scene);
    EXPECT_EQ(world->joint_length(ball).status, Status::not_in_scene);
    EXPECT_EQ(world->joint_distance(ball).status, Status::not_in_scene);
    ingot::JointId stale = rope;
    stale.generation += 2;
    same(world->set_joint_length(stale, 1), Status::stale_id);
}

/// As many rows as a figure may have; and no more, whichever kind asks for them.
TEST(TieCalls, ties_need_room) {
    const auto world = std::make_unique<YardWorld>();
    const ingot::BodyId A = add_ball(*world, 1, 0.2, {0, 0, 0}), B = add_ball(*world, 1, 0.2, {3, 0, 0});
    for (int row = 0; row < ingot::limits::loop_rows_max; ++row) EXPECT_TRUE(tie(*world, A, B, ingot::RopeJoint{4}).ok());
    const auto before = saved(*world);
    EXPECT_EQ(tie(*world, A, B, ingot::RodJoint{}).status, Status::no_room);
    EXPECT_EQ(saved(*world), before);
    EXPECT_TRUE(tie(*world, A, B, ingot::BallJoint{}).ok());  // it makes a tree
    EXPECT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
}

}  // namespace

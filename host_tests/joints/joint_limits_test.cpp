// SPDX-License-Identifier: MIT
// Limits of joints: they end where they say, give back what restitution says, and nothing pulls.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>

#include "joints/constrained_reference.h"
#include "joints/figure_scenes.h"
#include "random_trees.h"
#include "reference/draws.h"
#include "scene_in_world.h"

namespace {

using namespace figures;
using namespace ingot_figures;
using ingot::Status;

struct Limited : ingot::Scene {
    static constexpr int max_bodies = 16, max_joints = 16;
    static constexpr bool translates = true;
    using joints = AllJointsWith<ingot::WithLimits>;
};
using LimitedWorld = ingot::World<Limited>;

struct LimitedHeap : Limited {
    static constexpr int max_bodies = 46, max_joints = 40, max_manifolds = 240, max_pairs = 800;
    static constexpr bool sleeps = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box>;
    using broad_phase = ingot::SortedTree;
};

struct Factory : LimitedHeap {
    static constexpr bool rolling_resistance = true, surface_velocities = true, kinematic_bodies = true;
};

/// What a limit may be exceeded by: its slack, which is below what sweeps leave where many limits lean on each other, 1e-6; and what the rounding of
/// orientations and of places a few metres away does to what is measured.
constexpr double slack = std::max(2 * static_cast<double>(ingot::limits::limit_slack), 1e-6) + 16 * eps;

FigureScene limited_tree(RandomInput& random, bool tied) { return ingot_figures::limited_tree(random, 9, tied, 4); }

TEST(JointLimits, end_where_they_say) {
    RandomInput random(21);
    for (int run_i = 0; run_i < ingot_reference::draws(120); ++run_i) {
        const FigureScene scene = limited_tree(random, run_i % 3 != 0);
        const double rate = rates[random.integer(0, 4)];
        const JointRows rows(scene);
        const auto world = std::make_unique<LimitedWorld>();
        const Built built = add_scene(*world, scene);
        ASSERT_TRUE(built.sound);
        for (int step_i = 0; step_i < static_cast<int>(rate); ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean()) << run_i;
            ASSERT_LE(worst_gap(*world, built), held) << run_i << ", " << rate << " Hz, step " << step_i;
            ASSERT_LE(worst_excess(rows, state_of(*world, built)), slack) << run_i << ", " << rate << " Hz, step " << step_i;
        }
    }
}

/// A rod falls into its stop, and leaves it with e times its speed. The substep in which it meets the stop is of first order in time, a step of it
/// in angle: twice the speed there, h and the acceleration bound what the square of the speed can be off by.
TEST(JointLimits, give_back_what_restitution_says) {
    for (const double e : {0.0, 0.5, 1.0})
        for (const double rate : rates) {
            const double theta_0 = 1.2, stop = -0.3, rise = 3 * g * (std::cos(stop) - std::cos(theta_0));
            const FigureScene scene = pendulum_with_stop(theta_0, stop, e);
            const auto world = std::make_unique<LimitedWorld>();
            const Built built = add_scene(*world, scene);
            ASSERT_TRUE(built.sound);
            double last = 0, now = 0;
            for (int step_i = 0; step_i < 2 * rate && !(last < 0 && now >= 0); ++step_i) {
                ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
                last = now;
                now = static_cast<double>(world->joint_rate(built.joints[0]).value);
            }
            ASSERT_TRUE(last < 0 && now >= 0);
            (void)ingot::step(*world, static_cast<scalar>(1 / rate));
            const double theta = static_cast<double>(world->joint_angle(built.joints[0]).value) + theta_0;
            const double v = static_cast<double>(world->joint_rate(built.joints[0]).value), v_sq = v * std::abs(v);
            const double expected = 3 * g * (std::cos(theta) - std::cos(stop)) + e * e * rise;
            EXPECT_NEAR(v_sq, expected, 2 * std::sqrt(rise) * 1.5 * g / (4 * rate)) << "e " << e << ", " << rate << " Hz";
        }
}

/// What falls along a rail onto its stop comes up to e^2 of the height that it fell from, each time: along a line a substep is exact, so nothing of
/// the energy is lost but where it meets the stop, whenever in a substep that is. What is seen of the highest is lower by the parabola in half a
/// step, and each of four substeps rounds the speed, by half an ulp of it. (Of low ones a substep may begin within the slack of the stop, where
/// things rest.)
TEST(JointLimits, send_back_to_the_height_that_restitution_says) {
    RandomInput random(22);
    for (int run_i = 0; run_i < ingot_reference::draws(96); ++run_i) {
        const double e = random.real(0.6, 1), rate = rates[random.integer(0, 4)], height = random.real(0.3, 1), side = run_i % 2 == 0 ? 1 : -1;
        const Eigen::Vector3d aside = random.vector(0.6), axis = side * Eigen::Vector3d(aside.x(), aside.y(), 1).normalized();
        const double a = g * std::abs(axis.z());
        FigureScene scene;
        FigureJoint rail;
        rail.kind = FigureJointKind::slider;
        rail.body_A = the_world;
        rail.body_B = scene.add(FigureBody{});
        rail.axis_A = axis;
        (side > 0 ? rail.lower : rail.upper) = -side * height;
        rail.restitution = e;
        scene.join(rail);
        const auto world = std::make_unique<LimitedWorld>();
        const Built built = add_scene(*world, scene);
        ASSERT_TRUE(built.sound);
        double expected = height, highest = 0, before = 0;
        for (int step_i = 0, bounces = 0; bounces < 8 && expected * e * e > std::max(32 * a / (rate * rate), 0.03); ++step_i) {
            ASSERT_LT(step_i, 20 * rate);
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
            const double v = side * static_cast<double>(world->joint_speed(built.joints[0]).value);
            if (before < 0 && v >= 0) {
                expected *= e * e;
                highest = 0;
            }
            highest = std::max(highest, height + side * static_cast<double>(world->joint_travel(built.joints[0]).value));
            if (before > 0 && v <= 0) {
                ++bounces;
                EXPECT_NEAR(highest, expected, a / (4 * rate * rate) + 4 * step_i * eps * height) << run_i << ", " << rate << " Hz, " << bounces;
            }
            before = v;
        }
    }
}

/// What is pressed onto its stop rests there, at it, whatever presses.
TEST(JointLimits, carry_what_leans_on_them) {
    for (const double rate : rates) {
        const auto world = std::make_unique<LimitedWorld>();
        const Built built = add_scene(*world, pendulum_with_stop(pi / 2, 0.4, 0.3));
        for (int step_i = 0; step_i < 6 * rate; ++step_i) ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
        EXPECT_NEAR(static_cast<double>(world->joint_angle(built.joints[0]).value), 0.4 - pi / 2, slack) << rate << " Hz";
        EXPECT_NEAR(static_cast<double>(world->joint_rate(built.joints[0]).value), 0, 64 * eps) << rate << " Hz";
    }
}

/// Of a figure that floats, limits change neither momentum; energy does not grow, and with e = 0 it shrinks.
TEST(JointLimits, keep_momentum) {
    for (const double e : {0.0, 1.0}) {
        const FigureScene scene = floating_ragdoll(e);
        const auto world = std::make_unique<LimitedWorld>();
        const Built built = add_scene(*world, scene);
        ASSERT_TRUE(built.sound);
        const JointRows rows(scene);
        const FigureState start = start_of(scene);
        for (int step_i = 0; step_i < 120; ++step_i) ASSERT_TRUE(ingot::step(*world, scalar(1) / 120).clean());
        const FigureState end = state_of(*world, built);
        double L = 0;  // the sum of what its bodies have
        for (int body_i = 0; body_i < scene.body_count(); ++body_i) L += scene.body(body_i).M * start.body(body_i).v_CM.norm();
        const double E = kinetic_energy(scene, start);
        EXPECT_LE((momentum(scene, end) - momentum(scene, start)).norm(), mass(scene) * 64 * eps * 11);
        EXPECT_LE((angular_momentum(scene, end) - angular_momentum(scene, start)).norm(), (1e-3 + 640 * eps) * L);
        EXPECT_LE(kinetic_energy(scene, end), (e == 1 ? 1.02 : 0.999) * E);
    }
}

/// The angle of a hinge goes on over turns, and a limit is where its turns say.
TEST(JointLimits, of_hinges_go_on_over_turns) {
    for (const double sign : {1.0, -1.0}) {
        FigureScene scene = spring_rotor(1, 0, 0, 0);
        scene.g.setZero();
        scene.body(0).omega = {0, 0, sign * 25};
        scene.joint(0).servo = {};
        scene.joint(0).lower = -40;
        scene.joint(0).upper = 40;
        const auto world = std::make_unique<LimitedWorld>();
        const Built built = add_scene(*world, scene);
        for (int step_i = 1; step_i <= 120; ++step_i) {
            ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
            const double free = 25.0 * step_i / 60, angle = static_cast<double>(world->joint_angle(built.joints[0]).value);
            // The rate is right to 1e-4 of itself, and so is when it gets to its limit.
            const double allowed = free < 40 * (1 + 1e-4) ? step_i * 64 * eps + 1e-4 * free : 40 * 8 * eps + slack;
            ASSERT_NEAR(angle, sign * std::min(free, 40.0), allowed) << step_i;
        }
    }
}

/// A heap that lies: no limb is twisted beyond its limits, no joint apart, whatever lies on it.
TEST(JointLimits, hold_in_a_heap) {
    FigureScene scene = heap_of_ragdolls(3);
    const JointRows rows(scene);
    const auto world = std::make_unique<ingot::World<LimitedHeap>>();
    const Built built = add_scene(*world, scene);
    ASSERT_TRUE(built.sound);
    double excess = 0, gap = 0, most = 0, before = energy(rows, start_of(scene));
    for (int step_i = 0; step_i < 150; ++step_i) {
        const ingot::StepReport report = ingot::step(*world, scalar(1) / 60);
        ASSERT_EQ(report.bodies_frozen, 0);
        const FigureState state = state_of(*world, built);
        excess = std::max(excess, worst_excess(rows, state));
        gap = std::max(gap, worst_gap(*world, built));
        const double now = energy(rows, state);
        most = std::max(most, now - before);
        before = now;
    }
    EXPECT_LE(excess, slack);
    EXPECT_LE(gap, 5e-5);
    EXPECT_LE(most, 1);
}

/// Limits that come in motion hold from then on, and what is beyond them goes back slowly; bad ones change nothing.
TEST(JointLimits, are_set_in_motion) {
    const auto world = std::make_unique<LimitedWorld>();
    FigureScene scene = pendulum_with_stop(1, -infinity, 0);
    const Built built = add_scene(*world, scene);
    for (int step_i = 0; step_i < 10; ++step_i) ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
    const double angle = static_cast<double>(world->joint_angle(built.joints[0]).value);
    std::vector<unsigned char> before(sizeof *world);
    std::memcpy(before.data(), world.get(), sizeof *world);
    EXPECT_EQ(world->set_joint_limits(built.joints[0], {{{1, 0}, {}}, 0}), Status::bad_joint);
    ingot::JointId stale = built.joints[0];
    stale.generation += 2;
    EXPECT_EQ(world->set_joint_limits(stale, {}), Status::stale_id);
    EXPECT_EQ(std::memcmp(before.data(), world.get(), sizeof *world), 0);
    const double lower = angle + 0.1;
    ASSERT_EQ(world->set_joint_limits(built.joints[0], {{{static_cast<scalar>(lower), 2}, {}}, 0}), Status::ok);
    double last = angle;
    for (int step_i = 0; step_i < 12; ++step_i) {
        ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
        const double now = static_cast<double>(world->joint_angle(built.joints[0]).value);
        EXPECT_LE(std::abs(now - last), static_cast<double>(ingot::limits::limit_return) / 60 + slack);
        last = now;
    }
    EXPECT_NEAR(last, lower, slack);
}

/// Limits of what rolls, lies on belts, and hangs on what is moved as it is told.
TEST(JointLimits, go_with_materials_and_kinematic_bodies) {
    const auto world = std::make_unique<ingot::World<Factory>>();
    FigureScene scene = heap_of_ragdolls(1);
    const JointRows rows(scene);
    const Built built = add_scene(*world, scene);
    ASSERT_TRUE(built.sound);
    ingot::BodyDef lift;
    lift.kinematic = true;
    lift.shape = ingot::Box{{3, 3, scalar(0.1)}};
    lift.state.r_CM = {0, 0, scalar(0.15)};
    const auto id = world->add(lift);
    ASSERT_TRUE(id.ok());
    ASSERT_EQ(world->set_velocity(id.value, {0, 0, scalar(0.3)}, {}), Status::ok);
    for (int step_i = 0; step_i < 90; ++step_i) {
        ASSERT_EQ(ingot::step(*world, scalar(1) / 60).bodies_frozen, 0);
        ASSERT_LE(worst_gap(*world, built), 5e-5);
        ASSERT_LE(worst_excess(rows, state_of(*world, built)), slack);
    }
}

TEST(JointLimits, that_are_none_are_refused) {
    const auto world = std::make_unique<LimitedWorld>();
    const ingot::BodyId body = add_scene(*world, pendulum_with_stop(1, 0, 0)).bodies[0];
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN();
    const auto refused = [&](const ingot::Joint& joint, Status status) {
        std::vector<unsigned char> before(sizeof *world);
        std::memcpy(before.data(), world.get(), sizeof *world);
        ingot::JointDef def;
        def.body_B = body;
        def.joint = joint;
        EXPECT_EQ(world->add_joint(def).status, status);
        EXPECT_EQ(std::memcmp(before.data(), world.get(), sizeof *world), 0) << ingot::name(status);
    };
    const ingot::JointRange backwards = {1, -1}, wide = {-4, 4};
    refused(ingot::HingeJoint{1, -1}, Status::bad_joint);
    refused(ingot::SliderJoint{1, scalar(0.5)}, Status::bad_joint);
    refused(ingot::UniversalJoint{{}, backwards}, Status::bad_joint);
    refused(ingot::UniversalJoint{wide}, Status::out_of_range);
    refused(ingot::HingeJoint{nan, 1}, Status::not_finite);
    refused(ingot::HingeJoint{-1, nan}, Status::not_finite);
    refused(ingot::HingeJoint{-1, 1, nan}, Status::not_finite);
    refused(ingot::HingeJoint{-1, 1, 2}, Status::bad_restitution);
    refused(ingot::HingeJoint{-1, 1, scalar(-0.1)}, Status::bad_restitution);
    refused(ingot::HingeJoint{-2000, 0}, Status::out_of_range);
    refused(ingot::SliderJoint{0, 2 * ingot::limits::position_max}, Status::out_of_range);
    refused(ingot::BallJoint{scalar(0.001)}, Status::out_of_range);
    refused(ingot::BallJoint{4}, Status::out_of_range);
    refused(ingot::BallJoint{1, 1, -1}, Status::bad_joint);
    refused(ingot::BallJoint{1, -1, 1, 0, {0, 0, -1}}, Status::out_of_range);
    refused(ingot::BallJoint{1, -1, 1, 0, {0, 1, 1}}, Status::bad_direction);
    struct Plain : Limited {
        using joints = ingot::Joints<ingot::HingeJoint>;
    };
    const auto plain = std::make_unique<ingot::World<Plain>>();
    EXPECT_FALSE(add_scene(*plain, pendulum_with_stop(1, 0, 0)).sound);
}

/// Saved in the midst of it, limits and turns go on to the same bits.
TEST(JointLimits, go_on_from_a_snapshot) {
    RandomInput random(23);
    const auto world = std::make_unique<LimitedWorld>(), other = std::make_unique<LimitedWorld>();
    ASSERT_TRUE(add_scene(*world, limited_tree(random, true)).sound);
    for (int step_i = 0; step_i < 40; ++step_i) (void)ingot::step(*world, scalar(1) / 60);
    std::vector<uint8_t> bytes(ingot::snapshot_size<Limited>());
    const auto size = ingot::save_snapshot(*world, bytes.data(), bytes.size());
    ASSERT_TRUE(size.ok());
    ASSERT_EQ(ingot::load_snapshot(*other, bytes.data(), size.value), Status::ok);
    EXPECT_EQ(world->state_hash(), other->state_hash());
    for (int step_i = 0; step_i < 40; ++step_i) {
        (void)ingot::step(*world, scalar(1) / 60);
        (void)ingot::step(*other, scalar(1) / 60);
    }
    EXPECT_EQ(world->state_hash(), other->state_hash());
}

}  // namespace

// SPDX-License-Identifier: MIT
// Drives of joints: springs, servos and motors do what their law says, at any stiffness and rate, within their torque, alone and in figures.
#include <gtest/gtest.h>

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

struct Driven : ingot::Scene {
    static constexpr int max_bodies = 16, max_joints = 16;
    static constexpr bool translates = true;
    using joints = AllJointsWith<ingot::WithDrives>;
};
using DrivenWorld = ingot::World<Driven>;

/// With limits and contacts beside them.
struct Workshop : Driven {
    static constexpr int max_manifolds = 64, max_pairs = 200;
    static constexpr bool sleeps = true, rolling_resistance = true, surface_velocities = true, kinematic_bodies = true;
    using joints = AllJointsWith<ingot::WithLimits, ingot::WithDrives>;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box>;
};
using WorkshopWorld = ingot::World<Workshop>;

constexpr int substeps = 4;  // of a step, see Effort
scalar number(double x) { return static_cast<scalar>(x); }

/// A disc of moment J on a hinge.
struct Rotor {
    std::unique_ptr<DrivenWorld> world = std::make_unique<DrivenWorld>();
    Built built;

    explicit Rotor(double J) {
        FigureScene scene = spring_rotor(J, 0, 0, 0);
        scene.g.setZero();
        built = add_scene(*world, scene);
    }
    void drive(const ingot::JointDrive& drive) { ASSERT_EQ(world->set_joint_drive(built.joints[0], drive), Status::ok); }
    void step(double rate) { ASSERT_TRUE(ingot::step(*world, number(1 / rate)).clean()); }
    double angle() const { return static_cast<double>(world->joint_angle(built.joints[0]).value); }
    double speed() const { return static_cast<double>(world->joint_rate(built.joints[0]).value); }
    double torque() const { return static_cast<double>(world->drive_torque(built.joints[0]).value); }
};

/// The stiffest servo is at its target in four steps, and stays there.
TEST(JointDrives, stiff_servos_do_not_ring) {
    for (const double rate : rates)
        for (const double share : {0.0, 0.5}) {
            Rotor rotor(1e-3);
            const double stiffness = 1e6, damping = share * stiffness / (rate * substeps);
            rotor.drive(ingot::SpringDrive{number(stiffness), number(damping), 1});
            for (int step_i = 0; step_i < 4; ++step_i) rotor.step(rate);
            EXPECT_NEAR(rotor.angle(), 1, 1e-6) << rate << " Hz, damping " << damping;
            for (int step_i = 0; step_i < 20; ++step_i) {
                rotor.step(rate);
                EXPECT_NEAR(rotor.angle(), 1, 1e-6) << rate << " Hz";
            }
        }
}

/// What hangs on a servo is off by its torque over the stiffness.
TEST(JointDrives, servos_carry_by_their_stiffness) {
    for (const double stiffness : {1e3, 1e5}) {
        const auto world = std::make_unique<DrivenWorld>();
        const FigureScene scene = pendulum_with_stop(pi / 2, -infinity, 0);
        const Built built = add_scene(*world, scene);
        ASSERT_EQ(world->set_joint_drive(built.joints[0], ingot::SpringDrive{number(stiffness), number(stiffness / 20)}), Status::ok);
        for (int step_i = 0; step_i < 240; ++step_i) ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
        const double angle = static_cast<double>(world->joint_angle(built.joints[0]).value);
        const double load = 9.81 / 2 * std::cos(angle);
        EXPECT_NEAR(-angle, load / stiffness, 0.01 * load / stiffness + 2 * eps);
        EXPECT_NEAR(static_cast<double>(world->drive_torque(built.joints[0]).value), load, 0.01 * load);
    }
}

/// A law of the form 1 + 1: e'' from the poles of the exact motion, sampled: e(n + 1) = (z1 + z2) e(n) - z1 z2 e(n - 1).
TEST(JointDrives, tuned_ones_have_the_poles_of_the_exact_motion) {
    for (const double hertz : {1.0, 2.0, 5.0})
        for (const double zeta : {0.1, 0.5, 1.0, 2.0}) {
            constexpr double rate = 60;
            Rotor rotor(0.02);
            rotor.drive(ingot::TunedDrive{number(hertz), number(zeta), 1});
            const double w = 2 * pi * hertz, x = w / rate, product = std::exp(-2 * zeta * x);
            const double sum = zeta < 1   ? 2 * std::exp(-zeta * x) * std::cos(x * std::sqrt(1 - zeta * zeta))
                               : zeta > 1 ? std::exp(-x * (zeta - std::sqrt(zeta * zeta - 1))) + std::exp(-x * (zeta + std::sqrt(zeta * zeta - 1)))
                                          : 2 * std::exp(-x);
            double e[3] = {};
            for (int step_i = 0; step_i < 30; ++step_i) {
                rotor.step(rate);
                e[0] = e[1];
                e[1] = e[2];
                e[2] = rotor.angle() - 1;
                // Roundings of an angle near 1; 1 % of the damping and of the frequency are far more.
                if (step_i < 2) continue;
                EXPECT_NEAR(e[2], sum * e[1] - product * e[0], 64 * eps + 1e-5 * std::abs(e[0])) << hertz << " Hz, " << zeta;
            }
        }
}

/// Torque within its limit in every substep, here one step; and what it does is what it says that it does.
TEST(JointDrives, keep_to_their_torque) {
    for (const double limit : {0.1, 1.0, 10.0})
        for (const double stiffness : {10.0, 1e6}) {
            constexpr double J = 1e-3, rate = 240;
            Rotor rotor(J);
            rotor.drive(ingot::SpringDrive{number(stiffness), number(stiffness / 10), 1, 0, 0, number(limit)});
            double before = 0;
            for (int step_i = 0; step_i < 480; ++step_i) {
                rotor.step(rate);
                ASSERT_LE(std::abs(rotor.torque()), limit * (1 + 8 * eps));
                const double rounding = 64 * eps * std::max(std::abs(rotor.speed()), std::abs(before)) + 1e-12;
                ASSERT_NEAR(rotor.speed() - before, rotor.torque() / (J * rate), rounding + 1e-4 * std::abs(rotor.torque()) / (J * rate));
                before = rotor.speed();
            }
            EXPECT_NEAR(rotor.angle(), 1, 1e-5) << limit << " N m, " << stiffness;
        }
}

/// A motor goes up to its rate with its torque, and stays there; a load beyond its torque turns it back.
TEST(JointDrives, motors_keep_their_rate) {
    for (const double rate : rates)
        for (const double speed : {-1.0, 20.0}) {
            constexpr double J = 1e-3, torque = 0.05;
            Rotor rotor(J);
            rotor.drive(ingot::MotorDrive{number(speed), number(torque)});
            const double rise = std::abs(speed) * J / torque;
            for (int step_i = 1; step_i < 1.5 * rate; ++step_i) {
                rotor.step(rate);
                const double t = step_i / rate;
                if (t < rise - 1 / rate) {
                    ASSERT_NEAR(rotor.speed(), std::copysign(torque / J * t, speed), 1e-4 * torque / J * t) << rate << " Hz";
                } else if (t > rise + 1 / rate) {
                    ASSERT_NEAR(rotor.speed(), speed, 1e-5 * std::abs(speed)) << rate << " Hz";
                }
            }
        }
    for (const double torque : {20.0, 3.0}) {
        FigureScene scene = pendulum_with_stop(0, -infinity, 0);
        scene.joint(0).motor = {1, torque};  // g/2 sin theta passes 3 N m
        ConstrainedReference exact(scene);
        const auto world = std::make_unique<DrivenWorld>();
        const Built built = add_scene(*world, scene);
        ASSERT_EQ(world->set_joint_drive(built.joints[0], ingot::MotorDrive{1, number(torque)}), Status::ok);
        for (int step_i = 0; step_i < 120; ++step_i) ASSERT_TRUE(ingot::step(*world, scalar(1) / 120).clean());
        exact.advance_to(1);
        const double angle = measured(exact.rows(), exact.state(), 0, FigureMeasure::angle);
        EXPECT_NEAR(static_cast<double>(world->joint_angle(built.joints[0]).value), angle, 0.01) << torque;
    }
}

/// Turns of a ball joint, from anywhere to anywhere.
TEST(JointDrives, ball_servos_go_where_they_are_told) {
    RandomInput random(31);
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i) {
        FigureScene scene;
        scene.g.setZero();
        FigureBody body = sphere(1, 0.1, {0, 0, 0});
        body.I_body = {1e-3, 2e-3, 2.5e-3};
        body.A = random.rotation();
        scene.join(ball(the_world, scene.add(body), {0, 0, 0}));
        const auto world = std::make_unique<DrivenWorld>();
        const Built built = add_scene(*world, scene);
        const Vector3d target = random.direction() * random.real(0, 2.9);
        const ingot::SpringDrive servo = {1000000, number(random.integer(0, 1) * 2000.0)};
        ASSERT_EQ(world->set_ball_drive(built.joints[0], servo, to_vector(target)), Status::ok);
        for (int step_i = 0; step_i < 4; ++step_i) ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
        const Eigen::Matrix3d there = Eigen::AngleAxisd(target.norm(), target.normalized()).toRotationMatrix() * body.A;
        const Eigen::Matrix3d A = ingot_reference::to_eigen(world->state(built.bodies[0]).value.A);
        EXPECT_LE((A - there).norm(), 1e-5) << run_i;
    }
}

/// A target that turns on and on about an axis is followed for half a minute as exactly as at first: what is kept of it is half a turn at most, and a
/// step loses a rounding of that.
TEST(JointDrives, ball_servos_follow_a_target_round_and_round) {
    RandomInput random(37);
    double worst = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i) {
        FigureScene scene;
        scene.g.setZero();
        FigureBody body = sphere(1, 0.1, {0, 0, 0});
        body.A = random.rotation();
        scene.join(ball(the_world, scene.add(body), {0, 0, 0}));
        const auto world = std::make_unique<DrivenWorld>();
        const Built built = add_scene(*world, scene);
        const Vector3d axis = random.direction();
        const double begin = random.real(-2, 2), rate = random.real(20, 60) * (random.integer(0, 1) == 0 ? -1 : 1);
        const ingot::SpringDrive servo = {1000000, 0};
        ASSERT_EQ(world->set_ball_drive(built.joints[0], servo, to_vector(axis * begin), to_vector(axis * rate)), Status::ok);
        for (int step_i = 1; step_i <= 1800; ++step_i) {
            ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
            if (step_i < 4) continue;
            const Eigen::Matrix3d due = Eigen::AngleAxisd(begin + rate * step_i / 60, axis).toRotationMatrix() * body.A;
            const Eigen::Matrix3d A = ingot_reference::to_eigen(world->state(built.bodies[0]).value.A);
            worst = std::max(worst, (A - due).norm());
        }
    }
    std::printf("    off by %.2g rad\n", worst);
    // What the servo leaves; a rounding a step of half a turn, and of its way; and those of the rate, over all of the way.
    EXPECT_LE(worst, 1e-5 + static_cast<double>(ingot::epsilon) * (4 * 1800 + 2 * 60 * 30));
}

/// A tree whose joints all have servos towards where they begin, thrown.
FigureScene driven_tree(RandomInput& random, bool tied, double stiffness) {
    return turning_tree(random, 8, tied, 2, 3, [&](FigureJoint& joint) {
        joint.servo.stiffness = stiffness * random.real(0.5, 2);
        joint.servo.damping = joint.servo.stiffness * random.real(0, 0.1);
        if (joint.kind == FigureJointKind::hinge) joint.servo.target_rate = random.real(-1, 1);
    });
}

template <class World>
bool set_servos(World& world, const FigureScene& scene, const Built& built) {
    bool sound = built.sound;
    for (size_t i = 0; i < built.joints.size(); ++i) {
        const FigureDrive& servo = scene.joints[i].servo;
        const ingot::SpringDrive drive = {number(servo.stiffness), number(servo.damping), number(servo.target), number(servo.target_rate)};
        const Status status = scene.joints[i].kind == FigureJointKind::ball ? world.set_ball_drive(built.joints[i], drive)
                                                                            : world.set_joint_drive(built.joints[i], drive);
        sound = sound && status == Status::ok;
    }
    return sound;
}

/// Against the exact motion: the error goes with h, and twice the rate halves it.
TEST(JointDrives, follow_the_exact_motion) {
    RandomInput random(32);
    double coarse = 0, fine = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(24); ++run_i) {
        FigureScene scene = driven_tree(random, run_i % 2 == 0, 60);
        for (FigureJoint& joint : scene.joints) joint.servo.target_rate = 0;
        ConstrainedReference exact(scene, 1e-9);
        exact.advance_to(0.25);
        double error[2];
        for (const int fold : {0, 1}) {
            const int steps = fold == 0 ? 30 : 60;
            const auto world = std::make_unique<DrivenWorld>();
            const Built built = add_scene(*world, scene);
            ASSERT_TRUE(set_servos(*world, scene, built));
            for (int step_i = 0; step_i < steps; ++step_i) ASSERT_TRUE(ingot::step(*world, number(0.25 / steps)).clean());
            const FigureState state = state_of(*world, built);
            error[fold] = 0;
            for (int i = 0; i < scene.body_count(); ++i)
                error[fold] = std::max(error[fold], (state.body(i).r_CM - exact.state().body(i).r_CM).norm());
        }
        EXPECT_LE(error[0], 5e-3) << run_i;
        coarse += error[0];
        fine += error[1];
    }
    EXPECT_LE(fine, 0.6 * coarse);
}

/// However stiff, springs and dampers make no energy: kinetic, of height, and of springs.
TEST(JointDrives, springs_make_no_energy) {
    RandomInput random(33);
    for (int run_i = 0; run_i < ingot_reference::draws(60); ++run_i) {
        const double rate = rates[random.integer(1, 4)], stiffness = std::pow(10.0, random.real(1, 7));
        FigureScene scene = driven_tree(random, run_i % 2 == 0, stiffness);
        for (FigureJoint& joint : scene.joints) joint.servo.target_rate = 0;
        const JointRows rows(scene);
        const auto world = std::make_unique<DrivenWorld>();
        const Built built = add_scene(*world, scene);
        ASSERT_TRUE(set_servos(*world, scene, built));
        const double begin = energy(rows, start_of(scene)), unit = mass(scene) * 9.81;
        for (int step_i = 0; step_i < static_cast<int>(rate); ++step_i) {
            ASSERT_TRUE(ingot::step(*world, number(1 / rate)).clean());
            const FigureState state = state_of(*world, built);
            // Springs of stiffness k feel the roundings of angles and places; see swinging_figures_test.cpp for the rest.
            const double rounding = scene.joint_count() * 2 * stiffness * std::pow(16 * eps, 2);
            ASSERT_LE(energy(rows, state), begin + 0.01 * (unit + kinetic_energy(scene, state)) + rounding) << run_i << ", " << rate << " Hz";
            ASSERT_LE(worst_gap(*world, built), held) << run_i;
        }
    }
}

/// A servo between two bodies that float changes no momentum.
TEST(JointDrives, react_on_the_parent) {
    RandomInput random(34);
    for (int run_i = 0; run_i < ingot_reference::draws(24); ++run_i) {
        FigureScene scene = driven_tree(random, false, 1000);
        scene.g.setZero();
        const auto world = std::make_unique<DrivenWorld>();
        const Built built = add_scene(*world, scene);
        ASSERT_TRUE(set_servos(*world, scene, built));
        const FigureState start = start_of(scene);
        double L = 0;
        for (int i = 0; i < scene.body_count(); ++i) L += scene.body(i).M * (start.body(i).v_CM.norm() + 1);
        for (int step_i = 0; step_i < 60; ++step_i) ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
        const FigureState end = state_of(*world, built);
        EXPECT_LE((momentum(scene, end) - momentum(scene, start)).norm(), mass(scene) * 1280 * eps) << run_i;
        EXPECT_LE((angular_momentum(scene, end) - angular_momentum(scene, start)).norm(), (1e-3 + 640 * eps) * L) << run_i;
    }
}

TEST(JointDrives, that_are_none_are_refused) {
    const auto world = std::make_unique<DrivenWorld>();
    FigureScene scene = driven_tree(*std::make_unique<RandomInput>(35), true, 100);
    const int post = scene.add(box(1, {0.1, 0.1, 0.1}, {5, 0, 0}, Eigen::Quaterniond::Identity().toRotationMatrix()));
    scene.join(joint_of(FigureJointKind::fixed, the_world, post, {5, 0, 0}, Vector3d::UnitX(), Vector3d::UnitX()));
    const Built built = add_scene(*world, scene);
    ingot::JointId hinge{}, ball{}, fixed = built.joints.back();
    for (size_t i = 0; i < scene.joints.size(); ++i) {
        if (scene.joints[i].kind == FigureJointKind::hinge || scene.joints[i].kind == FigureJointKind::slider) hinge = built.joints[i];
        if (scene.joints[i].kind == FigureJointKind::ball) ball = built.joints[i];
    }
    ASSERT_TRUE(world->is_alive(hinge) && world->is_alive(ball) && world->is_alive(fixed));
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN(), infinity_s = std::numeric_limits<scalar>::infinity();
    const auto refused = [&](Status expected, const auto& call) {
        std::vector<unsigned char> before(sizeof *world);
        std::memcpy(before.data(), world.get(), sizeof *world);
        EXPECT_EQ(call(), expected) << ingot::name(expected);
        EXPECT_EQ(std::memcmp(before.data(), world.get(), sizeof *world), 0) << ingot::name(expected);
    };
    const auto bad = [&](Status expected, const ingot::JointDrive& drive) {
        refused(expected, [&] { return world->set_joint_drive(hinge, drive); });
        if (drive.target == 0 && std::abs(drive.target_rate) < 1e6) refused(expected, [&] { return world->set_ball_drive(ball, drive); });
    };
    bad(Status::not_finite, ingot::SpringDrive{nan});
    bad(Status::not_finite, ingot::SpringDrive{1, nan});
    bad(Status::not_finite, ingot::SpringDrive{1, 1, nan});
    bad(Status::not_finite, ingot::SpringDrive{1, 1, 1, infinity_s});
    bad(Status::not_finite, ingot::SpringDrive{1, 1, 1, 0, nan});
    bad(Status::not_finite, ingot::MotorDrive{1, nan});
    bad(Status::out_of_range, ingot::MotorDrive{1, -1});
    bad(Status::out_of_range, ingot::SpringDrive{-1, 1});
    bad(Status::out_of_range, ingot::SpringDrive{1, -1});
    bad(Status::out_of_range, ingot::TunedDrive{-1, 1});
    bad(Status::out_of_range, ingot::TunedDrive{2000, 1});
    bad(Status::out_of_range, ingot::TunedDrive{1, 20});
    bad(Status::out_of_range, ingot::MotorDrive{number(1e9)});
    ingot::JointDrive unknown;
    unknown.kind = static_cast<ingot::DriveKind>(9);
    bad(Status::out_of_range, unknown);
    ingot::JointId stale = hinge;
    stale.generation += 2;
    refused(Status::stale_id, [&] { return world->set_joint_drive(stale, {}); });
    refused(Status::not_in_scene, [&] { return world->set_joint_drive(hinge, {}, 1); });
    refused(Status::not_in_scene, [&] { return world->set_joint_drive(hinge, {}, -1); });
    refused(Status::not_in_scene, [&] { return world->set_joint_drive(ball, {}); });
    refused(Status::not_in_scene, [&] { return world->set_joint_drive(fixed, {}); });
    refused(Status::not_in_scene, [&] { return world->set_ball_drive(hinge, {}); });
    refused(Status::out_of_range, [&] { return world->set_ball_drive(ball, ingot::SpringDrive{1}, {4, 0, 0}); });
    refused(Status::not_finite, [&] { return world->set_ball_drive(ball, ingot::SpringDrive{1}, {nan, 0, 0}); });
    refused(Status::not_finite, [&] { return world->set_joint_target(hinge, nan); });
    refused(Status::not_finite, [&] { return world->set_joint_target(hinge, 0, nan); });
    refused(Status::not_finite, [&] { return world->set_ball_target(ball, {0, 0, 0}, {0, nan, 0}); });
    EXPECT_EQ(world->drive_torque(stale).status, Status::stale_id);
    EXPECT_EQ(world->ball_torque(hinge).status, Status::not_in_scene);
}

/// Targets move with their rate, drives end when they are told to, and saved in the midst of it all go on to the same bits.
TEST(JointDrives, are_edited_in_motion) {
    RandomInput random(36);
    const auto world = std::make_unique<DrivenWorld>(), other = std::make_unique<DrivenWorld>();
    const FigureScene scene = driven_tree(random, true, 1000);
    const Built built = add_scene(*world, scene);
    ASSERT_TRUE(set_servos(*world, scene, built));
    for (int step_i = 0; step_i < 40; ++step_i) (void)ingot::step(*world, scalar(1) / 60);
    std::vector<uint8_t> bytes(ingot::snapshot_size<Driven>());
    const auto size = ingot::save_snapshot(*world, bytes.data(), bytes.size());
    ASSERT_TRUE(size.ok());
    ASSERT_EQ(ingot::load_snapshot(*other, bytes.data(), size.value), Status::ok);
    for (int step_i = 0; step_i < 40; ++step_i) {
        (void)ingot::step(*world, scalar(1) / 60);
        (void)ingot::step(*other, scalar(1) / 60);
    }
    EXPECT_EQ(world->state_hash(), other->state_hash());

    Rotor rotor(1e-3);
    rotor.drive(ingot::SpringDrive{1000000, 0, 0, 2});
    for (int step_i = 1; step_i <= 60; ++step_i) {
        rotor.step(60);
        if (step_i <= 3) continue;
        ASSERT_NEAR(rotor.angle(), 2.0 * step_i / 60, 1e-5);
    }
    EXPECT_NEAR(static_cast<double>(rotor.world->joint_drive(rotor.built.joints[0]).value.target), 2, 1e-5);
    ASSERT_EQ(rotor.world->set_joint_target(rotor.built.joints[0], 1), Status::ok);
    for (int step_i = 0; step_i < 4; ++step_i) rotor.step(60);
    EXPECT_NEAR(rotor.angle(), 1, 1e-6);
    rotor.drive({});
    ASSERT_EQ(rotor.world->apply_angular_impulse(rotor.built.bodies[0], {0, 0, scalar(0.002)}), Status::ok);
    for (int step_i = 0; step_i < 60; ++step_i) rotor.step(60);
    EXPECT_NEAR(rotor.angle(), 3, 1e-4);
}

/// An arm that presses on a block of stone with all of its torque: it rests there, on its servo, and wakes when it is told to go elsewhere.
TEST(JointDrives, press_on_what_is_in_the_way) {
    const auto world = std::make_unique<WorkshopWorld>();
    FigureScene scene;
    FigureBody stone = box(0, {1, 1, 0.5}, {1, 0, -0.7});
    stone.friction = 0.5;
    scene.add(stone);
    const int arm_i = scene.add(capsule(2, 0.1, 0.4, {0.5, 0, 0}, along(Vector3d::UnitX())));
    scene.join(hinge(the_world, arm_i, {0, 0, 0}, Vector3d::UnitY()));
    const Built built = add_scene(*world, scene);
    ASSERT_TRUE(built.sound);
    ASSERT_EQ(world->set_joint_drive(built.joints[0], ingot::SpringDrive{10000, 100, 1, 0, 0, 60}), Status::ok);
    int step_i = 0;
    for (; step_i < 600 && !world->is_asleep(built.bodies[1]); ++step_i) {
        ASSERT_EQ(ingot::step(*world, scalar(1) / 60).bodies_frozen, 0);
        ASSERT_LE(std::abs(static_cast<double>(world->drive_torque(built.joints[0]).value)), 60.001);
    }
    EXPECT_LT(step_i, 600);
    EXPECT_NEAR(static_cast<double>(world->drive_torque(built.joints[0]).value), 60, 0.001);
    EXPECT_GT(static_cast<double>(world->state(built.bodies[1]).value.r_CM.z), -0.12);
    ASSERT_EQ(world->set_joint_target(built.joints[0], scalar(-0.5)), Status::ok);
    EXPECT_FALSE(world->is_asleep(built.bodies[1]));
    for (step_i = 0; step_i < 120; ++step_i) (void)ingot::step(*world, scalar(1) / 60);
    EXPECT_NEAR(static_cast<double>(world->joint_angle(built.joints[0]).value), -0.5, 0.002);
    ASSERT_EQ(world->set_joint_drive(built.joints[0], ingot::MotorDrive{scalar(0.001)}), Status::ok);
    for (step_i = 0; step_i < 120; ++step_i) (void)ingot::step(*world, scalar(1) / 60);
    EXPECT_FALSE(world->is_asleep(built.bodies[1]));
}

}  // namespace

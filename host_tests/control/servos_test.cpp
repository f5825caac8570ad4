// SPDX-License-Identifier: MIT
// Servos: what they turn is where it should be in the world, by the law of its drive, whatever it hangs on and whatever takes the torque.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <memory>

#include "joints/figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;
using ingot::Status;
using ingot_reference::to_eigen;
using Eigen::Vector3d;

struct Servos : ingot::Scene {
    static constexpr int max_bodies = 24, max_joints = 24, max_loops = 6;
    static constexpr bool translates = true;
    using joints = AllJointsWith<ingot::ServoJoint, ingot::BallServoJoint, ingot::WithDrives>;
};
using ServoWorld = ingot::World<Servos>;

/// With limits, contacts and sleep beside them.
struct Hall : Servos {
    static constexpr int max_manifolds = 40, max_pairs = 100;
    static constexpr bool sleeps = true, kinematic_bodies = true;
    using joints = AllJointsWith<ingot::ServoJoint, ingot::BallServoJoint, ingot::RodJoint, ingot::WithLimits, ingot::WithDrives>;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
using HallWorld = ingot::World<Hall>;

constexpr double pi = 3.14159265358979323846;
scalar number(double x) { return static_cast<scalar>(x); }

/// A body of moments J about its own axes, which are the world's, and a mass of 1 kg.
template <class World>
ingot::BodyId add_body(World& world, const Vector3d& J, const Vector3d& place = Vector3d::Zero(), const Vector3d& omega = Vector3d::Zero()) {
    ingot::BodyDef def;
    def.mass = {1, to_vector(J), {}, ingot::identity_matrix<scalar>()};
    def.state.r_CM = to_vector(place);
    def.state.L = to_vector(J.cwiseProduct(omega));
    const ingot::Result<ingot::BodyId> added = world.add(def);
    EXPECT_TRUE(added.ok());
    return added.value;
}
template <class World>
ingot::Result<ingot::JointId> add_joint(World& world, const ingot::Joint& kind, ingot::BodyId A, ingot::BodyId B, const Vector3d& axis,
                                        const Vector3d& P = Vector3d::Zero()) {
    ingot::JointDef def;
    def.body_A = A;
    def.body_B = B;
    def.joint = kind;
    def.P = to_vector(P);
    def.axis = to_vector(axis);
    return world.add_joint(def);
}
/// Three moments that a body can have.
Vector3d random_moments(RandomInput& random) {
    const double a = random.real(0.5, 1), b = random.real(0.5, 1), scale = std::exp(random.real(std::log(1e-3), std::log(10)));
    return scale * Vector3d(a, b, random.real(std::abs(a - b) + 0.1, a + b - 0.1));
}
ingot::JointDrive random_drive(RandomInput& random, double J, double h) {
    const double stiffness = J / (h * h) * std::exp(random.real(std::log(1e-4), std::log(1e3)));
    if (random.integer(0, 2) == 0) return ingot::TunedDrive{number(random.real(0.5, 10)), number(random.real(0, 2)), number(random.real(-0.3, 0.3))};
    if (random.integer(0, 3) == 0) return ingot::MotorDrive{number(random.real(-5, 5))};
    return ingot::SpringDrive{number(stiffness), number(random.real(0, 2) * stiffness * h), number(random.real(-0.3, 0.3)),
                              number(random.real(-1, 1)), number(random.real(-1, 1) * J)};
}
double angle_of(const ServoWorld& world, ingot::JointId id) { return static_cast<double>(world.joint_angle(id).value); }

/// What nothing else holds is turned as a hinge of the world turns it, by any law and at any rate; and it does not know what takes the torque:
/// nothing, a body that floats, however it spins, or one that stands still. Of what turns by less than a third in a substep, which is cut alike.
TEST(Servos, turn_a_body_as_a_hinge_of_the_world_does) {
    RandomInput random(1);
    for (int run_i = 0; run_i < ingot_reference::draws(200); ++run_i) {
        const double rate = rates[random.integer(0, 3)], h = 1 / rate;
        const Vector3d J = random_moments(random);
        const int axis_i = random.integer(0, 2);
        const Vector3d axis = Vector3d::Unit(axis_i) * (random.integer(0, 1) == 0 ? 1 : -1), omega = axis * random.real(-5, 5);
        const ingot::JointDrive drive = random_drive(random, J[axis_i], h / Servos::effort.substeps);
        const auto hinged = std::make_unique<ServoWorld>(), turned = std::make_unique<ServoWorld>();
        const ingot::JointId hinge = add_joint(*hinged, ingot::HingeJoint{}, {}, add_body(*hinged, J, {0, 0, 0}, omega), axis).value;
        const ingot::BodyId B = add_body(*turned, J, {0, 0, 0}, omega);
        const int reaction = random.integer(0, 2);
        ingot::BodyId A{};
        if (reaction == 1) A = add_body(*turned, J * random.real(1, 10), random.vector(5), random.vector(3));
        if (reaction == 2) {
            ingot::BodyDef wall;
            wall.immovable = true;
            A = turned->add(wall).value;
        }
        const ingot::JointId servo = add_joint(*turned, ingot::ServoJoint{}, A, B, axis).value;
        ASSERT_EQ(hinged->set_joint_drive(hinge, drive), Status::ok);
        ASSERT_EQ(turned->set_joint_drive(servo, drive), Status::ok);
        for (int step_i = 0; step_i < 30; ++step_i) {
            ASSERT_TRUE(ingot::step(*hinged, number(h)).clean());
            ASSERT_TRUE(ingot::step(*turned, number(h)).clean());
            const double wanted = angle_of(*hinged, hinge), rate_wanted = static_cast<double>(hinged->joint_rate(hinge).value);
            EXPECT_NEAR(angle_of(*turned, servo), wanted, 2e3 * eps * (1 + std::abs(wanted))) << run_i << ", step " << step_i;
            EXPECT_NEAR(static_cast<double>(turned->joint_rate(servo).value), rate_wanted, 2e3 * eps * (1 + std::abs(rate_wanted)) / h) << run_i;
        }
    }
}

/// The same with three rows: what a ball servo turns is at its target, up to nearly half a turn away, in four steps, and A has got as much the other
/// way round: what both have of angular momentum stays.
TEST(Servos, of_balls_go_where_they_are_told) {
    RandomInput random(2);
    for (int run_i = 0; run_i < ingot_reference::draws(80); ++run_i) {
        const double rate = rates[random.integer(0, 3)];
        const auto world = std::make_unique<ServoWorld>();
        const ingot::BodyId B = add_body(*world, Vector3d(1e-3, 2e-3, 2.5e-3));
        const bool floats = random.integer(0, 1) == 1;
        const ingot::BodyId A = floats ? add_body(*world, random_moments(random), {1, 2, 3}) : ingot::BodyId{};
        const ingot::JointId servo = add_joint(*world, ingot::BallServoJoint{}, A, B, {0, 0, 1}).value;
        const Vector3d target = random.direction() * random.real(0, 2.5);
        ASSERT_EQ(world->set_ball_drive(servo, ingot::SpringDrive{1000000}, to_vector(target)), Status::ok);
        for (int step_i = 0; step_i < 4; ++step_i) ASSERT_TRUE(ingot::step(*world, number(1 / rate)).clean());
        const Eigen::Matrix3d wanted = Eigen::AngleAxisd(target.norm(), target.normalized()).toRotationMatrix();
        const Eigen::Matrix3d is = ingot_reference::to_eigen(world->state(B).value.A);
        EXPECT_LE(Eigen::AngleAxisd(is * wanted.transpose()).angle(), 1e-5 + 16 * eps) << run_i << ", " << rate << " Hz, " << target.transpose();
        if (!floats) continue;
        const Vector3d L_A = to_eigen(world->state(A).value.L), L_B = to_eigen(world->state(B).value.L);
        EXPECT_LE((L_A + L_B).norm(), 1e3 * eps * (L_A.norm() + 2e-3 * rate)) << run_i;
    }
}

/// Of a tree that floats, servos between any two of its bodies, or to a third that it is not joined to, change neither momentum: what they give to
/// one they take from another. Joints let angular momentum go to second order in the step: it goes with the rate.
TEST(Servos, make_no_momentum) {
    RandomInput random(3);
    for (int run_i = 0; run_i < ingot_reference::draws(60); ++run_i) {
        const double rate = rates[random.integer(1, 3)];
        const auto world = std::make_unique<ServoWorld>();
        Built built;
        add_figure(*world, random, {random.integer(2, 6), 0.2, 10, 0, false}, {0, 0, 0}, built);
        add_figure(*world, random, {random.integer(1, 3), 0.2, 10, 0, false}, {5, 0, 0}, built);
        ASSERT_TRUE(built.sound);
        const int count = static_cast<int>(built.bodies.size());
        double turned = 0;
        for (int i = 0; i < 3; ++i) {
            const int b = random.integer(0, count - 1), a = (b + random.integer(1, count - 1)) % count;
            const ingot::BodyId A = built.bodies[static_cast<size_t>(a)], B = built.bodies[static_cast<size_t>(b)];
            const ingot::JointId id = add_joint(*world, ingot::ServoJoint{}, A, B, random.direction()).value;
            ASSERT_EQ(world->set_joint_drive(id, ingot::TunedDrive{1, 1, number(random.real(-0.5, 0.5)), 0, 0, number(5)}), Status::ok);
            turned += 5;
        }
        double time = 0;
        for (; time < 0.5; time += 1 / rate) ASSERT_EQ(ingot::step(*world, number(1 / rate)).status, Status::ok);
        Vector3d p = Vector3d::Zero(), L = Vector3d::Zero();
        double M = 0;
        for (const ingot::BodyId id : built.bodies) {
            const ingot::BodyState state = world->state(id).value;
            const double M_i = static_cast<double>(world->mass(id).value);
            p += M_i * to_eigen(state.v_CM);
            L += to_eigen(state.L) + M_i * to_eigen(state.r_CM).cross(to_eigen(state.v_CM));
            M += M_i;
        }
        EXPECT_LE(p.norm(), 2e4 * eps * M) << run_i;
        EXPECT_LE(L.norm(), (1e-3 + 1e3 * eps) * turned * time) << run_i << ", " << rate << " Hz";  // of what servos could give in that time
    }
}

/// What is held level in the world stays so by its stiffness, as its base is shaken: off by no more than what it is asked for over the stiffness.
TEST(Servos, hold_what_hangs_on_something_that_moves) {
    RandomInput random(4);
    for (int run_i = 0; run_i < ingot_reference::draws(24); ++run_i) {
        const double rate = rates[random.integer(1, 3)];
        const auto world = std::make_unique<ServoWorld>();
        const ingot::BodyId base = add_body(*world, Vector3d(1, 1, 1)), head = add_body(*world, Vector3d(0.1, 0.1, 0.1), {1, 0, 0});
        const ingot::JointId swing = add_joint(*world, ingot::HingeJoint{}, {}, base, {0, 0, 1}).value;
        ASSERT_TRUE(add_joint(*world, ingot::HingeJoint{}, base, head, {0, 0, 1}, {1, 0, 0}).ok());
        const ingot::BodyId A = random.integer(0, 1) == 0 ? base : ingot::BodyId{};
        const ingot::JointId servo = add_joint(*world, ingot::ServoJoint{}, A, head, {0, 0, 1}).value;
        const double stiffness = std::exp(random.real(std::log(30), std::log(1e5))), hertz = random.real(0.2, 1);
        ASSERT_EQ(world->set_joint_drive(servo, ingot::SpringDrive{number(stiffness), number(stiffness / 30)}), Status::ok);
        double most = 0, angle = 0;
        for (double time = 0; time < 3; time += 1 / rate) {
            const double phase = 2 * pi * hertz * time;
            const double target = 0.8 * std::sin(phase), target_rate = 0.8 * 2 * pi * hertz * std::cos(phase);
            ASSERT_EQ(world->set_joint_drive(swing, ingot::SpringDrive{number(1e6), 0, number(target), number(target_rate)}), Status::ok);
            ASSERT_TRUE(ingot::step(*world, number(1 / rate)).clean());
            if (time < 0.5) continue;
            most = std::max(most, std::abs(static_cast<double>(world->drive_torque(servo).value)));
            angle = std::max(angle, std::abs(angle_of(*world, servo)));
        }
        EXPECT_LE(angle, 1.05 * most / stiffness + 1e-5) << run_i << ", " << rate << " Hz, " << stiffness;
    }
}

/// Never more than the largest torque, in trees, against the ground, whatever is asked for.
TEST(Servos, keep_to_their_torque) {
    RandomInput random(5);
    for (int run_i = 0; run_i < ingot_reference::draws(120); ++run_i) {
        const double rate = rates[random.integer(0, 3)];
        const auto world = std::make_unique<HallWorld>();
        ASSERT_TRUE(weigh(*world));
        ASSERT_TRUE(add_ground(*world));
        Built built;
        add_figure(*world, random, {random.integer(2, 6), 0.2, 10, 1, false}, {0, 0, 2}, built);
        ASSERT_TRUE(built.sound);
        const int count = static_cast<int>(built.bodies.size());
        const int b = random.integer(0, count - 1), a = (b + random.integer(1, count - 1)) % count;
        const bool is_ball = random.integer(0, 1) == 1, alone = random.integer(0, 2) == 0;
        const ingot::BodyId A = alone ? ingot::BodyId{} : built.bodies[static_cast<size_t>(a)];
        const ingot::Joint kind = is_ball ? ingot::Joint(ingot::BallServoJoint{}) : ingot::Joint(ingot::ServoJoint{});
        const ingot::JointId id = add_joint(*world, kind, A, built.bodies[static_cast<size_t>(b)], random.direction()).value;
        const double most = std::exp(random.real(std::log(0.1), std::log(30))), stiffness = std::exp(random.real(0, std::log(1e4)));
        const ingot::SpringDrive drive = {number(stiffness), number(stiffness * random.real(0, 0.1)), number(random.real(-2, 2)), 0, 0, number(most)};
        if (is_ball) {
            ASSERT_EQ(world->set_ball_drive(id, drive, to_vector(random.direction() * 2)), Status::ok);
        } else {
            ASSERT_EQ(world->set_joint_drive(id, drive), Status::ok);
        }
        for (int step_i = 0; step_i < static_cast<int>(2 * rate); ++step_i) {
            const ingot::StepReport report = ingot::step(*world, number(1 / rate));
            ASSERT_EQ(report.status, Status::ok);
            ASSERT_EQ(report.bodies_frozen, 0) << run_i;
            const double given =
                is_ball ? to_eigen(world->ball_torque(id).value).norm() : std::abs(static_cast<double>(world->drive_torque(id).value));
            ASSERT_LE(given, most * (1 + 64 * eps)) << run_i << ", step " << step_i;
        }
    }
}

/// What calls refuse, and that they leave the world as it is.
TEST(Servos, that_are_none_are_refused) {
    const auto world = std::make_unique<HallWorld>();
    ingot::BodyDef wall;
    wall.immovable = true;
    const ingot::BodyId still = world->add(wall).value, B = add_body(*world, {1, 1, 1}), A = add_body(*world, {1, 1, 1}, {3, 0, 0});
    const Vector3d z = {0, 0, 1};
    const ingot::JointId servo = add_joint(*world, ingot::ServoJoint{}, A, B, z).value;
    const ingot::JointId ball = add_joint(*world, ingot::BallServoJoint{}, {}, B, z).value;
    ASSERT_EQ(world->set_joint_drive(servo, ingot::SpringDrive{10, 1, 1}), Status::ok);
    const HallWorld before = *world;
    const auto nan = std::numeric_limits<scalar>::quiet_NaN();
    EXPECT_EQ(add_joint(*world, ingot::ServoJoint{}, B, {}, z).status, Status::immovable);  // nothing to turn
    EXPECT_EQ(add_joint(*world, ingot::ServoJoint{}, B, still, z).status, Status::immovable);
    EXPECT_EQ(add_joint(*world, ingot::ServoJoint{}, B, B, z).status, Status::bad_joint);
    EXPECT_EQ(add_joint(*world, ingot::ServoJoint{}, A, B, {0, 0, 2}).status, Status::bad_direction);
    EXPECT_EQ(add_joint(*world, ingot::ServoJoint{}, A, B, {0, 0, std::numeric_limits<double>::quiet_NaN()}).status, Status::not_finite);
    const ingot::Joint limited = {ingot::JointKind::servo, {{{-1, 1}, {}}, 0}, {}}, broken = {ingot::JointKind::ball_servo, {{{}, {nan, 1}}, 0}, {}};
    EXPECT_EQ(add_joint(*world, limited, A, B, z).status, Status::not_in_scene);
    EXPECT_EQ(add_joint(*world, broken, A, B, z).status, Status::not_finite);
    EXPECT_EQ(world->set_joint_drive(servo, ingot::SpringDrive{nan}), Status::not_finite);
    EXPECT_EQ(world->set_joint_drive(servo, ingot::SpringDrive{-1}), Status::out_of_range);
    EXPECT_EQ(world->set_joint_drive(servo, ingot::SpringDrive{1, 1, 0, 0, 0, -1}), Status::out_of_range);
    EXPECT_EQ(world->set_joint_drive(servo, ingot::SpringDrive{1}, 1), Status::not_in_scene);
    EXPECT_EQ(world->set_joint_drive(ball, ingot::SpringDrive{1}), Status::not_in_scene);
    EXPECT_EQ(world->set_ball_drive(servo, ingot::SpringDrive{1}), Status::not_in_scene);
    EXPECT_EQ(world->set_ball_drive(ball, ingot::SpringDrive{1}, {4, 0, 0}), Status::out_of_range);
    EXPECT_EQ(world->set_joint_limits(servo, ingot::HingeJoint{-1, 1}.operator ingot::Joint().limits), Status::not_in_scene);
    EXPECT_EQ(world->set_joint_length(servo, 1), Status::not_in_scene);
    EXPECT_EQ(world->joint_angle(ball).status, Status::not_in_scene);
    EXPECT_EQ(world->joint_angle(servo, 1).status, Status::not_in_scene);
    EXPECT_EQ(world->joint_travel(servo).status, Status::not_in_scene);
    EXPECT_EQ(world->set_joint_drive({}, ingot::SpringDrive{1}), Status::stale_id);
    EXPECT_EQ(world->joint_gap(servo).value, 0);
    EXPECT_TRUE(std::memcmp(&before, world.get(), sizeof before) == 0);
    for (int i = 0; i < 4; ++i) ASSERT_TRUE(add_joint(*world, ingot::ServoJoint{}, A, B, z).ok());
    const HallWorld full = *world;
    EXPECT_EQ(add_joint(*world, ingot::ServoJoint{}, A, B, z).status, Status::no_room);  // max_loops
    EXPECT_TRUE(std::memcmp(&full, world.get(), sizeof full) == 0);
}

/// A servo makes one island of its two bodies: they sleep and wake as one, and a target that moves keeps them awake.
TEST(Servos, join_who_sleeps) {
    const auto world = std::make_unique<HallWorld>();
    ASSERT_TRUE(weigh(*world));
    ASSERT_TRUE(add_ground(*world));
    const auto add_box = [&](double x) {
        ingot::BodyDef def;
        def.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, {scalar(0.5), scalar(0.5), scalar(0.5)}), 10)).value;
        def.shape = ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.5)}};
        def.state.r_CM = {number(x), 0, scalar(0.5)};
        return world->add(def).value;
    };
    const ingot::BodyId A = add_box(0), B = add_box(4), C = add_box(8);
    const ingot::JointId servo = add_joint(*world, ingot::ServoJoint{}, A, B, {0, 0, 1}).value;
    ASSERT_EQ(world->set_joint_drive(servo, ingot::SpringDrive{10, 1}), Status::ok);
    for (int i = 0; i < 120; ++i) (void)ingot::step(*world, scalar(1) / 60);
    EXPECT_TRUE(world->is_asleep(A) && world->is_asleep(B) && world->is_asleep(C));
    EXPECT_EQ(world->asleep_island_count(), 2);
    ASSERT_EQ(world->set_joint_target(servo, scalar(0.1)), Status::ok);
    (void)ingot::step(*world, scalar(1) / 60);
    EXPECT_FALSE(world->is_asleep(A) || world->is_asleep(B));
    EXPECT_TRUE(world->is_asleep(C));
    ASSERT_EQ(world->set_joint_target(servo, 0, scalar(0.01)), Status::ok);
    for (int i = 0; i < 120; ++i) (void)ingot::step(*world, scalar(1) / 60);
    EXPECT_FALSE(world->is_asleep(B));
    ASSERT_EQ(world->set_joint_target(servo, 0), Status::ok);
    for (int i = 0; i < 240; ++i) (void)ingot::step(*world, scalar(1) / 60);
    EXPECT_TRUE(world->is_asleep(B));
    ASSERT_EQ(world->remove(A), Status::ok);  // takes the servo along
    EXPECT_FALSE(world->is_alive(servo));
    (void)ingot::step(*world, scalar(1) / 60);
}

/// A snapshot taken as servos are at work goes on to the same bits; damaged ones are refused or go on.
TEST(Servos, go_on_from_a_snapshot) {
    RandomInput random(6);
    for (int run_i = 0; run_i < ingot_reference::draws(12); ++run_i) {
        const auto world = std::make_unique<HallWorld>(), other = std::make_unique<HallWorld>();
        ASSERT_TRUE(weigh(*world));
        ASSERT_TRUE(add_ground(*world));
        Built built;
        add_figure(*world, random, {5, 0.2, 10, 1, false}, {0, 0, 1}, built);
        const ingot::JointId servo = add_joint(*world, ingot::ServoJoint{}, built.bodies[1], built.bodies[0], random.direction()).value;
        const ingot::JointId ball = add_joint(*world, ingot::BallServoJoint{}, built.bodies[2], built.bodies[3], random.direction()).value;
        ASSERT_EQ(world->set_joint_drive(servo, ingot::SpringDrive{300, 30, 1, scalar(0.5), 0, 20}), Status::ok);
        ASSERT_EQ(world->set_ball_drive(ball, ingot::TunedDrive{3, 1}, {1, 0, 0}, {0, 1, 0}), Status::ok);
        for (int i = 0; i < 30; ++i) (void)ingot::step(*world, scalar(1) / 60);
        std::vector<uint8_t> bytes(ingot::snapshot_size<Hall>());
        bytes.resize(ingot::save_snapshot(*world, bytes.data(), bytes.size()).value);
        ASSERT_EQ(ingot::load_snapshot(*other, bytes.data(), bytes.size()), Status::ok);
        for (int i = 0; i < 60; ++i) {
            (void)ingot::step(*world, scalar(1) / 60);
            (void)ingot::step(*other, scalar(1) / 60);
        }
        EXPECT_EQ(world->state_hash(), other->state_hash()) << run_i;
        EXPECT_EQ(world->drive_torque(servo).value, other->drive_torque(servo).value);
    }
}

}  // namespace

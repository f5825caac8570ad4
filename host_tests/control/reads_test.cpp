// SPDX-License-Identifier: MIT
// What controllers read between two steps: turns of ball joints, loads of contacts.
#include <gtest/gtest.h>

#include <memory>

#include "control/drawn_figure.h"
#include "reference/draws.h"

namespace {

using namespace ingot_control;
using ingot::scalar;
using ingot::Status;
using ingot_reference::draws;
using ingot_reference::to_eigen;

constexpr double eps = static_cast<double>(ingot::epsilon);

struct Hanging : ingot::Scene {
    static constexpr int max_bodies = 2, max_joints = 1;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::WithLimits, ingot::WithDrives>;
};

Matrix3d rotation_by(const Vector3d& turn) { return Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix(); }

ingot::BodyDef body_at(const Matrix3d& A, const Vector3d& spin) {
    const Vector3d I(1, 2, 2.5);
    ingot::BodyDef def = ingot_reference::definition(3, I);
    def.state.A = ingot_reference::to_matrix(A);
    def.state.L = to_vector(Vector3d(A * I.cwiseProduct(A.transpose() * spin)));
    return def;
}

}  // namespace

/// B is turned by a vector in the axes of A, as they stand then; the world may be either.
TEST(BallJoints, tell_their_turn) {
    RandomInput random(1);
    for (int run_i = 0; run_i < draws(100); ++run_i) {
        const auto world = std::make_unique<ingot::World<Hanging>>();
        const bool of_world = run_i % 3 == 0;
        const Matrix3d A_before = of_world ? Matrix3d(Matrix3d::Identity()) : random.rotation(), B_before = random.rotation();
        const Matrix3d A = of_world ? A_before : random.rotation();
        const Vector3d turn = random.direction() * random.real(0.01, 3.1), spin_A = of_world ? Vector3d(0, 0, 0) : random.vector(3),
                       spin_B = random.vector(3);
        ingot::JointDef def;
        if (!of_world) def.body_A = world->add(body_at(A_before, {0, 0, 0})).value;
        def.body_B = world->add(body_at(B_before, {0, 0, 0})).value;
        def.joint = ingot::BallJoint{};
        def.axis = to_vector(random.direction());
        const ingot::JointId id = world->add_joint(def).value;
        EXPECT_LE(to_eigen(world->ball_turn(id).value).norm(), 16 * eps);
        if (!of_world) {
            EXPECT_EQ(world->set_state(def.body_A, body_at(A, spin_A).state), Status::ok);
        }
        const Matrix3d B = A * rotation_by(turn) * A_before.transpose() * B_before;
        EXPECT_EQ(world->set_state(def.body_B, body_at(B, spin_B).state), Status::ok);
        // Near half a turn a rounding of the matrix turns the axis by as much over the sine of the half angle, which is above a half.
        EXPECT_LE((to_eigen(world->ball_turn(id).value) - turn).norm(), 64 * eps);
        EXPECT_LE((to_eigen(world->ball_rate(id).value) - A.transpose() * (spin_B - spin_A)).norm(), 64 * eps * (spin_A.norm() + spin_B.norm()));
    }
}

TEST(BallJoints, alone_tell_it) {
    const auto world = std::make_unique<ingot::World<Hanging>>();
    ingot::JointDef def;
    def.body_B = world->add(body_at(Matrix3d::Identity(), {0, 0, 0})).value;
    def.joint = ingot::HingeJoint{};
    const ingot::JointId id = world->add_joint(def).value;
    EXPECT_EQ(world->ball_turn(id).status, Status::not_in_scene);
    EXPECT_EQ(world->ball_rate(id).status, Status::not_in_scene);
    EXPECT_EQ(world->ball_turn({}).status, Status::stale_id);
}

namespace {

struct Slope : ingot::Scene {
    static constexpr int max_bodies = 4, max_manifolds = 8;
    static constexpr bool translates = true, reads_contacts = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};

}  // namespace

/// What rests on a slope is borne: its weight, by a force below its centre of mass.
TEST(Contacts, bear_what_rests_on_a_slope) {
    RandomInput random(2);
    for (int run_i = 0; run_i < draws(24); ++run_i) {
        const auto world = std::make_unique<ingot::World<Slope>>();
        const double g = 9.81, h = 1.0 / 60, M = random.real(1, 50), tilt = random.real(0, 0.3);
        ASSERT_EQ(world->set_gravity({0, 0, static_cast<scalar>(-g)}), Status::ok);
        const Vector3d n(std::sin(tilt), 0, std::cos(tilt)), half(random.real(0.2, 0.5), random.real(0.2, 0.5), random.real(0.1, 0.2));
        ingot::BodyDef ground;
        ground.immovable = true;
        ground.shape = ingot::HalfSpace{to_vector(n), 0};
        ground.friction = scalar(0.8);
        const ingot::BodyId under = world->add(ground).value;
        const Vector3d sides = half.cwiseProduct(half);
        ingot::BodyDef box =
            ingot_reference::definition(M, Vector3d(M / 3 * Vector3d(sides.y() + sides.z(), sides.z() + sides.x(), sides.x() + sides.y())));
        box.shape = ingot::Box{to_vector(half)};
        box.friction = scalar(0.8);
        box.state.A = ingot_reference::to_matrix(Eigen::AngleAxisd(tilt, Vector3d::UnitY()).toRotationMatrix());
        box.state.r_CM = to_vector(Vector3d(half.z() * n));
        const ingot::BodyId id = world->add(box).value;
        for (int step_i = 0; step_i < 60; ++step_i) (void)ingot::step(*world, static_cast<scalar>(h));
        // A substep, one of four, is swept until nothing changes by more than a settled speed, of the four points each.
        const double share = 16 * static_cast<double>(ingot::limits::settled_speed) / (g * h);
        const ingot::ContactSum sum = world->contact_sum(id).value, against = world->contact_sum(under).value;
        const Vector3d weight(0, 0, M * g * h), r = to_eigen(world->state(id).value.r_CM), P = to_eigen(sum.P);
        EXPECT_EQ(sum.contact_count, 1);
        EXPECT_LE((to_eigen(sum.j) - weight).norm(), share * weight.norm());
        EXPECT_NEAR(static_cast<double>(sum.j_normal), weight.dot(n), share * weight.norm());
        EXPECT_LE(Eigen::Vector2d(P.x() - r.x(), P.y() - r.y()).norm(), share * half.norm());
        EXPECT_EQ(to_eigen(against.j), Vector3d(-to_eigen(sum.j)));
        EXPECT_EQ(to_eigen(against.P), P);
    }
}

TEST(Contacts, of_what_touches_nothing_give_nothing) {
    const auto world = std::make_unique<ingot::World<Slope>>();
    ingot::BodyDef ball = ingot_reference::definition(1, Vector3d(1, 1, 1));
    ball.shape = ingot::Sphere{1};
    const ingot::BodyId id = world->add(ball).value;
    (void)ingot::step(*world, scalar(1) / 60);
    const ingot::ContactSum sum = world->contact_sum(id).value;
    EXPECT_EQ(sum.contact_count, 0);
    EXPECT_EQ(sum.j_normal, 0);
    EXPECT_EQ(to_eigen(sum.P), Vector3d(0, 0, 0));
    EXPECT_EQ(world->contact_sum({}).status, Status::stale_id);
}

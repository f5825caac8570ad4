// SPDX-License-Identifier: MIT
// The user's frame and the body's are two descriptions of one motion.
//
// Tolerances count roundings, u = epsilon / 2 each, relative to the sum of the magnitudes of the terms: a turn of a vector is 3
// roundings relative to its length times sqrt 3, A_principal is orthonormal to 8 u.
#include <ingot/body/user_frame.h>
#include <ingot/ingot.h>

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

#include "reference/kernel_types.h"
#include "reference/measure.h"
#include "reference/random_input.h"

namespace {

using ingot::BodyState;
using ingot::MassDistribution;
using ingot::MassProperties;
using ingot::scalar;
using ingot::Status;
using ingot::UserMotion;
using ingot::UserPose;
using ingot::Vector;
using ingot_reference::RandomInput;
using ingot_reference::to_eigen;
using ingot_reference::to_matrix;
using ingot_reference::to_vector;
using Real = long double;
using Matrix3 = Eigen::Matrix<Real, 3, 3>;
using Vector3 = Eigen::Matrix<Real, 3, 1>;

Real gamma(int roundings) { return ingot_reference::gamma<scalar>(roundings); }

template <class A, class B>
Real difference(const A& a, const B& b) {
    return (to_eigen<Real>(a) - to_eigen<Real>(b)).cwiseAbs().maxCoeff();
}

Real norm(const Vector& v) { return to_eigen<Real>(v).norm(); }

/// A box beside the origin of its user's frame and askew in it, placed and spun in the world.
struct Case {
    MassDistribution solid;
    MassProperties mass;
    UserPose pose;
    UserMotion motion;
    BodyState state;
};

Case random_case(RandomInput& random) {
    const auto size = [&] { return static_cast<scalar>(random.real(0.5, 2)); };
    Case c{};
    const Vector half_extents = {size(), size(), size()};
    const ingot::Matrix A = to_matrix(random.rotation());
    c.solid = ingot::placed(ingot::solid_box(size(), half_extents), A, to_vector(random.vector(4)));
    c.mass = ingot::principal(c.solid).value;
    c.pose = {to_vector(random.vector(10)), to_matrix(random.rotation())};
    c.motion = {to_vector(random.vector(10)), to_vector(random.vector(10))};
    c.state = ingot::body_state(c.mass, c.pose, c.motion);
    return c;
}

constexpr int many = 5000;

TEST(UserFrame, is_where_it_was_put) {
    RandomInput random(1);
    for (int i = 0; i < many; ++i) {
        const Case c = random_case(random);
        const UserPose back = ingot::user_pose(c.mass, c.state);
        // Two products of rotations, and A_principal is no rotation to 8 u.
        EXPECT_LE(difference(back.A, c.pose.A), gamma(2 * 3 + 8) * std::sqrt(3.0L));
        EXPECT_LE(difference(back.r, c.pose.r), gamma(2 * 3 + 8 + 6) * std::sqrt(3.0L) * (norm(c.pose.r) + norm(c.mass.r_CM)));
    }
}

TEST(UserFrame, moves_as_it_was_told) {
    RandomInput random(2);
    for (int i = 0; i < many; ++i) {
        const Case c = random_case(random);
        const UserMotion back = ingot::user_motion(c.mass, c.state);
        // omega goes to L and back: four turns, two of them with an A that is off by 14 u, and L is rounded relative to its
        // largest component, whose moment may be this much larger than another.
        const Vector3 I = to_eigen<Real>(c.mass.I_body);
        const Real spread = I.maxCoeff() / I.minCoeff(), omega = norm(c.motion.omega);
        const Real omega_bound = gamma(4 * 3 + 2 * 14 + 2) * std::sqrt(3.0L) * spread * omega;
        EXPECT_LE(difference(back.omega, c.motion.omega), omega_bound);
        EXPECT_LE(difference(back.v, c.motion.v),
                  omega_bound * 2 * norm(c.mass.r_CM) + gamma(40) * (norm(c.motion.v) + omega * norm(c.mass.r_CM)));
    }
}

TEST(UserFrame, points_of_the_model_are_points_of_the_body) {
    RandomInput random(3);
    for (int i = 0; i < many; ++i) {
        const Case c = random_case(random);
        // A point of the model, seen from the body frame by definition of MassProperties.
        const Vector p = to_vector(random.vector(4)), p_body = ingot::transpose_times(c.mass.A_principal, p - c.mass.r_CM);
        const Vector by_user = ingot::point_position(c.pose.r, c.pose.A, p);
        const Vector by_body = ingot::point_position(c.state.r_CM, c.state.A, p_body);
        const Real reach = norm(c.pose.r) + norm(p) + norm(c.mass.r_CM);
        EXPECT_LE(difference(by_user, by_body), gamma(5 * 4 + 8) * std::sqrt(3.0L) * 2 * reach)
            << "five turns of four roundings";
        const Vector v_user = ingot::point_velocity(c.motion.v, c.motion.omega, by_user - c.pose.r);
        const Vector v_body = ingot::point_velocity(c.state.v_CM, c.motion.omega, by_body - c.state.r_CM);
        EXPECT_LE(difference(v_user, v_body),
                  gamma(5 * 4 + 8 + 8) * std::sqrt(3.0L) * 4 * (norm(c.motion.v) + norm(c.motion.omega) * reach));
    }
}

TEST(UserFrame, angular_momentum_is_that_of_the_tensor_in_the_user_s_axes) {
    RandomInput random(4);
    for (int i = 0; i < many; ++i) {
        const Case c = random_case(random);
        const Matrix3 A = to_eigen<Real>(c.pose.A), I = to_eigen<Real>(c.solid.I);
        const Vector3 L = A * I * A.transpose() * to_eigen<Real>(c.motion.omega);
        // The tensor is off by 50 u of its largest moment (principal_axes); two turns follow.
        EXPECT_LE((to_eigen<Real>(c.state.L) - L).norm(),
                  3 * gamma(50 + 2 * 14 + 7) * to_eigen<Real>(c.mass.I_body).maxCoeff() * norm(c.motion.omega));
    }
}

TEST(UserFrame, kinetic_energy_is_that_of_the_tensor_about_the_user_s_origin) {
    RandomInput random(5);
    for (int i = 0; i < many; ++i) {
        Case c = random_case(random);
        c.motion.v = {};
        c.state = ingot::body_state(c.mass, c.pose, c.motion);
        const Vector3 w = to_eigen<Real>(c.pose.A).transpose() * to_eigen<Real>(c.motion.omega);
        const Matrix3 I = to_eigen<Real>(ingot::inertia_about(c.solid, {}));
        const Real expected = w.dot(I * w) / 2;
        const Real M = static_cast<Real>(c.mass.M), v_sq = to_eigen<Real>(c.state.v_CM).squaredNorm();
        const Real T = (M * v_sq + to_eigen<Real>(c.state.L).dot(to_eigen<Real>(c.motion.omega))) / 2;
        EXPECT_LE(std::abs(T - expected), 3 * gamma(50 + 2 * 14 + 7 + 12) * I.trace() * w.squaredNorm() / 2);
    }
}

TEST(UserFrame, of_a_solid_along_its_own_axes_is_the_body_frame_to_the_bit) {
    RandomInput random(6);
    const MassProperties mass = ingot::principal(ingot::solid_box(1, {1, 2, 3})).value;
    for (int i = 0; i < many; ++i) {
        const UserPose pose = {to_vector(random.vector(10)), to_matrix(random.rotation())};
        const BodyState state = ingot::body_state(mass, pose);
        EXPECT_EQ(to_eigen(state.r_CM), to_eigen(pose.r));
        EXPECT_EQ(to_eigen(state.A), to_eigen(pose.A));
        EXPECT_EQ(to_eigen(state.v_CM), Eigen::Vector3d::Zero());
        EXPECT_EQ(to_eigen(state.L), Eigen::Vector3d::Zero());
    }
}

struct OneBody : ingot::Scene {
    static constexpr bool translates = true;
};

TEST(UserFrame, of_a_body_in_a_world_flies_as_its_points_do) {
    RandomInput random(7);
    for (int i = 0; i < 50; ++i) {
        const Case c = random_case(random);
        ingot::World<OneBody> world;
        ingot::BodyDef def;
        def.mass = c.mass;
        def.state = c.state;
        const ingot::Result<ingot::BodyId> id = world.add(def);
        ASSERT_EQ(id.status, Status::ok);
        const BodyState added = world.state(id.value).value;
        // The world makes A orthonormal: it moves by no more than it was off, 14 u.
        const UserPose at_start = ingot::user_pose(c.mass, added);
        EXPECT_LE(difference(at_start.A, c.pose.A), gamma(2 * 14 + 6) * std::sqrt(3.0L));

        const scalar h = scalar(1) / 256;
        ASSERT_TRUE(ingot::step(world, h).clean());
        const UserPose at_end = ingot::user_pose(c.mass, world.state(id.value).value);
        // The velocity of the user's origin is v and changes by the acceleration of a turn about a centre within |r_CM| and, as
        // omega itself changes, by I^-1 (L x omega): both below twice the spread of the moments times omega^2 |r_CM|.
        const Vector3 I = to_eigen<Real>(c.mass.I_body);
        const Real omega = norm(c.motion.omega), a = (1 + I.maxCoeff() / I.minCoeff()) * omega * omega * norm(c.mass.r_CM);
        const Vector3 moved =
            to_eigen<Real>(at_end.r) - to_eigen<Real>(at_start.r) - to_eigen<Real>(c.motion.v) * static_cast<Real>(h);
        EXPECT_LE(moved.norm(),
                  a * static_cast<Real>(h) * static_cast<Real>(h) + gamma(100) * (norm(c.pose.r) + norm(c.mass.r_CM)));
    }
}

TEST(UserFrame, of_an_immovable_body_needs_no_mass) {
    const MassProperties none{};
    const UserPose pose = {{1, 2, 3}, ingot::axis_angle({0, 0, 1}, 1)};
    const BodyState state = ingot::body_state(none, pose);
    EXPECT_EQ(to_eigen(state.r_CM), to_eigen(pose.r));
    EXPECT_EQ(to_eigen(state.A), to_eigen(pose.A));
    const UserMotion motion = ingot::user_motion(none, state);
    EXPECT_EQ(to_eigen(motion.v), Eigen::Vector3d::Zero());
    EXPECT_EQ(to_eigen(motion.omega), Eigen::Vector3d::Zero());

    ingot::World<OneBody> world;
    ingot::BodyDef def;
    def.immovable = true;
    def.state = state;
    EXPECT_EQ(world.add(def).status, Status::ok);
}

TEST(UserFrame, that_cannot_be_is_refused_by_the_world) {
    const MassProperties mass = ingot::principal(ingot::solid_box(1, {1, 2, 3})).value;
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN();
    const auto status = [&](const UserPose& pose, const UserMotion& motion) {
        ingot::World<OneBody> world;
        ingot::BodyDef def;
        def.mass = mass;
        def.state = ingot::body_state(mass, pose, motion);
        return world.add(def).status;
    };
    const ingot::Matrix upright = ingot::identity_matrix<scalar>(), mirror = {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    EXPECT_EQ(status({{}, upright}, {}), Status::ok);
    EXPECT_EQ(status({{nan, 0, 0}, upright}, {}), Status::not_finite);
    EXPECT_EQ(status({{}, upright * nan}, {}), Status::not_finite);
    EXPECT_EQ(status({{}, mirror}, {}), Status::not_a_rotation);
    EXPECT_EQ(status({{}, upright * scalar(2)}, {}), Status::not_a_rotation);
    EXPECT_EQ(status({{}, upright}, {{nan, 0, 0}, {}}), Status::not_finite);
    EXPECT_EQ(status({{}, upright}, {{}, {0, nan, 0}}), Status::not_finite);
    EXPECT_EQ(status({{}, upright}, {{}, {0, 2 * ingot::limits::spin_max, 0}}), Status::out_of_range);
    EXPECT_EQ(status({{0, 2 * ingot::limits::position_max, 0}, upright}, {}), Status::out_of_range);
}

/// Half of an ulp times the roundings of: two quaternions (9 a component), weights of slerp (43 in float, 72 in double) that sum to 1.42, a product
/// and a sum; all of it doubled, for a turn has twice the angle of its quaternion, along four components; and 17 of the matrix.
Real gamma_of_turn() { return gamma(2 * 2 * static_cast<int>(1.42 * (9 + 16 + ingot::limits::slerp_terms_max) + 2) + 17); }

TEST(Interpolated, is_exact_at_both_ends_and_beyond) {
    RandomInput random(8);
    for (int i = 0; i < many; ++i) {
        const BodyState from = random_case(random).state, to = random_case(random).state;
        for (const scalar fraction : {scalar(0), scalar(-1), -std::numeric_limits<scalar>::infinity(), std::numeric_limits<scalar>::quiet_NaN()})
            EXPECT_EQ(std::memcmp(&from, std::data({ingot::interpolated(from, to, fraction)}), sizeof from), 0);
        for (const scalar fraction : {scalar(1), scalar(2), std::numeric_limits<scalar>::infinity()})
            EXPECT_EQ(std::memcmp(&to, std::data({ingot::interpolated(from, to, fraction)}), sizeof to), 0);
    }
}

TEST(Interpolated, goes_along_a_line_and_about_an_axis) {
    RandomInput random(9);
    for (int i = 0; i < many; ++i) {
        const BodyState from = random_case(random).state;
        const Vector n = to_vector(random.direction());
        const double angle = random.real(-3, 3), t = static_cast<double>(static_cast<scalar>(random.real(0, 1)));
        const Matrix3 turn = Eigen::AngleAxis<Real>(static_cast<Real>(angle), to_eigen<Real>(n).normalized()).toRotationMatrix();
        BodyState to = random_case(random).state;
        to.A = to_matrix(Matrix3(turn * to_eigen<Real>(from.A)));
        const BodyState between = ingot::interpolated(from, to, static_cast<scalar>(t));
        const Matrix3 part = Eigen::AngleAxis<Real>(static_cast<Real>(angle * t), to_eigen<Real>(n).normalized()).toRotationMatrix();
        // from.A is a rotation to 14 u an entry, to.A to 15: each turns its quaternion by no more.
        EXPECT_LE(difference(between.A, to_matrix(Matrix3(part * to_eigen<Real>(from.A)))), gamma_of_turn() + gamma(2 * (14 + 15) + 1));
        EXPECT_LE((to_eigen<Real>(between.A).transpose() * to_eigen<Real>(between.A) - Matrix3::Identity()).cwiseAbs().maxCoeff(), gamma(2 * 2 * 17));
        // 1 - t, two products and a sum.
        const auto line = [t](const Vector& a, const Vector& b) { return Vector3((1 - Real(t)) * to_eigen<Real>(a) + Real(t) * to_eigen<Real>(b)); };
        EXPECT_LE((to_eigen<Real>(between.r_CM) - line(from.r_CM, to.r_CM)).norm(), gamma(4) * (norm(from.r_CM) + norm(to.r_CM)));
        EXPECT_LE((to_eigen<Real>(between.v_CM) - line(from.v_CM, to.v_CM)).norm(), gamma(4) * (norm(from.v_CM) + norm(to.v_CM)));
        EXPECT_LE((to_eigen<Real>(between.L) - line(from.L, to.L)).norm(), gamma(4) * (norm(from.L) + norm(to.L)));
        const UserPose pose = ingot::interpolated(UserPose{from.r_CM, from.A}, UserPose{to.r_CM, to.A}, static_cast<scalar>(t));
        EXPECT_EQ(to_eigen(pose.A), to_eigen(between.A));
        EXPECT_EQ(to_eigen(pose.r), to_eigen(between.r_CM));
    }
}

struct OneBall : OneBody {
    using rotation = ingot::SymmetricTop;  // in closed form
};

TEST(Interpolated, of_a_ball_that_flies_freely_is_the_state_of_half_a_step) {
    RandomInput random(10);
    for (int i = 0; i < 200; ++i) {
        ingot::World<OneBall> whole, half;
        ingot::BodyDef def;
        def.mass = ingot::principal(ingot::solid_sphere(1, 1)).value;
        def.state = ingot::body_state(def.mass, {to_vector(random.vector(1)), to_matrix(random.rotation())},
                                      {to_vector(random.vector(10)), to_vector(random.vector(20))});
        const ingot::BodyId id = whole.add(def).value;
        (void)half.add(def);
        const scalar h = scalar(1) / 64;
        const BodyState from = whole.state(id).value;
        ASSERT_TRUE(ingot::step(whole, h).clean());
        ASSERT_TRUE(ingot::step(half, h / 2).clean());
        const BodyState drawn = ingot::interpolated(from, whole.state(id).value, scalar(0.5)), there = half.state(id).value;
        // The world makes A orthonormal, 14 u, and turns it by sines and cosines of 1 ulp, 12 u as AxisAngle and 4 u of the product; in two worlds.
        EXPECT_LE(difference(drawn.A, there.A), gamma_of_turn() + gamma(2 * (14 + 12 + 4)));
        EXPECT_LE(difference(drawn.r_CM, there.r_CM), gamma(8) * (norm(from.r_CM) + norm(there.r_CM)));
    }
}

constexpr MassProperties beside = {2, {1, 2, 3}, {1, 0, 0}, ingot::identity_matrix<scalar>()};
constexpr BodyState spun = ingot::body_state(beside, {{0, 0, 5}, ingot::identity_matrix<scalar>()}, {{}, {0, 0, 4}});
static_assert(spun.r_CM.x == 1 && spun.r_CM.z == 5, "the centre of mass lies beside the user's origin");
static_assert(spun.v_CM.y == 4 && spun.L.z == 12, "and circles it");
static_assert(ingot::user_pose(beside, spun).r.z == 5 && ingot::user_motion(beside, spun).v.y == 0, "and back");

}  // namespace

// SPDX-License-Identifier: MIT
// Sums that keep what their roundings take off: the laws of motion at high rates, float or double. Each bound is in roundings of the
// whole way: an increment that is the same in every step rounds the same way in every step, in its product with h and in what it is made of.
#include <ingot/ingot.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/kernel_types.h"
#include "reference/measure.h"
#include "reference/random_input.h"

namespace {

using namespace ingot;
using ingot_reference::RandomInput;
using ingot_reference::to_eigen;
using ingot_reference::to_matrix;
using ingot_reference::to_vector;
using Column = Eigen::Matrix<long double, 3, 1>;
using Square = Eigen::Matrix<long double, 3, 3>;

constexpr double u = static_cast<double>(ingot_reference::roundoff<scalar>);

struct Summed : Scene {
    static constexpr int max_bodies = 5;
    static constexpr bool translates = true, compensated_sums = true;
};
struct Turning : Scene {
    static constexpr bool compensated_sums = true;
};
struct Rolling : Summed {
    static constexpr int max_manifolds = 8;
    using shapes = Shapes<Sphere, HalfSpace>;
};
struct Resting : Rolling {
    static constexpr bool sleeps = true;
};

BodyDef body_of(const Eigen::Vector3d& moments) { return ingot_reference::definition(1, moments); }

const std::vector<double> rates = {30, 60, 250, 500, 1000};

/// A constant torque about a principal axis turns by tau t^2 / (2 I). Of the angle: two roundings of tau h, one of its sum, two of the inverse
/// moment, three of the turn of a step; and those of A at the end. At 6 rad/s and 30 Hz the method itself is still right to rounding.
TEST(CompensatedSums, constant_torque_at_every_rate) {
    RandomInput random(151);
    for (const double rate : rates) {
        World<Turning> world{};
        const Eigen::Vector3d moments = random.moments(12);
        const scalar tau = static_cast<scalar>(random.real(0.25, 0.5) * moments.z()), h = static_cast<scalar>(1 / rate);
        const BodyId id = world.add(body_of(moments)).value;
        const int steps = static_cast<int>(12 * rate);
        for (int step_i = 0; step_i < steps; ++step_i) {
            ASSERT_EQ(world.add_torque(id, {0, 0, tau}), Status::ok);
            ASSERT_TRUE(step(world, h).clean());
        }
        const long double t = static_cast<long double>(h) * steps, I_z = static_cast<long double>(to_vector(moments).z);
        const long double angle = static_cast<long double>(tau) * t * t / (2 * I_z);
        const Square expected = Eigen::AngleAxis<long double>(angle, Column::UnitZ()).toRotationMatrix();
        const double error = ingot_reference::attitude_error(to_eigen<long double>(world.state(id).value.A), expected);
        std::printf("    %4.0f Hz: %.1e rad of %.0f\n", rate, error, static_cast<double>(angle));
        EXPECT_LE(error, u * (8 * static_cast<double>(angle) + 8)) << rate;
    }
}

/// Thrown: v = v_0 + g t, r = r_0 + v_0 t + g t^2 / 2, to two roundings of an increment and one of its sum, of the whole way. In r there are those
/// of v as well.
TEST(CompensatedSums, a_throw_at_every_rate) {
    RandomInput random(152);
    for (const double rate : rates) {
        World<Summed> world{};
        const Vector g = {0, 0, scalar(-9.81)};
        ASSERT_EQ(world.set_gravity(g), Status::ok);
        BodyDef def = body_of({1, 2, 3});
        def.state.v_CM = to_vector(random.vector(40));
        def.state.r_CM = to_vector(random.vector(10));
        const BodyId id = world.add(def).value;
        const scalar h = static_cast<scalar>(1 / rate);
        const int steps = static_cast<int>(8 * rate);
        for (int step_i = 0; step_i < steps; ++step_i) ASSERT_TRUE(step(world, h).clean());
        const long double t = static_cast<long double>(h) * steps;
        const Column v_0 = to_eigen<long double>(def.state.v_CM), v = v_0 + to_eigen<long double>(g) * t;
        const Column r = to_eigen<long double>(def.state.r_CM) + (v_0 + v) * (t / 2);
        const double v_way = static_cast<double>(v.norm() + 9.81L * t), r_way = static_cast<double>(r.norm() + (v_0.norm() + 9.81L * t) * t);
        const BodyState state = world.state(id).value;
        const double v_error = static_cast<double>((to_eigen<long double>(state.v_CM) - v).norm());
        const double r_error = static_cast<double>((to_eigen<long double>(state.r_CM) - r).norm());
        std::printf("    %4.0f Hz: v %.1e of %.0f m/s, r %.1e of %.0f m\n", rate, v_error, v_way, r_error, r_way);
        EXPECT_LE(v_error, 3 * u * v_way) << rate;
        EXPECT_LE(r_error, 6 * u * r_way) << rate;
    }
}

/// A ball that rolls: its way, to the speed that the solver leaves it (4 roundings, and settled_speed in double) and 4 roundings of an increment.
TEST(CompensatedSums, a_ball_rolls_as_far_as_its_speed_says) {
    for (const double rate : rates) {
        World<Rolling> world{};
        ASSERT_EQ(world.set_gravity({0, 0, scalar(-9.8125)}), Status::ok);
        BodyDef ground;
        ground.immovable = true;
        ground.shape = HalfSpace{{0, 0, 1}, 0};
        ASSERT_TRUE(world.add(ground).ok());
        const double R = 0.25, I = 0.4 * R * R;
        BodyDef ball = body_of({I, I, I});
        ball.shape = Sphere{scalar(R)};
        ball.friction = scalar(0.5);
        ball.state.r_CM = {0, 0, scalar(R)};
        ball.state.v_CM = {2, 0, 0};
        ball.state.L = {0, scalar(I * 2 / R), 0};
        const BodyId id = world.add(ball).value;
        const scalar h = static_cast<scalar>(1 / rate);
        const int steps = static_cast<int>(8 * rate);
        for (int step_i = 0; step_i < steps; ++step_i) ASSERT_TRUE(step(world, h).clean());
        const double way = 2 * static_cast<double>(h) * steps;
        const double error = std::abs(static_cast<double>(world.state(id).value.r_CM.x) - way);
        std::printf("    %4.0f Hz: %.1e m of %.0f\n", rate, error, way);
        EXPECT_LE(error, 8 * u * way) << rate;
    }
}

/// Each body sums for itself: the same bits alone and beside others, kicked or not.
TEST(CompensatedSums, are_of_each_body) {
    RandomInput random(153);
    std::vector<BodyDef> defs;
    for (int i = 0; i < 5; ++i) {
        defs.push_back(body_of(random.moments(6)));
        defs.back().state.v_CM = to_vector(random.vector(3));
        defs.back().state.L = to_vector(random.vector(2));
    }
    const auto push = [](World<Summed>& world, BodyId id, int i, int step_i) {
        if ((step_i + i) % 3 == 0) return;
        ASSERT_EQ(world.add_torque(id, {scalar(0.1), scalar(0.3), scalar(-0.7)}), Status::ok);
    };
    World<Summed> crowd{};
    std::vector<BodyId> ids;
    for (const BodyDef& def : defs) ids.push_back(crowd.add(def).value);
    for (int step_i = 0; step_i < 500; ++step_i) {
        for (int i = 0; i < 5; ++i) push(crowd, ids[static_cast<std::size_t>(i)], i, step_i);
        ASSERT_TRUE(step(crowd, scalar(0.001)).clean());
    }
    for (std::size_t i = 0; i < 5; ++i) {
        World<Summed> alone{};
        const BodyId id = alone.add(defs[i]).value;
        for (int step_i = 0; step_i < 500; ++step_i) {
            push(alone, id, static_cast<int>(i), step_i);
            ASSERT_TRUE(step(alone, scalar(0.001)).clean());
        }
        const BodyState here = alone.state(id).value, there = crowd.state(ids[i]).value;
        EXPECT_TRUE(to_eigen(here.L) == to_eigen(there.L) && to_eigen(here.A) == to_eigen(there.A) && to_eigen(here.r_CM) == to_eigen(there.r_CM));
    }
}

World<Summed> thrown(BodyId& id) {
    World<Summed> world{};
    EXPECT_EQ(world.set_gravity({0, 0, scalar(-9.81)}), Status::ok);
    BodyDef def = body_of({1, 2, 3});
    def.state.v_CM = {3, 1, 7};
    id = world.add(def).value;
    for (int step_i = 0; step_i < 100; ++step_i) {
        EXPECT_EQ(world.add_torque(id, {scalar(0.1), scalar(0.3), scalar(-0.7)}), Status::ok);
        EXPECT_TRUE(step(world, scalar(0.001)).clean());
    }
    return world;
}

/// Remainders are part of the state: a snapshot goes on to the same bits, and one with more than half a last bit is none of ours.
TEST(CompensatedSums, are_kept_by_snapshots) {
    BodyId id{};
    World<Summed> world = thrown(id), other{};
    std::vector<uint8_t> bytes(snapshot_size<Summed>());
    const Result<size_t> size = save_snapshot(world, bytes.data(), bytes.size());
    ASSERT_TRUE(size.ok());
    ASSERT_EQ(load_snapshot(other, bytes.data(), size.value), Status::ok);
    EXPECT_EQ(other.state_hash(), world.state_hash());
    for (int step_i = 0; step_i < 500; ++step_i) ASSERT_TRUE(step(world, scalar(0.001)).clean() && step(other, scalar(0.001)).clean());
    EXPECT_EQ(other.state_hash(), world.state_hash());

    SavedBody saved{};
    saved.v_CM = {4, 0, 0};
    features::CompensatedSums::OfBody sums;
    sums.v_low = {4 * epsilon, 0, 0};
    EXPECT_TRUE(sums.is_valid<Summed>(saved));
    sums.v_low = {5 * epsilon, 0, 0};
    EXPECT_FALSE(sums.is_valid<Summed>(saved));
    sums.v_low = {0, epsilon * epsilon, 0};
    EXPECT_FALSE(sums.is_valid<Summed>(saved));
}

/// A state that is set has no remainder, even where it is the one that was there; nor has the slot of a body that left.
TEST(CompensatedSums, are_gone_where_a_state_is_set) {
    BodyId id{};
    World<Summed> world = thrown(id);
    const uint64_t before = world.state_hash();
    ASSERT_EQ(world.set_state(id, world.state(id).value), Status::ok);
    EXPECT_NE(world.state_hash(), before);
    const uint64_t after = world.state_hash();
    ASSERT_EQ(world.set_state(id, world.state(id).value), Status::ok);
    EXPECT_EQ(world.state_hash(), after);
    BodyState bad = world.state(id).value;
    bad.v_CM.x = scalar_max;
    EXPECT_NE(world.set_state(id, bad), Status::ok);
    EXPECT_EQ(world.state_hash(), after);
}

/// A body that sleeps beside one that moves keeps its bits.
TEST(CompensatedSums, of_bodies_asleep_stay) {
    World<Resting> world{};
    ASSERT_EQ(world.set_gravity({0, 0, scalar(-9.8125)}), Status::ok);
    BodyDef ground;
    ground.immovable = true;
    ground.shape = HalfSpace{{0, 0, 1}, 0};
    ASSERT_TRUE(world.add(ground).ok());
    BodyDef ball = body_of({0.025, 0.025, 0.025});
    ball.shape = Sphere{scalar(0.25)};
    ball.state.r_CM = {0, 0, scalar(0.25)};
    const BodyId resting = world.add(ball).value;
    ball.state.r_CM = {5, 0, scalar(0.25)};
    ball.state.v_CM = {scalar(0.7), 0, 0};
    ASSERT_TRUE(world.add(ball).ok());
    for (int step_i = 0; step_i < 120; ++step_i) ASSERT_TRUE(step(world, scalar(1) / 60).clean());
    ASSERT_TRUE(world.is_asleep(resting));
    const Vector r = world.state(resting).value.r_CM;
    for (int step_i = 0; step_i < 120; ++step_i) ASSERT_TRUE(step(world, scalar(1) / 60).clean());
    EXPECT_EQ(to_eigen(world.state(resting).value.r_CM), to_eigen(r));
}

}  // namespace

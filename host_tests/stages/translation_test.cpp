// SPDX-License-Identifier: MIT
// integrate_v and integrate_r: exact for constant force, second order for a changing one.
#include <gtest/gtest.h>
#include <ingot/motion/integrate_L.h>
#include <ingot/motion/integrate_r.h>
#include <ingot/motion/integrate_v.h>

#include <cmath>

#include "reference/kernel_types.h"
#include "reference/measure.h"
#include "reference/random_input.h"
#include "tiles.h"

namespace {

using namespace ingot_reference;
using ingot::scalar;
using ingot_stages::Tiles;
using Column = Eigen::Matrix<long double, 3, 1>;

constexpr double u = static_cast<double>(roundoff<scalar>);

struct Slider : ingot::Scene {
    static constexpr int max_bodies = 2;
    static constexpr bool translates = true;
};
using World = ingot::World<Slider>;

/// With binary fractions of few digits nothing is rounded, and the parabola is met bitwise at every step.
TEST(Translation, constant_force_gives_the_parabola_bitwise) {
    World world{};
    ingot::BodyDef def = definition(2, Eigen::Vector3d(1, 1, 1));
    def.state.r_CM = {1, 2, 3};
    def.state.v_CM = {scalar(0.5), -1, 2};
    const ingot::BodyId id = world.add(def).value;
    ASSERT_EQ(world.set_gravity({0, 0, -8}), ingot::Status::ok);
    const scalar h = scalar(1) / 16;
    for (int step_i = 1; step_i <= 64; ++step_i) {
        ASSERT_EQ(world.add_central_force(id, {2, 0, 4}), ingot::Status::ok);  // a = (1, 0, 2) + g
        ASSERT_TRUE(ingot::step(world, h).clean());
        const scalar t = static_cast<scalar>(step_i) * h;
        const ingot::BodyState s = world.state(id).value;
        ASSERT_EQ(to_eigen(s.v_CM), Eigen::Vector3d(0.5 + t, -1, 2 - 6 * t));
        ASSERT_EQ(to_eigen(s.r_CM), Eigen::Vector3d(1 + 0.5 * t + t * t / 2, 2 - t, 3 + 2 * t - 3 * t * t));
    }
}

/// v takes 3 roundings a step of numbers below v_max + h a; r takes 4 of r_max, and h times each of those of v before it.
TEST(Translation, constant_force_gives_the_parabola_to_rounding) {
    RandomInput random(111);
    constexpr int steps = 500;
    for (int i = 0; i < 20; ++i) {
        World world{};
        const double M = random.real(0.1, 10);
        ingot::BodyDef def = definition(M, Eigen::Vector3d(1, 1, 1));
        def.state.r_CM = to_vector(random.vector(10));
        def.state.v_CM = to_vector(random.vector(5));
        const ingot::BodyId id = world.add(def).value;
        const ingot::Vector F = to_vector(random.vector(3)), g = to_vector(random.vector(10));
        ASSERT_EQ(world.set_gravity(g), ingot::Status::ok);
        const scalar h = scalar(1) / 60;
        for (int step_i = 0; step_i < steps; ++step_i) {
            ASSERT_EQ(world.add_central_force(id, F), ingot::Status::ok);
            ASSERT_TRUE(ingot::step(world, h).clean());
        }
        const long double t = steps * static_cast<long double>(h), M_used = static_cast<long double>(def.mass.M);
        const Column a = to_eigen<long double>(F) / M_used + to_eigen<long double>(g);
        const Column r_0 = to_eigen<long double>(def.state.r_CM), v_0 = to_eigen<long double>(def.state.v_CM);
        const ingot::BodyState s = world.state(id).value;
        const double v_max = static_cast<double>(v_0.norm() + a.norm() * t),
                     r_max = length_of(r_0) + v_max * static_cast<double>(t);
        const double v_bound = 3 * u * steps * v_max;
        ASSERT_LE(largest_difference(to_eigen(s.v_CM), Column(v_0 + a * t)), v_bound);
        ASSERT_LE(largest_difference(to_eigen(s.r_CM), Column(r_0 + v_0 * t + a * t * t / 2)),
                  4 * u * steps * r_max + v_bound * static_cast<double>(t));
    }
}

/// Error at t = 2 s of a body pushed by F = M a cos(w t), given at the middle of each step.
double error_of_driven_slider(int steps) {
    constexpr double a = 3, w = 2, t = 2;
    World world{};
    const ingot::BodyId id = world.add(definition(1, Eigen::Vector3d(1, 1, 1))).value;
    const scalar h = static_cast<scalar>(t / steps);
    for (int step_i = 0; step_i < steps; ++step_i) {
        const double middle = (step_i + 0.5) * t / steps;
        EXPECT_EQ(world.add_central_force(id, {static_cast<scalar>(a * std::cos(w * middle)), 0, 0}), ingot::Status::ok);
        EXPECT_TRUE(ingot::step(world, h).clean());
    }
    const double r = static_cast<double>(world.state(id).value.r_CM.x);
    return std::abs(r - a / (w * w) * (1 - std::cos(w * t)));
}

TEST(Translation, changing_force_is_met_with_order_2) {
    const double coarse = error_of_driven_slider(16), fine = error_of_driven_slider(32), finest = error_of_driven_slider(64);
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1);
    EXPECT_NEAR(std::log2(fine / finest), 2, 0.1);
}

/// integrate_r gets v_CM of the end of the step and takes half of what integrate_v added off again.
TEST(Translation, r_follows_the_mean_of_the_velocities) {
    RandomInput random(112);
    Tiles tiles(2 * ingot::lanes + 1);
    const scalar h = scalar(1) / 32;
    const ingot::Vector g = to_vector(random.vector(10));
    std::vector<Column> r, v, F;
    for (int slot = 0; slot <= 2 * ingot::lanes; ++slot) {
        ingot::BodyDef def = definition(2, Eigen::Vector3d(1, 1, 1));
        def.state.r_CM = to_vector(random.vector(3));
        def.state.v_CM = to_vector(random.vector(3));
        tiles.write(slot, def);
        const ingot::Vector push = to_vector(random.vector(5));
        ingot::set_lane(tiles.translation(slot).F_T, slot % ingot::lanes, push);
        r.push_back(to_eigen<long double>(def.state.r_CM));
        v.push_back(to_eigen<long double>(def.state.v_CM));
        F.push_back(to_eigen<long double>(push));
    }
    ingot::integrate_v(tiles.view(), h, g);
    ingot::integrate_r(tiles.view(), h, g);
    for (int slot = 0; slot <= 2 * ingot::lanes; ++slot) {
        const std::size_t i = static_cast<std::size_t>(slot);
        const Column a = F[i] / 2 + to_eigen<long double>(g), dv = a * static_cast<long double>(h);
        const double v_size = static_cast<double>(v[i].norm() + dv.norm());
        EXPECT_LE(largest_difference(to_eigen(tiles.state(slot).v_CM), Column(v[i] + dv)), 3 * u * v_size);
        EXPECT_LE(
            largest_difference(to_eigen(tiles.state(slot).r_CM), Column(r[i] + (v[i] + dv / 2) * static_cast<long double>(h))),
            u * (length_of(r[i]) + 8 * h * v_size));  // the last sum, and the roundings of v_mid
    }
}

TEST(Translation, listing1_moves_with_the_velocity_of_step_n) {
    Tiles tiles(1);
    ingot::BodyDef def = definition(2, Eigen::Vector3d(1, 1, 1));
    def.state.r_CM = {1, 2, 3};
    def.state.v_CM = {4, 8, -2};
    tiles.write(0, def);
    ingot::drift_r(tiles.view(), scalar(0.25));
    EXPECT_EQ(to_eigen(tiles.state(0).r_CM), Eigen::Vector3d(2, 4, 2.5));
    EXPECT_EQ(to_eigen(tiles.state(0).v_CM), Eigen::Vector3d(4, 8, -2));
}

TEST(Translation, immovable_and_empty_lanes_feel_nothing) {
    Tiles tiles(2);
    ingot::BodyDef wall{};
    wall.immovable = true;
    wall.state.r_CM = {1, 2, 3};
    tiles.write(0, wall);
    const ingot::Vector g = {0, 0, -10};
    for (int step_i = 0; step_i < 3; ++step_i) {
        ingot::integrate_v(tiles.view(), scalar(0.25), g);
        ingot::integrate_r(tiles.view(), scalar(0.25), g);
    }
    EXPECT_EQ(to_eigen(tiles.state(0).r_CM), Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(to_eigen(tiles.state(0).v_CM), Eigen::Vector3d(0, 0, 0));
    EXPECT_EQ(to_eigen(tiles.state(1).r_CM), Eigen::Vector3d(0, 0, 0));
    EXPECT_EQ(to_eigen(tiles.state(1).v_CM), Eigen::Vector3d(0, 0, 0));
}

TEST(IntegrateL, adds_the_impulse_of_the_torque_and_tells_free_flight_that_it_ended) {
    Tiles tiles(ingot::lanes + 1);
    for (int slot = 0; slot <= ingot::lanes; ++slot) {
        ingot::BodyDef def = definition(1, Eigen::Vector3d(1, 1, 1));
        def.state.L = {1, 2, 3};
        tiles.write(slot, def);
        tiles.rotation(slot).kicked = 0;
    }
    const int last = ingot::lanes;
    ingot::set_lane(tiles.rotation(last).tau_T, 0, ingot::Vector{4, -8, 0});
    ingot::integrate_L(tiles.view(), scalar(0.25));
    EXPECT_EQ(to_eigen(tiles.state(last).L), Eigen::Vector3d(2, 0, 3));
    EXPECT_EQ(tiles.rotation(last).kicked, 1u);
    EXPECT_EQ(to_eigen(tiles.state(0).L), Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(tiles.rotation(0).kicked, 0u) << "a torque of zero does not end the flight";
    ingot::clear_forces(tiles.view());
    EXPECT_EQ(to_eigen(ingot::lane_of(tiles.rotation(last).tau_T, 0)), Eigen::Vector3d(0, 0, 0));
}

}  // namespace

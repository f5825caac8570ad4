// SPDX-License-Identifier: MIT
// Figures that touch nothing: joints hold, whatever hangs on them and however fast they go, and nothing is made of nothing.
#include <gtest/gtest.h>

#include <memory>

#include "figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;

struct Swinging : ingot::Scene {
    static constexpr int max_bodies = 40, max_joints = 40;
    static constexpr bool translates = true;
    using joints = AllJoints;
};
using SwingingWorld = ingot::World<Swinging>;

double mass_of(const SwingingWorld& world, const Built& built) {
    double M = 0;
    for (const ingot::BodyId id : built.bodies) M += static_cast<double>(world.mass(id).value);
    return M;
}

TEST(Joints, hold_whatever_hangs_on_them) {
    RandomInput random(1);
    for (int run_i = 0; run_i < ingot_reference::draws(160); ++run_i) {
        const double rate = rates[random.integer(0, 4)], ratio = run_i % 2 == 0 ? 1 : 1000;
        const auto world = std::make_unique<SwingingWorld>();
        ASSERT_TRUE(weigh(*world));
        const Drawn drawn = {random.integer(2, 13), random.real(0.3, 1), ratio, random.real(0, 4), random.integer(0, 1) == 1};
        Built built;
        add_figure(*world, random, drawn, {0, 0, 0}, built);
        add_figure(*world, random, drawn, {0, 30, 0}, built);
        ASSERT_TRUE(built.sound);
        for (int step_i = 0; step_i < static_cast<int>(rate); ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean()) << run_i;
            ASSERT_LE(worst_gap(*world, built), held) << run_i << ", " << rate << " Hz, step " << step_i;
        }
    }
}

/// The step is of second order: single steps go up and down by a share of the energy of motion that is no more than (omega h)^2.
TEST(Joints, make_no_energy) {
    RandomInput random(2);
    for (int run_i = 0; run_i < ingot_reference::draws(80); ++run_i) {
        const double rate = rates[random.integer(1, 4)];
        const auto world = std::make_unique<SwingingWorld>();
        ASSERT_TRUE(weigh(*world));
        Built built;
        const Drawn drawn = {random.integer(2, 13), random.real(0.3, 1), run_i % 2 == 0 ? 1.0 : 1000.0, random.real(0, 4), true};
        add_figure(*world, random, drawn, {0, 0, 0}, built);
        const double unit = mass_of(*world, built) * g;
        const double begin = energy_of(*world, built);
        double most = begin;
        for (int step_i = 0; step_i < static_cast<int>(2 * rate); ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
            most = std::max(most, energy_of(*world, built));
        }
        EXPECT_LE(most - begin, 0.01 * (unit + static_cast<double>(world->kinetic_energy()))) << run_i << ", " << rate << " Hz";
    }
}

/// What floats keeps its momentum to rounding, and its angular momentum to what pushes turn.
TEST(Joints, keep_the_momentum_of_what_floats) {
    RandomInput random(3);
    for (int run_i = 0; run_i < ingot_reference::draws(80); ++run_i) {
        const double rate = rates[random.integer(1, 4)];
        const auto world = std::make_unique<SwingingWorld>();
        Built built;
        const Drawn drawn = {random.integer(2, 13), random.real(0.3, 1), run_i % 2 == 0 ? 1.0 : 100.0, random.real(0, 4), false};
        add_figure(*world, random, drawn, {0, 0, 0}, built);
        ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
        const Eigen::Vector3d L = ingot_reference::to_eigen(world->angular_momentum());
        for (int step_i = 0; step_i < static_cast<int>(2 * rate); ++step_i)
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
        const double M = mass_of(*world, built), steps = 2 * rate;
        const double rounding = 64 * std::sqrt(steps) * eps;
        EXPECT_LE(ingot_reference::to_eigen(world->linear_momentum()).norm(), M * 10 * rounding) << run_i;
        EXPECT_LE((ingot_reference::to_eigen(world->angular_momentum()) - L).norm(), (1e-3 + 10 * rounding) * L.norm()) << run_i;
    }
}

/// Alone as beside another, to the bit, in whatever slots.
TEST(Joints, figures_take_no_notice_of_each_other) {
    for (int run_i = 0; run_i < ingot_reference::draws(24); ++run_i) {
        RandomInput first(static_cast<uint64_t>(100 + run_i)), again(static_cast<uint64_t>(100 + run_i)), others(static_cast<uint64_t>(run_i));
        const auto alone = std::make_unique<SwingingWorld>(), beside = std::make_unique<SwingingWorld>();
        const Drawn drawn = {3 + run_i % 9, 0.5, 10, 3, run_i % 2 == 0};
        Built of_alone, of_beside, rest;
        add_figure(*alone, first, drawn, {0, 0, 0}, of_alone);
        add_figure(*beside, others, {5, 0.7, 3, 4, run_i % 3 == 0}, {0, 50, 0}, rest);
        add_figure(*beside, again, drawn, {0, 0, 0}, of_beside);
        add_figure(*beside, others, drawn, {0, -50, 0}, rest);
        ASSERT_TRUE(of_alone.sound && of_beside.sound && rest.sound);
        for (int step_i = 0; step_i < 60; ++step_i) {
            (void)ingot::step(*alone, scalar(1) / 60);
            (void)ingot::step(*beside, scalar(1) / 60);
        }
        ASSERT_TRUE(are_same(*alone, *beside, of_alone.bodies, of_beside.bodies)) << run_i;
    }
}

}  // namespace

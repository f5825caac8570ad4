// SPDX-License-Identifier: MIT
// The arm of six hinges follows paths drawn at random.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "reference/draws.h"
#include "reference/random_input.h"
#include "scenes/driven_arm.h"

namespace {

using ingot::scalar;
using ingot::Status;
using ingot_reference::draws;
using ingot_reference::RandomInput;

constexpr double pi = 3.14159265358979323846;

/// Each joint swings; at 0 all are at rest where the arm is set up.
struct Waves {
    double size[6], frequency[6];  // rad, rad/s

    explicit Waves(RandomInput& random) {
        for (int i = 0; i < 6; ++i) {
            size[i] = random.real(-0.5, 0.5);
            frequency[i] = 2 * pi * random.real(0.3, 1);
        }
    }
    /// size (1 - cos), and its derivatives.
    void at(double t, scenes::PathPoint (&path)[6]) const {
        for (int i = 0; i < 6; ++i) {
            const double w = frequency[i], s = std::sin(w * t), c = std::cos(w * t);
            path[i] = {static_cast<scalar>(size[i] * (1 - c)), static_cast<scalar>(size[i] * w * s), static_cast<scalar>(size[i] * w * w * c)};
        }
    }
};

/// rad, of the worst joint in 3 s.
template <class Control>
double worst_off(const Waves& waves, double rate, const Control& control) {
    const auto world = std::make_unique<ingot::World<scenes::DrivenArm>>();
    scenes::ArmIds ids;
    EXPECT_EQ(scenes::set_up(*world, ids), Status::ok);
    const double h = 1 / rate;
    double worst = 0;
    for (int step_i = 0; step_i < static_cast<int>(3 * rate); ++step_i) {
        EXPECT_EQ(control(*world, ids, step_i * h, h), Status::ok);
        (void)ingot::step(*world, static_cast<scalar>(h));
        scenes::PathPoint path[6];
        waves.at((step_i + 1) * h, path);
        for (int i = 0; i < 6; ++i)
            worst = std::max(worst, std::abs(static_cast<double>(world->joint_angle(ids.hinge[i]).value) - static_cast<double>(path[i].angle)));
    }
    return worst;
}
double off_by_torques(const Waves& waves, double rate) {
    scenes::ComputedTorque torques;
    return worst_off(waves, rate, [&](auto& world, const auto& ids, double t, double) {
        scenes::PathPoint path[6];
        waves.at(t, path);
        return torques.follow(world, ids, path, 10);
    });
}
double off_by_servos(const Waves& waves, double rate) {
    return worst_off(waves, rate, [&](auto& world, const auto& ids, double t, double h) {
        scenes::PathPoint path[6], ahead[6];
        waves.at(t, path);
        waves.at(t + h, ahead);
        return scenes::follow_by_servos(world, ids, path, ahead, static_cast<scalar>(h));
    });
}

}  // namespace

/// The torque of a step is off by about h^2 / 4 of its second derivative, so a joint, in units of its inertia, by that of the path's fourth over the
/// square of the springs' frequency: 6e-4 rad at 60 Hz; a light link at the end of a heavy one feels up to ten times its own. And it gets less as
/// the square of the step, until what is left of the first order shows: the bias is that of rates half a substep old.
TEST(Arm, follows_by_computed_torques) {
    RandomInput random(1);
    double at_30 = 0, at_60 = 0, at_120 = 0;
    for (int run_i = 0; run_i < draws(12); ++run_i) {
        const Waves waves(random);
        EXPECT_LE(off_by_torques(waves, 60), 6e-3);
        const auto add = [&](double& sum, double rate) { sum += std::pow(off_by_torques(waves, rate), 2); };
        add(at_30, 30);
        add(at_60, 60);
        add(at_120, 120);
    }
    EXPECT_GE(std::sqrt(at_30 / at_60), std::pow(2, 1.5));
    EXPECT_GE(std::sqrt(at_60 / at_120), 2);
}

/// At any rate, within what its loads bend it and its targets go along a chord instead of the path.
TEST(Arm, follows_by_stiff_servos) {
    RandomInput random(2);
    for (int run_i = 0; run_i < draws(12); ++run_i) {
        const Waves waves(random);
        for (const double rate : {30.0, 60.0, 240.0}) EXPECT_LE(off_by_servos(waves, rate), 1e-3);
    }
}

// SPDX-License-Identifier: MIT
// The arm of six hinges follows paths drawn at random.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/draws.h"
#include "scenes/arm_paths.h"

namespace {

using ingot_reference::draws;
using ingot_reference::RandomInput;
using scenes::off_by_servos;
using scenes::off_by_torques;
using scenes::Waves;

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

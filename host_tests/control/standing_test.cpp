// SPDX-License-Identifier: MIT
// A biped stands by its ankles: as good as an inverted pendulum whose foot ends can.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "scenes/walker.h"

namespace {

using ingot::scalar;
using ingot::Status;
using scenes::Walker;
using Plane = ingot::World<scenes::WalkingInPlane>;

constexpr double g = 9.81;

struct Standing {
    std::unique_ptr<Plane> world = std::make_unique<Plane>();
    Walker walker;
    scenes::Stand law;
    double M = 0;

    Standing() {
        EXPECT_EQ(scenes::add_ground(*world), Status::ok);
        EXPECT_EQ(scenes::add_walker(*world, {0, 0, 0}, 0, walker), Status::ok);
        M = static_cast<double>(world->figure(walker.trunk).value.mass);
    }
    /// False where it falls.
    bool stands(double seconds, double rate) {
        for (int step_i = 0; step_i < static_cast<int>(seconds * rate); ++step_i) {
            EXPECT_EQ(scenes::stand(*world, walker, law, static_cast<scalar>(M * g)), Status::ok);
            (void)ingot::step(*world, static_cast<scalar>(1 / rate));
            if (scenes::height_of(*world, walker) < scalar(1)) return false;
        }
        return true;
    }
    double height_over_ankles() const {
        return static_cast<double>(world->figure(walker.trunk).value.r_CM.z - scenes::walker_parts::foot.joint_z);
    }
    /// All of it by the same velocity, N s in all.
    void push(double impulse) {
        const ingot::BodyId parts[] = {walker.trunk,    walker.thigh[0], walker.thigh[1], walker.shank[0],
                                       walker.shank[1], walker.foot[0],  walker.foot[1]};
        for (const ingot::BodyId part : parts) {
            const double share = static_cast<double>(world->mass(part).value) / M;
            ASSERT_EQ(world->apply_central_impulse(part, {static_cast<scalar>(impulse * share), 0, 0}), Status::ok);
        }
    }
};

/// It comes to rest, at any rate.
TEST(Standing, is_quiet) {
    for (const double rate : {30.0, 60.0, 240.0}) {
        Standing standing;
        ASSERT_TRUE(standing.stands(8, rate)) << rate << " Hz";
        EXPECT_LE(std::abs(standing.world->figure(standing.walker.trunk).value.v_CM.x), scalar(1e-4)) << rate << " Hz";
    }
}

/// A push that an inverted pendulum survives by the load under its foot alone, m w (where the foot ends less where it stands), it survives by nine
/// tenths: forwards and backwards, at any rate.
TEST(Standing, survives_nine_tenths_of_what_can_be) {
    for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
        if (INGOT_TEST_BRIEF && rate != 60) continue;
        for (const int side : {1, -1}) {
            Standing standing;
            ASSERT_TRUE(standing.stands(4, rate));
            const double w = std::sqrt(g / standing.height_over_ankles());
            const double end = static_cast<double>(side > 0 ? standing.law.toes : standing.law.heel);
            const double bound = standing.M * w * std::abs(end - static_cast<double>(standing.law.middle));
            standing.push(side * 0.9 * bound);
            EXPECT_TRUE(standing.stands(5, rate)) << rate << " Hz, " << side * 0.9 * bound << " N s";
            if (side < 0) continue;  // backwards trunk and knees help
            Standing fallen;
            ASSERT_TRUE(fallen.stands(4, rate));
            fallen.push(1.2 * bound);
            EXPECT_FALSE(fallen.stands(5, rate)) << rate << " Hz: no more than can be";
        }
    }
}

}  // namespace

// SPDX-License-Identifier: MIT
// Arithmetic, cases A1 to A5.
#include "hard_cases/flown_by.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace {

using namespace hard_cases;
using Vector3 = Eigen::Vector3d;

struct Balls : ingot::Scene {
    static constexpr int max_bodies = 3, max_contacts = 6;
    using solver = ingot::FrictionlessImpacts;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;
};

/// 10^-6 and 10^6 kg collide: sums of inverse masses neither overflow nor vanish.
TEST(HardCases, A1_twelve_decades_of_mass) {
    ingot::World<Balls> world{};
    const auto ball = [](double M, double x, double v) {
        ingot::BodyDef def = definition(M, Vector3(1, 1, 1) * (0.1 * M));
        def.state.r_CM = {static_cast<scalar>(x), 0, 0};
        def.state.v_CM = {static_cast<scalar>(v), 0, 0};
        def.shape = ingot::Sphere{scalar(0.5)};
        def.restitution = 1;
        return def;
    };
    const ingot::BodyId light = world.add(ball(1e-6, -0.75, 1)).value, heavy = world.add(ball(1e6, 0.25, -1)).value;
    for (int step_i = 0; step_i < 10; ++step_i) ASSERT_TRUE(ingot::step(world, scalar(1) / 60).clean());
    const double j = 2 * 2 / (1e6 + 1e-6);  // Fig. 4: (1 + e) times 2 m/s over the sum of inverse masses
    EXPECT_NEAR(static_cast<double>(world.state(light).value.v_CM.x), 1 - j * 1e6, 16 * eps);
    EXPECT_NEAR(static_cast<double>(world.state(heavy).value.v_CM.x), -1 + j * 1e-6, 4 * eps);
}

/// A plate of no thickness has I1 + I2 = I3 to rounding, and is taken; moments of zero or less, or beyond a solid's, are refused.
TEST(HardCases, A2_degenerate_inertia) {
    const auto status_of = [](double a, double b, double c) {
        ingot::World<Alone<ingot::MoserVeselov>> world{};
        return world.add(definition(1, Vector3(a, b, c))).status;
    };
    EXPECT_EQ(status_of(1, 2, 3), ingot::Status::ok);
    EXPECT_EQ(status_of(1, 2, 3 * (1 + 2 * eps)), ingot::Status::ok);
    EXPECT_EQ(status_of(1, 1, 0), ingot::Status::bad_inertia);
    EXPECT_EQ(status_of(1, 1, -eps), ingot::Status::bad_inertia);
    EXPECT_EQ(status_of(1, 2, 3.1), ingot::Status::bad_inertia);
    EXPECT_EQ(status_of(1, 1, std::numeric_limits<double>::quiet_NaN()), ingot::Status::not_finite);
    EXPECT_FALSE(ingot::principal(ingot::solid_box(1, {1, 1, 0})).ok());
}

/// A3: tables of primitives and polyhedra stand in body/mass_properties_test.cpp. Here: a box far off does not lose its own inertia.
TEST(HardCases, A3_offset_box_does_not_cancel) {
    const ingot::MassDistribution here = ingot::solid_box(1, {scalar(0.5), scalar(0.25), scalar(0.125)});
    const ingot::MassDistribution there = ingot::placed(here, ingot::identity_matrix<scalar>(), {1000, -500, 250});
    const ingot::MassProperties a = ingot::principal(here).value, b = ingot::principal(there).value;
    EXPECT_LE(std::abs(static_cast<double>(a.I_body.x - b.I_body.x)), 1e-10 * static_cast<double>(a.I_body.x));
    EXPECT_LE(std::abs(static_cast<double>(a.I_body.z - b.I_body.z)), 1e-10 * static_cast<double>(a.I_body.z));
}

/// h = 0 is refused and is the identity; h from a nanosecond to a second is taken.
TEST(HardCases, A4_steps_of_every_length) {
    const FreeBodyCase body("free_asymmetric", "book");
    for (const scalar h :
         {scalar(0), scalar(-1), scalar(1e-10), scalar(2), std::numeric_limits<scalar>::infinity(), std::numeric_limits<scalar>::quiet_NaN()}) {
        Flight<> flight(body);
        const ingot::BodyState before = flight.state();
        EXPECT_EQ(ingot::step(flight.world(), h).status, ingot::Status::bad_step);
        const ingot::BodyState after = flight.state();
        EXPECT_EQ(std::memcmp(&before, &after, sizeof after), 0);
    }
    for (const scalar h : {scalar(1e-9), scalar(1e-3), scalar(1)}) {
        Flight<> flight(body);
        flight.fly(100, h);
        EXPECT_TRUE(flight.is_rotation() && flight.keeps_L());
        EXPECT_LE(flight.energy_error(), bound(1e-9, 1e-5));
    }
}

struct Feather : ingot::Scene {
    static constexpr int max_bodies = 2, max_contacts = 8;
    using solver = ingot::FrictionlessImpacts;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};

/// A feather of the least mass sinks onto the ground, slower and slower, down to denormals: squares of its impulses underflow, and it
/// comes to no harm. (0/0 of two of them froze it.)
TEST(HardCases, A5_impulses_whose_squares_vanish) {
    for (double v = 1; v > std::numeric_limits<scalar>::denorm_min(); v /= 7) {
        for (const double tilt : {0.0, 0.3, 0.7}) {
            ingot::World<Feather> world{};
            ingot::BodyDef ground;
            ground.immovable = true;
            ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
            ASSERT_TRUE(world.add(ground).ok());
            ingot::BodyDef def = definition(1e-9, Vector3(1, 1.5, 2) * 1e-9);
            def.shape = ingot::Box{{1, scalar(0.5), scalar(0.5)}};
            def.state.r_CM = {0, 0, scalar(0.5)};
            def.state.v_CM = {0, 0, static_cast<scalar>(-v)};
            def.state.L = {static_cast<scalar>(1e-9 * tilt * v), static_cast<scalar>(0.7e-9 * v), 0};
            def.restitution = scalar(0.5);
            def.mass.M = ingot::limits::mass_min;
            const ingot::Result<ingot::BodyId> id = world.add(def);
            ASSERT_TRUE(id.ok());
            for (int step_i = 0; step_i < 20; ++step_i) ASSERT_EQ(ingot::step(world, scalar(1) / 60).bodies_frozen, 0) << "v " << v;
            EXPECT_LE(std::abs(static_cast<double>(world.state(id.value).value.v_CM.z)), 2 * v) << "v " << v;
        }
    }
}

}  // namespace

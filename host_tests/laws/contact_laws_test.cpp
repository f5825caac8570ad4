// SPDX-License-Identifier: MIT
// Bouncing, coming to rest, resting and sliding, at 60 Hz.
#include <gtest/gtest.h>
#include <ingot/ingot.h>

#include <cstdio>
#include <string>
#include <tuple>

#include "laws/bodies.h"

namespace {

using namespace ingot_laws;
using namespace ingot_reference;

struct Ground : ingot::Scene {
    static constexpr int max_bodies = 2;
    static constexpr bool translates = true;
    static constexpr int max_contacts = 8;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};
using World = ingot::World<Ground>;

constexpr double g = 9.8125, R = 0.5;
const scalar h = scalar(1) / 60;

/// A ball of radius R over ground at z = 0.
struct BouncingBall {
    World world{};
    Known ball_;

    BouncingBall(double e, double height, double v = 0) {
        (void)add(world, half_space({0, 0, 1}, 0));
        ball_ = add(world, ball(1, R, {0, 0, R + height}, {0, 0, v}, e));
        EXPECT_EQ(world.set_gravity({0, 0, scalar(-g)}), ingot::Status::ok);
    }
    double height() const { return position(world, ball_)(2) - R; }
    double speed() const { return velocity(world, ball_)(2); }
    double energy() const { return speed() * speed() / 2 + g * height(); }  ///< over the mass
    ingot::StepReport step(scalar step_length = h) { return ingot::step(world, step_length); }
};

/// e = 1, at any rate: an impact turns the speed around at the place it has, and flight is exact, so only roundings add up: 4 a
/// step of r, worth g r each, and as many of v^2 / 2.
TEST(Bouncing, elastic_ball_keeps_its_energy) {
    for (const int rate : {15, 60, 240}) {
        BouncingBall b(1, 2);
        const double begin = b.energy();
        double worst = 0;
        int bounces = 0;
        for (int step_i = 0; step_i < 10 * rate; ++step_i) {
            const ingot::StepReport report = b.step(scalar(1) / static_cast<scalar>(rate));
            ASSERT_TRUE(report.clean());
            bounces += report.impact_waves;
            worst = std::max(worst, std::abs(b.energy() / begin - 1));
        }
        std::printf("    %3d Hz: %d bounces in 10 s, energy off by %.1e\n", rate, bounces, worst);
        EXPECT_GE(bounces, 7);
        EXPECT_LE(worst, 10 * rate * 8 * u);
    }
}

/// The closed form of the impacts, t_k = t_1 (2 k - 1): each is noticed at the step that follows it, so the apexes come late by
/// at most a step an impact, and never early.
TEST(Bouncing, elastic_ball_returns_to_its_height) {
    BouncingBall b(1, 2);
    double highest = 0;
    for (int step_i = 0; step_i < 600; ++step_i) {
        (void)b.step();
        if (step_i > 60) highest = std::max(highest, b.height());
    }
    EXPECT_LE(highest, 2 * (1 + 600 * 8 * u));
    EXPECT_GE(highest, 2 - g * static_cast<double>(h) * static_cast<double>(h));  // between two samples of the apex
}

/// I6: e = 1/2. The closed form comes to rest after t_1 (1 + 2 e / (1 - e)) = 3 t_1.
TEST(Bouncing, inelastic_ball_comes_to_rest_and_stays) {
    for (const double e : {0.0, 0.25, 0.5, 0.75}) {
        BouncingBall b(e, 2);
        const double t_rest = std::sqrt(2 * 2 / g) * (1 + 2 * e / (1 - e));
        int rest_step = -1;
        double resting_height = 0;
        const int steps = static_cast<int>((t_rest + 5) * 60);
        for (int step_i = 1; step_i <= steps; ++step_i) {
            ASSERT_TRUE(b.step().clean());
            if (std::abs(b.speed()) > 1e-6) {
                rest_step = -1;
            } else if (rest_step < 0 && b.world.contact_count() > 0) {
                rest_step = step_i;
                resting_height = b.height();
            }
        }
        ASSERT_GE(rest_step, 0) << "never at rest, e = " << e;
        std::printf("    e = %.2f: at rest after %.3f s, closed form %.3f s; resting at %.1e m\n", e, rest_step / 60.0, t_rest,
                    resting_height);
        const double impacts = e > 0 ? 1 + std::log(2 * g * static_cast<double>(h) / std::sqrt(2 * g * 2)) / std::log(e) : 1;
        // Each impact is noticed up to a step late.
        EXPECT_LE(rest_step / 60.0, t_rest + (impacts + 2) / 60);
        // An impact is seen up to a step late, up to g h faster: one of 3 g h may still count as slow, worth 3 * 2 h e / (1 -
        // e). And each impact before it turns back at a depth of up to a step's path, which makes its flight up to a step
        // shorter.
        EXPECT_GE(rest_step / 60.0, t_rest - 6 * e / (1 - e) / 60 - (impacts + 1) / 60);
        EXPECT_LE(std::abs(b.height() - resting_height), steps * u * R) << "stays";
    }
}

/// A ball that lies on the ground does not sink, move or turn; 1 rounding of r a step.
TEST(Resting, sphere_on_a_plane_does_not_sink) {
    BouncingBall b(0.5, 0);
    for (int step_i = 0; step_i < 3600; ++step_i) {
        const ingot::StepReport report = b.step();
        ASSERT_TRUE(report.clean());
        ASSERT_EQ(report.contacts, 1) << "step " << step_i;
    }
    std::printf("    one minute at rest: sunk by %.1e m, speed %.1e m/s\n", -b.height(), std::abs(b.speed()));
    EXPECT_LE(std::abs(b.height()), 3600 * u * R);
    EXPECT_LE(std::abs(b.speed()), ingot::limits::contact_roundings * 2 * u * g * static_cast<double>(h));
    EXPECT_EQ(spin(b.world, b.ball_), Eigen::Vector3d(0, 0, 0));
}

/// The ground carries the weight: j of the contact is M g h.
TEST(Resting, contact_carries_the_weight) {
    BouncingBall b(0, 0);
    for (int step_i = 0; step_i < 10; ++step_i) {
        ASSERT_TRUE(b.step().clean());
        ASSERT_EQ(b.world.contact_count(), 1);
        EXPECT_NEAR(static_cast<double>(b.world.contact(0).value.j), g * static_cast<double>(h),
                    2 * ingot::limits::contact_roundings * 2 * u * g * static_cast<double>(h));
    }
}

/// Without friction a body slides down a slope with g sin(alpha), whatever its shape, and does not turn.
class Incline : public ::testing::TestWithParam<std::tuple<double, bool>> {};

TEST_P(Incline, slides_with_g_sin_alpha) {
    const auto [degrees, is_ball] = GetParam();
    const double alpha = degrees * 3.14159265358979 / 180;
    const Eigen::Vector3d n(std::sin(alpha), 0, std::cos(alpha)), down(std::cos(alpha), 0, -std::sin(alpha));
    World world{};
    (void)add(world, half_space(n, 0));
    const Eigen::Vector3d r =
        n * (R - 1e-6);  // surely touching: a ball that begins a rounding above the ground first falls g h^2 / 2
    ingot::BodyDef def =
        is_ball ? ball(2, R, r, Eigen::Vector3d::Zero(), 0) : box(2, {1, 0.75, R}, r, Eigen::Vector3d::Zero(), 0);
    Eigen::Matrix3d A;
    A << down, Eigen::Vector3d::UnitY(), n;
    def.state.A = to_matrix(A);
    const Known body = add(world, def);
    ASSERT_EQ(world.set_gravity({0, 0, scalar(-g)}), ingot::Status::ok);
    const Eigen::Vector3d start = position(world, body);
    constexpr int steps = 120;
    for (int step_i = 0; step_i < steps; ++step_i) ASSERT_TRUE(ingot::step(world, h).clean());

    const double t = steps * static_cast<double>(h), s = (position(world, body) - start).dot(down),
                 v = velocity(world, body).dot(down);
    const double s_exact = g * std::sin(alpha) * t * t / 2, v_exact = g * std::sin(alpha) * t;
    const double off_ground = (position(world, body) - start).dot(n), turned = attitude_error(attitude(world, body), A);
    std::printf(
        "    %s, %2.0f degrees: distance off by %.1e, speed by %.1e; %.1e m off the ground, |omega| %.1e, turned %.1e rad\n",
        is_ball ? "ball" : "box", degrees, s / s_exact - 1, v / v_exact - 1, off_ground, spin(world, body).norm(), turned);
    // Each step rounds v and r a few times, of sizes up to v and r; the bar set for the kernel is 1e-5 of the distance.
    EXPECT_NEAR(s / s_exact, 1, std::min(1e-5, 16 * steps * u));
    EXPECT_NEAR(v / v_exact, 1, std::min(1e-5, 16 * steps * u));
    EXPECT_LE(spin(world, body).norm(), bar(1e-10, 1e-4));
    EXPECT_LE(turned, bar(1e-10, 1e-4));
    // n is rounded to u in its own direction, which over the distance s leads off the ground by u s, and r is rounded each
    // step.
    EXPECT_LE(std::abs(off_ground), 4 * u * s + steps * u * s);
}
INSTANTIATE_TEST_SUITE_P(Slopes, Incline, ::testing::Combine(::testing::Values(5.0, 30.0, 45.0, 80.0), ::testing::Bool()),
                         [](const ::testing::TestParamInfo<std::tuple<double, bool>>& slope) {
                             const auto degrees = std::get<0>(slope.param);
                             const auto is_ball = std::get<1>(slope.param);
                             return std::string(is_ball ? "ball_" : "box_") + std::to_string(static_cast<int>(degrees)) +
                                    "_degrees";
                         });

}  // namespace

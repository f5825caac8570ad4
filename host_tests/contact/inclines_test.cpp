// SPDX-License-Identifier: MIT
// One body on a plane against closed forms (reference/ball_and_brick.h) and their tables.
#include <gtest/gtest.h>

#include "contact/play.h"
#include "reference/ball_and_brick.h"
#include "reference/csv_table.h"

namespace {

using namespace ingot_contact;
using namespace scenes;

/// mu 0.7 on 30 degrees creeps <= 0.001 mm in 10 s.
TEST(Incline, of_mu_07_does_not_creep) {
    auto scene = play<Incline<70>>();
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, 10);
    const double creep = to_eigen(thirty_degrees.down()).dot(scene.moved(1));
    figure("creep, mm", 1e3 * creep);
    EXPECT_LE(1e3 * std::abs(creep), 0.001);
}

/// mu 0.4: the way after 2 s within 0.001 %.
TEST(Incline, of_mu_04_slides_the_exact_way) {
    auto scene = play<Incline<40>>();
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, 2);
    const double way = to_eigen(thirty_degrees.down()).dot(scene.moved(1));
    const double exact = static_cast<double>(ingot_reference::BrickOnIncline(9.81L, 0.4L, 0.5L, std::sqrt(0.75L), 0).at(2).s);
    figure("error of the way, %", 100 * (way / exact - 1));
    EXPECT_LE(std::abs(way / exact - 1), 1e-5);
}

const auto case_name = [](const auto& tested) { return std::string(tested.param.table_case); };

template <class Case>
Play<Room<2>> play_case(const Case& c) {
    return {bodies_from<2>([&](int body_i) { return c.body(body_i); }), Case::gravity};
}

/// C5: t_stop within 1 step, stop distance within 1 %, at 60 Hz. Where it does not stop, the way within 1 % as well.
class Bricks : public ::testing::TestWithParam<SlopeCase> {};
TEST_P(Bricks, stop_where_and_when_the_closed_form_says) {
    const SlopeCase c = GetParam();
    auto scene = play_case(c);
    ASSERT_TRUE(scene.sound());
    const auto exact = ingot_reference::BrickOnIncline(9.8125L, static_cast<long double>(c.mu), static_cast<long double>(c.slope.sin_alpha),
                                                       static_cast<long double>(c.slope.cos_alpha), static_cast<long double>(c.v_0));
    const Vector3d down = to_eigen(c.slope.down());
    const double h = 1.0 / 60, t_stop = static_cast<double>(exact.t_stop());
    double stopped_at = c.v_0 == 0 ? 0 : -1, least_speed = 1e30;
    scene.run(static_cast<scalar>(h), static_cast<double>(c.seconds), [&](int step_i) {
        const double speed = std::abs(down.dot(scene.v(1)));
        least_speed = std::min(least_speed, speed);
        if (stopped_at < 0 && speed < 1e-3) stopped_at = step_i * h;
    });
    const double way = down.dot(scene.moved(1)), exact_way = static_cast<double>(exact.at(static_cast<long double>(c.seconds)).s);
    figure("way, error relative to the longest", (way - exact_way) / std::max(std::abs(exact_way), 1e-3));
    if (exact.sticks()) {
        EXPECT_NEAR(stopped_at, t_stop, h);
    }
    EXPECT_NEAR(way, exact_way, 0.01 * std::abs(exact_way) + 1e-5);
    EXPECT_NEAR(down.dot(scene.v(1)), static_cast<double>(exact.at(static_cast<long double>(c.seconds)).v),
                0.01 * std::abs(static_cast<double>(c.v_0)) + 1e-4);
}
INSTANTIATE_TEST_SUITE_P(Incline, Bricks, ::testing::ValuesIn(brick_cases),
                         case_name);

/// C1, C2: s(2 s) within 0.5 %, slip of a rolling ball <= 1e-3 m/s.
class BallsOnIncline : public ::testing::TestWithParam<SlopeCase> {};
TEST_P(BallsOnIncline, roll_or_slide_as_the_closed_form_says) {
    const SlopeCase c = GetParam();
    auto scene = play_case(c);
    ASSERT_TRUE(scene.sound());
    const auto exact =
        ingot_reference::SphereOnIncline(9.8125L, static_cast<long double>(c.mu), static_cast<long double>(c.radius), 0.4L,
                                         static_cast<long double>(c.slope.sin_alpha), static_cast<long double>(c.slope.cos_alpha));
    const Vector3d down = to_eigen(c.slope.down()), up = to_eigen(c.slope.up());
    double worst_slip = 0;
    scene.run(OnEarth::h, static_cast<double>(c.seconds), [&](int) {
        const Vector3d slip = scene.v(1) + scene.omega(1).cross(-static_cast<double>(c.radius) * up);
        worst_slip = std::max(worst_slip, slip.norm());
    });
    const auto end = exact.at(static_cast<long double>(c.seconds));
    const double way = down.dot(scene.moved(1)), exact_way = static_cast<double>(end.s);
    figure("way, relative error", way / exact_way - 1);
    figure("slip, m/s", worst_slip);
    EXPECT_NEAR(way, exact_way, 0.005 * exact_way);
    EXPECT_NEAR(down.dot(scene.v(1)), static_cast<double>(end.v), 0.005 * static_cast<double>(end.v));
    if (exact.rolls() && std::string(c.table_case) != "threshold") {  // at the threshold itself rounding decides
        EXPECT_LE(worst_slip, 1e-3);
    }
}
INSTANTIATE_TEST_SUITE_P(Incline, BallsOnIncline, ::testing::ValuesIn(sphere_incline_cases),
                         case_name);

/// C2: the right side of tan = 7/2 mu at +-1 % of mu: 1 % above it rolls, 1 % below it slips by g (sin - 7/2 mu cos) t = 0.118 m/s after 2 s.
TEST(Incline, rolls_above_and_slides_below_the_threshold) {
    for (const double factor : {1.01, 0.99}) {
        SlopeCase c = sphere_incline_cases[2];
        c.mu = static_cast<scalar>(static_cast<double>(c.mu) * factor);
        auto scene = play_case(c);
        scene.run(OnEarth::h, 2);
        const double slip = (scene.v(1) + scene.omega(1).cross(-0.5 * to_eigen(c.slope.up()))).norm();
        figure("slip after 2 s, m/s", slip);
        if (factor > 1) {
            EXPECT_LE(slip, 1e-3);
        } else {
            EXPECT_NEAR(slip, 9.8125 * (0.6 - 3.5 * 3 / 14 * 0.99 * 0.8) * 2, 0.005);
        }
    }
}

/// C3: final velocity within 0.2 %, t_roll within 1 step, direction constant within 1e-3 rad.
class BallsOnPlane : public ::testing::TestWithParam<SpherePlaneCase> {};
TEST_P(BallsOnPlane, come_to_roll_as_the_closed_form_says) {
    const SpherePlaneCase c = GetParam();
    auto scene = play_case(c);
    ASSERT_TRUE(scene.sound());
    const auto long_of = [](const Vector& v) { return to_eigen<long double>(v); };
    const auto exact = ingot_reference::SphereOnPlane(9.8125L, static_cast<long double>(c.mu), static_cast<long double>(c.radius),
                                                      static_cast<long double>(c.k), long_of(c.v), long_of(c.omega));
    const double h = 1.0 / 60, t_roll = static_cast<double>(exact.t_roll());
    double rolls_at = -1, worst_turn = 0;
    const Vector3d slip_0 = to_eigen(c.v) + to_eigen(c.omega).cross(Vector3d(0, 0, -static_cast<double>(c.radius)));
    scene.run(static_cast<scalar>(h), static_cast<double>(c.seconds), [&](int step_i) {
        const Vector3d slip = scene.v(1) + scene.omega(1).cross(Vector3d(0, 0, -static_cast<double>(c.radius)));
        if (rolls_at < 0 && slip.norm() < 1e-3 * slip_0.norm()) rolls_at = step_i * h;
        if (rolls_at < 0 && step_i * h < t_roll - h)  // the last sliver of slip has no direction to speak of
            worst_turn = std::max(worst_turn, slip.cross(slip_0).norm() / (slip.norm() * slip_0.norm()));
    });
    const auto end = exact.at(static_cast<long double>(c.seconds));
    const Vector3d v_end = end.v.cast<double>();
    figure("final velocity, relative error", (scene.v(1) - v_end).norm() / v_end.norm());
    figure("starts to roll too late by, steps", (rolls_at - t_roll) / h);
    figure("turn of the slip, rad", worst_turn);
    EXPECT_LE((scene.v(1) - v_end).norm(), 0.002 * v_end.norm());
    EXPECT_NEAR(rolls_at, t_roll, h);
    EXPECT_LE(worst_turn, 1e-3);
}
INSTANTIATE_TEST_SUITE_P(Plane, BallsOnPlane, ::testing::ValuesIn(sphere_plane_cases),
                         case_name);

/// C4: a ball that rolls for 60 s loses < 0.1 % of its speed.
TEST(Plane, ball_rolls_on_without_loss) {
    SpherePlaneCase c = {"rolling", scalar(0.5), scalar(0.5), scalar(0.4), {2, 1, 0}, {-2, 4, 0}, 60};
    auto scene = play_case(c);
    ASSERT_TRUE(scene.sound());
    const double speed = scene.v(1).norm();
    scene.run(OnEarth::h, 60);
    figure("loss of speed, %", 100 * (1 - scene.v(1).norm() / speed));
    EXPECT_NEAR(scene.v(1).norm(), speed, 1e-3 * speed);
}

/// C6: mu = tan(alpha)(1 +- 1e-3): sticks, < 1e-5 m in 60 s; slips with g (sin - mu cos) within 5 %.
TEST(Incline, sticks_and_slips_a_permille_off_the_threshold) {
    for (const double factor : {1.001, 0.999}) {
        SlopeCase c = brick_cases[5];  // rest_sticks: from rest on three_four
        c.mu = static_cast<scalar>(0.75 * factor);
        auto scene = play_case(c);
        const double seconds = factor > 1 ? 60 : 4;
        scene.run(OnEarth::h, seconds);
        const double way = to_eigen(c.slope.down()).dot(scene.moved(1));
        figure("way, m", way);
        if (factor > 1) {
            EXPECT_LE(std::abs(way), 1e-5);
        } else {
            const double exact = 9.8125 * (0.6 - 0.75 * 0.999 * 0.8) * seconds * seconds / 2;
            EXPECT_NEAR(way, exact, 0.05 * exact);
        }
    }
}

/// C7: the spread of stopping distances over the directions < 1 %, and each within 1 % of v^2 / (2 mu g).
TEST(Plane, friction_is_the_same_in_all_directions) {
    double shortest = 1e30, longest = 0;
    for (int degrees = 0; degrees <= 90; degrees += 15) {
        Play<Room<2>> scene(bodies_from<2>([&](int body_i) { return brick_pushed_at(body_i, static_cast<scalar>(degrees), scalar(0.4)); }),
                            OnEarth::gravity);
        scene.run(OnEarth::h, 2);
        const double way = scene.drift(1);
        shortest = std::min(shortest, way);
        longest = std::max(longest, way);
        EXPECT_NEAR(way, 9 / (2 * 0.4 * 9.81), 0.01 * way) << degrees;
    }
    figure("spread, %", 100 * (longest / shortest - 1));
    EXPECT_LE(longest / shortest, 1.01);
}

/// C13: a box 0.5 m wide and 1 m high topples where tan(alpha) > 1/2: right at +-2 % (of the tangent).
TEST(Incline, box_topples_beyond_its_diagonal) {
    for (const double factor : {0.98, 1.02}) {
        const double alpha = std::atan(0.5 * factor);
        const Slope slope = {static_cast<scalar>(std::sin(alpha)), static_cast<scalar>(std::cos(alpha))};
        Play<Room<2>> scene(bodies_from<2>([&](int body_i) { return box_that_may_topple(body_i, slope, scalar(0.5), 1); }), OnEarth::gravity);
        scene.run(OnEarth::h, 10);
        const double tilt = to_eigen(slope.up()).dot(scene.A(1).col(2));
        figure("cosine of the tilt after 10 s", tilt);
        if (factor < 1) {
            EXPECT_GE(tilt, 1 - 1e-6);
        } else {
            EXPECT_LE(tilt, 0.5);
        }
    }
}

}  // namespace

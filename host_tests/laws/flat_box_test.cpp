// SPDX-License-Identifier: MIT
// A box dropped flat: four corners hit at once, and it does not begin to turn. I8: |omega| <= 1e-10 (double), 1e-4 (float)
// rad/s.
#include <gtest/gtest.h>
#include <ingot/ingot.h>

#include <cstdio>

#include "laws/bodies.h"

namespace {

using namespace ingot_laws;
using namespace ingot_reference;

struct Drop : ingot::Scene {
    static constexpr int max_bodies = 2;
    static constexpr bool translates = true;
    static constexpr int max_contacts = 8;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
using World = ingot::World<Drop>;

struct Size {
    double M;
    Eigen::Vector3d half;
};
const Size sizes[] = {{1, {0.5, 0.5, 0.5}}, {2, {1, 0.5, 0.25}}, {0.05, {0.02, 0.03, 0.01}},
                      {5000, {4, 3, 1.5}},  {3, {0.5, 0.25, 2}}, {1, {1, 1, 0.01}}};

class FlatBox : public ::testing::TestWithParam<double> {};

/// What befell the boxes of one restitution: every size at every angle about z, dropped on a sideways path for 5 s.
struct Drops {
    double omega = 0, turned = 0;  ///< worst, rad/s and rad
    /// rad/s, the worst over what roundings may add up to. Each impact leaves speeds of corners off by limits::contact_roundings of the speed v, and
    /// a corner of that lever turns; in t seconds there are g t / 2 v impacts with e = 1, fewer else: v does not matter.
    double omega_share = 0;
    int steps = 0, unfinished = 0, odd_contacts = 0, landings = 0;
    bool sideways_is_kept = true;

    explicit Drops(double e) {
        RandomInput random(301);
        for (const Size& size : sizes) {
            for (const double degrees : {0.0, 90.0, 45.0, 30.0, 17.3, -61.0}) drop(size, degrees, e, random);
        }
        std::printf("    e = %g: worst |omega| %.1e rad/s, turned by %.1e rad; %d of %d steps not solved in full\n", e, omega,
                    turned, unfinished, steps);
    }

private:
    void drop(const Size& size, double degrees, double e, RandomInput& random) {
        World world{};
        (void)add(world, half_space({0, 0, 1}, 0));
        const double height = random.real(0.01, 1);
        ingot::BodyDef def = box(size.M, size.half, {1, 2, size.half(2) + height}, {random.real(-1, 1), 0.5, 0}, e);
        def.state.A =
            to_matrix(Eigen::AngleAxisd(degrees * 3.14159265358979 / 180, Eigen::Vector3d::UnitZ()).toRotationMatrix());
        const Known body = add(world, def);
        EXPECT_EQ(world.set_gravity({0, 0, scalar(-9.8125)}), ingot::Status::ok);
        const Square begin = attitude(world, body);
        int contacts = 0;
        for (int step_i = 0; step_i < 300; ++step_i, ++steps) {
            const ingot::StepReport report = ingot::step(world, scalar(1) / 60);
            unfinished += report.clean() ? 0 : 1;
            odd_contacts += report.contacts == 0 || report.contacts == 4 || report.contacts == 8 ? 0 : 1;
            contacts += report.contacts;
            omega = std::max(omega, length_of(spin(world, body)));
            const double speeds = 9.8125 * 5 / 2 + 2 * std::sqrt(2 * 9.8125 * height), lever = std::min(size.half(0), size.half(1));
            omega_share = std::max(omega_share, length_of(spin(world, body)) / (ingot::limits::contact_roundings * 2 * u * speeds / lever));
            turned = std::max(turned, attitude_error(attitude(world, body), begin));
        }
        landings += contacts > 0 ? 1 : 0;
        const ingot::Vector v = world.state(body.id).value.v_CM;
        sideways_is_kept = sideways_is_kept && v.x == def.state.v_CM.x && v.y == def.state.v_CM.y;
    }
};

TEST_P(FlatBox, does_not_begin_to_turn) {
    const Drops drops(GetParam());
    EXPECT_EQ(drops.landings, 36);
    EXPECT_LE(drops.omega_share, 1);
    EXPECT_LE(drops.turned, 5 * bar(1e-10, 1e-4)) << "|omega| for 5 s";
    EXPECT_EQ(drops.odd_contacts, 0) << "a flat box touches with all its corners or none";
    EXPECT_TRUE(drops.sideways_is_kept) << "without friction, not a bit of it changes";
}

TEST_P(FlatBox, is_solved_in_full) { EXPECT_EQ(Drops(GetParam()).unfinished, 0); }

INSTANTIATE_TEST_SUITE_P(Restitution, FlatBox, ::testing::Values(0, 0.5, 1));

/// At the speed where restitution ends (limits::rest_speed_factor g h: where a box lands that was at rest so many steps before)
/// all corners bounce or none does, whatever the rounding in the speed of each.
TEST(FlatBoxImpact, corners_agree_on_whether_to_bounce) {
    const double g = 9.8125, rest_speed = ingot::limits::rest_speed_factor * g / 60;
    double worst = 0;
    for (const double tilt : {0.0, 1.0, -1.0}) {
        for (int ulp_i = -8; ulp_i <= 8; ++ulp_i) {
            World world{};
            (void)add(world, half_space({0, 0, 1}, 0));
            ingot::BodyDef def = box(1, {0.5, 0.25, 0.5}, {0, 0, 0.5}, {0, 0, -rest_speed * (1 + 2 * u * ulp_i)}, 0.5);
            def.state.L = {static_cast<scalar>(tilt * u), static_cast<scalar>(-tilt * u), 0};
            const Known body = add(world, def);
            ASSERT_EQ(world.set_gravity({0, 0, static_cast<scalar>(-g)}), ingot::Status::ok);
            for (int step_i = 0; step_i < 3; ++step_i) {
                (void)ingot::step(world, scalar(1) / 60);
                worst = std::max(worst, length_of(spin(world, body)));
            }
        }
    }
    EXPECT_LE(worst, bar(1e-10, 1e-4));
}

/// The impact itself: the corners together take M v (1 + e), and the box leaves with e v, to limits::contact_roundings of v.
TEST(FlatBoxImpact, corners_share_the_impulse) {
    for (const double e : {0.0, 0.5, 1.0}) {
        World world{};
        (void)add(world, half_space({0, 0, 1}, 0));
        const Known body = add(world, box(2, {1, 0.5, 0.25}, {0, 0, 0.25}, {0, 0, -2}, e));
        ASSERT_TRUE(ingot::step(world, scalar(1) / 64).clean());
        ASSERT_EQ(world.contact_count(), 4);
        double sum = 0;
        for (int i = 0; i < 4; ++i) sum += static_cast<double>(world.contact(i).value.j);
        const double speed_error = 8 * 2 * u * 2;  // contact_roundings epsilon |v|
        EXPECT_NEAR(velocity(world, body)(2), 2 * e, speed_error);
        EXPECT_NEAR(sum, 2 * 2 * (1 + e), 2 * speed_error + 8 * u * sum);
        EXPECT_LE(spin(world, body).norm(), bar(1e-10, 1e-4));
    }
}

/// A box that lies rests: five seconds on the ground, no drift, no turn, no sinking a step beyond one rounding of its height
/// and the path of the speed g h that a solve leaves at its tolerance, limits::contact_roundings epsilon.
TEST(FlatBoxAtRest, stays_where_it_lies) {
    for (const Size& size : sizes) {
        World world{};
        (void)add(world, half_space({0, 0, 1}, 0));
        const Known body = add(world, box(size.M, size.half, {0, 0, size.half(2)}, Eigen::Vector3d::Zero(), 0));
        ASSERT_EQ(world.set_gravity({0, 0, scalar(-9.8125)}), ingot::Status::ok);
        for (int step_i = 0; step_i < 300; ++step_i) ASSERT_TRUE(ingot::step(world, scalar(1) / 60).clean());
        EXPECT_LE(
            (position(world, body) - Eigen::Vector3d(0, 0, static_cast<double>(static_cast<scalar>(size.half(2))))).norm(),
            300 * u * size.half(2) + 300 * 8 * 2 * u * 9.8125 / 3600);
        EXPECT_LE(spin(world, body).norm(), bar(1e-10, 1e-4));
        EXPECT_LE(attitude_error(attitude(world, body), Square(Square::Identity())), bar(1e-10, 1e-4));
    }
}

}  // namespace

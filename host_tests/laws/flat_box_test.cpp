// SPDX-License-Identifier: MIT
// A box dropped flat: four corners hit at once, and it does not begin to turn. I8: |omega| <= 1e-10 (double), 1e-4 (float) rad/s.
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
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
using World = ingot::World<Drop>;

struct Size {
    double M;
    Eigen::Vector3d half;
};
const Size sizes[] = {
    {1, {0.5, 0.5, 0.5}}, {2, {1, 0.5, 0.25}}, {0.05, {0.02, 0.03, 0.01}}, {5000, {4, 3, 1.5}}, {3, {0.5, 0.25, 2}}, {1, {1, 1, 0.01}}};

class FlatBox : public ::testing::TestWithParam<double> {};

/// Drops every size at every angle about z, from some height and on a sideways path, and lets it bounce or rest for 5 s.
TEST_P(FlatBox, does_not_begin_to_turn) {
    const double e = GetParam();
    RandomInput random(301);
    double worst = 0;
    for (const Size& size : sizes) {
        for (const double degrees : {0.0, 90.0, 45.0, 30.0, 17.3, -61.0}) {
            World world{};
            (void)add(world, half_space({0, 0, 1}, 0));
            ingot::BodyDef def = box(size.M, size.half, {random.real(-2, 2), random.real(-2, 2), size.half(2) + random.real(0.01, 1)},
                                     {random.real(-1, 1), random.real(-1, 1), 0}, e);
            def.state.A = to_matrix(Eigen::AngleAxisd(degrees * 3.14159265358979 / 180, Eigen::Vector3d::UnitZ()).toRotationMatrix());
            const Known body = add(world, def);
            ASSERT_EQ(world.set_gravity({0, 0, scalar(-9.8125)}), ingot::Status::ok);
            int contacts = 0;
            for (int step_i = 0; step_i < 300; ++step_i) {
                const ingot::StepReport report = ingot::step(world, scalar(1) / 60);
                ASSERT_TRUE(report.clean()) << "size " << size.half.transpose() << ", " << degrees << " degrees, step " << step_i;
                ASSERT_TRUE(report.contacts == 0 || report.contacts == 4 || report.contacts == 8) << report.contacts;
                contacts += report.contacts;
                worst = std::max(worst, spin(world, body).norm());
            }
            ASSERT_GE(contacts, 4);
            // Without friction nothing changes the sideways motion: not by a bit.
            ASSERT_EQ(velocity(world, body)(0), static_cast<double>(def.state.v_CM.x));
            ASSERT_EQ(velocity(world, body)(1), static_cast<double>(def.state.v_CM.y));
        }
    }
    std::printf("    e = %g: worst |omega| %.1e rad/s\n", e, worst);
    EXPECT_LE(worst, bar(1e-10, 1e-4));
}

INSTANTIATE_TEST_SUITE_P(Restitution, FlatBox, ::testing::Values(0, 0.5, 1));

/// The impact itself: each corner takes a quarter of M v (1 + e), and the box leaves with e v. Four sums of 3 terms, and what a sweep
/// over the four may leave: limits::contact_roundings.
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

/// A box that lies rests: five seconds on the ground, no drift, no turn, no sinking beyond one rounding of its height a step.
TEST(FlatBoxAtRest, stays_where_it_lies) {
    for (const Size& size : sizes) {
        World world{};
        (void)add(world, half_space({0, 0, 1}, 0));
        const Known body = add(world, box(size.M, size.half, {0, 0, size.half(2)}, Eigen::Vector3d::Zero(), 0));
        ASSERT_EQ(world.set_gravity({0, 0, scalar(-9.8125)}), ingot::Status::ok);
        for (int step_i = 0; step_i < 300; ++step_i) ASSERT_TRUE(ingot::step(world, scalar(1) / 60).clean());
        EXPECT_LE((position(world, body) - Eigen::Vector3d(0, 0, static_cast<double>(static_cast<scalar>(size.half(2))))).norm(), 300 * u * size.half(2));
        EXPECT_LE(spin(world, body).norm(), bar(1e-10, 1e-4));
        EXPECT_LE(attitude_error(attitude(world, body), Square(Square::Identity())), bar(1e-10, 1e-4));
    }
}

}  // namespace

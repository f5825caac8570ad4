// SPDX-License-Identifier: MIT
// Impacts through the step: momentum, energy, and several at once.
#include <gtest/gtest.h>
#include <ingot/ingot.h>

#include <cstdio>

#include "laws/bodies.h"

namespace {

using namespace ingot_laws;
using namespace ingot_reference;

struct Balls : ingot::Scene {
    static constexpr int max_bodies = 16;
    static constexpr bool translates = true;
    static constexpr int max_contacts = 64;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;
};
using World = ingot::World<Balls>;
const scalar h = scalar(1) / 64;

/// Speeds of contacts are met to limits::contact_roundings of the speeds they are made of.
double speed_error(double speed) { return ingot::limits::contact_roundings * 2 * u * speed; }

/// Two balls on a line: the textbook's velocities after the impact.
TEST(Impact, two_balls_on_a_line) {
    RandomInput random(311);
    for (int i = 0; i < 200; ++i) {
        World world{};
        const double M_1 = random.real(0.1, 10), M_2 = random.real(0.1, 10), v_1 = random.real(0.5, 3),
                     v_2 = -random.real(0.5, 3);
        const double e = i % 4 == 0 ? 1 : random.real(0, 1);
        const Known a = add(world, ball(M_1, 0.5, {-0.5, 0, 0}, {v_1, 0, 0}, e)),
                    b = add(world, ball(M_2, 0.5, {0.5, 0, 0}, {v_2, 0, 0}, e));
        const double e_used = static_cast<double>(static_cast<scalar>(e)), centre = (M_1 * v_1 + M_2 * v_2) / (M_1 + M_2);
        ASSERT_TRUE(ingot::step(world, h).clean());
        const double tolerance = speed_error(6) + 10 * u * 6;  // and 10 roundings of masses and speeds
        ASSERT_NEAR(velocity(world, a)(0), centre - e_used * M_2 * (v_1 - v_2) / (M_1 + M_2), tolerance);
        ASSERT_NEAR(velocity(world, b)(0), centre + e_used * M_1 * (v_1 - v_2) / (M_1 + M_2), tolerance);
    }
}

/// A cluster of balls in each other's way: masses over three decades, every pair that overlaps a contact.
std::vector<Known> add_cluster(World& world, RandomInput& random, double e, std::vector<double>* radii = nullptr) {
    std::vector<Known> bodies;
    const int n = random.integer(2, 8);
    for (int i = 0; i < n; ++i) {
        const double M = std::exp(random.real(-3, 3)), R = random.real(0.3, 0.6);
        const Eigen::Vector3d r = random.vector(0.7), v = random.vector(3);
        bodies.push_back(add(world, ball(M, R, r, v, e)));
        if (radii != nullptr) radii->push_back(R);
    }
    return bodies;
}

/// Every impulse is rounded once into each of its two bodies; with the sweeps of a step that makes so many roundings of the
/// largest momentum there is. Angular momentum is that times the place, below 1.3 m.
TEST(Impact, momentum_of_colliding_balls_is_kept) {
    RandomInput random(312);
    int impacts = 0;
    for (int i = 0; i < 300; ++i) {
        World world{};
        const std::vector<Known> bodies = add_cluster(world, random, random.real(0, 1));
        const Column p = linear_momentum(world, bodies);
        double largest = 0;
        for (const Known& body : bodies)
            largest = std::max(largest, static_cast<double>(body.M) * 10);  // speeds stay below 10 m/s
        const ingot::StepReport report = ingot::step(world, h);
        const double roundings = 2.0 * (report.sweeps * report.contacts + static_cast<int>(bodies.size()));
        ASSERT_LE(largest_difference(linear_momentum(world, bodies), p), 4 * roundings * u * largest);
        impacts += report.impact_waves > 0;
    }
    EXPECT_GT(impacts, 150);
}

/// Where momentum is exchanged: L about the origin, before and after an impact of balls that have not moved on.
TEST(Impact, angular_momentum_of_colliding_balls_is_kept) {
    RandomInput random(313);
    int counted = 0;
    for (int i = 0; i < 300; ++i) {
        World world{};
        const std::vector<Known> bodies = add_cluster(world, random, random.real(0, 1));
        const Column before = angular_momentum(world, bodies);
        double largest = 0;
        for (const Known& body : bodies) largest = std::max(largest, static_cast<double>(body.M) * 10 * 1.3);
        const ingot::StepReport report = ingot::step(world, h);
        if (!report.clean()) continue;  // contacts that still approach are then held by forces, which act along the path
        ++counted;
        // r x p does not change while a ball flies straight; its place is rounded once. Normals are unit to 3 roundings, and
        // what a normal is off its line of centres is a moment.
        const double roundings = 2.0 * (report.sweeps * report.contacts + static_cast<int>(bodies.size()));
        ASSERT_LE(largest_difference(angular_momentum(world, bodies), before), 3 * 4 * roundings * u * largest);
    }
    EXPECT_GT(counted, 200);
}

/// For e <= 1 an impact takes energy or keeps it; what speeds of contacts may be off is 8 roundings, and so is the energy. A
/// solve that stopped at its bound may be off by more: then the step says so.
TEST(Impact, energy_never_grows) {
    RandomInput random(314);
    int impacts = 0, unfinished = 0;
    double worst_unfinished = 0;
    for (int i = 0; i < 1000; ++i) {
        World world{};
        const double e = i % 3 == 0 ? 1 : random.real(0, 1);
        const std::vector<Known> bodies = add_cluster(world, random, e);
        const long double before = kinetic_energy(world, bodies);
        const ingot::StepReport report = ingot::step(world, h);
        const double change = static_cast<double>(kinetic_energy(world, bodies) / before - 1);
        impacts += report.impact_waves > 0;
        if (!report.clean()) {
            ++unfinished;
            worst_unfinished = std::max(worst_unfinished, change);
            continue;
        }
        if (!report.clean()) continue;  // a solve that stopped at its bound has said so
        const double rounding = 4 * ingot::limits::contact_slack * ingot::limits::contact_roundings * 2 * u * (1 + report.impact_waves) * 10;
        ASSERT_LE(change, rounding) << "case " << i << ", e = " << e;
        if (e == 1) {
            ASSERT_GE(change, -rounding) << "elastic impacts keep the energy; case " << i;
        }
    }
    std::printf("    %d of 1000 steps not solved in full, energy there grown by at most %.1e\n", unfinished, worst_unfinished);
    EXPECT_GT(impacts, 500);
    EXPECT_LT(unfinished, 50);
}

/// After a step no balls that are in each other approach, however many there are.
TEST(Impact, no_contact_approaches_any_more) {
    RandomInput random(315);
    int counted = 0;
    for (int i = 0; i < 300; ++i) {
        World world{};
        std::vector<double> radii;
        const std::vector<Known> bodies = add_cluster(world, random, random.real(0, 1), &radii);
        const ingot::StepReport report = ingot::step(world, h);
        if (!report.clean()) continue;  // it says itself that some do
        ++counted;
        for (int contact_i = 0; contact_i < world.contact_count(); ++contact_i) {
            const ingot::ContactInfo info = world.contact(contact_i).value;
            const ingot::BodyState A = world.state(info.A).value, B = world.state(info.B).value;
            if ((to_eigen(A.r_CM) - to_eigen(B.r_CM)).norm() > radii[info.A.slot] + radii[info.B.slot]) continue;  // they have parted
            const double speed = to_eigen(info.n).dot(to_eigen(A.v_CM) - to_eigen(B.v_CM));
            ASSERT_GE(speed, -speed_error(30)) << "case " << i;  // |n|_1 <= 1.74 times two speeds below 9 m/s
        }
    }
    std::printf("    %d of 300 clusters solved in full\n", counted);
    EXPECT_GT(counted, 200);
}

/// A ball in the corner of three walls hits them all at once. It leaves each with at least e times its speed into it, and with
/// no more where the wall pushed; in the corner of a cube that is -e v.
TEST(Impact, ball_squeezed_into_a_corner) {
    Eigen::Matrix3d corners[3];
    corners[0] = Eigen::Matrix3d::Identity();
    corners[1] << 0.8, 0, 0.6, 0, 1, 0, -0.28, 0, 0.96;
    corners[2] << 1, 0, 0, 0.6, 0.8, 0, 0.48, 0.36, 0.8;
    for (const Eigen::Matrix3d& normals : corners) {  // one normal a row
        for (const double e : {0.0, 0.5, 1.0}) {
            World world{};
            for (int i = 0; i < 3; ++i) (void)add(world, half_space(normals.row(i).transpose(), 0));
            const Eigen::Vector3d r = normals.inverse() * Eigen::Vector3d::Constant(0.499);  // a millimetre inside each wall
            const Eigen::Vector3d v = normals.inverse() * Eigen::Vector3d(-1, -2, -1.5);     // into each of them
            const Known body = add(world, ball(2, 0.5, r, v, e));
            const ingot::StepReport report = ingot::step(world, h);
            ASSERT_TRUE(report.clean());
            ASSERT_EQ(report.contacts, 3);
            // Each wall's speed is met to its tolerance; the three of them together as well as the walls are independent.
            const double conditioning = normals.inverse().norm();
            const double tolerance = conditioning * std::sqrt(3) * speed_error(2 * v.norm());
            for (int i = 0; i < 3; ++i) {
                const ingot::ContactInfo contact = world.contact(i).value;
                const Eigen::Vector3d n = to_eigen(contact.n);
                EXPECT_GE(n.dot(velocity(world, body)), -e * n.dot(v) - tolerance);
                if (contact.j > 0) {
                    EXPECT_LE(n.dot(velocity(world, body)), -e * n.dot(v) + tolerance);
                }
            }
            if (normals.isIdentity()) {
                EXPECT_LE((velocity(world, body) + e * v).norm(), tolerance);
            }
        }
    }
}

/// Gravity presses a ball into the corner: it stays.
TEST(Impact, ball_in_a_corner_rests) {
    World world{};
    for (int i = 0; i < 3; ++i) (void)add(world, half_space(Eigen::Vector3d::Unit(i), 0));
    const Known body = add(world, ball(2, 0.5, {0.5, 0.5, 0.5}, Eigen::Vector3d::Zero(), 0.5));
    ASSERT_EQ(world.set_gravity({-3, -4, -9}), ingot::Status::ok);
    for (int step_i = 0; step_i < 300; ++step_i) {
        const ingot::StepReport report = ingot::step(world, scalar(1) / 60);
        ASSERT_TRUE(report.clean());
        ASSERT_EQ(report.contacts, 3);
    }
    EXPECT_LE((position(world, body) - Eigen::Vector3d(0.5, 0.5, 0.5)).norm(), 300 * u * 0.5);
}

/// Two balls hit a third at the same time from either side of its way: by symmetry it leaves straight. Closed form: both
/// impulses are j = (1 + e) v cos(a) / (1/M + (1 + cos 2a)/M_3).
TEST(Impact, two_balls_hit_a_third_symmetrically) {
    for (const double e : {0.0, 0.5, 1.0}) {
        for (const double M_3 : {0.25, 1.0, 8.0}) {
            World world{};
            const double c = 0.8, s = 0.6, v = 2;  // cos a, sin a
            const Known third = add(world, ball(M_3, 0.5, {0, 0, 0}, {0, 0, 0}, e));
            const Known upper = add(world, ball(1, 0.5, {-c * 0.999, s * 0.999, 0}, {v, 0, 0}, e));
            const Known lower = add(world, ball(1, 0.5, {-c * 0.999, -s * 0.999, 0}, {v, 0, 0}, e));
            const ingot::StepReport report = ingot::step(world, h);
            ASSERT_TRUE(report.clean());
            ASSERT_EQ(report.contacts, 2);
            const double j = (1 + e) * v * c / (1 + (1 + c * c - s * s) / M_3),
                         tolerance = 4 * speed_error(3 * v) * std::max(1.0, 1 / M_3);
            EXPECT_NEAR(velocity(world, third)(0), 2 * j * c / M_3, tolerance);
            EXPECT_NEAR(velocity(world, third)(1), 0, tolerance);
            EXPECT_NEAR(velocity(world, upper)(0), v - j * c, tolerance);
            EXPECT_NEAR(velocity(world, upper)(1), j * s, tolerance);
            EXPECT_NEAR(velocity(world, upper)(0), velocity(world, lower)(0), tolerance);
            EXPECT_NEAR(velocity(world, upper)(1), -velocity(world, lower)(1), tolerance);
        }
    }
}

/// I7: five balls that touch. The impact passes through to the last; so many balls in, so many out.
TEST(Impact, newtons_cradle_passes_the_impact_on) {
    for (int movers = 1; movers <= 4; ++movers) {
        for (const bool backwards : {false, true}) {  // the order of the slots does not matter
            World world{};
            std::vector<Known> balls;
            for (int i = 0; i < 5; ++i) {
                const double v = i < movers ? 2 : 0, side = backwards ? -1 : 1;
                balls.push_back(add(world, ball(1, 0.5, {side * i, 0, 0}, {side * v, 0, 0}, 1)));
            }
            const long double energy = kinetic_energy(world, balls);
            const Column momentum = linear_momentum(world, balls);
            ASSERT_TRUE(ingot::step(world, h).clean());
            for (int i = 0; i < 5; ++i) {
                const double expected = i >= 5 - movers ? 2 : 0;
                EXPECT_NEAR(std::abs(velocity(world, balls[static_cast<std::size_t>(i)])(0)), expected, 4 * speed_error(4))
                    << movers << " movers, ball " << i;
            }
            EXPECT_NEAR(static_cast<double>(kinetic_energy(world, balls) / energy), 1, 16 * speed_error(1));
            EXPECT_LE(largest_difference(linear_momentum(world, balls), momentum), 16 * speed_error(2));
        }
    }
}

/// The same with gaps of 1e-3: one impact after the other, over many steps.
TEST(Impact, newtons_cradle_with_gaps) {
    World world{};
    std::vector<Known> balls;
    for (int i = 0; i < 5; ++i) balls.push_back(add(world, ball(1, 0.5, {i * 1.001, 0, 0}, {i == 0 ? 2.0 : 0.0, 0, 0}, 1)));
    for (int step_i = 0; step_i < 64; ++step_i) ASSERT_TRUE(ingot::step(world, h).clean());
    for (int i = 0; i < 5; ++i)
        EXPECT_NEAR(velocity(world, balls[static_cast<std::size_t>(i)])(0), i == 4 ? 2 : 0, 4 * speed_error(4));
}

/// A ball that hits two others of which one is against a wall: what the wall gives back comes through.
TEST(Impact, a_wall_behind_the_row_sends_the_impact_back) {
    World world{};
    (void)add(world, half_space({-1, 0, 0}, -2.5));  // x <= 2.5
    std::vector<Known> balls;
    for (int i = 0; i < 3; ++i)
        balls.push_back(add(world, ball(1, 0.5, {static_cast<double>(i), 0, 0}, {i == 0 ? 2.0 : 0.0, 0, 0}, 1)));
    ASSERT_TRUE(ingot::step(world, h).clean());
    EXPECT_NEAR(velocity(world, balls[0])(0), -2, 8 * speed_error(4));
    EXPECT_NEAR(velocity(world, balls[1])(0), 0, 8 * speed_error(4));
    EXPECT_NEAR(velocity(world, balls[2])(0), 0, 8 * speed_error(4));
}

}  // namespace

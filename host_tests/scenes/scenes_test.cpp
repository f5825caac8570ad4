// SPDX-License-Identifier: MIT
// What the scenes promise: the laws that hold over all of their steps.
#include "all_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

namespace {

using ingot::scalar;

constexpr bool is_double = sizeof(scalar) == 8;

double largest(const ingot::Vector& v) {
    return std::max({std::abs(double(v.x)), std::abs(double(v.y)), std::abs(double(v.z))});
}

/// Elastic impacts and free flight keep the energy; walls account for all momentum that is not there any more.
///
/// The bounds are the project's: 1e-10 and 1e-4 over 10^5 steps. Momentum: each of the N impacts rounds v and M v to epsilon of the
/// momentum p of a ball, and roundings add up like a random walk, to sqrt(N) epsilon p; 10 of those are allowed, and the sum of
/// wall impulses is kept in double.
TEST(Tumblers, keep_energy_and_account_for_momentum) {
    static ingot::World<scenes::Tumblers> world;
    ASSERT_EQ(set_up(world), ingot::Status::ok);
    const double energy = double(world.kinetic_energy());
    double walls[3] = {}, impacts = 0, momentum_of_ball = 0;
    const ingot::Vector begin = world.linear_momentum();
    const ingot::BodyId first_wall = world.body_at(0);

    for (int step_i = 0; step_i < 100000; ++step_i) {
        const ingot::StepReport report = ingot::step(world, scenes::Tumblers::h);
        ASSERT_TRUE(report.clean()) << "step " << step_i;
        for (int contact_i = 0; contact_i < world.contact_count(); ++contact_i) {
            const ingot::ContactInfo contact = world.contact(contact_i).value;
            impacts += contact.j > 0 ? 1 : 0;
            momentum_of_ball = std::max(momentum_of_ball, double(contact.j));
            if (contact.B.slot >= first_wall.slot + 6) continue;
            walls[0] += double(contact.n.x) * double(contact.j);
            walls[1] += double(contact.n.y) * double(contact.j);
            walls[2] += double(contact.n.z) * double(contact.j);
        }
    }
    const double drift = std::abs(double(world.kinetic_energy()) / energy - 1);
    const ingot::Vector end = world.linear_momentum();
    const double lost = std::max({std::abs(double(end.x) - double(begin.x) - walls[0]), std::abs(double(end.y) - double(begin.y) - walls[1]),
                                  std::abs(double(end.z) - double(begin.z) - walls[2])});
    EXPECT_LE(drift, is_double ? 1e-10 : 1e-4);
    EXPECT_LE(lost, 10 * std::sqrt(impacts) * double(ingot::epsilon) * momentum_of_ball);
    EXPECT_GT(impacts, 10000);
    std::cout << "    energy drift " << drift << ", momentum unaccounted for " << lost << " of " << momentum_of_ball << " N s in an impact, "
              << impacts << " impacts\n";

    // Nothing got out.
    for (int slot = 6; slot < scenes::Tumblers::max_bodies; ++slot)
        EXPECT_LE(largest(world.state(world.body_at(slot)).value.r_CM), 1.0);
}

struct OneBox : ingot::Scene {
    static constexpr int max_bodies = 2, max_contacts = 8;
    using solver = ingot::FrictionlessImpacts;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};

/// Four corners that land at once take a quarter of the impulse each: the box does not begin to turn.
TEST(FlatBox, does_not_turn_after_the_bounce) {
    for (const scalar e : {scalar(0), scalar(0.5), scalar(1)}) {
        for (const scalar about_z : {scalar(0), scalar(0.3), scalar(1)}) {
            ingot::World<OneBox> world;
            ASSERT_EQ(world.set_gravity({0, 0, scalar(-9.81)}), ingot::Status::ok);
            ingot::BodyDef ground;
            ground.immovable = true;
            ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
            ASSERT_TRUE(world.add(ground).ok());
            ingot::BodyDef box;
            const ingot::Vector half = {scalar(0.5), scalar(0.4), scalar(0.3)};
            box.mass = ingot::principal(ingot::solid_box(100, half)).value;
            box.shape = ingot::Box{half};
            box.restitution = e;
            box.state.r_CM = {0, 0, 2};
            box.state.A = ingot::axis_angle({0, 0, 1}, about_z);
            const ingot::BodyId id = world.add(box).value;

            double omega = 0;
            int steps_touching = 0;
            for (int step_i = 0; step_i < 240; ++step_i) {  // 2 s: several bounces
                const ingot::StepReport report = ingot::step(world, scalar(1) / 120);
                ASSERT_TRUE(report.clean());
                ASSERT_TRUE(report.contacts == 0 || report.contacts == 4);
                steps_touching += report.contacts > 0 ? 1 : 0;
                omega = std::max(omega, largest(world.omega(id).value));
            }
            EXPECT_GT(steps_touching, 0);
            EXPECT_LE(omega, is_double ? 1e-10 : 1e-4) << "e = " << e << ", turned by " << about_z;
            std::cout << "    e " << e << ", turned by " << about_z << ": |omega| " << omega << " rad/s\n";
        }
    }
}

/// With e < 1 everything on the plane comes to rest, and nothing sinks: what remains is the depth of the last slow impact, at
/// most rest_speed h.
TEST(Drop, comes_to_rest_on_the_plane) {
    static ingot::World<scenes::Drop> world;
    ASSERT_EQ(set_up(world), ingot::Status::ok);
    for (int step_i = 0; step_i < 20 * 240; ++step_i) ASSERT_TRUE(ingot::step(world, scenes::Drop::h).clean());
    const double speed_at_rest = 2 * double(scenes::Drop::g * scenes::Drop::h);
    for (int slot = 1; slot < scenes::Drop::max_bodies; ++slot) {
        const ingot::BodyId id = world.body_at(slot);
        const double before = double(world.state(id).value.r_CM.z);
        EXPECT_LE(largest(world.state(id).value.v_CM), speed_at_rest);
        const double lowest = slot <= scenes::Drop::box_count ? 0.3 : 0.25;  // the smallest half extent; the radius
        EXPECT_GE(before, lowest - speed_at_rest * double(scenes::Drop::h) - 1e-3);
    }
    std::vector<double> heights;
    for (int slot = 1; slot < scenes::Drop::max_bodies; ++slot) heights.push_back(double(world.state(world.body_at(slot)).value.r_CM.z));
    for (int step_i = 0; step_i < 10 * 240; ++step_i) ASSERT_TRUE(ingot::step(world, scenes::Drop::h).clean());
    for (int slot = 1; slot < scenes::Drop::max_bodies; ++slot)
        EXPECT_NEAR(double(world.state(world.body_at(slot)).value.r_CM.z), heights[size_t(slot - 1)], 1e-4) << "ten seconds later";
}

/// The satellite's L is bitwise constant, its energy stays to rounding for an hour: |dT/T| within 10 epsilon, which is what the
/// sum L.omega / 2 itself rounds to.
TEST(Satellite, keeps_L_bitwise_and_energy_to_rounding_for_an_hour) {
    static ingot::World<scenes::Satellite> world;
    ASSERT_EQ(set_up(world), ingot::Status::ok);
    const ingot::BodyId id = world.body_at(0);
    const ingot::Vector L = world.state(id).value.L;
    const double energy = double(world.kinetic_energy());
    double worst = 0;
    for (int step_i = 0; step_i < scenes::Satellite::demo_steps; ++step_i) {
        ASSERT_TRUE(ingot::step(world, scenes::Satellite::h).clean());
        worst = std::max(worst, std::abs(double(world.kinetic_energy()) / energy - 1));
    }
    const ingot::Vector after = world.state(id).value.L;
    EXPECT_EQ(L.x, after.x);
    EXPECT_EQ(L.y, after.y);
    EXPECT_EQ(L.z, after.z);
    EXPECT_LE(worst, 10 * double(ingot::epsilon));
    EXPECT_LE(double(ingot::orthogonality_error(world.state(id).value.A)), 4 * double(ingot::epsilon));
}

/// What hinges lead gains no energy but what a step of second order gives and takes back, and its joints stay closed. A fast whip loses some for
/// good: pushes take it.
///
/// A push ends below limits::joint_gap, and what it leaves grows by what the next substep turns; float adds roundings of places.
template <class S>
void expect_sound_swing() {
    static ingot::World<S> world;
    ASSERT_EQ(set_up(world), ingot::Status::ok);
    const auto energy = [] {
        double sum = double(world.kinetic_energy());
        for (int slot = 0; slot < S::max_bodies; ++slot) {
            const ingot::BodyId id = world.body_at(slot);
            sum += double(S::g) * double(world.mass(id).value) * double(world.state(id).value.r_CM.z);
        }
        return sum;
    };
    const double begin = energy();
    double most = 0, swing = 0;
    for (int step_i = 0; step_i < S::golden_steps; ++step_i) {
        ASSERT_TRUE(ingot::step(world, S::h).clean());
        most = std::max(most, energy() - begin);
        swing = std::max(swing, double(world.kinetic_energy()));
    }
    EXPECT_LE(most, 0.01 * swing);
    for (int slot = 0; slot < S::max_joints; ++slot)
        EXPECT_LE(double(world.joint_gap(world.joint_at(slot)).value), 2 * double(ingot::limits::joint_gap) + 64 * double(ingot::epsilon));
}
TEST(DoublePendulum, swings) { expect_sound_swing<scenes::DoublePendulum>(); }
TEST(ArmOfSix, swings) { expect_sound_swing<scenes::ArmOfSix>(); }

/// Ragdolls come to lie on the ground: no limb goes through it as it lands, and none is in it later.
TEST(Ragdolls, lie_on_the_ground) {
    static ingot::World<scenes::Ragdolls> world;
    ASSERT_EQ(set_up(world), ingot::Status::ok);
    constexpr double thinnest = 0.045, landed = 180;  // m; steps
    const double height = 0.9 + 1.9, way_of_substep = std::sqrt(2 * 9.81 * height) * double(scenes::Ragdolls::h) / 4;
    for (int step_i = 0; step_i < 300; ++step_i) {
        const ingot::StepReport report = ingot::step(world, scenes::Ragdolls::h);
        ASSERT_TRUE(scenes::Ragdolls::went_well(report)) << step_i;
        const double deepest = step_i < landed ? way_of_substep : double(ingot::limits::touching_gap);
        for (int slot = 1; slot < scenes::Ragdolls::max_bodies; ++slot)
            ASSERT_GE(double(world.state(world.body_at(slot)).value.r_CM.z), thinnest - deepest) << step_i;
    }
    for (int slot = 1; slot < scenes::Ragdolls::max_bodies; ++slot)
        EXPECT_LE(double(world.state(world.body_at(slot)).value.r_CM.z), 0.5);
}

}  // namespace

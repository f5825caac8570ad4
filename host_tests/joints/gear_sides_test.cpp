// SPDX-License-Identifier: MIT
// Gears whichever way their joints are: with any side as B, on the world, on what stands and on what moves as it is told, in trees and in touch.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;
using Eigen::Vector3d;
using ingot::Status;
using ingot_reference::to_eigen;

struct Works : ingot::Scene {
    static constexpr int max_bodies = 12, max_joints = 16, max_loops = 6, max_manifolds = 40, max_pairs = 80;
    static constexpr bool translates = true, kinematic_bodies = true;
    using joints = ingot::Joints<ingot::HingeJoint, ingot::SliderJoint, ingot::GearJoint, ingot::WithBreaking>;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
scalar number(double x) { return static_cast<scalar>(x); }

/// A body with the moment I about z and the mass M.
ingot::BodyDef rotor(double M, double I, const Vector3d& place) {
    ingot::BodyDef def;
    def.mass.M = number(M);
    def.mass.I_body = Vector{number(0.75 * I), number(0.75 * I), number(I)};
    def.mass.A_principal = ingot::identity_matrix<scalar>();
    def.state.r_CM = to_vector(place);
    return def;
}
/// B about z, or A and B the other way round.
template <class World>
ingot::JointId join(World& world, const ingot::Joint& kind, ingot::BodyId A, ingot::BodyId B, bool swaps, const Vector3d& P) {
    ingot::JointDef def;
    def.body_A = swaps ? B : A;
    def.body_B = swaps ? A : B;
    def.joint = kind;
    def.P = to_vector(P);
    const auto id = world.add_joint(def);
    EXPECT_TRUE(id.ok());
    return id.value;
}

/// X turns against the world, or a post; Y against X, k times as far. X is struck: (I_X + (1 + k)^2 I_Y) omega_X = H. Either joint may be the first
/// of the gear, and either body the A of its joint: its way is counted the other way round then.
TEST(GearSides, whichever_is_A_and_whichever_is_B) {
    RandomInput random(1);
    for (int run_i = 0; run_i < ingot_reference::draws(192); ++run_i) {
        const bool swaps_X = (run_i & 1) != 0, swaps_Y = (run_i & 2) != 0, is_other_first = (run_i & 4) != 0, on_post = (run_i & 8) != 0;
        const double k = (random.integer(0, 1) * 2 - 1) * std::exp(random.real(-2, 2)), rate = rates[random.integer(0, 4)];
        const double I_X = random.real(0.1, 5), I_Y = random.real(0.1, 5), H = random.real(0.5, 1);
        const auto world = std::make_unique<ingot::World<Works>>();
        ingot::BodyId post{};
        if (on_post) {
            ingot::BodyDef def;
            def.immovable = true;
            post = world->add(def).value;
        }
        const ingot::BodyId X = world->add(rotor(2, I_X, {0, 0, 0})).value, Y = world->add(rotor(1, I_Y, {0, 0, 1})).value;
        const ingot::JointId at_X = join(*world, ingot::HingeJoint{}, post, X, swaps_X, {0, 0, 0});
        const ingot::JointId at_Y = join(*world, ingot::HingeJoint{}, X, Y, swaps_Y, {0, 0, 1});
        const double r = k * (swaps_X == swaps_Y ? 1 : -1);
        const auto gear = is_other_first ? world->add_gear(at_Y, at_X, number(1 / r)) : world->add_gear(at_X, at_Y, number(r));
        ASSERT_TRUE(gear.ok());
        ASSERT_EQ(world->apply_angular_impulse(X, {0, 0, number(H)}), Status::ok);
        const double I = I_X + (1 + k) * (1 + k) * I_Y, of_X = H / I, of_Y = (1 + k) * H / I;
        // Rows are scaled by the larger way; what is solved are speeds as they would be without the gear, H / I_X.
        const double rounding = 64 * eps * (H / I_X) * (1 + std::abs(k));
        for (int step_i = 0; step_i < 20; ++step_i) {
            ASSERT_TRUE(ingot::step(*world, number(1 / rate)).clean());
            EXPECT_NEAR(static_cast<double>(world->omega(X).value.z), of_X, (step_i + 1) * rounding) << run_i << ", " << step_i;
            EXPECT_NEAR(static_cast<double>(world->omega(Y).value.z), of_Y, (step_i + 1) * rounding) << run_i << ", " << step_i;
        }
        EXPECT_LE(static_cast<double>(world->joint_gap(gear.value).value), held * (1 + std::abs(r) + 1 / std::abs(r))) << run_i;
    }
}

/// A rotor, geared to one that is told how to move, follows it at once, and the gear tells what that takes; where both are told it does nothing; what
/// moves freely again is geared again.
TEST(GearSides, what_becomes_kinematic_drives) {
    for (const bool is_first : {true, false})
        for (const double r : {-3.0, 0.5}) {
            const auto world = std::make_unique<ingot::World<Works>>();
            const double I = 2;
            const ingot::BodyId told = world->add(rotor(1, 3, {0, 0, 0})).value, free = world->add(rotor(1, I, {2, 0, 0})).value;
            const ingot::JointId at_told = join(*world, ingot::HingeJoint{}, {}, told, false, {0, 0, 0});
            const ingot::JointId at_free = join(*world, ingot::HingeJoint{}, {}, free, false, {2, 0, 0});
            // The free one goes k times as far.
            const auto gear = is_first ? world->add_gear(at_told, at_free, number(r)) : world->add_gear(at_free, at_told, number(r));
            ASSERT_TRUE(gear.ok());
            const double k = is_first ? r : 1 / r;
            const auto mass = [&](ingot::BodyId id) { return rotor(1, id == told ? 3 : I, {}).mass; };
            ASSERT_EQ(world->set_kinematic(told), Status::ok);
            double L = 0;
            for (int step_i = 0; step_i < 30; ++step_i) {
                const double W = step_i < 10 ? 1 : step_i < 20 ? -2 : 0.5;
                ASSERT_EQ(world->set_velocity(told, {}, {0, 0, number(W)}), Status::ok);
                ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
                const double now = static_cast<double>(world->state(free).value.L.z);
                EXPECT_NEAR(now, I * k * W, 1e-4 * I * std::abs(k)) << r << ", " << step_i;
                // It is told of the second joint's B: what the free one gets, by the ratio.
                const double torque = static_cast<double>(world->joint_reaction(gear.value).value.torque.z), of_free = (now - L) * 60;
                EXPECT_NEAR(torque, is_first ? of_free : -of_free / r, 1e-2 + 1e-3 * std::abs(of_free)) << r << ", " << step_i;
                L = now;
            }
            EXPECT_LE(static_cast<double>(world->joint_gap(gear.value).value), held * 4);
            // Both are told, and contradict the gear.
            ASSERT_EQ(world->set_kinematic(free), Status::ok);
            ASSERT_EQ(world->set_velocity(free, {}, {0, 0, 1}), Status::ok);
            ASSERT_EQ(world->set_velocity(told, {}, {0, 0, 1}), Status::ok);
            EXPECT_EQ(world->add_gear(at_told, at_free, 1).status, Status::immovable);
            for (int step_i = 0; step_i < 5; ++step_i) {
                ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
                EXPECT_EQ(world->joint_reaction(gear.value).value.torque.z, 0);
            }
            // The gap that came of it is taken back, by the one that moves by itself again.
            ASSERT_EQ(world->set_movable(free, mass(free)), Status::ok);
            ASSERT_EQ(world->set_velocity(told, {}, {}), Status::ok);
            for (int step_i = 0; step_i < 60; ++step_i) ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
            EXPECT_LE(static_cast<double>(world->joint_gap(gear.value).value), held * 4) << r;
            ASSERT_EQ(world->set_movable(told, mass(told)), Status::ok);
            ASSERT_EQ(world->apply_angular_impulse(told, {0, 0, 1}), Status::ok);
            ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
            EXPECT_NEAR(static_cast<double>(world->omega(free).value.z), k * static_cast<double>(world->omega(told).value.z), 1e-4);
            EXPECT_GT(std::abs(static_cast<double>(world->omega(told).value.z)), 0.01);
        }
}

/// What slides on a carrier that goes as it is told, and a wheel on the world: m v = j and I omega = -r j, with v - V = r omega.
TEST(GearSides, a_carrier_of_what_slides_drives) {
    for (const bool swaps : {false, true})
        for (const double r : {-0.5, 2.0}) {
            const auto world = std::make_unique<ingot::World<Works>>();
            const double V = 0.5, M = 3, I = 2;
            const ingot::BodyId carrier = world->add(rotor(1, 1, {0, 0, 0})).value;
            ASSERT_EQ(world->set_kinematic(carrier), Status::ok);
            const ingot::BodyId wheel = world->add(rotor(1, I, {3, 0, 0})).value, sliding = world->add(rotor(M, 1, {0, 0, 1})).value;
            const ingot::JointId at_wheel = join(*world, ingot::HingeJoint{}, {}, wheel, false, {3, 0, 0});
            const ingot::JointId at_sliding = join(*world, ingot::SliderJoint{}, carrier, sliding, swaps, {0, 0, 1});
            ASSERT_TRUE(world->add_gear(at_wheel, at_sliding, number(swaps ? -r : r)).ok());
            ASSERT_EQ(world->set_velocity(carrier, {0, 0, number(V)}, {}), Status::ok);
            const double j = V / (1 / M + r * r / I);
            for (int step_i = 0; step_i < 30; ++step_i) {
                ASSERT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
                EXPECT_NEAR(static_cast<double>(world->state(sliding).value.v_CM.z), j / M, 1e-4) << r << ", " << step_i;
                EXPECT_NEAR(static_cast<double>(world->omega(wheel).value.z), -r * j / I, 1e-4) << r << ", " << step_i;
            }
        }
}

/// Carts on the ground, each a box with boxes on it of which two turn by -1, or one has two hinges in a line: alone and beside others, to the bit.
TEST(GearSides, in_touch_as_if_alone) {
    RandomInput random(3);
    for (int run_i = 0; run_i < ingot_reference::draws(80); ++run_i) {
        const double spin[2] = {random.real(-2, 2), random.real(-2, 2)};
        const auto together = std::make_unique<ingot::World<Works>>(), alone = std::make_unique<ingot::World<Works>>();
        ingot::JointId gear{};
        const auto add_cart = [&](ingot::World<Works>& world, double x, int wheels, double turn, int doubled) {
            std::vector<ingot::BodyId> bodies;
            ingot::BodyDef def;
            const auto add_box = [&](const Vector& half, const Vector3d& place) {
                def.mass = ingot::principal(ingot::solid_box(100, half)).value;
                def.shape = ingot::Box{half};
                def.friction = scalar(0.5);
                def.state.r_CM = to_vector(place);
                bodies.push_back(world.add(def).value);
            };
            add_box({scalar(0.5), scalar(0.5), scalar(0.25)}, {x, 0, 0.25});
            std::vector<ingot::JointId> joints;
            for (int i = 0; i < wheels; ++i) {
                add_box({scalar(0.125), scalar(0.25), scalar(0.125)}, {x, 0, 0.75 + 0.25 * i});
                joints.push_back(join(world, ingot::HingeJoint{}, i < 2 ? bodies[0] : bodies[static_cast<size_t>(i)], bodies.back(), false,
                                      {x, 0, 0.75 + 0.25 * i}));
            }
            const auto id = world.add_gear(joints[0], joints[1], -1);
            EXPECT_TRUE(id.ok());
            gear = id.value;
            if (doubled > 0) {  // on a hinge of its own beside the other
                const ingot::BodyId A = doubled < 3 ? bodies[0] : bodies[static_cast<size_t>(doubled - 1)];
                (void)join(world, ingot::HingeJoint{}, A, bodies[static_cast<size_t>(doubled)], false, {x, 0, 0.5 + 0.25 * doubled});
                if (run_i % 4 != 0) {
                    EXPECT_EQ(world.remove(gear), Status::ok);
                }
            }
            EXPECT_EQ(world.apply_angular_impulse(bodies[1], {0, 0, number(turn)}), Status::ok);
            return bodies;
        };
        for (auto* const world : {together.get(), alone.get()}) ASSERT_TRUE(add_ground(*world) && weigh(*world));
        const int first_twice = random.integer(0, 3), twice = random.integer(0, 3), wheels = run_i % 2 == 1 && twice < 3 ? 2 : 3;
        (void)add_cart(*together, 9, 3 + run_i % 2, spin[0], first_twice);
        const std::vector<ingot::BodyId> second = add_cart(*together, 0, wheels, spin[1], twice);
        const std::vector<ingot::BodyId> by_itself = add_cart(*alone, 0, wheels, spin[1], twice);
        for (int step_i = 0; step_i < 60; ++step_i) {
            EXPECT_EQ(ingot::step(*together, scalar(1) / 60).bodies_frozen, 0);
            (void)ingot::step(*alone, scalar(1) / 60);
            ASSERT_TRUE(are_same(*together, *alone, second, by_itself)) << run_i << ", " << step_i;
        }
        if (!alone->is_alive(gear)) continue;
        EXPECT_LE(static_cast<double>(alone->joint_gap(gear).value), held * 2) << run_i;
        const auto turn_of = [&](size_t i) { return static_cast<double>(alone->omega(by_itself[i]).value.z); };
        EXPECT_NEAR(turn_of(1) - turn_of(0), turn_of(0) - turn_of(2), 1e-4) << run_i;
    }
}

}  // namespace

// SPDX-License-Identifier: MIT
// Drives of joints that close a loop, of any stiffness, as the steering of a wheel is held: they give no energy, at any size and rate, alone and
// beside others.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "joints/figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;
using ingot::Status;
using ingot_reference::to_eigen;

struct StiffLoops : ingot::Scene {
    static constexpr int max_bodies = 6, max_joints = 6, max_loops = 6;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::BallJoint, ingot::UniversalJoint, ingot::WheelJoint, ingot::WithDrives>;
};
using StiffWorld = ingot::World<StiffLoops>;

/// A ball or a universal joint, and then a wheel at the same place, whose steering is held: as it is joined, or by a spring. Lengths and speeds are
/// as many times those of a metre as its size.
struct StiffLoop {
    StiffWorld& world;
    ingot::BodyId bodies[2];
    double M = 0;
    bool is_stiff = false, sound = true;

    StiffLoop(StiffWorld& of, RandomInput random, double size, double y) : world(of) {
        const double density = std::exp(random.real(std::log(0.3), std::log(3e4)));
        double I = 0;
        for (int i = 0; i < 2; ++i) {
            ingot::BodyDef def;
            const Vector half = to_vector(size * Eigen::Vector3d(random.real(0.1, 0.3), random.real(0.1, 0.3), random.real(0.1, 0.3)));
            def.mass = ingot::principal(ingot::solid_box(static_cast<scalar>(density), half)).value;
            const ingot::UserMotion motion = {to_vector(size * random.vector(1)), to_vector(random.vector(2))};
            def.state = ingot::body_state(def.mass, {to_vector(Eigen::Vector3d(i == 0 ? 0 : 0.7 * size, y, 0))}, motion);
            M += static_cast<double>(def.mass.M);
            I = static_cast<double>(def.mass.I_body.x);
            const auto added = world.add(def);
            sound = sound && added.ok();
            bodies[i] = added.value;
        }
        ingot::JointDef def;
        const Eigen::Vector3d axis = random.direction();
        def.body_A = bodies[0];
        def.body_B = bodies[1];
        def.P = to_vector(Eigen::Vector3d(0.35 * size, y, 0));
        def.axis = to_vector(axis);
        def.axis_B = to_vector(Eigen::Vector3d(axis.unitOrthogonal()));
        def.joint = random.integer(0, 1) == 0 ? ingot::Joint(ingot::BallJoint{}) : ingot::Joint(ingot::UniversalJoint{});
        sound = sound && world.add_joint(def).ok();
        def.joint = ingot::WheelJoint{};
        const auto wheel = world.add_joint(def);
        sound = sound && wheel.ok();
        const bool as_joined = random.integer(0, 1) == 0;
        // Of what turns by it at rates from 1e2 to 1e6 a second.
        const double stiffness = std::min(I * std::exp(random.real(std::log(1e4), std::log(1e12))), 1e12);
        is_stiff = as_joined || stiffness > 1e10 * I;
        if (as_joined) return;
        const ingot::SpringDrive spring{static_cast<scalar>(stiffness)};
        sound = sound && world.set_joint_drive(wheel.value, spring, ingot::WheelJoint::steering) == Status::ok;
    }
    double energy() const { return kinetic_energy_of(world, {bodies[0], bodies[1]}); }
};

/// What springs hold they got from the motion: the energy of the bodies is never more than it was. Sides that round apart are drawn together:
/// limits::loop_gap in a substep, and of large ones a rounding of where they are.
TEST(StiffLoops, make_no_energy) {
    RandomInput random(1);
    int stiff = 0, beside = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(96); ++run_i) {
        const auto world = std::make_unique<StiffWorld>(), alone = std::make_unique<StiffWorld>();
        const double size = std::pow(2, random.real(-6, 6)), rate = rates[random.integer(0, 4)];
        const int count = random.integer(0, 1) == 0 ? 1 : 3;
        const bool alike = random.integer(0, 1) == 0;
        uint64_t seed = random.bits();
        std::vector<StiffLoop> loops, lonely;
        std::vector<double> allowed;
        for (int i = 0; i < count; ++i) {
            if (!alike) seed = random.bits();
            loops.emplace_back(*world, RandomInput(seed), size, 5 * size * i);
            if (i == 1) lonely.emplace_back(*alone, RandomInput(seed), size, 5 * size * i);
            ASSERT_TRUE(loops.back().sound);
            stiff += loops.back().is_stiff ? 1 : 0;
            const double gap = std::max(static_cast<double>(ingot::limits::loop_gap), 2 * eps * 12 * size), gap_speed = gap * 4 * rate;
            allowed.push_back(loops.back().energy() * (1 + 1e3 * eps) + loops.back().M * gap_speed * gap_speed);
        }
        for (int step_i = 0; step_i < 60; ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
            for (int i = 0; i < count; ++i)
                ASSERT_LT(loops[static_cast<size_t>(i)].energy(), allowed[static_cast<size_t>(i)])
                    << "run " << run_i << " step " << step_i << " loop " << i << " of size " << size << ", " << rate << " Hz";
            if (lonely.empty()) continue;
            (void)ingot::step(*alone, static_cast<scalar>(1 / rate));
            ASSERT_TRUE(are_same(*world, *alone, {loops[1].bodies[0], loops[1].bodies[1]}, {lonely[0].bodies[0], lonely[0].bodies[1]}));
            ++beside;
        }
    }
    EXPECT_GT(stiff, ingot_reference::draws(96) / 4);
    EXPECT_GT(beside, 0);
}

}  // namespace

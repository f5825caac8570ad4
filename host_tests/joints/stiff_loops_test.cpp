// SPDX-License-Identifier: MIT
// Drives of joints that close a loop, of any stiffness, as the steering of a wheel is held: they give no energy.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "joints/figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;
using ingot::Status;

struct StiffLoops : ingot::Scene {
    static constexpr int max_bodies = 2, max_joints = 2, max_loops = 2;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::BallJoint, ingot::UniversalJoint, ingot::WheelJoint, ingot::WithDrives>;
};

/// A ball or a universal joint, and then a wheel at the same place, whose steering is held: as it is joined, or by a spring. What springs hold they
/// got from the motion: the energy of the bodies is never more than it was. Sides that round apart are drawn together: limits::loop_gap in a substep.
TEST(StiffLoops, make_no_energy) {
    RandomInput random(1);
    int stiff = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(64); ++run_i) {
        const auto world = std::make_unique<ingot::World<StiffLoops>>();
        ingot::BodyId bodies[2];
        double M = 0;
        for (int i = 0; i < 2; ++i) {
            ingot::BodyDef def;
            const Vector half = to_vector(Eigen::Vector3d(random.real(0.1, 0.3), random.real(0.1, 0.3), random.real(0.1, 0.3)));
            def.mass = ingot::principal(ingot::solid_box(300, half)).value;
            const ingot::UserMotion motion = {to_vector(random.vector(1)), to_vector(random.vector(2))};
            def.state = ingot::body_state(def.mass, {{i == 0 ? scalar(0) : scalar(0.7), 0, 0}}, motion);
            M += static_cast<double>(def.mass.M);
            const auto added = world->add(def);
            ASSERT_TRUE(added.ok());
            bodies[i] = added.value;
        }
        ingot::JointDef def;
        const Eigen::Vector3d axis = random.direction();
        def.body_A = bodies[0];
        def.body_B = bodies[1];
        def.P = {scalar(0.35), 0, 0};
        def.axis = to_vector(axis);
        def.axis_B = to_vector(Eigen::Vector3d(axis.unitOrthogonal()));
        def.joint = random.integer(0, 1) == 0 ? ingot::Joint(ingot::BallJoint{}) : ingot::Joint(ingot::UniversalJoint{});
        ASSERT_TRUE(world->add_joint(def).ok());
        def.joint = ingot::WheelJoint{};
        const auto wheel = world->add_joint(def);
        ASSERT_TRUE(wheel.ok());
        const bool as_joined = random.integer(0, 1) == 0;
        const auto stiffness = static_cast<scalar>(std::exp(random.real(std::log(1e2), std::log(1e12))));
        if (!as_joined) {
            ASSERT_EQ(world->set_joint_drive(wheel.value, ingot::SpringDrive{stiffness}, ingot::WheelJoint::steering), Status::ok);
        }
        stiff += as_joined || stiffness > scalar(1e10) ? 1 : 0;

        const double rate = rates[random.integer(0, 4)], gap_speed = static_cast<double>(ingot::limits::loop_gap) * 4 * rate;
        const double allowed = static_cast<double>(world->kinetic_energy()) * (1 + 1e3 * eps) + M * gap_speed * gap_speed;
        for (int step_i = 0; step_i < 60; ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
            ASSERT_LT(static_cast<double>(world->kinetic_energy()), allowed) << "run " << run_i << " step " << step_i << ", " << rate << " Hz";
        }
    }
    EXPECT_GT(stiff, ingot_reference::draws(64) / 4);
}

}  // namespace

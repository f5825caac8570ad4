// SPDX-License-Identifier: MIT
// Machines that are asked for what cannot be, as by two rods of two lengths between the same two bodies. What is in them is slowed; what floats goes
// on as a whole, as nothing but itself holds it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "joints/figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;
using Eigen::Vector3d;
using ingot::Status;
using ingot_reference::to_eigen;

struct Jammed : ingot::Scene {
    static constexpr int max_bodies = 8, max_joints = 12, max_loops = 4;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::RodJoint>;
};
using JammedWorld = ingot::World<Jammed>;

/// Two boxes, two rods beside each other between them, and some boxes that hang on these. All move as one body.
struct JammedMachine {
    std::unique_ptr<JammedWorld> world = std::make_unique<JammedWorld>();
    ingot::JointId rod{};
    double length = 0, M = 0;
    Vector g{};
    bool sound = true;

    explicit JammedMachine(RandomInput& random, bool tied) {
        g = to_vector(random.vector(10));
        sound = world->set_gravity(g) == Status::ok;
        length = random.real(0.8, 1.2);
        const Vector3d way = random.direction() * length, aside = 0.15 * way.unitOrthogonal();
        const Vector3d v = random.vector(3), omega = random.vector(1);
        std::vector<ingot::BodyId> bodies;
        const int count = random.integer(2, 5);
        for (int i = 0; i < count; ++i) {
            const Vector3d r = i == 0 ? Vector3d(0, 0, 0) : i == 1 ? way : Vector3d((i - 1) * way + 0.5 * random.direction());
            ingot::BodyDef def;
            def.mass = ingot::principal(ingot::solid_box(static_cast<scalar>(random.real(200, 800)), {scalar(0.2), scalar(0.15), scalar(0.1)})).value;
            const ingot::UserMotion motion = {to_vector(v + omega.cross(r)), to_vector(omega)};
            def.state = ingot::body_state(def.mass, {to_vector(r), ingot_reference::to_matrix(random.rotation())}, motion);
            const auto added = world->add(def);
            sound = sound && added.ok();
            bodies.push_back(added.value);
            M += static_cast<double>(def.mass.M);
            if (i < 2) continue;
            ingot::JointDef joint;
            joint.body_A = bodies[static_cast<std::size_t>(random.integer(0, i - 1))];
            joint.body_B = added.value;
            joint.joint = random.integer(0, 1) == 0 ? ingot::Joint(ingot::BallJoint{}) : ingot::Joint(ingot::HingeJoint{});
            joint.P = to_vector(r);
            sound = sound && world->add_joint(joint).ok();
        }
        for (int side = 0; side < 2; ++side) {
            ingot::JointDef joint;
            joint.body_A = bodies[0];
            joint.body_B = bodies[1];
            joint.joint = ingot::RodJoint{};
            joint.P = to_vector(side * aside);
            joint.P_B = to_vector(way + side * aside);
            const auto added = world->add_joint(joint);
            sound = sound && added.ok();
            rod = added.value;
        }
        if (!tied) return;
        ingot::JointDef joint;
        joint.body_B = bodies[0];
        joint.joint = ingot::BallJoint{};
        sound = sound && world->add_joint(joint).ok();
    }
    Vector3d momentum() const { return to_eigen(world->linear_momentum()); }
    double energy() const { return static_cast<double>(world->kinetic_energy()); }
};

/// N s: of roundings of the speeds that it had. A step has 32 substeps at most, in each of which a body gets what two ways up and down give it.
double rounding_of(double M, double most_energy) { return 32 * 16 * static_cast<double>(ingot::epsilon) * std::sqrt(2 * M * most_energy); }

TEST(JammedMachines, that_float_keep_their_momentum) {
    RandomInput random(1);
    int slowed = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i) {
        JammedMachine machine(random, false);
        ASSERT_TRUE(machine.sound);
        const double longer = random.real(0, 1) < 0.5 ? random.real(0.4, 0.8) : random.real(1.2, 2);
        ASSERT_EQ(machine.world->set_joint_length(machine.rod, static_cast<scalar>(machine.length * longer)), Status::ok);
        double most = machine.energy();
        for (int step_i = 0; step_i < 60; ++step_i) {
            const double h = random.integer(0, 1) == 0 ? 1.0 / 60 : random.real(0.005, 0.03), before = machine.energy();
            const Vector3d expected = machine.momentum() + machine.M * h * to_eigen(machine.g);
            ASSERT_EQ(ingot::step(*machine.world, static_cast<scalar>(h)).bodies_frozen, 0);
            most = std::max(most, machine.energy());
            ASSERT_LT((machine.momentum() - expected).norm(), rounding_of(machine.M, most)) << "run " << run_i << " step " << step_i;
            slowed += machine.energy() < before / 2 ? 1 : 0;
        }
    }
    EXPECT_GT(slowed, ingot_reference::draws(40) / 4);  // else nothing was jammed
}

/// What is tied to the world does not gather what gravity gives.
TEST(JammedMachines, that_are_tied_stay_slow) {
    RandomInput random(2);
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i) {
        JammedMachine machine(random, true);
        ASSERT_TRUE(machine.sound);
        ASSERT_EQ(machine.world->set_joint_length(machine.rod, static_cast<scalar>(machine.length * random.real(1.3, 2))), Status::ok);
        for (int step_i = 0; step_i < 60; ++step_i) ASSERT_EQ(ingot::step(*machine.world, scalar(1) / 60).bodies_frozen, 0);
        const double fallen = machine.M * 10 * std::sqrt(3.0) * 4 * 5;  // J: of a fall by all of its length, five times
        EXPECT_LT(machine.energy(), fallen) << "run " << run_i;
    }
}

}  // namespace

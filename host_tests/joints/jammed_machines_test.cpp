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
    static constexpr int max_bodies = 20, max_joints = 32, max_loops = 12;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::RodJoint>;
};
using JammedWorld = ingot::World<Jammed>;

/// Two boxes, two rods beside each other between them, and some boxes that hang on these. All move as one body. Lengths, speeds and gravity are as
/// many times those of a machine of a metre as its size; times are not.
struct JammedMachine {
    JammedWorld& world;
    std::vector<ingot::BodyId> bodies;
    ingot::JointId rod{};
    double size, length = 0, M = 0;
    bool sound = true;

    JammedMachine(JammedWorld& of, RandomInput random, double of_size, bool tied, const Vector3d& place) : world(of), size(of_size) {
        length = size * random.real(0.8, 1.2);
        const Vector3d way = random.direction() * length, aside = 0.15 * way.unitOrthogonal() * size;
        const Vector3d v = size * random.vector(3), omega = random.vector(1);
        const double density = std::exp(random.real(std::log(0.1), std::log(1e4)));
        const int count = random.integer(2, 5);
        for (int i = 0; i < count; ++i) {
            const Vector3d r = i == 0 ? Vector3d(0, 0, 0) : i == 1 ? way : Vector3d((i - 1) * way + 0.5 * size * random.direction());
            ingot::BodyDef def;
            const Vector half = to_vector(size * Vector3d(0.2, 0.15, 0.1));
            def.mass = ingot::principal(ingot::solid_box(static_cast<scalar>(density * random.real(0.5, 2)), half)).value;
            const ingot::UserMotion motion = {to_vector(v + omega.cross(r)), to_vector(omega)};
            def.state = ingot::body_state(def.mass, {to_vector(place + r), ingot_reference::to_matrix(random.rotation())}, motion);
            const auto added = world.add(def);
            sound = sound && added.ok();
            bodies.push_back(added.value);
            M += static_cast<double>(def.mass.M);
            if (i < 2) continue;
            ingot::JointDef joint;
            joint.body_A = bodies[static_cast<std::size_t>(random.integer(0, i - 1))];
            joint.body_B = added.value;
            joint.joint = random.integer(0, 1) == 0 ? ingot::Joint(ingot::BallJoint{}) : ingot::Joint(ingot::HingeJoint{});
            joint.P = to_vector(place + r);
            sound = sound && world.add_joint(joint).ok();
        }
        for (int side = 0; side < 2; ++side) {
            ingot::JointDef joint;
            joint.body_A = bodies[0];
            joint.body_B = bodies[1];
            joint.joint = ingot::RodJoint{};
            joint.P = to_vector(place + side * aside);
            joint.P_B = to_vector(place + way + side * aside);
            const auto added = world.add_joint(joint);
            sound = sound && added.ok();
            rod = added.value;
        }
        if (!tied) return;
        ingot::JointDef joint;
        joint.body_B = bodies[0];
        joint.joint = ingot::BallJoint{};
        joint.P = to_vector(place);
        sound = sound && world.add_joint(joint).ok();
    }
    void ask_for(double share) { sound = sound && world.set_joint_length(rod, static_cast<scalar>(length * share)) == Status::ok; }
    Vector3d momentum() const {
        Vector3d sum(0, 0, 0);
        for (const ingot::BodyId id : bodies) sum += static_cast<double>(world.mass(id).value) * to_eigen(world.state(id).value.v_CM);
        return sum;
    }
    double energy() const { return kinetic_energy_of(world, bodies); }
};

/// A machine, or three beside each other whose lanes they share, and a world in which the second stands alone.
struct JammedMachines {
    std::unique_ptr<JammedWorld> world = std::make_unique<JammedWorld>(), alone = std::make_unique<JammedWorld>();
    std::vector<JammedMachine> machines, lonely;
    Vector3d g;
    double rate;
    bool sound = true;

    JammedMachines(RandomInput& random, bool tied) {
        const double size = std::pow(2, random.real(-6, 6));
        g = size * random.vector(10);
        rate = rates[random.integer(0, 4)];
        sound = world->set_gravity(to_vector(g)) == Status::ok && alone->set_gravity(to_vector(g)) == Status::ok;
        const int count = random.integer(0, 1) == 0 ? 1 : 3;
        const bool alike = random.integer(0, 1) == 0;
        uint64_t seed = random.bits();
        for (int i = 0; i < count; ++i) {
            const Vector3d place(0, 20 * size * i, 0);
            if (!alike) seed = random.bits();
            machines.emplace_back(*world, RandomInput(seed), size, tied, place);
            if (i == 1) lonely.emplace_back(*alone, RandomInput(seed), size, tied, place);
            sound = sound && machines.back().sound;
        }
    }
    void ask_for(size_t i, double share) {
        machines[i].ask_for(share);
        if (i == 1) lonely[0].ask_for(share);
        sound = sound && machines[i].sound;
    }
    void step(double h) {
        ASSERT_EQ(ingot::step(*world, static_cast<scalar>(h)).bodies_frozen, 0);
        (void)ingot::step(*alone, static_cast<scalar>(h));
        if (lonely.empty()) return;
        ASSERT_TRUE(are_same(*world, *alone, machines[1].bodies, lonely[0].bodies));
    }
};

/// N s: of roundings of the speeds that it had. A step has 32 substeps at most, in each of which a body gets what two ways up and down give it.
double rounding_of(double M, double most_energy) { return 32 * 16 * static_cast<double>(ingot::epsilon) * std::sqrt(2 * M * most_energy); }

TEST(JammedMachines, that_float_keep_their_momentum) {
    RandomInput random(1);
    int slowed = 0, beside = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(60); ++run_i) {
        JammedMachines jammed(random, false);
        for (size_t i = 0; i < jammed.machines.size(); ++i)
            if (i == 0 || random.integer(0, 1) == 0) jammed.ask_for(i, random.real(0, 1) < 0.5 ? random.real(0.4, 0.8) : random.real(1.2, 2));
        ASSERT_TRUE(jammed.sound);
        std::vector<double> most(jammed.machines.size(), 0);
        for (int step_i = 0; step_i < 60; ++step_i) {
            const double h = static_cast<double>(static_cast<scalar>((random.integer(0, 1) == 0 ? 1 : random.real(0.5, 1)) / jammed.rate));
            std::vector<Vector3d> expected;
            std::vector<double> before;
            for (size_t i = 0; i < jammed.machines.size(); ++i) {
                const JammedMachine& machine = jammed.machines[i];
                expected.push_back(machine.momentum() + machine.M * h * jammed.g);
                before.push_back(machine.energy());
                most[i] = std::max(most[i], machine.energy());
            }
            ASSERT_NO_FATAL_FAILURE(jammed.step(h)) << "run " << run_i << " step " << step_i;
            for (size_t i = 0; i < jammed.machines.size(); ++i) {
                const JammedMachine& machine = jammed.machines[i];
                most[i] = std::max(most[i], machine.energy());
                ASSERT_LT((machine.momentum() - expected[i]).norm(), rounding_of(machine.M, most[i]))
                    << "run " << run_i << " step " << step_i << " machine " << i << " of size " << machine.size << ", " << jammed.rate << " Hz";
                slowed += machine.energy() < before[i] / 2 ? 1 : 0;
            }
            beside += jammed.machines.size() > 1 ? 1 : 0;
        }
    }
    EXPECT_GT(slowed, ingot_reference::draws(60) / 4);  // else nothing was jammed
    EXPECT_GT(beside, 0);
}

/// What is tied to the world does not gather what gravity gives.
TEST(JammedMachines, that_are_tied_stay_slow) {
    RandomInput random(2);
    for (int run_i = 0; run_i < ingot_reference::draws(60); ++run_i) {
        JammedMachines jammed(random, true);
        for (size_t i = 0; i < jammed.machines.size(); ++i) jammed.ask_for(i, random.real(1.3, 2));
        ASSERT_TRUE(jammed.sound);
        for (int step_i = 0; step_i < 60; ++step_i) ASSERT_NO_FATAL_FAILURE(jammed.step(1 / jammed.rate)) << "run " << run_i << " step " << step_i;
        for (const JammedMachine& machine : jammed.machines) {
            // J: of a fall by all of its length, five times.
            const double fallen = machine.M * 10 * machine.size * std::sqrt(3.0) * 4 * machine.size * 5;
            EXPECT_LT(machine.energy(), fallen) << "run " << run_i << ", size " << machine.size << ", " << jammed.rate << " Hz";
        }
    }
}

}  // namespace

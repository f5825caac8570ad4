// SPDX-License-Identifier: MIT
// Energy of figures that catch light bodies between themselves and the ground: sweeps do not settle there, and give none all the same, whatever else
// the scene names.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;

struct Plain : ingot::Scene {
    static constexpr int max_bodies = 16, max_joints = 8, max_manifolds = 40, max_pairs = 120;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::UniversalJoint>;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
struct Rolling : Plain {
    static constexpr bool rolling_resistance = true;
};
struct WithBelts : Plain {
    static constexpr bool surface_velocities = true;
};
struct RollingWithLimits : Rolling {
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::UniversalJoint, ingot::WithLimits>;
};
struct RollingWithDrives : Rolling {
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::UniversalJoint, ingot::WithLimits, ingot::WithDrives>;
};
struct RollingWithLoops : Rolling {
    static constexpr int max_loops = 2;
};
struct RollingMachines : RollingWithDrives {
    static constexpr int max_loops = 2;
};

double size_of(const ingot::Vector& half) { return std::sqrt(static_cast<double>(ingot::length_sq(half))); }

template <class World>
ingot::BodyId add_box(World& world, const ingot::Vector& half, double M, const ingot::Vector& at, scalar friction) {
    ingot::BodyDef def;
    def.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, half), static_cast<scalar>(M))).value;
    def.shape = ingot::Box{half};
    def.state.r_CM = at;
    def.friction = friction;
    return world.add(def).value;
}

/// A pendulum that swings down, and a box of 0.1 to 1 kg on the ground below, which is higher than what the pendulum leaves free.
template <class Scene>
void add_trap(ingot::World<Scene>& world, RandomInput& random, scalar x) {
    const auto real = [&](double low, double high) { return static_cast<scalar>(random.real(low, high)); };
    const double M = random.real(0.1, 1);
    const ingot::Vector light = {real(0.1, 0.3), real(0.1, 0.3), real(0.1, 0.3)}, heavy = {real(0.1, 0.4), real(0.1, 0.4), real(0.1, 0.4)};
    const scalar friction = real(0, 1), arm = real(0.5, 1.2), reach = arm + static_cast<scalar>(size_of(heavy));
    const scalar anchor = reach + 2 * light.z * real(0.2, 0.9);
    (void)add_box(world, light, M, {x + real(-0.3, 0.3), real(-0.2, 0.2), light.z}, friction);
    ingot::JointDef joint;
    joint.body_B = add_box(world, heavy, M * std::exp(random.real(0, std::log(1000))), {x - arm, 0, anchor}, friction);
    joint.joint = kinds[random.integer(0, 1) == 0 ? random.integer(0, 1) : 3];
    joint.P = {x, 0, anchor};
    joint.axis = {0, 1, 0};
    joint.axis_B = {1, 0, 0};
    const ingot::JointId id = world.add_joint(joint).value;
    if constexpr (Scene::joints::has_drives)
        if (joint.joint.kind != ingot::JointKind::ball)  // a brake takes energy
            EXPECT_EQ(world.set_joint_drive(id, ingot::MotorDrive{0, static_cast<scalar>(M * random.real(0, 10))}), ingot::Status::ok);
}

template <class World>
double height_energy(const World& world, double& M) {
    double E = M = 0;
    for (int slot = 0; slot < 16; ++slot) {
        const ingot::BodyId id = world.body_at(slot);
        if (id == ingot::BodyId{} || !(world.mass(id).value > 0)) continue;
        M += static_cast<double>(world.mass(id).value);
        E += g * static_cast<double>(world.mass(id).value) * static_cast<double>(world.state(id).value.r_CM.z);
    }
    return E;
}

template <class Scene>
struct PressedLightBodies : testing::Test {};
using Scenes = testing::Types<Plain, Rolling, WithBelts, RollingWithLimits, RollingWithDrives, RollingWithLoops, RollingMachines>;
TYPED_TEST_SUITE(PressedLightBodies, Scenes);

/// As of all figures that fall: see joint_energy_test. Second orders of turns are a share of what moves, whatever its height.
TYPED_TEST(PressedLightBodies, give_their_figures_no_energy) {
    for (int run_i = 0; run_i < ingot_reference::draws(120); ++run_i) {
        RandomInput random(static_cast<uint64_t>(run_i));
        const auto world = std::make_unique<ingot::World<TypeParam>>();
        ASSERT_TRUE(weigh(*world) && add_ground(*world));
        for (int i = 0; i < 1 + run_i % 3; ++i) add_trap(*world, random, static_cast<scalar>(8 * i));
        const double rate = rates[run_i % 5];
        double M = 0, last = height_energy(*world, M), before = last;
        for (int step_i = 0; step_i < static_cast<int>(1.5 * rate); ++step_i) {
            const double motion = static_cast<double>(world->kinetic_energy());
            ASSERT_EQ(step(*world, static_cast<scalar>(1 / rate)).bodies_frozen, 0u);
            const double now = static_cast<double>(world->kinetic_energy()) + height_energy(*world, M);
            ASSERT_LE(now, std::max(last, before) + 0.01 * (M * g + motion)) << run_i << ", " << rate << " Hz, step " << step_i;
            before = last;
            last = now;
        }
    }
}

}  // namespace

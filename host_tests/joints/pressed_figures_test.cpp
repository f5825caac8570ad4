// SPDX-License-Identifier: MIT
// Figures that kinematic bodies press against their own joints: what cannot be stays bounded, is told, and ends.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;

struct Pressed : ingot::Scene {
    static constexpr int max_bodies = 16, max_joints = 12, max_manifolds = 40, max_pairs = 120;
    static constexpr bool translates = true, kinematic_bodies = true;
    using joints = ingot::Joints<ingot::BallJoint>;
    using shapes = ingot::Shapes<ingot::Box, ingot::Capsule, ingot::HalfSpace>;
};
using World = ingot::World<Pressed>;

struct Hung {
    std::vector<ingot::BodyId> bodies;
    std::vector<double> masses;
    ingot::BodyId plate;
    double length = 0;
};

ingot::BodyId add_capsule(World& world, Hung& hung, double M, double radius, double half, ingot::Vector at, bool lies) {
    ingot::BodyDef def;
    const auto r = static_cast<scalar>(radius), l = static_cast<scalar>(half);
    def.mass = ingot::principal(ingot::with_mass(ingot::solid_capsule(1, r, l), static_cast<scalar>(M))).value;
    def.shape = ingot::Capsule{r, l};
    def.state.r_CM = at;
    if (lies) def.state.A = ingot::axis_angle({0, 1, 0}, scalar(1.5707963));
    def.friction = scalar(0.6);
    hung.bodies.push_back(world.add(def).value);
    hung.masses.push_back(M);
    return hung.bodies.back();
}

/// A post that hangs on the world, an arm across it, and a plate below that comes up: the post is between the plate and its own joint.
Hung add_hung(World& world, RandomInput& random, scalar x, double size) {
    Hung hung;
    const double M = random.real(1, 40), radius = size / 3, half = size;
    const auto s = static_cast<scalar>(size);
    const ingot::BodyId post = add_capsule(world, hung, M, radius, half, {x, 0, -s}, false);
    ingot::JointDef joint;
    joint.joint = ingot::BallJoint{};
    joint.body_B = post;
    joint.P = {x, 0, 0};
    EXPECT_TRUE(world.add_joint(joint).ok());
    const double arm = random.real(0.5, 1) * size;
    const scalar z = -s * static_cast<scalar>(random.real(0.5, 1.2)), near = x + s / 3;
    const ingot::BodyId limb = add_capsule(world, hung, M * random.real(0.1, 1), size / 6, arm, {near + static_cast<scalar>(arm), 0, z}, true);
    joint.body_A = post;
    joint.body_B = limb;
    joint.P = {near, 0, z};
    EXPECT_TRUE(world.add_joint(joint).ok());
    ingot::BodyDef plate;
    plate.kinematic = true;
    plate.shape = ingot::Box{{s, s, s / 6}};
    plate.state.r_CM = {x + s * static_cast<scalar>(random.real(0, 0.3)), 0, -3 * s};
    plate.friction = scalar(0.6);
    hung.plate = world.add(plate).value;
    hung.length = 2 * size + 2 * radius + 2 * arm;
    return hung;
}

double energy_of_translation(const World& world, const Hung& hung) {
    double E = 0;
    for (size_t i = 0; i < hung.bodies.size(); ++i) {
        const ingot::Vector v = world.state(hung.bodies[i]).value.v_CM;
        E += hung.masses[i] / 2 * static_cast<double>(ingot::dot(v, v));
    }
    return E;
}

/// Kinetic energy stays below that of the figure's mass at four times the speed of the plate and what it can fall: pushes give no more, in any
/// substep, and falls are from no higher than twice the length of the figure. The contradiction is told.
TEST(PressedFigures, stay_within_what_presses_them) {
    for (int run_i = 0; run_i < ingot_reference::draws(24); ++run_i) {
        RandomInput random(static_cast<uint64_t>(run_i));
        const auto world = std::make_unique<World>();
        ASSERT_TRUE(weigh(*world));
        const double size = random.real(0.1, 0.5), u = random.real(0.2, 2);
        std::vector<Hung> all;
        for (int i = 0; i < 1 + run_i % 3; ++i) all.push_back(add_hung(*world, random, static_cast<scalar>(8 * i), size));
        const double rate = rates[random.integer(0, 4)];
        const double up = 2.5 * size / u;
        bool told = false;
        for (int step_i = 0; step_i < static_cast<int>(2 * up * rate) + 1; ++step_i) {
            const bool rises = step_i < up * rate;
            for (const Hung& hung : all)
                ASSERT_EQ(world->set_velocity(hung.plate, {0, 0, static_cast<scalar>(rises ? u : -u)}), ingot::Status::ok);
            const ingot::StepReport report = step(*world, static_cast<scalar>(1 / rate));
            told = told || !report.clean();
            ASSERT_EQ(report.bodies_frozen, 0u) << run_i;
            for (const Hung& hung : all) {
                const double M = hung.masses[0] + hung.masses[1];
                ASSERT_LE(energy_of_translation(*world, hung), M * (8 * u * u + 2 * figures::g * hung.length))
                    << run_i << ", " << rate << " Hz, step " << step_i << ", u " << u << ", size " << size;
            }
        }
        EXPECT_TRUE(told) << run_i;
    }
}

}  // namespace

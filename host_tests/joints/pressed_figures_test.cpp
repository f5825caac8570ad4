// SPDX-License-Identifier: MIT
// Figures that kinematic bodies press against their own joints: what cannot be stays bounded, is told, and ends; what can be is done.
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
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint>;
    using shapes = ingot::Shapes<ingot::Box, ingot::Capsule, ingot::Sphere, ingot::HalfSpace>;
};
struct Braked : Pressed {
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::WithLimits, ingot::WithDrives>;
};
struct Looped : Braked {
    static constexpr int max_loops = 4;
};

struct Hung {
    std::vector<ingot::BodyId> bodies;
    std::vector<double> masses;
    ingot::BodyId plate;
    double length = 0;
};

template <class World>
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

/// A post that hangs on the world, an arm across it, and a plate below that comes up: the post is between the plate and its own joint. Where there
/// are drives, both joints have brakes, which give no energy.
template <class Scene>
Hung add_hung(ingot::World<Scene>& world, RandomInput& random, scalar x, double size) {
    Hung hung;
    const double M = random.real(1, 40), radius = size / 3, half = size;
    const auto s = static_cast<scalar>(size);
    const ingot::BodyId post = add_capsule(world, hung, M, radius, half, {x, 0, -s}, false);
    ingot::JointDef joint;
    joint.joint = ingot::BallJoint{};
    joint.body_B = post;
    joint.P = {x, 0, 0};
    const ingot::JointId shoulder = world.add_joint(joint).value;
    const double arm = random.real(0.5, 1) * size;
    const scalar z = -s * static_cast<scalar>(random.real(0.5, 1.2)), near = x + s / 3;
    const ingot::BodyId limb = add_capsule(world, hung, M * random.real(0.1, 1), size / 6, arm, {near + static_cast<scalar>(arm), 0, z}, true);
    joint.body_A = post;
    joint.body_B = limb;
    joint.P = {near, 0, z};
    const ingot::JointId elbow = world.add_joint(joint).value;
    if constexpr (Scene::joints::has_drives)
        for (const ingot::JointId id : {shoulder, elbow}) {
            const double most = M * size * figures::g * random.real(0.1, 10);
            EXPECT_EQ(world.set_ball_drive(id, ingot::MotorDrive{0, static_cast<scalar>(most)}), ingot::Status::ok);
        }
    ingot::BodyDef plate;
    plate.kinematic = true;
    plate.shape = ingot::Box{{s, s, s / 6}};
    plate.state.r_CM = {x + s * static_cast<scalar>(random.real(0, 0.3)), 0, -3 * s};
    plate.friction = scalar(0.6);
    hung.plate = world.add(plate).value;
    hung.length = 2 * size + 2 * radius + 2 * arm;
    return hung;
}

double trace_of_inertia(const ingot::Vector& I) { return static_cast<double>(I.x) + static_cast<double>(I.y) + static_cast<double>(I.z); }

/// J, of motion and of turning.
template <class World>
double kinetic_energy_of(const World& world, const Hung& hung) {
    double E = 0;
    for (size_t i = 0; i < hung.bodies.size(); ++i) {
        const ingot::BodyState state = world.state(hung.bodies[i]).value;
        const ingot::Vector I = world.inertia(hung.bodies[i]).value, L = ingot::transpose_times(state.A, state.L);
        E += hung.masses[i] / 2 * static_cast<double>(ingot::dot(state.v_CM, state.v_CM));
        E += static_cast<double>(L.x * L.x / I.x + L.y * L.y / I.y + L.z * L.z / I.z) / 2;
    }
    return E;
}

/// J, that a plate at u can give in a step of h seconds: 2 u to all of the mass, and to each body what a rod of its length has that was in line with
/// its joint as the step began.
template <class World>
double given_by_push(const World& world, const Hung& hung, double u, double h) {
    double E = 0;
    for (size_t i = 0; i < hung.bodies.size(); ++i)
        E += 2 * hung.masses[i] * u * u + u / h * std::sqrt(hung.masses[i] * trace_of_inertia(world.inertia(hung.bodies[i]).value) / 24);
    return E;
}

template <class Scene>
struct PressedFigures : testing::Test {};
using Scenes = testing::Types<Pressed, Braked, Looped>;
TYPED_TEST_SUITE(PressedFigures, Scenes);

/// Kinetic energy stays below what the plate can give and what the figure can fall, from no higher than twice its length, in any step: turning as
/// well. The contradiction is told.
TYPED_TEST(PressedFigures, stay_within_what_presses_them) {
    for (int run_i = 0; run_i < ingot_reference::draws(24); ++run_i) {
        RandomInput random(static_cast<uint64_t>(run_i));
        const auto world = std::make_unique<ingot::World<TypeParam>>();
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
                ASSERT_LE(kinetic_energy_of(*world, hung), given_by_push(*world, hung, u, 1 / rate) + 2 * M * figures::g * hung.length)
                    << run_i << ", " << rate << " Hz, step " << step_i << ", u " << u << ", size " << size;
            }
        }
        EXPECT_TRUE(told) << run_i;
    }
}

/// A door that a hand opens near its hinge is a lever, and not in line: it is as fast as the hand has it, but for what changes in four steps. The
/// nearest is what a step makes of a door in line: sqrt(2 w u h).
TYPED_TEST(PressedFigures, open_as_doors_do) {
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i) {
        RandomInput random(static_cast<uint64_t>(run_i));
        const auto world = std::make_unique<ingot::World<TypeParam>>();
        const double w = random.real(0.3, 1.5), u = random.real(0.1, 1), rate = rates[random.integer(0, 4)];
        const double nearest = std::sqrt(2 * w * u / rate), r = nearest + random.real(0, 1) * std::max(0.0, w / 2 - nearest), radius = r / 10;
        const double thick = r / 10;
        ingot::BodyDef door;
        const ingot::Vector half = {static_cast<scalar>(w / 2), static_cast<scalar>(thick), static_cast<scalar>(w)};
        door.mass = ingot::principal(ingot::solid_box(static_cast<scalar>(random.real(10, 1000)), half)).value;
        door.shape = ingot::Box{half};
        door.state.r_CM = {static_cast<scalar>(w / 2), 0, 0};
        const ingot::BodyId door_id = world->add(door).value;
        ingot::JointDef hinge;
        hinge.body_B = door_id;
        hinge.joint = ingot::HingeJoint{};
        hinge.axis = {0, 0, 1};
        ASSERT_TRUE(world->add_joint(hinge).ok());
        ingot::BodyDef hand;
        hand.kinematic = true;
        hand.shape = ingot::Sphere{static_cast<scalar>(radius)};
        hand.state.r_CM = {static_cast<scalar>(r), static_cast<scalar>(-thick - radius), 0};
        const ingot::BodyId hand_id = world->add(hand).value;
        ASSERT_EQ(world->set_velocity(hand_id, {0, static_cast<scalar>(u), 0}), ingot::Status::ok);
        for (int step_i = 0; step_i < static_cast<int>(r / u * rate); ++step_i) {
            (void)step(*world, static_cast<scalar>(1 / rate));
            const ingot::BodyState now = world->state(door_id).value;
            const double at = static_cast<double>(ingot::dot(now.A.c0, world->state(hand_id).value.r_CM));
            const double spin = std::sqrt(static_cast<double>(ingot::dot(now.v_CM, now.v_CM))) / (w / 2);
            if (step_i < 2) continue;  // they meet
            ASSERT_GE(spin, u * static_cast<double>(now.A.c1.y) / at * (1 - 4 * u / rate / r))
                << run_i << ", " << rate << " Hz, step " << step_i << ", w " << w << ", r " << r << ", u " << u;
        }
    }
}

}  // namespace

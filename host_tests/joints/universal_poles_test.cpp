// SPDX-License-Identifier: MIT
// Energy of what swings past the pole of a universal joint, where it has to turn about the axis that it passes as fast as it can: it gets none.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;

struct Plain : ingot::Scene {
    static constexpr int max_bodies = 12, max_joints = 12;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::UniversalJoint>;
};
struct WithLimits : Plain {
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::UniversalJoint, ingot::WithLimits>;
};
struct WithBrakes : Plain {
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::UniversalJoint, ingot::WithLimits, ingot::WithDrives>;
};
struct WithLoops : Plain {
    static constexpr int max_loops = 2;
};
struct Machines : WithBrakes {
    static constexpr int max_loops = 2;
};

using Eigen::Vector3d;

/// A pendulum is tied to the world by a universal joint whose axis there is the pole; its mass at a lever comes up to the pole, and turns about it.
struct Pass {
    Vector3d anchor, pole, axis, lever, omega;
};

/// The other axis is off square to the plane of lever and pole, so the mass goes past.
Pass draw_pass(RandomInput& random, const Vector3d& anchor, const Vector3d& pole) {
    const Vector3d e = random.direction().cross(pole).normalized(), f = pole.cross(e);
    const double away = random.real(0.6, 1.6), beside = random.real(-0.4, 0.4);
    const Vector3d axis = f * std::cos(beside) + e * std::sin(beside);
    const Vector3d lever = (pole * std::cos(away) + e * std::sin(away)) * random.real(0.4, 1.2);
    return {anchor, pole, axis, lever, axis * -random.real(3, 8) + pole * random.real(-3, 3)};
}

/// It moves as if it were one with the pendulum.
template <class World>
ingot::BodyId add_body(World& world, const ingot::MassDistribution& solid, double M, const Pass& pass, const Vector3d& place) {
    ingot::BodyDef def;
    def.mass = ingot::principal(ingot::with_mass(solid, static_cast<scalar>(M))).value;
    def.state.r_CM = to_vector(place);
    def.state.v_CM = to_vector(pass.omega.cross(place - pass.anchor));
    def.state.L = ingot::scaled(def.mass.I_body, to_vector(pass.omega));
    return world.add(def).value;
}

/// The pendulum, and in half of all draws a second body that hangs on it, or a third. Masses: 1 to 1000.
template <class World, class Solid>
void add_pendulum(World& world, RandomInput& random, const Pass& pass, const Solid& solid_of) {
    const double ratio = std::log(1000) * random.real(0, 1);
    const auto mass = [&] { return std::exp(random.real(0, ratio)); };
    ingot::JointDef joint;
    joint.body_A = add_body(world, solid_of(random), mass(), pass, pass.anchor + pass.lever);
    joint.joint = ingot::UniversalJoint{};
    joint.P = to_vector(pass.anchor);
    joint.axis = to_vector(pass.axis);
    joint.axis_B = to_vector(pass.pole);
    if (random.integer(0, 1) == 1) {
        std::swap(joint.body_A, joint.body_B);
        std::swap(joint.axis, joint.axis_B);
    }
    if constexpr (World::scene::joints::has_limits)
        if (random.integer(0, 3) == 0) joint.joint.limits.range[random.integer(0, 1)] = {scalar(-2), static_cast<scalar>(random.real(0.05, 2))};
    const ingot::JointId id = world.add_joint(joint).value;
    if constexpr (World::scene::joints::has_drives)
        if (random.integer(0, 1) == 1) {  // a brake takes energy
            const ingot::MotorDrive brake = {0, static_cast<scalar>(random.real(0, 10))};
            EXPECT_EQ(world.set_joint_drive(id, brake, random.integer(0, 1)), ingot::Status::ok);
        }
    Vector3d place = pass.anchor + pass.lever;
    ingot::BodyId last = joint.body_A == ingot::BodyId{} ? joint.body_B : joint.body_A;
    for (int more = random.integer(0, 3) - 1; more > 0; --more) {
        ingot::JointDef next;
        const Vector3d P = place + random.direction() * random.real(0.3, 1), axis = random.direction();
        place = P + random.direction() * random.real(0.3, 1);
        next.body_A = last;
        next.body_B = last = add_body(world, solid_of(random), mass(), pass, place);
        next.joint = kinds[random.integer(0, 2) == 0 ? random.integer(0, 1) : 3];
        next.P = to_vector(P);
        next.axis = to_vector(axis);
        next.axis_B = to_vector(axis.cross(random.direction()).normalized());
        (void)world.add_joint(next).value;
    }
}

template <class World>
double mass_of(const World& world) {
    double M = 0;
    for (int slot = 0; slot < World::scene::max_bodies; ++slot)
        if (world.body_at(slot) != ingot::BodyId{}) M += static_cast<double>(world.mass(world.body_at(slot)).value);
    return M;
}

template <class World>
double height_energy(const World& world) {
    double E = 0;
    for (int slot = 0; slot < World::scene::max_bodies; ++slot) {
        const ingot::BodyId id = world.body_at(slot);
        if (id != ingot::BodyId{}) E += g * static_cast<double>(world.mass(id).value) * static_cast<double>(world.state(id).value.r_CM.z);
    }
    return E;
}

/// Without weight, and of bodies that are alike about all axes, so that no turn changes their energy, joints alone could give some: the targets of a
/// substep, by their share and what it takes to close a gap. The roundings of a substep are some of each body.
double most_after(double E, double M, double h) {
    const double substeps = ingot::limits::substeps << ingot::limits::doublings_max;
    const double gap_speed = static_cast<double>(ingot::limits::joint_gap) * substeps / h;
    return E * std::pow(1 + static_cast<double>(ingot::limits::figure_gain_allowed) + 64 * eps, substeps) + M * substeps * gap_speed * gap_speed;
}

template <class Scene>
struct UniversalPoles : testing::Test {};
using Scenes = testing::Types<Plain, WithLimits, WithBrakes, WithLoops, Machines>;
TYPED_TEST_SUITE(UniversalPoles, Scenes);

TYPED_TEST(UniversalPoles, give_no_energy_to_what_has_no_weight) {
    for (int run_i = 0; run_i < ingot_reference::draws(200); ++run_i) {
        RandomInput random(static_cast<uint64_t>(run_i));
        const auto world = std::make_unique<ingot::World<TypeParam>>();
        const auto ball = [](RandomInput& of) { return ingot::solid_sphere(1, static_cast<scalar>(of.real(0.05, 0.3))); };
        for (int i = 0; i <= run_i % 3; ++i) add_pendulum(*world, random, draw_pass(random, {4.0 * i, 0, 0}, random.direction()), ball);
        const double rate = rates[run_i % 2], M = mass_of(*world);
        for (int step_i = 0; step_i < static_cast<int>(rate); ++step_i) {
            const double E = static_cast<double>(world->kinetic_energy());
            ASSERT_EQ(step(*world, static_cast<scalar>(1 / rate)).bodies_frozen, 0u);
            ASSERT_LE(static_cast<double>(world->kinetic_energy()), most_after(E, M, 1 / rate)) << run_i << ", " << rate << " Hz, step " << step_i;
        }
    }
}

/// As of all figures that fall: see joint_energy_test.
TYPED_TEST(UniversalPoles, give_no_energy_to_what_swings) {
    const int runs = ingot_reference::draws(200), apart = std::max(1, 200 / runs);  // few are spread over all
    for (int run_i = 0; run_i < runs * apart; run_i += apart) {
        RandomInput random(static_cast<uint64_t>(run_i));
        const auto world = std::make_unique<ingot::World<TypeParam>>();
        ASSERT_TRUE(weigh(*world));
        const auto box = [](RandomInput& of) {
            const auto half = [&of] { return static_cast<scalar>(of.real(0.1, 0.5)); };
            const scalar x = half(), y = half(), z = half();
            return ingot::solid_box(1, {x, y, z});
        };
        for (int i = 0; i <= run_i % 3; ++i) {
            const Vector3d pole = (Vector3d(0, 0, -1) + random.direction() * random.real(0, 0.6)).normalized();
            add_pendulum(*world, random, draw_pass(random, {4.0 * i, 0, 0}, pole), box);
        }
        const double rate = rates[run_i % 5], M = mass_of(*world);
        double last = static_cast<double>(world->kinetic_energy()) + height_energy(*world), before = last;
        for (int step_i = 0; step_i < static_cast<int>(rate); ++step_i) {
            const double motion = static_cast<double>(world->kinetic_energy());
            ASSERT_EQ(step(*world, static_cast<scalar>(1 / rate)).bodies_frozen, 0u);
            const double now = static_cast<double>(world->kinetic_energy()) + height_energy(*world);
            ASSERT_LE(now, std::max(last, before) + 0.01 * (M * g + motion)) << run_i << ", " << rate << " Hz, step " << step_i;
            before = last;
            last = now;
        }
    }
}

}  // namespace

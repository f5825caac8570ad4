// SPDX-License-Identifier: MIT
// Driven figures whose parts overlap: contacts get no energy out of their drives.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;

struct Driven : ingot::Scene {
    static constexpr int max_bodies = 32, max_joints = 32, max_manifolds = 160, max_pairs = 400;
    static constexpr bool translates = true;
    using joints = AllJointsWith<ingot::WithLimits, ingot::WithDrives>;
    using shapes = ingot::Shapes<ingot::Capsule>;
};
struct Tied : Driven {
    static constexpr int max_loops = 8;
    static constexpr bool kinematic_bodies = true;
    using joints = AllJointsWith<ingot::RodJoint, ingot::RopeJoint, ingot::WithLimits, ingot::WithDrives>;
};

struct Crowd : Built {
    double M = 0;  ///< kg, of all
};

/// Brakes, dampers: they take energy alone. Half of them have a largest torque.
ingot::JointDrive drawn_brake(RandomInput& random, double size, double M) {
    ingot::JointDrive drive = ingot::MotorDrive{};
    if (random.integer(0, 1) == 1) drive = ingot::SpringDrive{0, static_cast<scalar>(M * size * size * std::exp(random.real(-3, 9)))};
    if (random.integer(0, 1) == 1) drive.max_torque = static_cast<scalar>(M * size * g * random.real(0.1, 10));
    return drive;
}

/// A tree of three to six capsules that are joined within each other, at rest and without weight: the parts of one parent overlap. Some of its joints
/// have brakes; where there may be loops, a rod or a rope ties two parts.
template <class Scene>
Crowd add_crowd(ingot::World<Scene>& world, RandomInput& random, const Eigen::Vector3d& place, double size) {
    Crowd crowd;
    const int count = random.integer(3, 6);
    for (int body_i = 0; body_i < count; ++body_i) {
        const double radius = size * random.real(0.2, 0.5), half = size * random.real(0.1, 1);
        const double M = 1000 * size * size * size * std::exp(random.real(0, 3));
        ingot::BodyDef def;
        const auto r = static_cast<scalar>(radius), l = static_cast<scalar>(half);
        def.mass = ingot::principal(ingot::with_mass(ingot::solid_capsule(1, r, l), static_cast<scalar>(M))).value;
        def.shape = ingot::Capsule{r, l};
        def.state.A = ingot_reference::to_matrix(random.rotation());
        def.friction = static_cast<scalar>(random.real(0, 1));
        ingot::JointDef joint;
        Eigen::Vector3d P = place;
        if (body_i > 0) {
            joint.body_A = crowd.bodies[static_cast<size_t>(random.integer(0, body_i - 1))];
            P = ingot_reference::to_eigen(world.state(joint.body_A).value.r_CM) + random.direction() * (size * random.real(0.1, 1));
        }
        def.state.r_CM = to_vector(P + random.direction() * (size * random.real(0.1, 1)));
        joint.body_B = world.add(def).value;
        crowd.bodies.push_back(joint.body_B);
        crowd.M += M;
        if (body_i == 0) continue;
        const Eigen::Vector3d axis = random.direction();
        joint.P = to_vector(P);
        joint.axis = to_vector(axis);
        joint.axis_B = to_vector(axis.cross(random.direction()).normalized());
        const int kind = random.integer(0, 3);
        joint.joint = kinds[kind];
        const ingot::JointId id = world.add_joint(joint).value;
        crowd.joints.push_back(id);
        const ingot::JointDrive drive = drawn_brake(random, size, M);
        if (random.integer(0, 2) == 0) continue;
        crowd.sound = (kind == 0 ? world.set_ball_drive(id, drive) : world.set_joint_drive(id, drive)) == ingot::Status::ok && crowd.sound;
    }
    if constexpr (Scene::max_loops > 0) {
        ingot::JointDef tie;
        tie.body_A = crowd.bodies[0];
        tie.body_B = crowd.bodies.back();
        tie.P = world.state(tie.body_A).value.r_CM;
        tie.P_B = world.state(tie.body_B).value.r_CM;
        tie.joint = random.integer(0, 1) == 0 ? ingot::Joint(ingot::RodJoint{}) : ingot::Joint(ingot::RopeJoint{});
        crowd.sound = world.add_joint(tie).ok() && crowd.sound;
    }
    return crowd;
}

template <class Scene>
struct DrivenOverlaps : testing::Test {};
using Scenes = testing::Types<Driven, Tied>;
TYPED_TEST_SUITE(DrivenOverlaps, Scenes);

/// Brakes take energy alone: however parts overlap, however stiff it all is, a figure that was at rest never has more than all of its mass has at
/// limits::gaining_speed, which no look at energies sees. It moves as if it were alone, to the bit.
TYPED_TEST(DrivenOverlaps, get_no_energy_from_brakes) {
    for (int run_i = 0; run_i < ingot_reference::draws(80); ++run_i) {
        RandomInput random(static_cast<uint64_t>(run_i)), again(static_cast<uint64_t>(run_i)), others(static_cast<uint64_t>(1000 + run_i));
        const auto world = std::make_unique<ingot::World<TypeParam>>(), company = std::make_unique<ingot::World<TypeParam>>();
        const double size = random.real(0.05, 0.5), rate = rates[random.integer(0, 4)];
        (void)again.real(0, 1);
        (void)again.integer(0, 4);
        const Crowd crowd = add_crowd(*world, random, {0, 0, 0}, size);
        const Crowd before = add_crowd(*company, others, {20, 0, 0}, size);
        const Crowd same = add_crowd(*company, again, {0, 0, 0}, size);
        const Crowd after = add_crowd(*company, others, {-20, 0, 0}, size);
        ASSERT_TRUE(crowd.sound && before.sound && same.sound && after.sound);
        const double v = static_cast<double>(ingot::limits::gaining_speed);
        for (int step_i = 0; step_i < 60; ++step_i) {
            const ingot::StepReport report = step(*world, static_cast<scalar>(1 / rate));
            (void)step(*company, static_cast<scalar>(1 / rate));
            ASSERT_EQ(report.bodies_frozen, 0u) << run_i;
            ASSERT_LE(static_cast<double>(world->kinetic_energy()), crowd.M / 2 * v * v)
                << run_i << ", " << rate << " Hz, step " << step_i << ", size " << size;
            ASSERT_TRUE(are_same(*world, *company, crowd.bodies, same.bodies)) << run_i << ", step " << step_i;
        }
    }
}

}  // namespace

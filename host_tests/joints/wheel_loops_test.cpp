// SPDX-License-Identifier: MIT
// Wheels in trees and in loops, whichever of their bodies is nearer to the root.
#include <gtest/gtest.h>

#include <memory>

#include "figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;

/// Of the steering of a wheel that closes a loop: what holds it straight is the wheel in the tree, and nothing is held twice.
constexpr ingot::JointDrive caster = {ingot::DriveKind::none, 0, 0, 0, 0, 0, 0};

struct Rolling : ingot::Scene {
    static constexpr int max_bodies = 16, max_joints = 24, max_loops = 4;
    static constexpr bool translates = true;
    using joints = AllJointsWith<ingot::WheelJoint, ingot::WithLimits, ingot::WithDrives>;
};
using RollingWorld = ingot::World<Rolling>;

ingot::BodyId add_block(RollingWorld& world, RandomInput& random, const Vector& place) {
    ingot::BodyDef def;
    const Vector half = to_vector(Eigen::Vector3d(random.real(0.2, 0.5), random.real(0.2, 0.5), random.real(0.2, 0.5)));
    def.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, half), static_cast<scalar>(random.real(1, 5)))).value;
    def.state.r_CM = place;
    return world.add(def).value;
}

/// Trees of wheels and other joints, tied or not, some of whose bodies are joined once more by a wheel: whichever side is nearer to the root,
/// what has a wheel below it or above, sprung and with ends or neither, they hold and nothing gains.
TEST(WheelLoops, hold_whatever_hangs_on_them) {
    RandomInput random(11);
    for (int run_i = 0; run_i < ingot_reference::draws(240); ++run_i) {
        const auto world = std::make_unique<RollingWorld>();
        ASSERT_TRUE(weigh(*world));
        const double rate = rates[random.integer(1, 3)];
        const int count = random.integer(2, 6);
        const bool sprung = random.integer(0, 1) == 1;
        Built built;
        const auto join = [&](const ingot::Joint& kind, ingot::BodyId A, ingot::BodyId B, const Vector& P) {
            ingot::JointDef def;
            def.body_A = A;
            def.body_B = B;
            def.joint = kind;
            def.P = P;
            const Eigen::Vector3d axis = random.direction();
            def.axis = to_vector(axis);
            def.axis_B = to_vector(axis.unitOrthogonal());
            const auto id = world->add_joint(def);
            built.sound = built.sound && id.ok();
            built.joints.push_back(id.value);
            if (!sprung || kind.kind != ingot::JointKind::wheel) return;
            ingot::JointDrive spring = ingot::SpringDrive{50, 5};
            if (run_i % 4 == 0) spring = ingot::TunedDrive{3, 1};
            EXPECT_EQ(world->set_joint_drive(id.value, spring, ingot::WheelJoint::travel), ingot::Status::ok);
            if (run_i % 3 != 0) return;  // its spin has ends, too
            EXPECT_EQ(world->set_joint_limits(id.value, {{{-1, 1}, {scalar(-0.3), scalar(0.3)}}, 0}), ingot::Status::ok);
        };
        const ingot::Joint wheel = sprung ? ingot::Joint(ingot::WheelJoint{scalar(-0.3), scalar(0.3)}) : ingot::Joint(ingot::WheelJoint{});
        for (int i = 0; i < count; ++i) {
            built.bodies.push_back(add_block(*world, random, {static_cast<scalar>(i), 0, 0}));
            const Vector P = {static_cast<scalar>(i) - scalar(0.5), 0, 0};
            if (i == 0 && random.integer(0, 1) == 1) continue;
            ingot::BodyId A = i == 0 ? ingot::BodyId{} : built.bodies[static_cast<size_t>(i - 1)], B = built.bodies.back();
            if (random.integer(0, 1) == 1) std::swap(A, B);
            join(random.integer(0, 2) == 0 ? kinds[random.integer(0, 4)] : wheel, A, B, P);
        }
        if (run_i % 3 != 0) {  // once more, to another or to the world
            const int first = random.integer(0, count - 1), second = random.integer(-1, count - 1);
            ingot::BodyId A = built.bodies[static_cast<size_t>(first)], B = second < 0 ? ingot::BodyId{} : built.bodies[static_cast<size_t>(second)];
            if (random.integer(0, 1) == 1) std::swap(A, B);
            if (first != second) {
                join(wheel, A, B, {static_cast<scalar>(first), scalar(0.5), 0});
                ASSERT_EQ(world->set_joint_drive(built.joints.back(), caster, ingot::WheelJoint::steering), ingot::Status::ok);
            }
        }
        ASSERT_TRUE(built.sound) << run_i;
        const double begin = energy_of(*world, built);
        double most = begin, M = 0;
        for (const ingot::BodyId id : built.bodies) M += static_cast<double>(world->mass(id).value);
        for (int step_i = 0; step_i < static_cast<int>(rate); ++step_i) {
            ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean()) << run_i;
            EXPECT_LE(worst_gap(*world, built), held) << run_i << ", " << rate << " Hz, " << step_i;
            most = std::max(most, energy_of(*world, built));
        }
        EXPECT_LE(most - begin, 0.01 * M * g) << run_i << ", " << rate << " Hz";
    }
}

/// A wheel that is joined twice, with half of its spring in each, goes as one that is joined once, whether it hangs or carries.
TEST(WheelLoops, a_wheel_joined_twice_is_one) {
    RandomInput random(12);
    for (int run_i = 0; run_i < ingot_reference::draws(96); ++run_i) {
        const bool on_world = run_i % 4 == 0, carries = run_i % 2 == 0;
        const double stiffness = random.real(20, 200), damping = random.real(0, 5), rate = rates[random.integer(1, 3)], size = random.real(1, 5);
        const Eigen::Vector3d along = random.direction(), axle = along.unitOrthogonal(), blow = random.direction();
        ingot::BodyState states[2];
        double travel[2];
        for (int twice = 0; twice < 2; ++twice) {
            const auto world = std::make_unique<RollingWorld>();
            RandomInput same(static_cast<uint64_t>(run_i));
            const ingot::BodyId moving = add_block(*world, same, {0, 0, 0}), other = on_world ? ingot::BodyId{} : add_block(*world, same, {1, 0, 0});
            ingot::JointDef def;
            def.body_A = carries ? moving : other;
            def.body_B = carries ? other : moving;
            def.joint = ingot::WheelJoint{};
            def.P = {scalar(0.25), 0, 0};
            def.axis = to_vector(along);
            def.axis_B = to_vector(axle);
            ingot::JointId id{};
            for (int i = 0; i <= twice; ++i) {
                const auto added = world->add_joint(def);
                ASSERT_TRUE(added.ok());
                id = added.value;
                const double share = 1.0 / (1 + twice);
                const ingot::SpringDrive spring = {static_cast<scalar>(share * stiffness), static_cast<scalar>(share * damping)};
                ASSERT_EQ(world->set_joint_drive(id, spring, ingot::WheelJoint::travel), ingot::Status::ok);
                if (i > 0) {
                    ASSERT_EQ(world->set_joint_drive(id, caster, ingot::WheelJoint::steering), ingot::Status::ok);
                }
            }
            ASSERT_EQ(world->apply_central_impulse(moving, to_vector((blow * size).eval())), ingot::Status::ok);
            for (int step_i = 0; step_i < static_cast<int>(rate / 4); ++step_i)
                ASSERT_TRUE(ingot::step(*world, static_cast<scalar>(1 / rate)).clean());
            states[twice] = world->state(moving).value;
            travel[twice] = static_cast<double>(world->joint_travel(id).value);
        }
        using ingot_reference::to_eigen;
        // So many substeps in a quarter of a second, each of which may leave a settled speed.
        const double rounding = 16 * eps * rate + rate * static_cast<double>(ingot::limits::settled_speed) / 8;
        EXPECT_NEAR(travel[0], travel[1], rounding) << run_i;
        EXPECT_LE((to_eigen(states[0].r_CM) - to_eigen(states[1].r_CM)).norm(), rounding) << run_i;
    }
}

}  // namespace

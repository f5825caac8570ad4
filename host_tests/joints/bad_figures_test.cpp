// SPDX-License-Identifier: MIT
// Figures that legal calls drive out of what numbers can say: bodies freeze, all that is told and kept stays finite, and nobody else notices.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;
using ingot::Status;
namespace limits = ingot::limits;

struct Wild : ingot::Scene {
    static constexpr int max_bodies = 12, max_joints = 18, max_loops = 6;
    static constexpr bool translates = true;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::SliderJoint, ingot::UniversalJoint, ingot::WheelJoint,
                                 ingot::TargetJoint, ingot::GearJoint, ingot::WithLimits, ingot::WithDrives>;
};
using WildWorld = ingot::World<Wild>;
scalar number(double x) { return static_cast<scalar>(x); }

bool is_finite(const ingot::BodyState& state) {
    return ingot::is_finite(state.r_CM) && ingot::is_finite(state.v_CM) && ingot::is_finite(state.A) && ingot::is_finite(state.L);
}

/// Five bodies in a row with every kind of joint, driven and with ends, geared, and drawn to a target by the last.
struct Wilds {
    std::vector<ingot::BodyId> bodies;
    ingot::JointId hinge, slider, ball, universal, wheel, target;

    /// M: kg; I: kg m^2. looped: with its gear and its target.
    Wilds(WildWorld& world, double y, double M, double I, bool tied, bool looped, double gain) {
        const auto at = [&](int i) { return Vector{number(i), number(y), 0}; };
        for (int i = 0; i < 5; ++i) {
            ingot::BodyDef def;
            def.mass.M = number(M);
            def.mass.I_body = Vector{number(I), number(I), number(I)};
            def.mass.A_principal = ingot::identity_matrix<scalar>();
            def.state.r_CM = at(i);
            bodies.push_back(world.add(def).value);
        }
        const auto join = [&](const ingot::Joint& joint, int A, int B) {
            ingot::JointDef def;
            if (A >= 0) def.body_A = bodies[static_cast<size_t>(A)];
            def.body_B = bodies[static_cast<size_t>(B)];
            def.joint = joint;
            def.P = at(B) - Vector{number(0.5), 0, 0};
            const auto id = world.add_joint(def);
            EXPECT_TRUE(id.ok()) << ingot::name(id.status);
            return id.value;
        };
        hinge = tied ? join(ingot::HingeJoint{-1, 1}, -1, 0) : ingot::JointId{};
        slider = join(ingot::SliderJoint{-1, 1}, 0, 1);
        ball = join(ingot::BallJoint{1, -1, 1}, 1, 2);
        universal = join(ingot::UniversalJoint{{-1, 1}, {-1, 1}}, 2, 3);
        wheel = join(ingot::WheelJoint{-1, 1}, 3, 4);
        EXPECT_EQ(world.set_joint_drive(slider, ingot::SpringDrive{number(gain), number(gain)}), Status::ok);
        EXPECT_EQ(world.set_joint_drive(universal, ingot::MotorDrive{1, number(gain)}), Status::ok);
        EXPECT_EQ(world.set_joint_drive(wheel, ingot::TunedDrive{5, 1}, ingot::WheelJoint::travel), Status::ok);
        EXPECT_EQ(world.set_ball_drive(ball, ingot::SpringDrive{number(gain), 1}), Status::ok);
        if (tied) {
            EXPECT_EQ(world.set_joint_drive(hinge, ingot::TunedDrive{2, 1}), Status::ok);
        }
        if (!looped) return;
        ingot::JointDef drawn;
        drawn.body_B = bodies.back();
        drawn.joint = ingot::TargetJoint{};
        drawn.P = at(4);
        target = world.add_joint(drawn).value;
        EXPECT_EQ(world.set_target_drive(target, {5, 1, number(gain), ingot::unlimited}), Status::ok);
        if (tied) {
            EXPECT_TRUE(world.add_gear(hinge, slider, number(0.5)).ok());
        }
    }
};

TEST(BadFigures, freeze_and_leave_nothing_bad) {
    RandomInput random(1);
    int frozen = 0, ran_away[3] = {};
    for (int run_i = 0; run_i < ingot_reference::draws(384); ++run_i) {
        const auto world = std::make_unique<WildWorld>(), calm = std::make_unique<WildWorld>(), loaded = std::make_unique<WildWorld>();
        const bool is_speck = run_i % 2 == 1, tied = run_i % 4 < 2, looped = run_i % 3 > 0;
        const double M = is_speck ? 2e-9 : 1, I = is_speck ? 4e-18 : 1, gain = std::exp(random.real(-3, 3));
        const Wilds wild(*world, 0, M, I, tied, looped, gain), beside(*world, 50, 1, 1, true, true, 10);
        const Wilds same(*calm, 0, M, I, tied, looped, gain), also_beside(*calm, 50, 1, 1, true, true, 10);
        const int axis = run_i / 2 % 3, what = random.integer(0, 2);
        const scalar side = random.integer(0, 1) == 1 ? scalar(-1) : scalar(1);
        Vector along{};
        (axis == 0 ? along.x : axis == 1 ? along.y : along.z) = side;
        const scalar share = number(std::pow(10, random.real(is_speck ? -14 : -4.5, 0)));  // from a little too much to all that a call takes
        const bool all = random.integer(0, 1) == 1;  // as one: it does not come apart first
        const ingot::BodyId pushed = wild.bodies[static_cast<size_t>(random.integer(0, 4))];
        for (int step_i = 0; step_i < 12; ++step_i) {
            for (const ingot::BodyId id : wild.bodies) {
                if (step_i < 2 || (!all && id != pushed)) continue;
                const Status good = world->is_frozen(id) ? Status::frozen : Status::ok;
                if (what != 1) {
                    EXPECT_EQ(world->add_central_force(id, along * (share * limits::force_max)), good);
                }
                if (what != 0) {
                    EXPECT_EQ(world->add_torque(id, along * (share * limits::torque_max)), good);
                }
            }
            const ingot::StepReport report = ingot::step(*world, scalar(1) / 60);
            (void)ingot::step(*calm, scalar(1) / 60);
            frozen += report.bodies_frozen;
            if (report.bodies_frozen > 0) ++ran_away[axis];
            int count = 0;
            for (const ingot::BodyId id : wild.bodies) {
                const ingot::BodyState state = world->state(id).value;
                EXPECT_TRUE(is_finite(state)) << run_i;
                EXPECT_LE(ingot::length_sq(state.v_CM), 3 * limits::speed_runaway * limits::speed_runaway);
                count += world->is_frozen(id) ? 1 : 0;
                if (world->is_frozen(id)) {
                    EXPECT_EQ(ingot::length_sq(state.v_CM) + ingot::length_sq(state.L), 0);
                }
            }
            EXPECT_TRUE(report.bodies_frozen == 0 || count > 0) << run_i;
            for (const ingot::JointId id : {wild.slider, wild.universal, wild.wheel}) {
                EXPECT_TRUE(ingot::is_finite(world->drive_torque(id).value)) << run_i << ", " << step_i;
            }
            if (looped) {
                EXPECT_TRUE(ingot::is_finite(world->target_force(wild.target).value)) << run_i;
                EXPECT_TRUE(ingot::is_finite(world->target_torque(wild.target).value)) << run_i;
            }
            ASSERT_TRUE(are_same(*world, *calm, beside.bodies, also_beside.bodies)) << run_i << ", " << step_i;
        }
        // All that is kept is what a snapshot may say.
        std::vector<uint8_t> bytes(ingot::snapshot_size<Wild>()), again(bytes.size());
        const auto size = ingot::save_snapshot(*world, bytes.data(), bytes.size());
        ASSERT_TRUE(size.ok());
        ASSERT_EQ(ingot::load_snapshot(*loaded, bytes.data(), size.value), Status::ok) << run_i;
        EXPECT_EQ(loaded->state_hash(), world->state_hash());
    }
    std::printf("    %d bodies froze\n", frozen);
    for (const int of_axis : ran_away) EXPECT_GT(of_axis, 0);
}

/// Two bodies in one place, joined at their centres: neither hinders the other, so each way out is met by itself. One of them is drawn.
TEST(BadFigures, by_each_way_out) {
    for (const bool drawn : {false, true})
        for (int axis = 0; axis < 3; ++axis)
            for (const char* const what : {"too fast", "spins too fast", "a speck, turned by all there is"}) {
                const auto world = std::make_unique<WildWorld>();
                const bool is_speck = what[0] == 'a', is_force = what[0] == 't';
                std::vector<ingot::BodyId> bodies;
                for (int i = 0; i < 2; ++i) {
                    ingot::BodyDef def;
                    const scalar I = is_speck ? 4 * limits::inertia_min : scalar(1);
                    def.mass.M = is_speck ? 4 * limits::mass_min : scalar(1);
                    def.mass.I_body = Vector{I, I, I};
                    def.mass.A_principal = ingot::identity_matrix<scalar>();
                    bodies.push_back(world->add(def).value);
                }
                ingot::JointDef def;
                def.body_A = bodies[0];
                def.body_B = bodies[1];
                def.joint = ingot::BallJoint{};
                ASSERT_TRUE(world->add_joint(def).ok());
                def.body_A = {};
                def.joint = ingot::TargetJoint{};
                const auto target = drawn ? world->add_joint(def) : ingot::Result<ingot::JointId>{Status::not_in_scene, {}};
                ASSERT_EQ(target.ok(), drawn);
                Vector along{};
                (axis == 0 ? along.x : axis == 1 ? along.y : along.z) = is_speck ? limits::torque_max : 60 * limits::speed_runaway;
                (void)ingot::step(*world, scalar(1) / 60);
                int frozen = 0;
                for (int step_i = 0; step_i < 3 && frozen == 0; ++step_i) {
                    for (const ingot::BodyId id : bodies)
                        ASSERT_EQ(is_force ? world->add_central_force(id, along * scalar(1.5)) : world->add_torque(id, along), Status::ok);
                    frozen = ingot::step(*world, scalar(1) / 60).bodies_frozen;
                }
                EXPECT_TRUE(frozen > 0 || (INGOT_DOUBLE && is_speck) || (drawn && !is_speck)) << what << ", " << axis;
                for (const ingot::BodyId id : bodies) {
                    const ingot::BodyState state = world->state(id).value;
                    EXPECT_TRUE(is_finite(state));
                    if (!world->is_frozen(id)) continue;
                    EXPECT_EQ(ingot::length_sq(state.r_CM), 0) << what << ", " << axis;
                    EXPECT_EQ(ingot::length_sq(state.v_CM) + ingot::length_sq(state.L), 0);
                }
                if (drawn) {
                    EXPECT_TRUE(ingot::is_finite(world->target_force(target.value).value));
                    EXPECT_TRUE(ingot::is_finite(world->target_torque(target.value).value));
                }
            }
}

/// A pair that flies out of the world along any axis, either way: who is beyond limits::position_max freezes within it, as a lone body does, and a
/// snapshot says so.
TEST(BadFigures, beyond_the_largest_place) {
    for (int axis = 0; axis < 3; ++axis)
        for (const scalar way : {scalar(-1), scalar(1)}) {
            const auto world = std::make_unique<WildWorld>(), loaded = std::make_unique<WildWorld>();
            const auto along = [&](scalar x) { return axis == 0 ? Vector{x, 0, 0} : axis == 1 ? Vector{0, x, 0} : Vector{0, 0, x}; };
            std::vector<ingot::BodyId> bodies;
            for (int i = 0; i < 2; ++i) {
                ingot::BodyDef def;
                def.mass = {1, {1, 1, 1}, {}, ingot::identity_matrix<scalar>()};
                def.state.r_CM = along(way * limits::position_max);
                def.state.v_CM = along(way * limits::speed_max);
                bodies.push_back(world->add(def).value);
            }
            ingot::JointDef def;
            def.body_A = bodies[0];
            def.body_B = bodies[1];
            def.joint = ingot::BallJoint{};
            def.P = along(way * limits::position_max);
            ASSERT_TRUE(world->add_joint(def).ok());
            // In float a step may be less than the rounding of such a place.
            int frozen = 0;
            for (int step_i = 0; step_i < 60 && frozen == 0; ++step_i) frozen = ingot::step(*world, limits::step_max).bodies_frozen;
            EXPECT_EQ(frozen, 2) << axis << ", " << way;
            for (const ingot::BodyId id : bodies) {
                const ingot::BodyState state = world->state(id).value;
                EXPECT_LE(std::abs(dot(state.r_CM, along(way))), limits::position_max);
            }
            std::vector<uint8_t> bytes(ingot::snapshot_size<Wild>());
            const auto size = ingot::save_snapshot(*world, bytes.data(), bytes.size());
            ASSERT_TRUE(size.ok());
            EXPECT_EQ(ingot::load_snapshot(*loaded, bytes.data(), size.value), Status::ok) << axis << ", " << way;
        }
}

}  // namespace

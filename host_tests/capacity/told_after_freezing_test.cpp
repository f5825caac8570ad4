// SPDX-License-Identifier: MIT
// What a step leaves behind that has frozen a body: all that is told is finite, a snapshot of it loads and goes on alike, and nobody beside it
// notices. Over the features that keep what a step gave: contacts, by whatever solver, joints, events, sleep.
#include <ingot/ingot.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "joints/figures.h"
#include "reference/draws.h"
#include "reference/sanitized.h"

namespace {

using ingot::BodyDef;
using ingot::BodyId;
using ingot::JointId;
using ingot::scalar;
using ingot::Status;
using ingot::Vector;
using ingot_reference::is_sanitized;
using ingot_reference::RandomInput;
namespace limits = ingot::limits;

scalar number(double x) { return static_cast<scalar>(x); }

struct Pile : ingot::Scene {
    static constexpr int max_bodies = 14, max_manifolds = 60;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::Capsule, ingot::HalfSpace>;
};
struct Read : Pile {
    static constexpr bool reads_contacts = true, rolling_resistance = true;
    static constexpr int max_events = 40;
};
struct Direct : Pile {
    static constexpr bool reads_contacts = true;
    using solver = ingot::HybridIslands<24>;
};
struct Pointwise : Pile {
    static constexpr bool reads_contacts = true;
    using solver = ingot::SequentialImpulses;
};
struct Sleepy : Pile {
    static constexpr bool sleeps = true, reads_contacts = true;
    static constexpr int max_events = 40;
};
struct Fast : Pile {
    static constexpr bool continuous = true;
    static constexpr int max_events = 40;
};
template <class Base>
struct Jointed : Base {
    static constexpr int max_joints = 22, max_loops = 10;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::SliderJoint, ingot::UniversalJoint, ingot::WheelJoint, ingot::FixedJoint,
                                 ingot::RodJoint, ingot::TargetJoint, ingot::ServoJoint, ingot::GearJoint, ingot::WithLimits, ingot::WithDrives,
                                 ingot::WithBreaking>;
};
struct Swinging : ingot::Scene {
    static constexpr int max_bodies = 14;
    static constexpr bool translates = true;
};
struct Smooth : Swinging {
    static constexpr int max_joints = 22;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::SliderJoint, ingot::UniversalJoint, ingot::WithReactions>;
    using figure_motion = ingot::EnergyMomentum<>;
};
struct SmoothPile : Pile {
    static constexpr int max_joints = 22;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::SliderJoint, ingot::UniversalJoint, ingot::WithReactions>;
    using figure_motion = ingot::EnergyMomentum<>;
};

/// Four bodies upon each other, joined where the scene has joints.
template <class S>
struct Heap {
    std::vector<BodyId> bodies;
    std::vector<JointId> joints;

    void join(ingot::World<S>& world, const ingot::Joint& joint, int A, int B) {
        ingot::JointDef def;
        if (A >= 0) def.body_A = bodies[static_cast<size_t>(A)];
        def.body_B = bodies[static_cast<size_t>(B)];
        def.joint = joint;
        const Vector b = world.state(def.body_B).value.r_CM;
        def.P = A < 0 ? b : (world.state(def.body_A).value.r_CM + b) * scalar(0.5);
        def.P_B = b;
        def.bodies_meet = true;
        const auto id = world.add_joint(def);
        ASSERT_TRUE(id.ok()) << ingot::name(id.status);
        joints.push_back(id.value);
    }
    Heap(ingot::World<S>& world, double y, double M, RandomInput random) {
        for (int body_i = 0; body_i < 4; ++body_i) {
            const double I = 0.1 * M;
            BodyDef def;
            def.mass = {number(M), {number(I), number(I), number(I)}, {}, ingot::identity_matrix<scalar>()};
            if constexpr (ingot::has_shapes<S>) {
                const bool is_ball = random.integer(0, 1) == 0;
                const Vector half{scalar(0.5), scalar(0.5), scalar(0.5)};
                def.shape = is_ball ? ingot::Shape(ingot::Sphere{scalar(0.5)}) : ingot::Shape(ingot::Box{half});
                def.friction = number(random.real(0, 1));
                def.restitution = number(random.real(0, 1));
            }
            def.state.r_CM = {number(random.real(-0.3, 0.3)), number(y + random.real(-0.3, 0.3)), number(0.5 + 0.95 * body_i)};
            bodies.push_back(world.add(def).value);
        }
        if constexpr (ingot::has_joints<S>) {
            join(world, ingot::HingeJoint{}, 0, 1);
            join(world, random.integer(0, 1) == 0 ? ingot::Joint(ingot::BallJoint{}) : ingot::Joint(ingot::UniversalJoint{}), 1, 2);
            if (random.integer(0, 1) == 0) join(world, ingot::SliderJoint{}, 2, 3);
            if constexpr (ingot::has_joint_drives<S>) {
                if (random.integer(0, 1) == 0) join(world, ingot::RodJoint{}, 0, 3);
                if (random.integer(0, 1) == 0) join(world, ingot::TargetJoint{}, -1, 2);
                if (random.integer(0, 1) == 0) join(world, ingot::ServoJoint{}, 0, 3);
                if (joints.size() > 2 && random.integer(0, 1) == 0) {
                    join(world, ingot::HingeJoint{-1, 1}, 1, 3);
                    const auto gear = world.add_gear(joints[0], joints.back(), number(random.real(-2, 2)));
                    if (gear.ok()) joints.push_back(gear.value);
                }
                EXPECT_EQ(world.set_joint_drive(joints[0], ingot::TunedDrive{5, 1}), Status::ok);
            }
        }
    }
};

template <class S>
class ToldAfterFreezing : public ::testing::Test {
protected:
    using World = ingot::World<S>;

    /// All that is told.
    static void expect_finite(const World& world, const Heap<S>& heap, const ingot::StepReport& report) {
        const auto is_finite = [](const auto& x) { return ingot::is_finite(x); };
        EXPECT_TRUE(is_finite(report.residual));
        EXPECT_TRUE(is_finite(world.kinetic_energy()) && is_finite(world.linear_momentum()) && is_finite(world.angular_momentum()));
        for (const BodyId id : heap.bodies) {
            const ingot::BodyState state = world.state(id).value;
            EXPECT_TRUE(is_finite(state.r_CM) && is_finite(state.A) && is_finite(state.v_CM) && is_finite(state.L));
            EXPECT_TRUE(is_finite(world.omega(id).value));
        }
        if constexpr (ingot::has_shapes<S>) {
            for (const ingot::ContactInfo& contact : world.contacts()) {
                EXPECT_TRUE(is_finite(contact.n) && is_finite(contact.separation) && is_finite(contact.j) && is_finite(contact.j_friction));
                for (int i = 0; i < contact.point_count; ++i) EXPECT_TRUE(is_finite(contact.points[i].P) && is_finite(contact.points[i].j));
            }
            for (const BodyId id : heap.bodies) {
                const ingot::ContactSum sum = world.contact_sum(id).value;
                EXPECT_TRUE(is_finite(sum.j) && is_finite(sum.j_normal) && is_finite(sum.P));
            }
        }
        if constexpr (ingot::has_events<S>)
            for (const ingot::Event& event : world.events()) EXPECT_TRUE(is_finite(event.P) && is_finite(event.n) && is_finite(event.speed));
        if constexpr (ingot::has_joint_reactions<S>)
            for (const JointId id : heap.joints) {
                const ingot::JointReaction reaction = world.joint_reaction(id).value;
                EXPECT_TRUE(is_finite(reaction.force) && is_finite(reaction.torque));
            }
        if constexpr (ingot::has_joint_drives<S>)
            for (const JointId id : heap.joints) {
                EXPECT_TRUE(is_finite(world.drive_torque(id).value) && is_finite(world.ball_torque(id).value));
                EXPECT_TRUE(is_finite(world.target_force(id).value) && is_finite(world.target_torque(id).value));
                EXPECT_TRUE(is_finite(world.joint_angle(id).value) && is_finite(world.joint_rate(id).value));
            }
    }
    static std::vector<uint8_t> saved(const World& world) {
        std::vector<uint8_t> bytes(ingot::snapshot_size<S>());
        const auto size = ingot::save_snapshot(world, bytes.data(), bytes.size());
        EXPECT_TRUE(size.ok());
        bytes.resize(size.value);
        return bytes;
    }
    /// True when a body of one meets one of the other: what is thrown meets others far away.
    static bool meet(const World& world, const Heap<S>& a, const Heap<S>& b) {
        bool some = false;
        if constexpr (ingot::has_shapes<S>)
            for (const ingot::ContactInfo& contact : world.contacts())
                for (const BodyId x : a.bodies)
                    for (const BodyId y : b.bodies) some = some || (contact.A == x && contact.B == y) || (contact.A == y && contact.B == x);
        return some;
    }
    /// It loads, and what is loaded goes on as the other does.
    static void expect_same_life(const World& world, scalar h) {
        const auto loaded = std::make_unique<World>(), copy = std::make_unique<World>(world);
        const auto bytes = saved(world);
        ASSERT_EQ(ingot::load_snapshot(*loaded, bytes.data(), bytes.size()), Status::ok);
        for (int step_i = 0; step_i < 4; ++step_i) {
            EXPECT_EQ(loaded->state_hash(), copy->state_hash());
            EXPECT_EQ(saved(*loaded), saved(*copy));
            (void)ingot::step(*loaded, h);
            (void)ingot::step(*copy, h);
        }
    }
};

using Scenes = ::testing::Types<Pile, Read, Direct, Pointwise, Sleepy, Fast, Jointed<Swinging>, Jointed<Read>, Jointed<Sleepy>, Jointed<Fast>,
                                Smooth, SmoothPile>;
TYPED_TEST_SUITE(ToldAfterFreezing, Scenes);

/// Pushed and turned by what calls take, one body or all, a step or several; light and heavy.
TYPED_TEST(ToldAfterFreezing, is_finite_and_goes_on) {
    using S = TypeParam;
    // To be mended: where a body turns by a million radians in a step, factors of the energy-momentum step divide by 0 (invert in move_end.cpp). What
    // comes of it is no solution, and the step does without; but divisions are watched there.
    if (is_sanitized && ingot::swings_freely<S>) GTEST_SKIP();
    using World = ingot::World<S>;
    constexpr int count = is_sanitized ? 16 : 48;  // watched, a draw takes seconds
    RandomInput random(7);
    int froze = 0, touched = 0, beside = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(count); ++run_i) {
        const auto world = std::make_unique<World>(), calm = std::make_unique<World>();
        const double M = run_i % 2 == 0 ? 1 : std::pow(10, random.real(-8, 0));
        const uint64_t seed = random.bits();
        std::vector<Heap<S>> heaps;
        for (World* const each : {world.get(), calm.get()}) {
            ASSERT_EQ(each->set_gravity({0, 0, scalar(-9.8125)}), Status::ok);
            if constexpr (ingot::has_shapes<S>) {
                BodyDef ground;
                ground.immovable = true;
                ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
                ASSERT_TRUE(each->add(ground).ok());
            }
            heaps.emplace_back(*each, 0, M, RandomInput(seed));
            heaps.emplace_back(*each, 50, 1, RandomInput(seed + 1));
        }
        const double share = std::pow(10, random.real(-8, 0));
        const bool all = random.integer(0, 1) == 0, rests = random.integer(0, 1) == 0;
        const int what = random.integer(0, 2), from = random.integer(1, 6), pushed = random.integer(0, 3);
        const Vector along = ingot_reference::to_vector(random.direction());
        constexpr int rates[] = {30, 60, 120, 240, 1000};
        const scalar h = 1 / static_cast<scalar>(rates[random.integer(0, 4)]);
        bool alone = true;
        for (int step_i = 0; step_i < 14; ++step_i) {
            if (step_i >= from)
                for (int body_i = 0; body_i < 4; ++body_i) {
                    const BodyId id = heaps[0].bodies[static_cast<size_t>(body_i)];
                    if (!all && body_i != pushed) continue;
                    if (what != 1) (void)world->add_central_force(id, along * (number(share) * limits::force_max));
                    if (what != 0) (void)world->add_torque(id, along * (number(share) * limits::torque_max));
                    if constexpr (S::sleeps)
                        if (rests) (void)world->sleep(id);
                }
            const ingot::StepReport report = ingot::step(*world, h);
            (void)ingot::step(*calm, h);
            alone = alone && !this->meet(*world, heaps[0], heaps[1]);
            if (alone) {
                ASSERT_TRUE(figures::are_same(*world, *calm, heaps[1].bodies, heaps[3].bodies)) << run_i << ", " << step_i;
            }
            this->expect_finite(*world, heaps[0], report);
            if (report.bodies_frozen > 0) {
                ++froze;
                beside += alone ? 1 : 0;
                if constexpr (ingot::has_shapes<S>)
                    for (const BodyId id : heaps[0].bodies)
                        if (world->is_frozen(id))
                            for (const ingot::ContactInfo& contact : world->contacts_of(id)) touched += contact.point_count;
                this->expect_same_life(*world, h);
            }
            if (this->HasFailure()) {
                std::printf("run %d, step %d\n", run_i, step_i);
                return;
            }
        }
    }
    std::printf("    bodies froze in %d steps, in %d of them beside others; %d points of their contacts were told\n", froze, beside, touched);
    EXPECT_GT(beside, ingot_reference::draws(count) / 8);
}

}  // namespace

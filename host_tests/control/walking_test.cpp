// SPDX-License-Identifier: MIT
// A biped walks by servos of its joints and of the world: at any rate, within its torques, pushed, saved in mid-stride, and in company.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

#include "scenes/controlled.h"

namespace {

using ingot::scalar;
using ingot::Status;
using scenes::Gait;
using scenes::Walker;
using scenes::WalkState;
using Scene = scenes::WalkingInPlane;
using Plane = ingot::World<Scene>;

/// What was seen on the way.
struct Walk {
    std::unique_ptr<Plane> world = std::make_unique<Plane>();
    Walker walker;
    Gait gait;
    WalkState state;
    double gap = 0, depth = 0, torque = 0;  ///< m, m, N m: the most
    int unfinished = 0;                     ///< steps that were not clean

    Walk() {
        EXPECT_EQ(scenes::add_ground(*world), Status::ok);
        EXPECT_EQ(scenes::add_walker(*world, {0, 0, 0}, scalar(0.8), walker), Status::ok);
    }
    void step(double rate) {
        ASSERT_EQ(scenes::walk(*world, walker, gait, state, static_cast<scalar>(1 / rate)), Status::ok);
        unfinished += ingot::step(*world, static_cast<scalar>(1 / rate)).clean() ? 0 : 1;
        for (int leg_i = 0; leg_i < 2; ++leg_i) {
            const ingot::JointId hinges[] = {walker.hip[leg_i], walker.knee[leg_i], walker.ankle[leg_i]};
            for (const ingot::JointId id : hinges) gap = std::max(gap, static_cast<double>(world->joint_gap(id).value));
            const ingot::JointId driven[] = {walker.upright[leg_i], walker.swing[leg_i], walker.knee[leg_i]};
            for (const ingot::JointId id : driven) torque = std::max(torque, std::abs(static_cast<double>(world->drive_torque(id).value)));
            torque = std::max(torque, std::abs(static_cast<double>(world->drive_torque(walker.ankle[leg_i]).value)) / 0.7);
            for (const ingot::ContactInfo& contact : world->contacts_of(walker.foot[leg_i]))
                depth = std::max(depth, -static_cast<double>(contact.separation));
        }
    }
    /// False where it falls.
    bool walks(double seconds, double rate) {
        for (int step_i = 0; step_i < static_cast<int>(seconds * rate + 0.5); ++step_i) {
            step(rate);
            if (scenes::height_of(*world, walker) < scalar(0.9)) return false;
        }
        return true;
    }
    double distance() const { return static_cast<double>(world->figure(walker.trunk).value.r_CM.x); }
};

/// A minute without a fall, from 30 Hz on; joints hold, feet stay on the ground, and nearly all steps are clean. At 60 Hz it gets as far as at 960 Hz
/// within 5 %.
TEST(Walking, goes_on_for_a_minute_at_any_rate) {
    const double seconds = INGOT_TEST_BRIEF ? 20 : 60;
    double at_60 = 0;
    for (const double rate : {30.0, 60.0, 120.0, 240.0, 960.0}) {
        if (INGOT_TEST_BRIEF && rate > 120) continue;
        Walk walk;
        ASSERT_TRUE(walk.walks(seconds, rate)) << rate << " Hz, after " << walk.distance() << " m";
        EXPECT_GE(walk.distance(), seconds) << rate << " Hz";
        EXPECT_LE(walk.gap, 5e-5) << rate << " Hz";
        EXPECT_LE(walk.depth, 2e-4) << rate << " Hz";
        EXPECT_LE(walk.unfinished, 0.05 * seconds * rate) << rate << " Hz";
        if (rate == 60) at_60 = walk.distance();
        if (rate == 960) {
            EXPECT_NEAR(at_60, walk.distance(), 0.05 * walk.distance());
        }
    }
}

/// Within the torque that it has; an ankle has 0.7 of it.
TEST(Walking, keeps_to_its_torque) {
    for (const double most : {100.0, 150.0, 200.0}) {
        if (INGOT_TEST_BRIEF && most != 100) continue;
        for (const double rate : {30.0, 60.0, 240.0}) {
            if (INGOT_TEST_BRIEF && rate != 60) continue;
            Walk walk;
            walk.gait.max_torque = static_cast<scalar>(most);
            ASSERT_TRUE(walk.walks(INGOT_TEST_BRIEF ? 20 : 60, rate)) << most << " N m, " << rate << " Hz, after " << walk.distance() << " m";
            EXPECT_LE(walk.torque, most * (1 + 64 * static_cast<double>(ingot::epsilon))) << rate << " Hz";
            EXPECT_LE(walk.depth, 3e-4) << most << " N m, " << rate << " Hz";  // drives that give way are found in the solve
            EXPECT_LE(walk.gap, 5e-5) << most << " N m, " << rate << " Hz";
        }
    }
}

/// A push against the trunk at four moments of a stride: 75 N s from ahead, 70 N s from behind. Where it looks but sixty times a second, its target
/// has to move between two looks.
TEST(Walking, survives_pushes) {
    constexpr double stride = 0.36;  // s, of one step
    for (const double rate : {60.0, 120.0, 240.0}) {
        if (INGOT_TEST_BRIEF && rate != 60) continue;
        for (const double push : {70.0, -75.0})
            for (const double phase : {0.0, 0.25, 0.5, 0.75}) {
                Walk walk;
                walk.gait.lead = rate < 100 ? 1 : 0;
                while (walk.state.steps < 8) walk.step(rate);
                ASSERT_TRUE(walk.walks(phase * stride, rate));
                ASSERT_EQ(walk.world->apply_central_impulse(walk.walker.trunk, {static_cast<scalar>(push), 0, 0}), Status::ok);
                EXPECT_TRUE(walk.walks(INGOT_TEST_BRIEF ? 4 : 15, rate)) << rate << " Hz, " << push << " N s, phase " << phase;
            }
    }
}

std::vector<uint8_t> saved(const Plane& world) {
    std::vector<uint8_t> bytes(ingot::snapshot_size<Scene>());
    bytes.resize(ingot::save_snapshot(world, bytes.data(), bytes.size()).value);
    return bytes;
}

/// What is saved in mid-stride goes on to the same bits.
TEST(Walking, goes_on_from_a_snapshot) {
    Walk walk, other;
    ASSERT_TRUE(walk.walks(3.1, 60));
    const std::vector<uint8_t> bytes = saved(*walk.world);
    ASSERT_EQ(ingot::load_snapshot(*other.world, bytes.data(), bytes.size()), Status::ok);
    other.state = walk.state;
    ASSERT_TRUE(walk.walks(3, 60));
    ASSERT_TRUE(other.walks(3, 60));
    EXPECT_EQ(walk.world->state_hash(), other.world->state_hash());
    EXPECT_EQ(walk.state.steps, other.state.steps);
}

/// Room for two, and for a heap of stones.
struct Street : Scene {
    static constexpr int max_bodies = 24, max_joints = 22, max_loops = 10, max_manifolds = 40, max_pairs = 80;
};

/// In a world with another, and a heap that falls, it walks as it does alone, to the bit.
TEST(Walking, is_the_same_in_company) {
    Walk alone;
    const auto world = std::make_unique<ingot::World<Street>>();
    ASSERT_EQ(scenes::add_ground(*world), Status::ok);
    ingot::BodyDef stone;
    stone.mass = ingot::principal(ingot::with_mass(ingot::solid_box(1, {scalar(0.2), scalar(0.2), scalar(0.2)}), 20)).value;
    stone.shape = ingot::Box{{scalar(0.2), scalar(0.2), scalar(0.2)}};
    for (int i = 0; i < 6; ++i) {
        stone.state.r_CM = {static_cast<scalar>(i % 2) * scalar(0.1), -3, scalar(0.25) + static_cast<scalar>(i) * scalar(0.45)};
        ASSERT_TRUE(world->add(stone).ok());
    }
    Walker first, second;
    ASSERT_EQ(scenes::add_walker(*world, {0, 0, 0}, scalar(0.8), first), Status::ok);
    ASSERT_EQ(scenes::add_walker(*world, {0, 4, 0}, scalar(0.9), second), Status::ok);
    WalkState of_first, of_second;
    for (int step_i = 0; step_i < 300; ++step_i) {
        alone.step(60);
        ASSERT_EQ(scenes::walk(*world, first, alone.gait, of_first, scalar(1) / 60), Status::ok);
        ASSERT_EQ(scenes::walk(*world, second, alone.gait, of_second, scalar(1) / 60), Status::ok);
        (void)ingot::step(*world, scalar(1) / 60);
        const ingot::BodyState a = alone.world->state(alone.walker.foot[0]).value, b = world->state(first.foot[0]).value;
        ASSERT_TRUE(std::memcmp(&a, &b, sizeof a) == 0) << "step " << step_i;
    }
    EXPECT_GT(of_first.steps, 10);
    EXPECT_GT(of_second.steps, 10);
}

/// In space nothing but servos holds it up, of ball joints and of the world: it walks, straight on, and within the torque of a man.
TEST(Walking, in_space_needs_no_more_than_servos) {
    struct Case {
        double rate, most;
    };
    std::vector<Case> cases = {{240, 0}};
    for (const double rate : {30.0, 60.0, 120.0})
        for (const double most : {0.0, 100.0, 150.0, 200.0}) cases.push_back({rate, most});
    for (const Case& of : cases) {
        if (INGOT_TEST_BRIEF && (of.rate != 60 || of.most > 100)) continue;
        const auto world = std::make_unique<ingot::World<scenes::WalkingInSpace>>();
        scenes::SpatialWalker walker;
        scenes::SpatialGait gait;
        WalkState state;
        if (of.most > 0) gait.max_torque = static_cast<scalar>(of.most);
        ASSERT_EQ(scenes::add_ground(*world), Status::ok);
        ASSERT_EQ(scenes::add_walker(*world, scalar(0.6), walker), Status::ok);
        const double seconds = INGOT_TEST_BRIEF ? 10 : 60;
        double gap = 0, torque = 0;
        for (int step_i = 0; step_i < static_cast<int>(seconds * of.rate); ++step_i) {
            ASSERT_EQ(scenes::walk(*world, walker, gait, state, static_cast<scalar>(1 / of.rate)), Status::ok);
            (void)ingot::step(*world, static_cast<scalar>(1 / of.rate));
            ASSERT_GE(world->state(walker.pelvis).value.r_CM.z, scalar(0.7)) << of.rate << " Hz, " << of.most << " N m, step " << step_i;
            for (int side_i = 0; side_i < 2; ++side_i) {
                const ingot::JointId joints[] = {walker.hip[side_i], walker.knee[side_i], walker.ankle[side_i]};
                for (const ingot::JointId id : joints) gap = std::max(gap, static_cast<double>(world->joint_gap(id).value));
                const ingot::JointId balls[] = {walker.upright[side_i], walker.swing[side_i], walker.ankle[side_i]};
                for (const ingot::JointId id : balls)
                    torque = std::max(torque, std::sqrt(static_cast<double>(length_sq(world->ball_torque(id).value))));
            }
        }
        const ingot::Vector place = world->figure(walker.pelvis).value.r_CM;
        EXPECT_GE(static_cast<double>(place.x), 0.45 * seconds) << of.rate << " Hz, " << of.most << " N m";
        if (of.rate > 30) {
            EXPECT_LE(std::abs(static_cast<double>(place.y)), 1) << of.rate << " Hz, " << of.most << " N m";
        }
        EXPECT_LE(gap, 5e-5) << of.rate << " Hz, " << of.most << " N m";
        if (of.most > 0) {
            EXPECT_LE(torque, of.most * (1 + 64 * static_cast<double>(ingot::epsilon)));
        }
    }
}

/// With a cap on the visits of a step it walks as well, and next to no step is cut short by it.
TEST(Walking, keeps_to_its_budget) {
    const auto world = std::make_unique<ingot::World<scenes::PlanarWalk::Scene>>();
    scenes::PlanarWalk controlled;
    ASSERT_EQ(controlled.begin(*world), Status::ok);
    const int steps = INGOT_TEST_BRIEF ? 600 : 3600;
    int told = 0;
    for (int step_i = 0; step_i < steps; ++step_i) {
        ASSERT_EQ(controlled.steer(*world), Status::ok);
        told += ingot::step(*world, scenes::sixtieth).clean() ? 0 : 1;
    }
    EXPECT_TRUE(controlled.is_well(*world));
    EXPECT_LE(told, steps / 100);
}

struct OnAShoestring : Scene {
    static constexpr int work_budget = 48;  // the least there is
};
/// One that is too low says so: drives at their largest torque are solved again, from what is left of it. And the walker walks nevertheless.
TEST(Walking, says_what_its_budget_cuts_short) {
    const auto world = std::make_unique<ingot::World<OnAShoestring>>();
    Walker walker;
    WalkState state;
    Gait gait;
    gait.max_torque = 150;
    ASSERT_EQ(scenes::add_ground(*world), Status::ok);
    ASSERT_EQ(scenes::add_walker(*world, {0, 0, 0}, scalar(0.8), walker), Status::ok);
    int told = 0;
    for (int step_i = 0; step_i < 300; ++step_i) {
        ASSERT_EQ(scenes::walk(*world, walker, gait, state, scenes::sixtieth), Status::ok);
        const ingot::StepReport report = ingot::step(*world, scenes::sixtieth);
        told += report.sweeps_unfinished > 0 ? 1 : 0;
        ASSERT_EQ(report.bodies_frozen, 0);
    }
    EXPECT_GT(told, 0);
    EXPECT_GE(scenes::height_of(*world, walker), scalar(0.9));
}

/// Gains that are none are refused before anything has moved, and the walker is as it was.
TEST(Walking, refuses_bad_gains) {
    Walk walk;
    ASSERT_TRUE(walk.walks(1, 60));
    const auto nan = std::numeric_limits<scalar>::quiet_NaN();
    const auto before = std::make_unique<Plane>(*walk.world);
    const auto refused = [&](const auto& change, Status why) {
        Walk bad;
        *bad.world = *before;
        WalkState state = walk.state;
        Gait gait;
        change(gait);
        EXPECT_EQ(scenes::walk(*bad.world, walk.walker, gait, state, scalar(1) / 60), why);
        EXPECT_TRUE(saved(*bad.world) == saved(*before));  // what it lets go of was let go of before
    };
    refused([&](Gait& gait) { gait.stiffness = nan; }, Status::not_finite);
    refused([&](Gait& gait) { gait.stiffness = -1; }, Status::out_of_range);
    refused([&](Gait& gait) { gait.damping = -1; }, Status::out_of_range);
    refused([&](Gait& gait) { gait.damping = nan; }, Status::not_finite);
    refused([&](Gait& gait) { gait.max_torque = -1; }, Status::out_of_range);
}

}  // namespace

// SPDX-License-Identifier: MIT
// Targets of drives that go on keep time: after any number of steps they are where their rate says, at any rate of steps, through snapshots, and
// begin anew where they are told to.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "joints/figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;
using ingot::JointId;
using ingot::Status;

struct Clock : ingot::Scene {
    static constexpr int max_bodies = 4, max_joints = 4;
    static constexpr bool translates = true;
    static constexpr ingot::Effort effort = {2, 3};
    using joints =
        ingot::Joints<ingot::HingeJoint, ingot::SliderJoint, ingot::UniversalJoint, ingot::WheelJoint, ingot::WithDrives>;
};
/// Among contacts, where a step may begin again with more substeps.
struct ClockInContact : Clock {
    static constexpr int max_manifolds = 16, max_loops = 2;
    static constexpr bool sleeps = true;
    using shapes = ingot::Shapes<ingot::Sphere>;
};

constexpr double u = eps / 2;

/// What a direction of a joint is driven by. (Of ball joints: JointDrives.ball_servos_follow_a_target_round_and_round.)
struct Hand {
    JointId joint{};
    int which = 0;
    scalar begin{}, rate{};

    template <class S>
    double target(const ingot::World<S>& world) const {
        return static_cast<double>(world.joint_drive(joint, which).value.target);
    }
};

template <class S>
struct Clockwork {
    std::unique_ptr<ingot::World<S>> world = std::make_unique<ingot::World<S>>();
    std::vector<Hand> hands;

    explicit Clockwork(RandomInput random) {
        const ingot::Joint joints[] = {ingot::HingeJoint{}, ingot::SliderJoint{}, ingot::UniversalJoint{}, ingot::WheelJoint{}};
        constexpr int directions[] = {1, 1, 2, 3};
        for (int i = 0; i < 3; ++i) {
            ingot::BodyDef body;
            body.mass = {1, {1, 1, 1}, {}, ingot::identity_matrix<scalar>()};
            body.state.r_CM = {static_cast<scalar>(4 * i), 0, 0};
            ingot::JointDef def;
            def.body_B = world->add(body).value;
            def.P = body.state.r_CM;
            const int kind = random.integer(0, 3);
            def.joint = joints[kind];
            const bool from_zero = random.integer(0, 2) == 0;
            const Hand hand = {world->add_joint(def).value, random.integer(0, directions[kind] - 1),
                               static_cast<scalar>(from_zero ? 0 : random.of_any_size(-4, 14)), static_cast<scalar>(random.of_any_size(-10, 8))};
            aim(hand);
            hands.push_back(hand);
        }
    }
    /// It hardly follows: where targets are is no matter of where joints are.
    void aim(const Hand& hand) {
        const ingot::SpringDrive spring = {scalar(0.01), 0, hand.begin, hand.rate, 0, scalar(0.01)};
        ASSERT_EQ(world->set_joint_drive(hand.joint, spring, hand.which), Status::ok);
    }
    void step(scalar h, int count) {
        for (int i = 0; i < count; ++i) ASSERT_EQ(ingot::step(*world, h).bodies_frozen, 0);
    }
};

/// How far roundings may put a target off: those of the way of a step, and of its sum with what was left over; and of the target itself. A sum whose
/// first steps are larger than it loses a few roundings of these.
double allowed_of(const Hand& hand, double target, scalar h, int steps) {
    const double step = std::abs(static_cast<double>(hand.rate) * static_cast<double>(h));
    return u * (2.01 * step * steps + std::abs(target) + 8 * step);
}

template <class S>
class MovingTargets : public ::testing::Test {};
using Scenes = ::testing::Types<Clock, ClockInContact>;
TYPED_TEST_SUITE(MovingTargets, Scenes);

TYPED_TEST(MovingTargets, keep_time) {
    RandomInput random(1);
    double most = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i) {
        const double rate = std::exp(random.real(std::log(30), std::log(1000)));
        const auto h = static_cast<scalar>(1 / rate);
        Clockwork<TypeParam> clock(RandomInput(random.bits()));
        const int before = random.integer(1, 600), after = random.integer(1, 600);
        ASSERT_NO_FATAL_FAILURE(clock.step(h, before));

        // Saved in mid-run, and gone on with.
        Clockwork<TypeParam> other(RandomInput(1));
        std::vector<uint8_t> bytes(ingot::snapshot_size<TypeParam>());
        const auto size = ingot::save_snapshot(*clock.world, bytes.data(), bytes.size());
        ASSERT_TRUE(size.ok());
        ASSERT_EQ(ingot::load_snapshot(*other.world, bytes.data(), size.value), Status::ok);
        ASSERT_NO_FATAL_FAILURE(clock.step(h, after));
        ASSERT_NO_FATAL_FAILURE(other.step(h, after));
        for (const Hand& hand : clock.hands) {
            const double target = hand.target(*clock.world), allowed = allowed_of(hand, target, h, before + after);
            const double due = static_cast<double>(hand.begin) + static_cast<double>(hand.rate) * static_cast<double>(h) * (before + after);
            EXPECT_LE(std::abs(target - due), allowed) << "run " << run_i << ", " << rate << " Hz, " << before + after << " steps from " << hand.begin
                                                       << " by " << hand.rate;
            most = std::max(most, std::abs(target - due) / allowed);
            EXPECT_EQ(target, hand.target(*other.world));
        }
        EXPECT_EQ(clock.world->state_hash(), other.world->state_hash());
    }
    std::printf("    off by up to %.2g of what roundings allow\n", most);
}

/// A target that is set anew goes on as one that begins there.
TYPED_TEST(MovingTargets, begin_anew_where_they_are_told_to) {
    RandomInput random(2);
    for (int run_i = 0; run_i < ingot_reference::draws(20); ++run_i) {
        const auto h = static_cast<scalar>(1 / rates[random.integer(0, 4)]);
        const uint64_t seed = random.bits();
        Clockwork<TypeParam> clock{RandomInput(seed)}, fresh{RandomInput(seed)};
        ASSERT_NO_FATAL_FAILURE(clock.step(h, random.integer(1, 300)));
        for (const Hand& hand : clock.hands) {
            ASSERT_EQ(clock.world->set_joint_target(hand.joint, hand.begin, hand.rate, hand.which), Status::ok);
        }
        ASSERT_NO_FATAL_FAILURE(clock.step(h, 100));
        ASSERT_NO_FATAL_FAILURE(fresh.step(h, 100));
        for (const Hand& hand : clock.hands) EXPECT_EQ(hand.target(*clock.world), hand.target(*fresh.world));
    }
}

}  // namespace

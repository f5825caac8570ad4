// SPDX-License-Identifier: MIT
// Figures that touch: the ground, each other, themselves; and that sleep.
#include <gtest/gtest.h>

#include <memory>

#include "figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;

template <int ragdolls>
struct Heap : ingot::Scene {
    static constexpr int max_bodies = parts_of_ragdoll * ragdolls + 4, max_joints = (parts_of_ragdoll - 1) * ragdolls + 2;
    static constexpr int max_manifolds = 60 * ragdolls + 10, max_pairs = 200 * ragdolls;
    static constexpr bool translates = true, sleeps = true;
    using joints = AllJoints;
    using shapes = ingot::Shapes<ingot::Capsule, ingot::Box, ingot::HalfSpace>;
    using broad_phase = ingot::SortedTree;
};
using HeapWorld = ingot::World<Heap<8>>;

/// The bars of a heap: gaps of 0.05 mm at any time, no step gains a joule of some thousands, nothing under the floor.
TEST(Heap, of_ragdolls_falls_and_lies) {
    for (const double rate : {30.0, 60.0, 120.0}) {
        if (INGOT_TEST_BRIEF && rate != 60) continue;
        const auto world = std::make_unique<HeapWorld>();
        ASSERT_TRUE(add_ground(*world) && weigh(*world));
        RandomInput random(5);
        Built built;
        for (int i = 0; i < 8; ++i) {
            const auto at = [&](double low, double high) { return static_cast<scalar>(random.real(low, high)); };
            const Vector place = {at(-0.5, 0.5), at(-0.5, 0.5), scalar(1.4) + static_cast<scalar>(i)};
            add_ragdoll(*world, place, ingot_reference::to_matrix(random.rotation()), built);
        }
        ASSERT_TRUE(built.sound);
        double before = energy_of(*world, built), most = 0, gap = 0;
        for (int step_i = 0; step_i < static_cast<int>(3 * rate); ++step_i) {
            const ingot::StepReport report = ingot::step(*world, static_cast<scalar>(1 / rate));
            ASSERT_EQ(report.bodies_frozen, 0);
            ASSERT_EQ(report.contacts_lost, 0);
            const double now = energy_of(*world, built);
            most = std::max(most, now - before);
            before = now;
            gap = std::max(gap, worst_gap(*world, built));
        }
        EXPECT_LE(gap, 5e-5) << rate << " Hz";
        EXPECT_LE(most, rate < 60 ? 7 : 1) << rate << " Hz";
        for (const ingot::BodyId id : built.bodies) EXPECT_GT(world->state(id).value.r_CM.z, 0.03) << rate << " Hz";
    }
}

struct Platform : ingot::Scene {
    static constexpr int max_bodies = 4, max_joints = 3, max_manifolds = 8;
    static constexpr bool translates = true, kinematic_bodies = true;
    using joints = AllJoints;
    using shapes = ingot::Shapes<ingot::Box>;
};

/// What hangs on a platform that goes and turns as it is told goes and turns with it.
TEST(Figures, hang_on_platforms) {
    for (int run_i = 0; run_i < ingot_reference::draws(20); ++run_i) {
        RandomInput random(static_cast<uint64_t>(run_i));
        const auto world = std::make_unique<ingot::World<Platform>>();
        ASSERT_TRUE(weigh(*world));
        ingot::BodyDef platform;
        platform.immovable = true;
        platform.shape = ingot::Box{{scalar(0.2), scalar(0.2), scalar(0.1)}};
        platform.state.A = ingot_reference::to_matrix(random.rotation());
        ingot::BodyId last = world->add(platform).value;
        ASSERT_EQ(world->set_kinematic(last), ingot::Status::ok);
        ASSERT_EQ(world->set_velocity(last, to_vector(random.vector(1)), to_vector(random.direction() * random.real(0, 6))), ingot::Status::ok);
        Built built;
        for (int i = 0; i < 3; ++i) {
            ingot::BodyDef link;
            link.mass = ingot::principal(ingot::solid_box(500, {scalar(0.1), scalar(0.05), scalar(0.2)})).value;
            link.state.r_CM = {scalar(0.4), 0, scalar(-0.6) * static_cast<scalar>(i) - scalar(0.5)};
            ingot::JointDef joint;
            joint.body_A = last;
            joint.body_B = last = world->add(link).value;
            joint.joint = i == 1 ? kinds[0] : kinds[random.integer(0, 4)];
            joint.axis = {1, 0, 0};
            joint.axis_B = {0, 1, 0};
            joint.P = link.state.r_CM + Vector{0, 0, scalar(0.3)};
            built.joints.push_back(world->add_joint(joint).value);
        }
        const int rate = run_i % 2 == 0 ? 60 : 240;
        for (int step_i = 0; step_i < rate; ++step_i) {
            (void)ingot::step(*world, scalar(1) / static_cast<scalar>(rate));
            ASSERT_LE(worst_gap(*world, built), 5e-5) << run_i << ", step " << step_i;
        }
    }
}

/// What is joined falls asleep as one, and wakes as one.
TEST(Figures, sleep_and_wake_as_one) {
    const auto world = std::make_unique<HeapWorld>();
    ASSERT_TRUE(add_ground(*world) && weigh(*world));
    ingot::BodyDef box;
    box.mass = ingot::principal(ingot::solid_box(500, {scalar(0.2), scalar(0.2), scalar(0.2)})).value;
    box.shape = ingot::Box{{scalar(0.2), scalar(0.2), scalar(0.2)}};
    std::vector<ingot::BodyId> boxes;
    for (int i = 0; i < 3; ++i) {
        box.state.r_CM = {static_cast<scalar>(i), 0, scalar(0.2)};
        boxes.push_back(world->add(box).value);
        if (i == 0) continue;
        ingot::JointDef joint;
        joint.body_A = boxes[static_cast<size_t>(i - 1)];
        joint.body_B = boxes.back();
        joint.joint = ingot::BallJoint{};
        joint.P = {static_cast<scalar>(i) - scalar(0.5), 0, scalar(0.2)};
        ASSERT_TRUE(world->add_joint(joint).ok());
    }
    int step_i = 0;
    while (!world->is_asleep(boxes[0]) && ++step_i < 600) (void)ingot::step(*world, scalar(1) / 60);
    ASSERT_LT(step_i, 600);
    // Islands are made once more in the step after, and then last.
    for (int later = 0; later < 3; ++later) (void)ingot::step(*world, scalar(1) / 60);
    for (const ingot::BodyId id : boxes) EXPECT_TRUE(world->is_asleep(id));
    ASSERT_EQ(world->apply_central_impulse(boxes[2], {0, 40, 0}), ingot::Status::ok);
    for (const ingot::BodyId id : boxes) EXPECT_FALSE(world->is_asleep(id));
    (void)ingot::step(*world, scalar(1) / 60);
    EXPECT_GT(world->state(boxes[0]).value.v_CM.y * world->state(boxes[0]).value.v_CM.y, 0);
}

/// Saved in the midst of it, a heap goes on to the same bits.
TEST(Figures, go_on_from_a_snapshot) {
    const auto world = std::make_unique<HeapWorld>(), other = std::make_unique<HeapWorld>();
    ASSERT_TRUE(add_ground(*world) && weigh(*world));
    Built built;
    for (int i = 0; i < 3; ++i)
        add_ragdoll(*world, {scalar(0.2) * static_cast<scalar>(i), 0, scalar(0.5) + static_cast<scalar>(i)},
                    ingot::axis_angle({0, 1, 0}, static_cast<scalar>(i)), built);
    for (int step_i = 0; step_i < 40; ++step_i) (void)ingot::step(*world, scalar(1) / 60);
    ASSERT_EQ(world->remove(built.joints[4]), ingot::Status::ok);
    std::vector<uint8_t> bytes(ingot::snapshot_size<Heap<8>>());
    const auto size = ingot::save_snapshot(*world, bytes.data(), bytes.size());
    ASSERT_TRUE(size.ok());
    ASSERT_EQ(ingot::load_snapshot(*other, bytes.data(), size.value), ingot::Status::ok);
    for (int step_i = 0; step_i < 40; ++step_i) {
        (void)ingot::step(*world, scalar(1) / 60);
        (void)ingot::step(*other, scalar(1) / 60);
    }
    EXPECT_EQ(world->state_hash(), other->state_hash());
    EXPECT_EQ(other->joint_count(), 29);
}

/// Bodies that are joined do not meet, unless they are asked to; and those whose joint leaves them nothing are let be.
TEST(Figures, joined_bodies_meet_where_they_are_asked_to) {
    for (const bool meet : {false, true}) {
        const auto world = std::make_unique<HeapWorld>();
        ingot::BodyDef box;
        box.mass = ingot::principal(ingot::solid_box(500, {scalar(0.2), scalar(0.2), scalar(0.2)})).value;
        box.shape = ingot::Box{{scalar(0.2), scalar(0.2), scalar(0.2)}};
        const ingot::BodyId A = world->add(box).value;
        box.state.r_CM = {scalar(0.3), 0, 0};
        box.state.v_CM = {-1, 0, 0};
        const ingot::BodyId B = world->add(box).value;
        ingot::JointDef joint;
        joint.body_A = A;
        joint.body_B = B;
        joint.joint = ingot::SliderJoint{};
        joint.axis = {1, 0, 0};
        joint.bodies_meet = meet;
        ASSERT_TRUE(world->add_joint(joint).ok());
        int contacts = 0;
        for (int step_i = 0; step_i < 30; ++step_i) contacts += ingot::step(*world, scalar(1) / 60).contacts;
        EXPECT_EQ(contacts > 0, meet);
        const scalar apart = world->state(B).value.r_CM.x - world->state(A).value.r_CM.x;
        EXPECT_EQ(apart > 0, meet) << apart;
    }
}

struct Turntable : ingot::Scene {
    static constexpr int max_bodies = 4, max_joints = 1, max_manifolds = 16;
    static constexpr bool translates = true, kinematic_bodies = true;
    using joints = AllJoints;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};

/// Two boxes, joined, turn with the table that they stand on, but for what joints and friction are off by in a step, which is of second order.
TEST(FiguresOnATurntable, turn_with_it) {
    for (const double rate : rates)
        for (const ingot::Joint& kind : {kinds[0], kinds[1], kinds[4]}) {
            const auto world = std::make_unique<ingot::World<Turntable>>();
            ASSERT_TRUE(weigh(*world));
            ingot::BodyDef table;
            table.kinematic = true;
            table.shape = ingot::Box{{3, 3, scalar(0.1)}};
            table.friction = 1;
            const ingot::BodyId turns = world->add(table).value;
            ASSERT_EQ(world->set_velocity(turns, {0, 0, 0}, {0, 0, 1}), ingot::Status::ok);
            ingot::JointDef joint;
            ingot::BodyId* const ends[] = {&joint.body_A, &joint.body_B};
            for (int i = 0; i < 2; ++i) {
                ingot::BodyDef box;
                const scalar x = scalar(1) + scalar(0.5) * static_cast<scalar>(i);
                box.mass = ingot::principal(ingot::solid_box(10, {scalar(0.2), scalar(0.2), scalar(0.2)})).value;
                box.shape = ingot::Box{{scalar(0.2), scalar(0.2), scalar(0.2)}};
                box.friction = 1;
                box.state.r_CM = {x, 0, scalar(0.3)};
                box.state.v_CM = {0, x, 0};
                box.state.L = {0, 0, box.mass.I_body.z};
                *ends[i] = world->add(box).value;
            }
            joint.joint = kind;
            joint.P = {scalar(1.25), 0, scalar(0.3)};
            ASSERT_TRUE(world->add_joint(joint).ok());
            for (int step_i = 0; step_i < static_cast<int>(4 * rate); ++step_i) (void)ingot::step(*world, static_cast<scalar>(1 / rate));
            for (const ingot::BodyId* const id : ends)
                EXPECT_NEAR(static_cast<double>(world->omega(*id).value.z), 1, 4 / (rate * rate) + 64 * eps * rate) << rate << " Hz";
        }
}

}  // namespace

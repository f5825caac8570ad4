// SPDX-License-Identifier: MIT
// Bodies that have joints are edited: they keep them.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "figures.h"
#include "reference/draws.h"

namespace {

using namespace figures;
using ingot::Status;

struct Edited : ingot::Scene {
    static constexpr int max_bodies = 40, max_joints = 40, max_loops = 6, max_manifolds = 200, max_pairs = 800, max_overlaps = 8;
    static constexpr bool translates = true, sleeps = true, kinematic_bodies = true;
    using joints = AllJointsWith<ingot::WithLimits, ingot::WithDrives, ingot::WithBreaking>;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};
/// No joint closes a loop.
struct EditedTrees : Edited {
    static constexpr int max_loops = 0;
};

ingot::MassProperties mass_of(double M) { return ingot::principal(ingot::with_mass(ingot::solid_box(1, {1, 2, 3}), static_cast<scalar>(M))).value; }

template <class World>
std::vector<uint8_t> bytes_of(const World& world) {
    std::vector<uint8_t> bytes(1u << 20);
    const auto size = ingot::save_snapshot(world, bytes.data(), bytes.size());
    EXPECT_TRUE(size.ok());
    bytes.resize(size.value);
    return bytes;
}
template <class World>
bool live_all(const World& world, const Built& built) {
    bool live = true;
    for (const ingot::JointId id : built.joints) live = live && world.is_alive(id);
    return live;
}
template <class World>
int bodies_that_move(const World& world, const Built& built) {
    int count = 0;
    for (const ingot::BodyId id : built.bodies) count += world.is_movable(id) ? 1 : 0;
    return count;
}

/// Any kind of edit, of any body of a tree that falls and lies beside others: joints live on and hold, and what is joined to a sleeper wakes it.
TEST(EditedBodies, keep_their_joints) {
    for (int run_i = 0; run_i < ingot_reference::draws(60); ++run_i) {
        RandomInput random(static_cast<uint64_t>(run_i));
        const auto world = std::make_unique<ingot::World<Edited>>();
        ASSERT_TRUE(add_ground(*world) && weigh(*world));
        Built built;
        for (const double x : {0.0, 1.5, 3.0}) {
            const Drawn drawn = {random.integer(2, 8), 0.1, 20, 1, random.integer(0, 1) == 1};
            add_figure(*world, random, drawn, {x, 0, 0.8}, built);
        }
        ASSERT_TRUE(built.sound);
        const ingot::Box box = {{scalar(0.05), scalar(0.06), scalar(0.07)}};
        for (const ingot::BodyId id : built.bodies) ASSERT_EQ(world->set_shape(id, box), Status::ok);
        ASSERT_TRUE(live_all(*world, built));
        const double rate = rates[random.integer(0, 4)];
        const auto h = static_cast<scalar>(1 / rate);
        for (int edit_i = 0; edit_i < 12; ++edit_i) {
            const ingot::BodyId id = built.bodies[static_cast<size_t>(random.integer(0, static_cast<int>(built.bodies.size()) - 1))];
            Status status = Status::ok;
            switch (random.integer(0, 5)) {
                case 0: status = world->set_immovable(id); break;
                case 1: status = world->set_kinematic(id); break;
                case 2: status = world->set_shape(id, ingot::Sphere{scalar(0.05)}); break;
                case 3: status = world->set_sensor(id, random.integer(0, 1) == 1); break;
                default: status = world->set_movable(id, mass_of(random.real(0.5, 5))); break;
            }
            ASSERT_TRUE(status == Status::ok || status == Status::no_room) << run_i << ", " << ingot::name(status);
            if (status == Status::ok && world->is_kinematic(id)) {
                ASSERT_EQ(world->set_velocity(id, to_vector(random.vector(0.3)), to_vector(random.vector(1))), Status::ok);
            }
            for (int step_i = 0; step_i < static_cast<int>(rate / 10) + 2; ++step_i) ASSERT_EQ(ingot::step(*world, h).bodies_frozen, 0) << run_i;
            ASSERT_TRUE(live_all(*world, built)) << run_i;
        }
        // All go again, and what platforms have torn apart comes together.
        for (const ingot::BodyId id : built.bodies)
            if (!world->is_movable(id)) {
                ASSERT_EQ(world->set_movable(id, mass_of(1)), Status::ok) << run_i;
            }
        ASSERT_EQ(bodies_that_move(*world, built), static_cast<int>(built.bodies.size()));
        for (int step_i = 0; step_i < static_cast<int>(2 * rate); ++step_i) ASSERT_EQ(ingot::step(*world, h).bodies_frozen, 0);
        EXPECT_LE(worst_gap(*world, built), held) << run_i << ", " << rate << " Hz";
    }
}

/// An edited world is the world that was built so: in any state, to the bit.
TEST(EditedBodies, are_as_bodies_built_so) {
    for (int run_i = 0; run_i < ingot_reference::draws(60); ++run_i) {
        const auto built_so = std::make_unique<ingot::World<Edited>>(), edited = std::make_unique<ingot::World<Edited>>();
        Built of_built, of_edited;
        const int count = 2 + run_i % 7, edited_i = run_i % count;
        const bool kinematic = run_i % 2 == 0;
        for (auto* built : {&of_built, &of_edited}) {
            auto& world = built == &of_built ? *built_so : *edited;
            RandomInput random(static_cast<uint64_t>(run_i));
            ASSERT_TRUE(weigh(world));
            ingot::BodyId last{};
            for (int i = 0; i < count; ++i) {
                ingot::BodyDef def;
                def.mass = mass_of(random.real(1, 5));
                def.state.r_CM = to_vector(Eigen::Vector3d(i, 0, 0) + random.vector(0.2));
                def.shape = ingot::Box{{scalar(0.1), scalar(0.2), scalar(0.3)}};
                const bool stands = built == &of_built && i == edited_i;
                def.immovable = stands && !kinematic;
                def.kinematic = stands && kinematic;
                const ingot::BodyId id = world.add(def).value;
                built->bodies.push_back(id);
                ingot::JointDef joint;
                joint.body_A = last;
                joint.body_B = id;
                joint.joint = kinds[random.integer(0, 3)];
                joint.P = to_vector(Eigen::Vector3d(i - 0.5, 0, 0) + random.vector(0.2));
                joint.axis = {1, 0, 0};
                joint.axis_B = {0, 1, 0};
                last = id;
                if (i > 0) built->joints.push_back(world.add_joint(joint).value);
            }
        }
        const ingot::BodyId id = of_edited.bodies[static_cast<size_t>(edited_i)];
        ASSERT_EQ(kinematic ? edited->set_kinematic(id) : edited->set_immovable(id), Status::ok);
        for (int step_i = 0; step_i < 60; ++step_i) {
            const ingot::StepReport a = ingot::step(*built_so, scalar(1) / 60), b = ingot::step(*edited, scalar(1) / 60);
            ASSERT_EQ(a.clean(), b.clean());
        }
        EXPECT_TRUE(are_same(*built_so, *edited, of_built.bodies, of_edited.bodies)) << run_i;
        EXPECT_EQ(bytes_of(*built_so), bytes_of(*edited)) << run_i;
    }
}

/// An edit that would close a loop for which there is no room is refused, and the world goes on as one that never heard of it.
TEST(EditedBodies, close_no_loop_without_room) {
    for (const bool kinematic : {false, true}) {
        const auto world = std::make_unique<ingot::World<EditedTrees>>(), other = std::make_unique<ingot::World<EditedTrees>>();
        Built built, of_other;
        for (auto* of : {&built, &of_other}) {
            RandomInput random(7);
            auto& one = of == &built ? *world : *other;
            ASSERT_TRUE(weigh(one));
            add_figure(one, random, {6, 0.1, 10, 1, true}, {0, 0, 5}, *of);  // the first is tied to the world
            ASSERT_TRUE(of->sound);
            for (int step_i = 0; step_i < 20; ++step_i) (void)ingot::step(one, scalar(1) / 60);
        }
        const std::vector<uint8_t> before = bytes_of(*world);
        const ingot::BodyId last = built.bodies.back();
        EXPECT_EQ(kinematic ? world->set_kinematic(last) : world->set_immovable(last), Status::no_room);
        EXPECT_EQ(bytes_of(*world), before);
        for (int step_i = 0; step_i < 60; ++step_i) {
            (void)ingot::step(*world, scalar(1) / 60);
            (void)ingot::step(*other, scalar(1) / 60);
        }
        EXPECT_EQ(bytes_of(*world), bytes_of(*other));
        // With its root fixed the tree has one way to the ground less, and nothing else changes.
        EXPECT_EQ(world->set_immovable(built.bodies.front()), Status::ok);
        EXPECT_EQ(kinematic ? world->set_kinematic(last) : world->set_immovable(last), Status::no_room);
        // One that floats may have one ground, and no second.
        Built floating;
        RandomInput random(8);
        add_figure(*world, random, {2, 0.1, 10, 1, false}, {5, 0, 5}, floating);
        EXPECT_EQ(world->set_immovable(floating.bodies.front()), Status::ok);
        EXPECT_EQ(world->set_immovable(floating.bodies.back()), Status::ok);
        EXPECT_EQ(world->set_movable(floating.bodies.front(), mass_of(1)), Status::ok);
        EXPECT_TRUE(live_all(*world, built) && live_all(*world, floating));
    }
}

/// A sleeping figure hangs on what stands; that is let go: it wakes and falls with it.
TEST(EditedBodies, wake_what_hangs_on_them) {
    const auto world = std::make_unique<ingot::World<Edited>>();
    ASSERT_TRUE(weigh(*world));
    ingot::BodyDef post;
    post.immovable = true;
    const ingot::BodyId hook = world->add(post).value;
    ingot::BodyDef link;
    link.mass = mass_of(1);
    link.state.r_CM = {0, 0, -1};
    const ingot::BodyId body = world->add(link).value;
    ingot::JointDef joint;
    joint.body_A = hook;
    joint.body_B = body;
    joint.joint = ingot::HingeJoint{};
    joint.axis = {1, 0, 0};
    const ingot::JointId at = world->add_joint(joint).value;
    for (int step_i = 0; step_i < 300 && !world->is_asleep(body); ++step_i) (void)ingot::step(*world, scalar(1) / 60);
    ASSERT_TRUE(world->is_asleep(body));
    ASSERT_EQ(world->set_movable(hook, mass_of(1)), Status::ok);
    EXPECT_FALSE(world->is_asleep(body));
    for (int step_i = 0; step_i < 60; ++step_i) (void)ingot::step(*world, scalar(1) / 60);
    EXPECT_LE(static_cast<double>(world->state(body).value.r_CM.z), -5);
    EXPECT_LE(static_cast<double>(world->joint_gap(at).value), held);
    EXPECT_LE(static_cast<double>(world->joint_reaction(at).value.force.z), 1e-3);
    // Neither moves: the joint does nothing, and bears nothing.
    ASSERT_EQ(world->set_immovable(hook), Status::ok);
    ASSERT_EQ(world->set_kinematic(body), Status::ok);
    EXPECT_EQ(world->figure(at).status, Status::immovable);
    EXPECT_TRUE(ingot::step(*world, scalar(1) / 60).clean());
    EXPECT_EQ(world->joint_reaction(at).value.force.z, 0);
}

/// A sleeper is joined, by any joint or rope, to a platform that begins to move, however it is told to: it wakes, and hangs on it at any speed.
TEST(EditedBodies, that_begin_to_move_take_sleepers_along) {
    struct Pulled : Edited {
        using joints = AllJointsWith<ingot::RodJoint, ingot::RopeJoint>;
    };
    const ingot::Joint ways[] = {ingot::BallJoint{}, ingot::HingeJoint{}, ingot::FixedJoint{}, ingot::RodJoint{}, ingot::RopeJoint{}};
    for (const ingot::Joint& way : ways)
        for (int told = 0; told < 4; ++told)
            for (const double speed : {1e-3, 0.1, 2.0}) {
                const auto world = std::make_unique<ingot::World<Pulled>>();
                ASSERT_TRUE(add_ground(*world) && weigh(*world));
                ingot::BodyDef def;
                def.kinematic = told != 3;
                def.immovable = told == 3;
                def.state.r_CM = {0, 0, 2};
                const ingot::BodyId puller = world->add(def).value;
                def = {};
                def.mass = mass_of(2);
                def.shape = ingot::Box{{scalar(0.1), scalar(0.1), scalar(0.1)}};
                def.state.r_CM = {0, 0, scalar(0.1)};
                const ingot::BodyId box = world->add(def).value;
                ingot::JointDef joint;
                joint.body_A = puller;
                joint.body_B = box;
                joint.joint = way;
                joint.P = {0, 0, 2};
                joint.P_B = {0, 0, scalar(0.1)};
                joint.axis = {0, 1, 0};
                const ingot::JointId id = world->add_joint(joint).value;
                for (int step_i = 0; step_i < 300; ++step_i) (void)ingot::step(*world, scalar(1) / 60);
                ASSERT_TRUE(world->is_asleep(box));
                const auto v = static_cast<scalar>(speed);
                if (told == 3) {
                    ASSERT_EQ(world->set_kinematic(puller), Status::ok);
                }
                if (told == 0 || told == 3) {
                    ASSERT_EQ(world->set_velocity(puller, {0, 0, v}), Status::ok);
                }
                for (int step_i = 1; step_i <= 120; ++step_i) {
                    ingot::BodyState state = world->state(puller).value;
                    state.r_CM.z = 2 + v * static_cast<scalar>(step_i) / 60;
                    if (told == 1) {
                        ASSERT_EQ(world->move_to(puller, state.r_CM, state.A), Status::ok);
                    }
                    if (told == 2) {
                        ASSERT_EQ(world->set_state(puller, state), Status::ok);
                    }
                    (void)ingot::step(*world, scalar(1) / 60);
                    ASSERT_FALSE(world->is_asleep(box)) << told << ", " << speed;
                }
                EXPECT_NEAR(static_cast<double>(world->state(box).value.r_CM.z), 0.1 + 2 * speed, held + speed / 60) << told << ", " << speed;
                EXPECT_LE(static_cast<double>(world->joint_gap(id).value), held + (told == 2 ? speed / 60 : 0)) << told << ", " << speed;
            }
}

/// A figure that an animation moves, all of it or but a part, and lets go again: its snapshots load at any time, and go on to the same bits.
TEST(EditedBodies, are_animated_and_saved) {
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i) {
        RandomInput random(static_cast<uint64_t>(run_i));
        const auto world = std::make_unique<ingot::World<Edited>>(), copy = std::make_unique<ingot::World<Edited>>();
        ASSERT_TRUE(add_ground(*world) && weigh(*world));
        Built built;
        add_figure(*world, random, {random.integer(2, 10), 0.1, 20, 1, false}, {0, 0, 3}, built);
        ASSERT_TRUE(built.sound);
        const auto h = static_cast<scalar>(1 / rates[random.integer(0, 4)]);
        for (int round = 0; round < 6; ++round) {
            const Vector v = to_vector(random.vector(0.5)), omega = to_vector(random.vector(1));
            for (const ingot::BodyId id : built.bodies) {
                const bool led = round % 3 == 0 || (round % 3 == 1 && random.integer(0, 1) == 1);
                const Status status = led ? world->set_kinematic(id) : world->set_movable(id, mass_of(1));
                ASSERT_TRUE(status == Status::ok || status == Status::no_room);
                if (world->is_kinematic(id)) {
                    ASSERT_EQ(world->set_velocity(id, v, omega), Status::ok);
                }
            }
            for (int step_i = 0; step_i < 10; ++step_i) (void)ingot::step(*world, h);
            const std::vector<uint8_t> bytes = bytes_of(*world);
            ASSERT_EQ(ingot::load_snapshot(*copy, bytes.data(), bytes.size()), Status::ok) << run_i << ", " << round;
            for (int step_i = 0; step_i < 10; ++step_i) {
                (void)ingot::step(*world, h);
                (void)ingot::step(*copy, h);
            }
            ASSERT_EQ(world->state_hash(), copy->state_hash()) << run_i << ", " << round;
        }
    }
}

}  // namespace

// SPDX-License-Identifier: MIT
// Joints that break: which, when, and what is left; in company, in snapshots and asleep.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>

#include "joints/figure_scenes.h"
#include "random_trees.h"
#include "reference/draws.h"
#include "scene_in_world.h"

namespace {

using namespace figures;
using namespace ingot_figures;
using ingot::Status;
using ingot_reference::to_eigen;

struct Breaking : ingot::Scene {
    static constexpr int max_bodies = 64, max_joints = 64;
    static constexpr bool translates = true;
    using joints = AllJointsWith<ingot::WithBreaking>;
};
struct BreakingFreely : Breaking {
    using figure_motion = ingot::EnergyMomentum<>;
};
struct BreakingInTouch : Breaking {
    static constexpr int max_manifolds = 200, max_pairs = 800;
    static constexpr bool sleeps = true, kinematic_bodies = true;
    using joints = AllJointsWith<ingot::WithBreaking, ingot::WithLimits, ingot::WithDrives>;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box>;
};
struct BreakingLoops : Breaking {
    static constexpr int max_loops = 2;
};

template <class World>
std::vector<ingot::JointBreak> breaks_of(const World& world) {
    std::vector<ingot::JointBreak> breaks;
    for (const ingot::JointBreak& broken : world.broken_joints()) breaks.push_back(broken);
    return breaks;
}
scalar number(double x) { return static_cast<scalar>(x); }
scalar size_of(const Vector& v) { return number(to_eigen(v).norm()); }

/// Links below each other from a point at the origin. Joints of any kind that hold what hangs on them.
FigureScene hanging_chain(RandomInput& random, int links, double end_mass) {
    FigureScene scene;
    for (int i = 0; i < links; ++i) {
        const double M = i + 1 == links ? end_mass : random.real(0.5, 2);
        scene.add(box(M, {0.05, 0.05, 0.2}, {0, 0, -0.25 - 0.5 * i}, Matrix3d::Identity()));
        constexpr FigureJointKind kinds[] = {FigureJointKind::ball, FigureJointKind::hinge, FigureJointKind::universal, FigureJointKind::fixed};
        const bool turned = i > 0 && random.integer(0, 1) == 1;
        scene.join(joint_of(kinds[random.integer(0, 3)], turned ? i : i - 1, turned ? i - 1 : i, {0, 0, -0.5 * i}, {1, 0, 0}, {0, 1, 0}));
    }
    return scene;
}

/// A winch pulls at the end of a chain, harder in each step: where it bears most it breaks, at the first step in which that is more than it can, and
/// nowhere else. What is left hangs on, and bears what hangs on it. A figure of another kind beside it changes no bit of it.
template <class Scene>
void expect_to_break_at_the_top(uint64_t seed) {
    RandomInput random(seed);
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i) {
        const int links = random.integer(2, 20);
        const double rate = rates[random.integer(0, 4)], end_mass = random.real(1, 20), pull = random.real(5, 50);
        const FigureScene scene = hanging_chain(random, links, end_mass);
        double weight = 0;
        for (const FigureBody& body : scene.bodies) weight += body.M * g;
        const int step_of_break = random.integer(1, 20);
        const double strength = weight + step_of_break * pull - std::min(pull, scene.body(0).M * g) / 2;  // the second joint bears less
        const auto alone = std::make_unique<ingot::World<Scene>>(), world = std::make_unique<ingot::World<Scene>>();
        const Built built = add_scene(*world, scene), built_alone = add_scene(*alone, scene);
        Built beside;
        add_figure(*world, random, {random.integer(2, 8), 0.4, 10, 2, true}, {0, 50, 0}, beside);
        for (int i = 0; i < links; ++i)
            for (const auto& [in, of] : {std::pair{world.get(), &built}, std::pair{alone.get(), &built_alone}})
                ASSERT_EQ(in->set_joint_strength(of->joints[static_cast<std::size_t>(i)], {number(strength), ingot::unlimited}), Status::ok);
        for (int step_i = 0; step_i < 25; ++step_i) {
            const auto h = number(1 / rate);
            for (const auto& [in, of] : {std::pair{world.get(), &built}, std::pair{alone.get(), &built_alone}}) {
                const Vector force = {0, 0, number(step_i <= step_of_break ? -pull * step_i : 0)};
                ASSERT_EQ(in->add_central_force(of->bodies.back(), force), Status::ok);
                ASSERT_TRUE(ingot::step(*in, h).clean());
            }
            ASSERT_TRUE(are_same(*world, *alone, built.bodies, built_alone.bodies)) << run_i << ", step " << step_i;
            const std::vector<ingot::JointBreak> breaks = breaks_of(*world), breaks_alone = breaks_of(*alone);
            ASSERT_EQ(breaks.size(), step_i == step_of_break ? 1u : 0u) << run_i << ", step " << step_i << " of " << step_of_break;
            ASSERT_EQ(breaks_alone.size(), breaks.size());
            if (breaks.empty()) continue;
            EXPECT_EQ(breaks[0].joint, built.joints[0]);
            EXPECT_NEAR(size_of(breaks[0].reaction.force), number(weight + step_i * pull), 1e-3 * (weight + step_i * pull));
            EXPECT_TRUE(world->is_joint_broken(built.joints[0]).value);
            EXPECT_FALSE(world->is_joint_enabled(built.joints[0]).value);
        }
        EXPECT_LT(world->state(built.bodies[0]).value.v_CM.z, 0);
        EXPECT_EQ(size_of(world->joint_reaction(built.joints[0]).value.force), 0);
        EXPECT_EQ(world->joint_count(), static_cast<int>(built.joints.size() + beside.joints.size()));
    }
}
TEST(Breaking, is_where_and_when_the_load_is_too_much) { expect_to_break_at_the_top<Breaking>(1); }
TEST(Breaking, of_figures_that_swing_freely_is_too) { expect_to_break_at_the_top<BreakingFreely>(2); }

/// A beam that is held at one end bears its moment there: m g l, of a fixed joint about all axes, of a hinge but for its own, by a drive or a limit.
TEST(Breaking, by_torque) {
    for (const bool strong : {false, true}) {
        FigureScene scene;
        scene.add(box(2, {0.5, 0.05, 0.05}, {0.5, 0, 0}, Matrix3d::Identity()));
        scene.join(joint_of(FigureJointKind::fixed, the_world, 0, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}));
        const auto world = std::make_unique<ingot::World<Breaking>>();
        const Built built = add_scene(*world, scene);
        const double moment = 2 * g * 0.5;
        ASSERT_EQ(world->set_joint_strength(built.joints[0], {ingot::unlimited, number(moment * (strong ? 1.01 : 0.99))}), Status::ok);
        (void)ingot::step(*world, number(1.0 / 60));
        EXPECT_EQ(breaks_of(*world).size(), strong ? 0u : 1u);
        EXPECT_NEAR(world->joint_reaction(built.joints[0]).value.torque.y, -moment, 1e-3 * moment);
        EXPECT_NEAR(world->joint_reaction(built.joints[0]).value.force.z, 2 * g, 1e-3);
    }
}
/// A servo, or a limit, bears the moment of a beam about its hinge, and the hinge the rest, along and across.
TEST(Reactions, are_without_what_a_servo_or_a_limit_holds) {
    for (const bool servo : {false, true}) {
        FigureScene scene;
        scene.add(box(2, {0.5, 0.05, 0.05}, {0.5, 0.3, 0}, Matrix3d::Identity()));
        FigureJoint hinge = joint_of(FigureJointKind::hinge, the_world, 0, {0, 0, 0}, {0, 1, 0}, {0, 1, 0});
        if (!servo) hinge.upper = 0;
        scene.join(hinge);
        const auto world = std::make_unique<ingot::World<BreakingInTouch>>();
        const Built built = add_scene(*world, scene);
        const ingot::JointDrive drive = servo ? ingot::JointDrive(ingot::SpringDrive{number(1e5), number(1e3)}) : ingot::JointDrive{};
        ASSERT_EQ(world->set_joint_drive(built.joints[0], drive), Status::ok);
        for (int step_i = 0; step_i < 30; ++step_i) (void)ingot::step(*world, number(1.0 / 60));
        const ingot::JointReaction reaction = world->joint_reaction(built.joints[0]).value;
        EXPECT_LE((to_eigen(reaction.force) - Vector3d(0, 0, 2 * g)).norm(), 1e-3) << servo;
        EXPECT_LE((to_eigen(reaction.torque) - Vector3d(2 * g * 0.3, 0, 0)).norm(), 1e-3) << servo;
    }
}

/// Bodies that a joint kept from meeting meet once it is broken, and part again when it is mended.
TEST(Breaking, lets_bodies_meet) {
    FigureScene scene;
    FigureBody floor = box(1, {5, 5, 1}, {0, 0, -1}, Matrix3d::Identity());
    floor.M = 0;
    scene.add(floor);
    scene.add(box(2, {0.2, 0.2, 0.2}, {0, 0, 0.2}, Matrix3d::Identity()));
    scene.add(box(2, {0.2, 0.2, 0.2}, {0, 0, 0.6}, Matrix3d::Identity()));
    scene.join(joint_of(FigureJointKind::slider, 1, 2, {0, 0, 0.4}, {0, 0, 1}, {1, 0, 0}));
    const auto world = std::make_unique<ingot::World<BreakingInTouch>>();
    const Built built = add_scene(*world, scene);
    ASSERT_EQ(world->set_joint_drive(built.joints[0], ingot::SpringDrive{1000, 100}), Status::ok);
    const auto contacts_of_top = [&] {
        int count = 0;
        for (const ingot::ContactInfo& contact : world->contacts_of(built.bodies[2])) count += contact.j >= 0 ? 1 : 0;
        return count;
    };
    for (int step_i = 0; step_i < 200 && !world->is_asleep(built.bodies[2]); ++step_i) (void)ingot::step(*world, number(1.0 / 60));
    ASSERT_TRUE(world->is_asleep(built.bodies[1]) && world->is_asleep(built.bodies[2]));
    EXPECT_EQ(contacts_of_top(), 0);

    // Asleep it tells what it bore last, and a weaker one wakes to break.
    const ingot::JointReaction asleep = world->joint_reaction(built.joints[0]).value;
    (void)ingot::step(*world, number(1.0 / 60));
    const ingot::JointReaction later = world->joint_reaction(built.joints[0]).value;
    EXPECT_EQ(std::memcmp(&asleep, &later, sizeof later), 0);
    ASSERT_EQ(world->set_joint_strength(built.joints[0], {}), Status::ok);
    EXPECT_FALSE(world->is_asleep(built.bodies[1]));
    ASSERT_EQ(world->apply_central_impulse(built.bodies[2], {1, 0, 0}), Status::ok);
    ASSERT_EQ(world->set_joint_strength(built.joints[0], {1, ingot::unlimited}), Status::ok);
    (void)ingot::step(*world, number(1.0 / 60));
    ASSERT_EQ(breaks_of(*world).size(), 1u);
    EXPECT_NE(world->drive_torque(built.joints[0]).value, 0);
    for (int step_i = 0; step_i < 5; ++step_i) (void)ingot::step(*world, number(1.0 / 60));
    EXPECT_EQ(contacts_of_top(), 1);
    EXPECT_EQ(world->drive_torque(built.joints[0]).value, 0);
    EXPECT_TRUE(breaks_of(*world).empty());

    ASSERT_EQ(world->set_joint_strength(built.joints[0], {}), Status::ok);
    ASSERT_EQ(world->set_joint_enabled(built.joints[0], true), Status::ok);
    EXPECT_FALSE(world->is_joint_broken(built.joints[0]).value);
    for (int step_i = 0; step_i < 60; ++step_i) (void)ingot::step(*world, number(1.0 / 60));
    EXPECT_EQ(contacts_of_top(), 0);
    EXPECT_LE(static_cast<double>(world->joint_gap(built.joints[0]).value), held);
}

/// A joint that is switched off and on goes on where it was, to the bit, if its bodies have not moved meanwhile: the angles that it had are kept.
TEST(Breaking, is_mended_with_the_angles_it_had) {
    const auto world = std::make_unique<ingot::World<BreakingInTouch>>();
    FigureScene scene = pendulum_with_stop(pi / 3, -infinity, 0);
    const Built built = add_scene(*world, scene);
    for (int step_i = 0; step_i < 20; ++step_i) (void)ingot::step(*world, number(1.0 / 60));
    const ingot::scalar angle = world->joint_angle(built.joints[0]).value, rate = world->joint_rate(built.joints[0]).value;
    ASSERT_EQ(world->set_joint_enabled(built.joints[0], false), Status::ok);
    EXPECT_EQ(world->joint_angle(built.joints[0]).value, angle);
    EXPECT_EQ(world->joint_rate(built.joints[0]).value, rate);
    EXPECT_FALSE(world->is_joint_broken(built.joints[0]).value);
    EXPECT_TRUE(world->is_alive(built.joints[0]));
    ASSERT_EQ(world->set_joint_enabled(built.joints[0], true), Status::ok);
    EXPECT_EQ(world->joint_angle(built.joints[0]).value, angle);
    (void)ingot::step(*world, number(1.0 / 60));
    EXPECT_LE(static_cast<double>(world->joint_gap(built.joints[0]).value), held);
    // What leaves takes a joint along that does nothing.
    ASSERT_EQ(world->set_joint_enabled(built.joints[0], false), Status::ok);
    ASSERT_EQ(world->remove(built.bodies[0]), Status::ok);
    EXPECT_FALSE(world->is_alive(built.joints[0]));
    EXPECT_EQ(world->joint_count(), 0);
}

/// What has fallen apart is mended once it is put where it fits, and not before; a small gap is closed in a step, and throws nothing about.
TEST(Breaking, is_mended_where_it_fits) {
    RandomInput random(4);
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i) {
        constexpr FigureJointKind kinds_of_joint[] = {FigureJointKind::ball, FigureJointKind::hinge, FigureJointKind::slider,
                                                      FigureJointKind::universal, FigureJointKind::fixed};
        FigureScene scene;
        const Matrix3d A = random.rotation();
        for (int i = 0; i < 3; ++i) scene.add(box(random.real(1, 5), {0.1, 0.15, 0.25}, {0, 0, -0.5 * i}, A));
        const Vector3d axis = random.direction();
        const FigureJointKind kind = kinds_of_joint[run_i % 5];
        scene.join(joint_of(kind, 0, 1, {0, 0, -0.25}, axis, kind == FigureJointKind::universal ? square_to(axis) : axis));
        scene.join(ball(1, 2, {0, 0, -0.75}));
        const auto world = std::make_unique<ingot::World<Breaking>>();
        const Built built = add_scene(*world, scene);
        ASSERT_TRUE(built.sound && world->set_gravity({}) == Status::ok);
        ASSERT_EQ(world->set_joint_enabled(built.joints[0], false), Status::ok);
        const ingot::BodyState fits = world->state(built.bodies[0]).value;
        ingot::BodyState off = fits;
        off.r_CM = off.r_CM + to_vector(square_to(axis) * 0.1);
        ASSERT_EQ(world->set_state(built.bodies[0], off), Status::ok);
        EXPECT_EQ(world->set_joint_enabled(built.joints[0], true), Status::bad_joint) << run_i;
        off = fits;
        off.A = ingot_reference::to_matrix(Matrix3d(-A));
        off.A.c0 = off.A.c0 * scalar(-1);  // turned by half a turn about c0
        if (kind == FigureJointKind::fixed || kind == FigureJointKind::slider) {
            ASSERT_EQ(world->set_state(built.bodies[0], off), Status::ok);
            EXPECT_EQ(world->set_joint_enabled(built.joints[0], true), Status::bad_joint) << run_i;
            off = fits;  // turned by half a turn about its axis, on it
            const Vector3d n = kind == FigureJointKind::fixed ? Vector3d(0, 0, 1) : axis, P(0, 0, -0.25);
            const Matrix3d half = 2 * n * n.transpose() - Matrix3d::Identity();
            off.A = ingot_reference::to_matrix(Matrix3d(half * A));
            off.r_CM = to_vector(Vector3d(P + half * (to_eigen(fits.r_CM) - P)));
            ASSERT_EQ(world->set_state(built.bodies[0], off), Status::ok);
            EXPECT_EQ(world->set_joint_enabled(built.joints[0], true), Status::bad_joint) << run_i;
        }
        off = fits;
        off.r_CM = off.r_CM + to_vector(square_to(axis) * 0.03);
        ASSERT_EQ(world->set_state(built.bodies[0], off), Status::ok);
        ASSERT_EQ(world->set_joint_enabled(built.joints[0], true), Status::ok) << run_i;
        (void)ingot::step(*world, number(1.0 / 60));
        EXPECT_LE(worst_gap(*world, built), held) << run_i;
        EXPECT_LE(static_cast<double>(world->kinetic_energy()), 1) << run_i;  // of 15 kg that were moved by 0.03 m
    }
}

/// Figures on a floor whose joints break here and there; some are mended, some switched off, some taken out and some new. From any of their states
/// they go on the same, from a copy and from a snapshot.
struct Rubble {
    std::unique_ptr<ingot::World<BreakingInTouch>> world = std::make_unique<ingot::World<BreakingInTouch>>();
    Built built;

    explicit Rubble(uint64_t seed) {
        RandomInput random(seed);
        FigureScene scene = turning_tree(random, 10, false, 3, 4, [](FigureJoint&) {});
        FigureBody floor = box(1, {10, 10, 1}, {0, 0, -2.5}, Matrix3d::Identity());
        floor.M = 0;
        scene.add(floor);
        built = add_scene(*world, scene);
        for (const ingot::JointId id : built.joints)
            built.sound = built.sound && world->set_joint_strength(id, {number(random.real(50, 2000)), number(random.real(20, 500))}) == Status::ok;
    }
    /// The same for each number of a step.
    static void edit(ingot::World<BreakingInTouch>& of, int step_i) {
        RandomInput random(static_cast<uint64_t>(step_i) + 77);
        const int joint_i = random.integer(0, 11);
        const ingot::JointId id = of.joint_at(joint_i);
        if (id == ingot::JointId{} || step_i % 3 != 0) return;
        if (random.integer(0, 2) == 0) (void)of.set_joint_enabled(id, random.integer(0, 1) == 1);
        if (random.integer(0, 5) == 0) {
            ingot::JointDef joint;
            joint.joint = ingot::BallJoint{};
            joint.body_A = of.body_at(random.integer(0, 4));
            joint.body_B = of.body_at(random.integer(0, 4));
            joint.P = of.state(joint.body_A).value.r_CM;
            if (of.remove(id) == Status::ok) (void)of.add_joint(joint);
        }
    }
    static uint64_t step(ingot::World<BreakingInTouch>& of, int step_i) {
        edit(of, step_i);
        (void)ingot::step(of, number(1.0 / 60));
        uint64_t hash = of.state_hash();
        for (const ingot::JointBreak& broken : of.broken_joints()) {
            hash = hash * 0x100000001b3u + static_cast<uint64_t>(broken.joint.slot) + broken.joint.generation;
            const scalar numbers[] = {broken.reaction.force.x, broken.reaction.force.y, broken.reaction.torque.z};
            uint64_t bits = 0;
            for (const scalar& x : numbers) {
                std::memcpy(&bits, &x, sizeof x);
                hash = hash * 0x100000001b3u + bits;
            }
        }
        return hash;
    }
};
TEST(Breaking, is_the_same_from_any_copy_and_snapshot) {
    int broken = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(12); ++run_i) {
        constexpr int steps = 90;
        Rubble rubble(static_cast<uint64_t>(run_i) + 1);
        ASSERT_TRUE(rubble.built.sound);
        const int kept_at = 15 + run_i * 5;
        const auto copy = std::make_unique<ingot::World<BreakingInTouch>>(), loaded = std::make_unique<ingot::World<BreakingInTouch>>();
        std::vector<uint8_t> bytes(ingot::snapshot_size<BreakingInTouch>());
        std::vector<uint64_t> hashes;
        for (int step_i = 0; step_i < steps; ++step_i) {
            if (step_i == kept_at) {
                std::memcpy(static_cast<void*>(copy.get()), rubble.world.get(), sizeof *copy);
                const auto size = ingot::save_snapshot(*rubble.world, bytes.data(), bytes.size());
                ASSERT_TRUE(size.ok());
                ASSERT_EQ(ingot::load_snapshot(*loaded, bytes.data(), size.value), Status::ok);
                EXPECT_EQ(breaks_of(*loaded).size(), breaks_of(*rubble.world).size());
                for (const ingot::JointId id : rubble.built.joints) {
                    EXPECT_EQ(loaded->is_joint_broken(id).value, rubble.world->is_joint_broken(id).value);
                    const auto a = loaded->joint_reaction(id), b = rubble.world->joint_reaction(id);
                    EXPECT_EQ(a.status, b.status);
                    EXPECT_EQ(std::memcmp(&a.value, &b.value, sizeof b.value), 0);
                }
            }
            hashes.push_back(Rubble::step(*rubble.world, step_i));
            broken += static_cast<int>(breaks_of(*rubble.world).size());
        }
        for (int step_i = kept_at; step_i < steps; ++step_i) {
            ASSERT_EQ(Rubble::step(*copy, step_i), hashes[static_cast<std::size_t>(step_i)]) << run_i << ", copy, step " << step_i;
            ASSERT_EQ(Rubble::step(*loaded, step_i), hashes[static_cast<std::size_t>(step_i)]) << run_i << ", snapshot, step " << step_i;
        }
    }
    EXPECT_GT(broken, ingot_reference::draws(12));
    std::printf("    %d joints broke\n", broken);
}

/// A snapshot whose bytes were changed is refused, or it is of a world that there can be: what it says of joints then stays as it is.
TEST(Breaking, in_damaged_snapshots_is_refused_or_sound) {
    Rubble rubble(5);
    for (int step_i = 0; step_i < 40; ++step_i) (void)Rubble::step(*rubble.world, step_i);
    std::vector<uint8_t> sound(ingot::snapshot_size<BreakingInTouch>());
    const auto size = ingot::save_snapshot(*rubble.world, sound.data(), sound.size());
    ASSERT_TRUE(size.ok());
    sound.resize(size.value);
    const auto loaded = std::make_unique<ingot::World<BreakingInTouch>>();
    RandomInput random(12);
    int taken = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(4000); ++run_i) {
        std::vector<uint8_t> bytes = sound;
        const std::size_t begin = bytes.size() * 2 / 3;  // joints stand in the last third
        const int at = random.integer(static_cast<int>(begin), static_cast<int>(bytes.size()) - 9);
        bytes[static_cast<std::size_t>(at)] = static_cast<uint8_t>(random.bits());
        const uint64_t checksum = ingot::snapshot_checksum(bytes.data(), bytes.size() - sizeof(uint64_t));
        for (unsigned i = 0; i < 8; ++i) bytes[bytes.size() - 8 + i] = static_cast<uint8_t>(checksum >> (8 * i));
        if (ingot::load_snapshot(*loaded, bytes.data(), bytes.size()) != Status::ok) continue;
        ++taken;
        std::vector<uint8_t> again(sound.size());
        ASSERT_TRUE(ingot::save_snapshot(*loaded, again.data(), again.size()).ok());
        ASSERT_EQ(again, bytes) << run_i;
        for (int step_i = 0; step_i < 2; ++step_i) (void)Rubble::step(*loaded, step_i);
    }
    EXPECT_GT(taken, 100);
}

/// What is refused changes no bit.
TEST(Breaking, bad_calls_are_refused) {
    FigureScene scene = hanging_chain(*std::make_unique<RandomInput>(3), 3, 5);
    const auto world = std::make_unique<ingot::World<BreakingInTouch>>();
    const Built built = add_scene(*world, scene);
    for (int step_i = 0; step_i < 3; ++step_i) (void)ingot::step(*world, number(1.0 / 60));
    const ingot::JointId id = built.joints[0];
    ingot::JointId stale = id, foreign = id, beyond = id;
    stale.generation += 2;
    foreign.world_tag = 9;
    beyond.slot = 60;
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN(), endless = std::numeric_limits<scalar>::infinity();
    std::vector<unsigned char> before(sizeof *world);
    std::memcpy(before.data(), world.get(), sizeof *world);
    EXPECT_EQ(world->set_joint_strength(id, {nan, 1}), Status::not_finite);
    EXPECT_EQ(world->set_joint_strength(id, {1, nan}), Status::not_finite);
    EXPECT_EQ(world->set_joint_strength(id, {endless, 1}), Status::not_finite);
    EXPECT_EQ(world->set_joint_strength(id, {-1, 1}), Status::out_of_range);
    EXPECT_EQ(world->set_joint_strength(id, {1, number(-1e-6)}), Status::out_of_range);
    for (const auto& [bad, status] : {std::pair{stale, Status::stale_id}, {ingot::JointId{}, Status::stale_id}, {beyond, Status::stale_id},
                                      {foreign, Status::foreign_id}}) {
        EXPECT_EQ(world->set_joint_strength(bad, {}), status);
        EXPECT_EQ(world->joint_strength(bad).status, status);
        EXPECT_EQ(world->joint_reaction(bad).status, status);
        EXPECT_EQ(world->set_joint_enabled(bad, false), status);
        EXPECT_EQ(world->is_joint_enabled(bad).status, status);
        EXPECT_EQ(world->is_joint_broken(bad).status, status);
        EXPECT_EQ(world->figure(bad).status, status);
    }
    ingot::BodyId stale_body = built.bodies[0];
    stale_body.generation += 2;
    EXPECT_EQ(world->figure(stale_body).status, Status::stale_id);
    EXPECT_EQ(world->set_joint_enabled(id, true), Status::ok);  // it is
    EXPECT_EQ(std::memcmp(before.data(), world.get(), sizeof *world), 0);

    ASSERT_EQ(world->set_joint_enabled(id, false), Status::ok);
    EXPECT_EQ(world->figure(id).status, Status::not_in_scene);
    EXPECT_EQ(world->set_joint_enabled(id, false), Status::ok);
    EXPECT_TRUE(world->figure(built.bodies[0]).ok());
    ingot::BodyDef post;
    post.immovable = true;
    post.shape = ingot::Box{{1, 1, 1}};
    post.state.r_CM = {50, 0, 0};
    EXPECT_EQ(world->figure(world->add(post).value).status, Status::immovable);
}

/// A loop that was broken is closed again where there is room for it, and nowhere else.
TEST(Breaking, of_loops_is_mended_where_there_is_room) {
    const auto world = std::make_unique<ingot::World<BreakingLoops>>();
    FigureScene scene;
    for (int i = 0; i < 4; ++i) scene.add(box(1, {0.3, 0.1, 0.1}, {static_cast<double>(i), 0, 0}, Matrix3d::Identity()));
    for (int i = 0; i < 3; ++i) scene.join(ball(i, i + 1, {i + 0.5, 0, 0}));
    scene.join(ball(0, 3, {1.5, 0, 0}));
    scene.join(ball(0, 2, {1, 0, 0}));
    const Built built = add_scene(*world, scene);
    ASSERT_TRUE(built.sound);
    ASSERT_EQ(world->set_joint_enabled(built.joints[3], false), Status::ok);
    ingot::JointDef one_more;
    one_more.body_A = built.bodies[1];
    one_more.body_B = built.bodies[3];
    one_more.joint = ingot::BallJoint{};
    one_more.P = {2, 0, 0};
    const auto id = world->add_joint(one_more);
    ASSERT_TRUE(id.ok());
    EXPECT_EQ(world->set_joint_enabled(built.joints[3], true), Status::no_room);
    EXPECT_FALSE(world->is_joint_enabled(built.joints[3]).value);
    ASSERT_EQ(world->remove(id.value), Status::ok);
    EXPECT_EQ(world->set_joint_enabled(built.joints[3], true), Status::ok);
    for (int step_i = 0; step_i < 30; ++step_i) ASSERT_TRUE(ingot::step(*world, number(1.0 / 60)).clean());
}

}  // namespace

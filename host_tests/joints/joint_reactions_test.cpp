// SPDX-License-Identifier: MIT
// What joints bear: alone, in loops and in contact, apart from what drives and limits give.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "joint_balance.h"
#include "joints/figure_scenes.h"
#include "random_trees.h"
#include "reference/draws.h"

namespace {

using namespace figures;
using namespace ingot_figures;
using ingot::Status;
using ingot_reference::to_eigen;

struct Bearing : ingot::Scene {
    static constexpr int max_bodies = 24, max_joints = 26;
    static constexpr bool translates = true;
    using joints = AllJointsWith<ingot::WithReactions>;
};
struct BearingFreely : Bearing {
    using figure_motion = ingot::EnergyMomentum<>;
};
struct BearingFreelyByFour : Bearing {
    using figure_motion = ingot::EnergyMomentum<ingot::Snap::keep, 4>;
};
struct BearingLoops : Bearing {
    static constexpr int max_loops = 6;
};
struct Working : Bearing {
    using joints = AllJointsWith<ingot::WithReactions, ingot::WithLimits, ingot::WithDrives>;
};
struct Touching : Bearing {
    static constexpr int max_manifolds = 200, max_pairs = 800;
    static constexpr bool reads_contacts = true, filters = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box>;
};
struct OnPlatforms : Touching {
    static constexpr bool kinematic_bodies = true;
};
struct TouchingInLoops : Touching {
    static constexpr int max_loops = 6;
};
struct WorkingInTouch : Touching {
    using joints = Working::joints;
};

/// rad, of the body that turns furthest.
double furthest_turn(const std::vector<BodyNow>& before, const std::vector<BodyNow>& after) {
    double most = 0;
    for (std::size_t i = 0; i < before.size(); ++i) most = std::max(most, (after[i].A - before[i].A).norm());
    return most;
}

/// N s, that each body got from contacts.
template <class World>
std::vector<Vector3d> contacts_of(const World& world, const Built& built) {
    std::vector<Vector3d> sums(built.bodies.size(), Vector3d::Zero());
    for (const ingot::ContactInfo& contact : world.contacts())
        for (std::size_t i = 0; i < built.bodies.size(); ++i) {
            const Vector3d on_A = to_eigen(contact.n) * static_cast<double>(contact.j) + to_eigen(contact.j_friction);
            if (built.bodies[i] == contact.A) sums[i] += on_A;
            if (built.bodies[i] == contact.B) sums[i] -= on_A;
        }
    return sums;
}

/// Steps of a scene, all of which must balance: set_up(world, built) is done first. See JointBalance.
template <class Scene, class SetUp>
Balance worst_balance(const FigureScene& scene, double rate, bool has_free_loads, const SetUp& set_up) {
    const auto world = std::make_unique<ingot::World<Scene>>();
    const Built built = add_scene(*world, scene);
    EXPECT_TRUE(built.sound);
    set_up(*world, built);
    JointBalance balance(scene, built, Scene::figure_motion::is_implicit);
    balance.has_free_loads = has_free_loads;
    // A row is let go that gives way by less than this share: of one that gives way by no more, so many digits are left.
    if (ingot::has_loops<Scene>) balance.share_of_loops = eps / static_cast<double>(ingot::limits::loop_compliance);
    Balance worst;
    std::vector<BodyNow> before = bodies_now(*world, built.bodies);
    for (int step_i = 0; step_i < 30; ++step_i) {
        const ingot::StepReport report = ingot::step(*world, static_cast<scalar>(1 / rate));
        EXPECT_TRUE(report.clean() || Scene::max_manifolds > 0);
        if (report.bodies_frozen > 0) break;
        const std::vector<BodyNow> after = bodies_now(*world, built.bodies);
        if constexpr (Scene::max_manifolds > 0) balance.contacts = world->contact_count() > 0 ? contacts_of(*world, built) : std::vector<Vector3d>{};
        // The energy-momentum step takes out of velocities what joints do not allow: as it begins, and where a step is long for the turns.
        // Loops that could not be closed have lost velocity.
        const bool is_whole = ingot::has_loops<Scene>             ? worst_gap(*world, built) < 2 * static_cast<double>(ingot::limits::loop_gap)
                              : Scene::figure_motion::is_implicit ? step_i > 0 && furthest_turn(before, after) < 0.05
                                                                  : true;
        if (is_whole) worst.add(balance.of_step(*world, before, after, 1 / rate));
        before = after;
    }
    return worst;
}
void expect_balance(const Balance& worst) {
    EXPECT_LE(worst.force, 1);
    EXPECT_LE(worst.torque, 1);
    EXPECT_LE(worst.along, 1);
    std::printf("    force %.3f, torque %.3f, along %.3f of what may be\n", worst.force, worst.torque, worst.along);
}

FigureScene tree_of(RandomInput& random, int run_i, int most_bodies) {
    return random_tree(random, {random.integer(2, most_bodies), run_i % 2 == 0 ? 1.001 : 100, random.real(0.1, 4), run_i % 4 < 2});
}
template <class Scene>
void expect_balance_of_trees(uint64_t seed) {
    RandomInput random(seed);
    Balance worst;
    for (int run_i = 0; run_i < ingot_reference::draws(60); ++run_i)
        worst.add(worst_balance<Scene>(tree_of(random, run_i, 12), rates[random.integer(0, 4)], false, [](auto&, const Built&) {}));
    expect_balance(worst);
}

TEST(Reactions, are_what_momenta_change_by) { expect_balance_of_trees<Bearing>(1); }
TEST(Reactions, of_the_energy_momentum_step_are_too) {
    expect_balance_of_trees<BearingFreely>(2);
    expect_balance_of_trees<BearingFreelyByFour>(3);
}

/// A tree with more joints than it needs, where they are: what bodies get from all of theirs is determined, whatever their shares.
TEST(Reactions, of_loops_are_too) {
    RandomInput random(4);
    Balance worst;
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i) {
        FigureScene scene = tree_of(random, run_i, 10);
        for (int loop_i = random.integer(1, 3); loop_i > 0; --loop_i) {
            FigureJoint joint = scene.joint(random.integer(0, scene.joint_count() - 1));
            joint.body_B = random.integer(0, scene.body_count() - 1);
            joint.body_A = random.integer(0, 1) == 0 ? the_world : (joint.body_B + 1) % scene.body_count();
            joint.anchor = scene.body(joint.body_B).r_CM + random.direction() * 0.3;
            scene.join(joint);
        }
        worst.add(worst_balance<BearingLoops>(scene, rates[random.integer(0, 4)], false, [](auto&, const Built&) {}));
    }
    worst.torque = 0;  // shares that turn round from substep to substep are large beside their sum: with which arms they acted is not known
    expect_balance(worst);
}

/// A ring of links that hangs by one of them, or falls.
FigureScene ring_of(RandomInput& random, int links, bool tied) {
    FigureScene scene;
    const Matrix3d R = random.rotation();
    const auto corner = [&](int i) -> Vector3d {
        const double angle = 2 * pi * i / links;
        return R * Vector3d(std::cos(angle), std::sin(angle), 0.1 * (i % links % 3));
    };
    for (int i = 0; i < links; ++i) {
        const Vector3d side = corner(i + 1) - corner(i);
        FigureBody link = capsule(random.real(1, 10), 0.05, side.norm() / 2, corner(i) + side / 2, along(side));
        link.v_CM = random.vector(0.3);
        scene.add(link);
    }
    for (int i = 0; i < links; ++i) scene.join(ball(i, (i + 1) % links, corner(i + 1)));
    if (tied) scene.join(ball(the_world, 0, corner(0)));
    return scene;
}
/// Loops that are determined: each joint by itself.
TEST(Reactions, of_a_ring_are_exact) {
    RandomInput random(9);
    Balance worst;
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i)
        worst.add(worst_balance<BearingLoops>(ring_of(random, random.integer(3, 12), run_i % 2 == 0), rates[random.integer(0, 4)], false,
                                              [](auto&, const Built&) {}));
    expect_balance(worst);
    EXPECT_LE(worst.force, 1e-2);
}

/// What hangs on a body that goes and turns as it is told, and on one that cannot move.
TEST(Reactions, of_what_hangs_on_platforms_are_too) {
    RandomInput random(10);
    Balance worst;
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i) {
        FigureScene scene = random_tree(random, {random.integer(2, 8), 10, random.real(0.1, 2), true});
        FigureBody platform = box(1, {0.1, 0.1, 0.1}, {0, 0, 0}, random.rotation());
        platform.M = 0;
        const int platform_i = scene.add(platform);
        scene.joint(0).body_A = platform_i;
        worst.add(worst_balance<OnPlatforms>(scene, rates[random.integer(0, 4)], false, [&](auto& world, const Built& built) {
            for (const ingot::BodyId id : built.bodies) EXPECT_EQ(world.set_filter(id, {2, 0xfffd}), Status::ok);
            if (run_i % 2 == 0) return;
            const ingot::BodyId id = built.bodies[static_cast<std::size_t>(platform_i)];
            EXPECT_EQ(world.set_kinematic(id), Status::ok);
            EXPECT_EQ(world.set_velocity(id, to_vector(random.vector(1)), to_vector(random.vector(2))), Status::ok);
        }));
    }
    expect_balance(worst);
}

/// Trees that are driven, within their torque and beyond, and whose turns may end.
FigureScene working_tree(RandomInput& random, bool with_limits) {
    return turning_tree(random, 8, random.integer(0, 1) == 1, 4, 4, [&](FigureJoint& joint) {
        if (!with_limits) return;
        if (joint.kind == FigureJointKind::ball) joint.cone = random.real(0.1, 1);
        joint.lower = -random.real(0.01, 0.3);
        joint.upper = random.real(0.01, 0.3);
        joint.restitution = random.integer(0, 1) == 0 ? 0 : 0.5;
    });
}
template <class World>
void drive_some(World& world, const Built& built, RandomInput& random) {
    for (const ingot::JointId id : built.joints) {
        const auto torque = static_cast<scalar>(random.integer(0, 1) == 0 ? 1e6 : random.real(1, 100));
        const ingot::JointDrive drive = ingot::SpringDrive{static_cast<scalar>(random.real(10, 1e4)), 10, static_cast<scalar>(0.5), 0, 0, torque};
        if (random.integer(0, 2) == 0) continue;
        const bool driven = world.set_joint_drive(id, drive) == Status::ok || world.set_ball_drive(id, drive, {0, scalar(0.5), 0}) == Status::ok;
        EXPECT_TRUE(driven);
    }
}
TEST(Reactions, are_apart_from_drives_and_limits) {
    RandomInput random(5);
    Balance worst;
    for (int run_i = 0; run_i < ingot_reference::draws(80); ++run_i) {
        const bool with_limits = run_i % 2 == 0;
        const FigureScene scene = working_tree(random, with_limits);
        worst.add(worst_balance<Working>(scene, rates[random.integer(0, 4)], true,
                                         [&](auto& world, const Built& built) { drive_some(world, built, random); }));
    }
    expect_balance(worst);
}

/// Figures fall on a floor, whose contacts are told by themselves. They do not meet themselves: what is nearly one body may press itself as it likes.
void add_floor(FigureScene& scene) {
    FigureBody floor = box(1, {20, 20, 1}, {0, 0, -2.2}, Matrix3d::Identity());
    floor.M = 0;
    scene.add(floor);
    for (FigureBody& body : scene.bodies) body.friction = 0.5;
    scene.g = {0, 0, -9.81};
}
template <class World>
void let_meet_the_floor_alone(World& world, const Built& built) {
    for (std::size_t i = 0; i + 1 < built.bodies.size(); ++i) EXPECT_EQ(world.set_filter(built.bodies[i], {2, 0xfffd}), Status::ok);
}
TEST(Reactions, in_contact_are_what_contacts_leave) {
    RandomInput random(6);
    Balance worst;
    for (int run_i = 0; run_i < ingot_reference::draws(40); ++run_i) {
        const double rate = rates[random.integer(0, 2)];
        FigureScene scene = tree_of(random, run_i, 8), ring = ring_of(random, random.integer(3, 12), false), working = working_tree(random, true);
        add_floor(scene);
        add_floor(ring);
        add_floor(working);
        const auto set_up = [](auto& world, const Built& built) { let_meet_the_floor_alone(world, built); };
        worst.add(worst_balance<Touching>(scene, rate, false, set_up));
        worst.add(worst_balance<TouchingInLoops>(ring, rate, false, set_up));
        worst.add(worst_balance<WorkingInTouch>(working, rate, true, [&](auto& world, const Built& built) {
            let_meet_the_floor_alone(world, built);
            drive_some(world, built, random);
        }));
    }
    expect_balance(worst);
}

}  // namespace

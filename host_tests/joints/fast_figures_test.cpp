// SPDX-License-Identifier: MIT
// Figures with `continuous`: none of their bodies gets through a thin wall, at any speed; joints hold through the impact, and nothing gains energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "joints/figure_measures.h"
#include "joints/figure_scenes.h"
#include "level/ground.h"
#include "random_trees.h"
#include "reference/draws.h"
#include "reference/powers_of_two.h"
#include "scene_in_world.h"

namespace {

using namespace figures;
using namespace ingot_figures;
using ingot_reference::to_eigen;

/// All that joints may have.
struct Shot : ingot::Scene {
    static constexpr int max_bodies = 40, max_joints = 40, max_manifolds = 300, max_pairs = 600, max_loops = 24;
    static constexpr bool translates = true, continuous = true, sleeps = true;
    using joints = AllJointsWith<ingot::RodJoint, ingot::RopeJoint, ingot::TargetJoint, ingot::WithLimits, ingot::WithDrives>;
    using shapes = ingot::Shapes<ingot::Box, ingot::Capsule, ingot::Sphere>;
    using broad_phase = ingot::SortedTree;
};
#if !INGOT_TEST_BRIEF
struct PlainShot : ingot::Scene {
    static constexpr int max_bodies = 40, max_joints = 40, max_manifolds = 300, max_pairs = 600;
    static constexpr bool translates = true, continuous = true;
    using joints = AllJoints;
    using shapes = ingot::Shapes<ingot::Box, ingot::Capsule, ingot::Sphere>;
};
struct LoopedShot : PlainShot {
    static constexpr int max_loops = 4;
};
struct LimitedShot : PlainShot {
    static constexpr bool sleeps = true;
    using joints = AllJointsWith<ingot::WithLimits, ingot::WithBreaking>;
};
struct DrivenShot : PlainShot {
    using joints = AllJointsWith<ingot::WithLimits, ingot::WithDrives>;
};
struct DrivenLoopedShot : DrivenShot {
    static constexpr int max_loops = 4;
};
struct TiedShot : PlainShot {
    static constexpr int max_loops = 24;
    using joints = AllJointsWith<ingot::RodJoint, ingot::RopeJoint, ingot::TargetJoint>;
};
struct SwingingShot : PlainShot {
    using figure_motion = ingot::EnergyMomentum<>;
    using broad_phase = ingot::SortedTree;
};
/// Its room is of triangles.
struct ShotAtTriangles : Shot {
    using shapes = ingot::Shapes<ingot::Box, ingot::Capsule, ingot::Sphere, ingot::Level>;
    static inline ingot::LevelTable levels[1] = {};
};
using Scenes = testing::Types<Shot, PlainShot, LoopedShot, LimitedShot, DrivenShot, DrivenLoopedShot, TiedShot, SwingingShot, ShotAtTriangles>;
#else
using Scenes = testing::Types<Shot>;
#endif
template <class Scene>
class FastFigures : public testing::Test {};
TYPED_TEST_SUITE(FastFigures, Scenes);

constexpr double open_joint = 5e-5;  ///< m: joints in contact are held to this

constexpr double half_room = 4, half_wall = 0.005;  ///< m

/// Six walls about x, a centimetre thick, or sheets of triangles; behind them there is nothing.
template <class World>
bool add_room(World& world, double x) {
    if constexpr (World::scene::shapes::has(ingot::ShapeKind::level)) {
        static level_test::Random random(77);
        static const level_test::Ground room = level_test::room_of(random, {8, 8, 8});
        World::scene::levels[0] = room.view;
        ingot::LevelDef level;
        level.r = {static_cast<scalar>(x - half_room), static_cast<scalar>(-half_room), static_cast<scalar>(-half_room)};
        level.friction = scalar(0.4);
        return world.add_level(level).ok();
    }
    const double unit = static_cast<double>(World::scene::length_unit);
    bool sound = true;
    for (int side = 0; side < 6; ++side) {
        ingot::BodyDef wall;
        Vector3d r(0, 0, 0), half(half_room, half_room, half_room);
        r[side / 2] += (side % 2 == 0 ? 1 : -1) * (half_room + half_wall);
        half[side / 2] = half_wall;
        wall.immovable = true;
        wall.state.r_CM = ingot_reference::to_vector(Vector3d(r * unit + Vector3d(x, 0, 0)));
        wall.shape = ingot::Box{ingot_reference::to_vector(Vector3d(half * unit))};
        wall.friction = scalar(0.4);
        sound = world.add(wall).ok() && sound;
    }
    return sound;
}

/// A figure that is thrown about in a room, and what flies there beside it.
struct Throw {
    FigureScene scene;
    std::vector<ingot::BodyDef> bullets;
    double rate, torque;
    bool is_drawn;  ///< to where it begins, by a target; else it may have ties
    uint64_t seed;
};

/// A tree of small boxes and capsules, limited or closed to a ring where the scene knows of that.
template <class Scene>
FigureScene drawn_figure(RandomInput& random) {
    FigureScene scene;
    const bool closes = Scene::max_loops > 0 && random.integer(0, 1) == 1;
    if constexpr (Scene::joints::has_limits)
        scene = closes ? limited_ring(random, 8, false, 6) : limited_tree(random, 8, false, 6);
    else
        scene = turning_tree(random, 8, false, 6, 2, [](FigureJoint&) {});
    if (!Scene::joints::has_limits && closes) close_ring(random, scene);
    for (FigureBody& body : scene.bodies) {
        body.half_extent *= 0.25;
        if (random.integer(0, 1) == 1) {
            body.shape = FigureShape::capsule;
            body.half_extent.y() = body.half_extent.x();
        }
        body.friction = random.real(0, 1);
        body.restitution = random.integer(0, 2) * 0.3;
    }
    scene.g = Vector3d(0, 0, -g);
    return scene;
}
/// It begins inside of the room.
template <class Scene>
Throw drawn_throw(RandomInput& random, double fastest) {
    Throw drawn;
    bool fits = false;
    while (!fits) {
        drawn.scene = drawn_figure<Scene>(random);
        fits = true;
        for (const FigureBody& body : drawn.scene.bodies) fits = fits && body.r_CM.cwiseAbs().maxCoeff() + body.half_extent.norm() < half_room;
    }
    const double speed = fastest * random.real(0.1, 1);
    add_motion(drawn.scene, random.direction() * speed, random.direction() * random.real(0, 0.05 * fastest));
    for (int i = random.integer(0, 3); i > 0; --i) {
        ingot::BodyDef ball;
        ball.mass = ingot::principal(ingot::solid_sphere(scalar(2000), scalar(0.04))).value;
        ball.shape = ingot::Sphere{scalar(0.04)};
        ball.state.r_CM = ingot_reference::to_vector(Vector3d(random.direction() * 3.5));
        ball.state.v_CM = ingot_reference::to_vector(Vector3d(random.direction() * speed));
        ball.restitution = scalar(0.5);
        drawn.bullets.push_back(ball);
    }
    drawn.rate = rates[random.integer(0, 3)];
    drawn.torque = random.real(0.5, 100);
    drawn.is_drawn = random.integer(0, 3) == 0;
    drawn.seed = static_cast<uint64_t>(random.integer(0, 1 << 30));
    return drawn;
}

template <class World>
void tie_to_others(World& world, const Throw& drawn, Built& built) {
    RandomInput random(drawn.seed);
    const auto any = [&] { return built.bodies[static_cast<size_t>(random.integer(0, static_cast<int>(built.bodies.size()) - 1))]; };
    ingot::JointDef tie;
    tie.body_B = any();
    tie.P = world.state(tie.body_B).value.r_CM;
    if (drawn.is_drawn) {
        tie.joint = ingot::TargetJoint{};
        const auto id = world.add_joint(tie);
        built.sound = built.sound && id.ok() && world.set_target_drive(id.value, {4, 1, 500, 50}) == ingot::Status::ok;
        return;
    }
    for (int i = random.integer(0, 2); i > 0; --i) {
        tie.body_A = any();
        tie.body_B = any();
        tie.P = world.state(tie.body_A).value.r_CM;
        tie.P_B = world.state(tie.body_B).value.r_CM;
        const double length = (to_eigen(tie.P) - to_eigen(tie.P_B)).norm();
        if (length < 0.05) continue;
        if (random.integer(0, 1) == 1)
            tie.joint = ingot::RodJoint{};
        else
            tie.joint = ingot::RopeJoint{static_cast<scalar>(length * random.real(1, 1.5))};
        (void)world.add_joint(tie);  // two bodies that have a joint may have another
    }
}

/// Throws it in a room about x. The bodies of the figure come first.
template <class Scene>
Built add_throw(ingot::World<Scene>& world, Throw drawn, double x) {
    for (FigureBody& body : drawn.scene.bodies) body.r_CM.x() += x;
    for (FigureJoint& joint : drawn.scene.joints) {
        joint.anchor.x() += x;
        joint.anchor_B.x() += x;
    }
    Built built = add_scene(world, drawn.scene);
    built.sound = add_room(world, x) && built.sound;
    for (ingot::BodyDef& ball : drawn.bullets) {
        ball.state.r_CM.x += static_cast<scalar>(x);
        const auto id = world.add(ball);
        built.sound = built.sound && id.ok();
        built.bodies.push_back(id.value);
    }
    if constexpr (Scene::joints::has_ties) tie_to_others(world, drawn, built);
    if constexpr (Scene::joints::has_drives)
        for (const ingot::JointId id : built.joints) {
            const ingot::JointDrive drive = ingot::SpringDrive{200, 5, 0, 0, 0, static_cast<scalar>(drawn.torque)};
            if (world.set_joint_drive(id, drive) != ingot::Status::ok) (void)world.set_ball_drive(id, drive);
        }
    return built;
}

/// m; how far the centre of a body is beyond the inner face of a wall.
double outside(const Vector3d& r) { return r.cwiseAbs().maxCoeff() - half_room; }

/// Overlaps that are pushed out, and second orders of turns, are allowed what JointEnergy allows them. A target gives energy.
struct Worst {
    double gap = 0;
    int waits = 0, opened = 0, gained = 0, steps = 0;
};
template <class Scene>
Worst throw_about(uint64_t seed, double fastest, int throws) {
    Worst worst;
    RandomInput random(seed);
    for (int throw_i = 0; throw_i < throws; ++throw_i) {
        const auto world = std::make_unique<ingot::World<Scene>>();
        const Throw drawn = drawn_throw<Scene>(random, fastest);
        const Built built = add_throw(*world, drawn, 0);
        EXPECT_TRUE(built.sound) << throw_i;
        const bool gives = Scene::joints::has_ties && drawn.is_drawn;
        double M = 0;
        for (const ingot::BodyId id : built.bodies) M += static_cast<double>(world->mass(id).value);
        double last = energy_of(*world, built), before = last;
        for (int step_i = 0; step_i < 40; ++step_i) {
            worst.waits += ingot::step(*world, static_cast<scalar>(1 / drawn.rate)).impacts_deferred > 0 ? 1 : 0;
            ++worst.steps;
            const double now = energy_of(*world, built);
            if (!gives && now > std::max(last, before) + 0.01 * (M * g + std::abs(last))) ++worst.gained;
            before = last;
            last = now;
            const double gap = worst_gap(*world, built);
            worst.gap = std::max(worst.gap, gap);
            worst.opened += gap > open_joint ? 1 : 0;
            for (const ingot::BodyId id : built.bodies) {
                const double out = outside(to_eigen(world->state(id).value.r_CM));
                EXPECT_LE(out, half_wall) << "seed " << seed << ", throw " << throw_i << ", " << drawn.rate << " Hz, step " << step_i;
            }
        }
    }
    return worst;
}

// Where they touch, joints hold as they do elsewhere. At 200 m/s and 30 Hz a solve here and there leaves one open until the next step, or gives some
// of the energy back that it took: less than one of a thousand.
TYPED_TEST(FastFigures, stay_in_a_room_of_thin_walls) {
    const int throws = INGOT_TEST_BRIEF ? 12 : 500;
    const Worst slow = throw_about<TypeParam>(5, 10, throws), fast = throw_about<TypeParam>(6, 200, 2 * throws);
    EXPECT_EQ(slow.opened, 0) << slow.gap << " m";
    EXPECT_LE(fast.opened, std::max(1, fast.steps / 1000)) << fast.gap << " m";
    EXPECT_LE(slow.waits, slow.steps / 50);
    EXPECT_LE(fast.waits, fast.steps / 8);
    if (TypeParam::joints::has_drives) return;  // springs store some
    EXPECT_EQ(slow.gained, 0);
    EXPECT_LE(fast.gained, std::max(1, fast.steps / 1000));
}

TYPED_TEST(FastFigures, move_as_if_alone) {
    RandomInput random(7);
    for (int case_i = 0; case_i < ingot_reference::draws(12); ++case_i) {
        const Throw drawn[2] = {drawn_throw<TypeParam>(random, 100), drawn_throw<TypeParam>(random, 100)};
        const auto together = std::make_unique<ingot::World<TypeParam>>();
        std::unique_ptr<ingot::World<TypeParam>> alone[2];
        Built built[2], built_alone[2];
        for (int i : {1, 0}) built[i] = add_throw(*together, drawn[i], 64.0 * i);
        for (int i : {0, 1}) {
            alone[i] = std::make_unique<ingot::World<TypeParam>>();
            built_alone[i] = add_throw(*alone[i], drawn[i], 64.0 * i);
            ASSERT_TRUE(built[i].sound && built_alone[i].sound);
        }
        for (int step_i = 0; step_i < 40; ++step_i) {
            (void)ingot::step(*together, static_cast<scalar>(1 / drawn[0].rate));
            for (int i : {0, 1}) {
                (void)ingot::step(*alone[i], static_cast<scalar>(1 / drawn[0].rate));
                ASSERT_TRUE(are_same(*together, *alone[i], built[i].bodies, built_alone[i].bodies)) << "case " << case_i << ", step " << step_i;
            }
        }
    }
}

TYPED_TEST(FastFigures, go_on_from_a_snapshot) {
    RandomInput random(8);
    for (int case_i = 0; case_i < ingot_reference::draws(12); ++case_i) {
        const auto world = std::make_unique<ingot::World<TypeParam>>(), other = std::make_unique<ingot::World<TypeParam>>();
        ASSERT_TRUE(add_throw(*world, drawn_throw<TypeParam>(random, 100), 0).sound);
        for (int step_i = random.integer(1, 10); step_i > 0; --step_i) (void)ingot::step(*world, scalar(1) / 60);
        std::vector<uint8_t> bytes(ingot::snapshot_size<TypeParam>());
        const auto size = ingot::save_snapshot(*world, bytes.data(), bytes.size());
        ASSERT_TRUE(size.ok());
        ASSERT_EQ(ingot::load_snapshot(*other, bytes.data(), size.value), ingot::Status::ok);
        for (int step_i = 0; step_i < 20; ++step_i) {
            (void)ingot::step(*world, scalar(1) / 60);
            (void)ingot::step(*other, scalar(1) / 60);
        }
        EXPECT_EQ(world->state_hash(), other->state_hash()) << case_i;
    }
}

/// A rod on a hinge, that turns by up to 100 rad/s, and a plate in its way: it never comes to the other side, from wherever it starts.
TYPED_TEST(FastFigures, flail_against_a_thin_plate) {
    RandomInput random(9);
    for (int case_i = 0; case_i < ingot_reference::draws(60); ++case_i) {
        const auto world = std::make_unique<ingot::World<TypeParam>>();
        const double half = random.real(0.2, 0.6), thick = random.real(0.02, 0.05), spin = random.real(20, 100) * (random.integer(0, 1) * 2 - 1);
        const double away = random.real(0.5, 5.5);  // rad, from the plate
        ingot::BodyDef rod;
        rod.mass = ingot::principal(ingot::solid_box(500, {static_cast<scalar>(half), static_cast<scalar>(thick), static_cast<scalar>(thick)})).value;
        rod.shape = ingot::Box{{static_cast<scalar>(half), static_cast<scalar>(thick), static_cast<scalar>(thick)}};
        const double angle = spin > 0 ? -away : away;
        rod.state.A = ingot::axis_angle({0, 0, 1}, static_cast<scalar>(angle));
        rod.state.r_CM = rod.state.A.c0 * static_cast<scalar>(half);
        rod.restitution = random.integer(0, 1) == 0 ? scalar(0) : scalar(0.6);
        const auto id = world->add(rod);
        ASSERT_TRUE(id.ok());
        ingot::JointDef hinge;
        hinge.body_B = id.value;
        hinge.joint = ingot::HingeJoint{};
        hinge.axis = {0, 0, 1};
        ASSERT_TRUE(world->add_joint(hinge).ok());
        ingot::BodyDef plate;
        plate.immovable = true;
        plate.shape = ingot::Box{{1, scalar(half_wall), 1}};
        plate.state.r_CM = {scalar(1.3), 0, 0};
        ASSERT_TRUE(world->add(plate).ok());
        const scalar I = static_cast<scalar>(world->mass(id.value).value * static_cast<scalar>(half * half * 4 / 3));
        ASSERT_EQ(world->apply_angular_impulse(id.value, {0, 0, static_cast<scalar>(spin) * I / 4}), ingot::Status::ok);
        ASSERT_EQ(world->apply_central_impulse(id.value, rod.state.A.c1 * (world->mass(id.value).value * static_cast<scalar>(spin * half))),
                  ingot::Status::ok);
        double turned = angle, last = angle;
        for (int step_i = 0; step_i < 30; ++step_i) {
            (void)ingot::step(*world, scalar(1) / 60);
            const Vector x = world->state(id.value).value.A.c0;
            const double now = std::atan2(static_cast<double>(x.y), static_cast<double>(x.x));
            turned += std::remainder(now - last, 2 * pi);
            last = now;
            if (spin > 0) {
                EXPECT_LE(turned, 0) << case_i << ", step " << step_i;
            } else {
                EXPECT_GE(turned, 0) << case_i << ", step " << step_i;
            }
        }
    }
}

/// Nothing follows what is fast: joints are carried past their ends, and turn by radians in a substep.
template <int loops>
struct BlindShot : ingot::Scene {
    static constexpr int max_bodies = 40, max_joints = 40, max_manifolds = 300, max_pairs = 600, max_loops = loops;
    static constexpr bool translates = true, sleeps = true;
    using joints = AllJointsWith<ingot::WithLimits>;
    using shapes = ingot::Shapes<ingot::Box, ingot::Capsule, ingot::Sphere>;
};
/// Trees with limits, thrown at up to 200 m/s and 30 Hz: no step, of contacts, of joints that are far off or of their ends, gives a tenth of what the
/// throw began with. Of a figure whose spins had changed little, targets of turns by radians were taken as they were: one of a thousand throws got up
/// to a million times its energy. In brief one that did.
template <int loops>
void expect_no_gain_of_throws() {
    for (int seed = 45; seed < (INGOT_TEST_BRIEF ? 46 : 245); ++seed) {
        RandomInput random(static_cast<uint64_t>(seed));
        for (int throw_i = 0; throw_i < 12; ++throw_i) {
            const auto world = std::make_unique<ingot::World<BlindShot<loops>>>();
            const Throw drawn = drawn_throw<BlindShot<loops>>(random, 200);
            const Built built = add_throw(*world, drawn, 0);
            ASSERT_TRUE(built.sound);
            const double begin = energy_of(*world, built);
            double last = begin, before = begin;
            for (int step_i = 0; step_i < 20; ++step_i) {
                (void)ingot::step(*world, scalar(1) / 30);
                const double now = energy_of(*world, built);
                EXPECT_LE(now - std::max(last, before), 0.1 * begin) << "seed " << seed << ", throw " << throw_i << ", step " << step_i;
                before = last;
                last = now;
            }
        }
    }
}
TEST(ThrownFigures, gain_nothing) { expect_no_gain_of_throws<0>(); }
TEST(ThrownFigures, gain_nothing_with_loops) { expect_no_gain_of_throws<4>(); }

#if !INGOT_TEST_BRIEF
template <int k>
struct ScaledShot : LoopedShot {
    static constexpr scalar length_unit = ingot_reference::power_of_two(k);
    using joints = AllJointsWith<ingot::WithLimits>;
};

Throw scaled(Throw drawn, double length) {
    drawn.scene.g *= length;
    for (FigureBody& body : drawn.scene.bodies) {
        body.I_body *= length * length;
        body.r_CM *= length;
        body.v_CM *= length;
        body.half_extent *= length;
    }
    for (FigureJoint& joint : drawn.scene.joints) {
        joint.anchor *= length;
        if (joint.kind != FigureJointKind::slider) continue;
        joint.lower *= length;
        joint.upper *= length;
    }
    drawn.bullets.clear();
    return drawn;
}

/// Lengths, speeds, gravity and length_unit 2^k times as large: the same way, to the bit.
template <int k>
void expect_same_way() {
    RandomInput random(10);
    constexpr scalar length = ingot_reference::power_of_two(k);
    for (int case_i = 0; case_i < 100; ++case_i) {
        const auto plain = std::make_unique<ingot::World<ScaledShot<0>>>();
        const auto other = std::make_unique<ingot::World<ScaledShot<k>>>();
        const Throw drawn = drawn_throw<ScaledShot<0>>(random, 200);
        const Built A = add_throw(*plain, scaled(drawn, 1), 0), B = add_throw(*other, scaled(drawn, static_cast<double>(length)), 0);
        ASSERT_TRUE(A.sound && B.sound);
        for (int step_i = 0; step_i < 40; ++step_i) {
            const scalar h = static_cast<scalar>(1 / drawn.rate);
            EXPECT_EQ(ingot::step(*plain, h).impacts_deferred, ingot::step(*other, h).impacts_deferred);
            for (size_t i = 0; i < A.bodies.size(); ++i) {
                const ingot::BodyState a = plain->state(A.bodies[i]).value, b = other->state(B.bodies[i]).value;
                ASSERT_TRUE(ingot_reference::equal(a.r_CM * length, b.r_CM)) << case_i << ", step " << step_i;
                ASSERT_TRUE(ingot_reference::equal(a.v_CM * length, b.v_CM)) << case_i << ", step " << step_i;
                ASSERT_TRUE(ingot_reference::equal(a.A.c0, b.A.c0) && ingot_reference::equal(a.A.c1, b.A.c1)) << case_i << ", step " << step_i;
            }
        }
    }
}
TEST(ScaleOfFastFigures, is_no_matter) {
    expect_same_way<9>();
    expect_same_way<-8>();
}
#endif

}  // namespace

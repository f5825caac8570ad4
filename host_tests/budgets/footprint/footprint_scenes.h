// SPDX-License-Identifier: MIT
// In the place of scenes/all_scenes.h: scenes that differ in one thing, for what that thing takes. footprint.csv has a row for each.
#pragma once

#include "scenes/hulls.h"
#include "scenes/terrain.h"

namespace scenes {

/// What a caller does beside stepping; the compiler must not see that nobody reads the answers.
inline volatile int answer = 0;

/// One body that turns.
struct Turning : ingot::Scene {
    static constexpr const char* name = "footprint";
    static constexpr int golden_steps = 2;
    static constexpr scalar h = display_rate_h;  ///< s

    template <class World>
    static void ask(World&) {}
};
struct Moving : Turning {
    static constexpr bool translates = true;
};

/// Two balls and a plane.
struct Impacts : Moving {
    static constexpr int max_bodies = 3;
    static constexpr int max_contacts = 3;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;
};
struct Balls : Moving {
    static constexpr int max_bodies = 3;
    static constexpr int max_manifolds = 3;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;
};
/// What is left where nothing bounces.
struct BallsAtRest : Balls {
    static constexpr bool bounces = false;
};
struct BallsByPoint : Balls {
    using solver = ingot::SequentialImpulses;
};
struct Capsules : Balls {
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::HalfSpace>;
};
struct Boxes : Balls {
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};
struct Cylinders : Balls {
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Cylinder, ingot::HalfSpace>;
};
struct Hulls : Balls {
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Hull, ingot::HalfSpace>;
    static constexpr ingot::ConvexHull hulls[] = {cube_hull.hull.value.view()};
};
struct AllShapes : Hulls {
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::Hull, ingot::HalfSpace>;
};

/// With tables of a level beside the plane, whose slots come on top.
struct BallsOnMesh : Balls {
    static constexpr int max_bodies = 3 + ingot::level_patches;
    static constexpr ingot::LevelTable levels[] = {steps_of_terrain.value.view()};
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace, ingot::Level>;
};
struct BallsOnField : BallsOnMesh {
    static constexpr ingot::LevelTable levels[] = {field_of_terrain.value.view()};
};

/// Ten boxes and a plane, for what a scene may name beside shapes.
struct TenBoxesOnPlane : Moving {
    static constexpr int max_bodies = 11;
    static constexpr int max_manifolds = 10;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
struct OnMesh : TenBoxesOnPlane {
    static constexpr int max_bodies = 11 + ingot::level_patches;
    static constexpr ingot::LevelTable levels[] = {steps_of_terrain.value.view()};
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace, ingot::Level>;
};
struct OnField : OnMesh {
    static constexpr ingot::LevelTable levels[] = {field_of_terrain.value.view()};
};
struct NothingBounces : TenBoxesOnPlane {
    static constexpr bool bounces = false;
};
struct NothingRenewed : TenBoxesOnPlane {
    static constexpr bool recycles_manifolds = false;
};
struct ByPointSweeps : NothingBounces {
    using solver = ingot::SequentialImpulses;
};
struct BySortedTree : TenBoxesOnPlane {
    using broad_phase = ingot::SortedTree;
};
struct Filtered : TenBoxesOnPlane {
    static constexpr bool filters = true;
};
struct Sensors : TenBoxesOnPlane {
    static constexpr int max_overlaps = 10;
};
struct Events : TenBoxesOnPlane {
    static constexpr int max_events = 10;
    template <class World>
    static void ask(World& world) {
        for (const ingot::Event& event : world.events()) answer = event.shape_A;
    }
};
struct Sleeping : TenBoxesOnPlane {
    static constexpr bool sleeps = true;
};
struct Continuous : TenBoxesOnPlane {
    static constexpr bool continuous = true;
};
struct Compounds : TenBoxesOnPlane {
    static constexpr int max_shapes_of_body = 2;
    template <class World>
    static void ask(World& world) {
        ingot::BodyDef def;
        def.mass = mass_of(ingot::solid_box(1, {1, 1, 1}));
        const ingot::ShapeDef part = {ingot::Box{{1, 1, 1}}, {}};
        const ingot::ShapeDef parts[] = {part, part};
        answer = world.add(def, parts).ok();
    }
};
struct SmallDirect : TenBoxesOnPlane {
    using solver = ingot::HybridIslands<4>;
};
struct ColumnDirect : TenBoxesOnPlane {
    using solver = ingot::HybridIslands<10, 10>;
};
struct Rays : TenBoxesOnPlane {
    template <class World>
    static void ask(World& world) {
        answer = world.cast_ray({0, 0, 9}, {0, 0, -10}).ok();
    }
};
struct Casts : TenBoxesOnPlane {
    template <class World>
    static void ask(World& world) {
        answer = world.cast_shape({ingot::Box{{1, 1, 1}}, {0, 0, 9}, ingot::identity_matrix<scalar>(), nullptr}, {0, 0, -10}).ok();
    }
};
struct Overlaps : TenBoxesOnPlane {
    template <class World>
    static void ask(World& world) {
        ingot::BodyId found[4];
        answer = world.find_overlaps({ingot::Box{{1, 1, 1}}, {}, ingot::identity_matrix<scalar>(), nullptr}, found, 4).value;
    }
};
struct Nearest : TenBoxesOnPlane {
    template <class World>
    static void ask(World& world) {
        answer = world.find_nearest({0, 0, 9}, 10).ok();
    }
};
struct Snapshots : TenBoxesOnPlane {
    template <class World>
    static void ask(World& world) {
        static uint8_t bytes[ingot::snapshot_size<Snapshots>()];
        const ingot::Result<size_t> size = ingot::save_snapshot(world, bytes, sizeof bytes);
        answer = ingot::load_snapshot(world, bytes, size.value) == ingot::Status::ok;
    }
};

/// Two rods on hinges, for what joints may have beside.
struct TwoHinges : Moving {
    static constexpr int max_bodies = 2;
    static constexpr int max_joints = 2;
    using joints = ingot::Joints<ingot::HingeJoint>;
};
struct TwoLimits : TwoHinges {
    using joints = ingot::Joints<ingot::HingeJoint, ingot::WithLimits>;
};
struct TwoDrives : TwoHinges {
    using joints = ingot::Joints<ingot::HingeJoint, ingot::WithDrives>;
    template <class World>
    static void ask(World& world) {
        answer = world.set_joint_drive(world.joint_at(0), ingot::TunedDrive{}) == ingot::Status::ok;
    }
};
struct TwoBalls : TwoHinges {
    using joints = ingot::Joints<ingot::BallJoint>;
};
struct OneLoop : TwoHinges {
    static constexpr int max_loops = 1;
};
struct TwoHingesTouch : TwoHinges {
    static constexpr int max_bodies = 3;
    static constexpr int max_manifolds = 3;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};

/// A shape of the scene for the body of that number: one kind after another.
template <class S>
ingot::Shape shape_of(int body_i) {
    ingot::Shape kinds[5];
    int count = 0;
    constexpr scalar half = scalar(0.5);
    if constexpr (S::shapes::has(ingot::ShapeKind::sphere)) kinds[count++] = ingot::Sphere{half};
    if constexpr (S::shapes::has(ingot::ShapeKind::capsule)) kinds[count++] = ingot::Capsule{half, half};
    if constexpr (S::shapes::has(ingot::ShapeKind::box)) kinds[count++] = ingot::Box{{half, half, half}};
    if constexpr (S::shapes::has(ingot::ShapeKind::cylinder)) kinds[count++] = ingot::Cylinder{half, half};
    if constexpr (S::shapes::has(ingot::ShapeKind::hull)) kinds[count++] = ingot::hull_of<S>(0);
    return kinds[body_i % count];
}

template <class S>
ingot::Status set_up(ingot::World<S>& world) {
    ingot::Status status = ingot::Status::ok;
    if constexpr (S::translates) status = world.set_gravity({0, 0, -standard_gravity});
    ingot::BodyDef def;
    def.mass = mass_of(ingot::solid_sphere(1, scalar(0.5)));
    constexpr int slots_of_others = (ingot::has_compounds<S> ? 1 : 0) + (ingot::has_levels<S> ? ingot::level_patches : 0);
    for (int body_i = ingot::has_shapes<S> ? 1 : 0; body_i < S::max_bodies - slots_of_others && status == ingot::Status::ok; ++body_i) {
        if constexpr (ingot::has_shapes<S>) def.shape = shape_of<S>(body_i);
        if constexpr (S::translates) def.state.r_CM = {static_cast<scalar>(body_i) * 3, 0, 1};
        status = world.add(def).status;
    }
    if constexpr (ingot::has_shapes<S>) {
        ingot::BodyDef ground;
        ground.immovable = true;
        ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        if (status == ingot::Status::ok) status = world.add(ground).status;
    }
    if constexpr (ingot::has_levels<S>) {
        ingot::LevelDef level;
        level.r = {0, 0, -8};  // below all bodies: two steps are no time to land in
        if (status == ingot::Status::ok) status = world.add_level(level).status;
    }
    if constexpr (ingot::has_joints<S>) {
        ingot::JointDef joint;
        if constexpr (S::joints::has(ingot::JointKind::ball)) {
            joint.joint = ingot::BallJoint{};
        } else {
            joint.joint = ingot::HingeJoint{};
        }
        for (int body_i = 0; body_i < 2 && status == ingot::Status::ok; ++body_i) {
            joint.body_B = world.body_at(body_i);
            status = world.add_joint(joint).status;
            joint.body_A = joint.body_B;
        }
    }
    S::ask(world);
    return status;
}

}  // namespace scenes

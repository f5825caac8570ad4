// SPDX-License-Identifier: MIT
// Damaged snapshots of scenes with every trait that adds to them: several shapes, hulls, sensors, materials, sleep, the direct solver. What is
// wrong with one number is refused, and the world that it was for stays as it is, to the bit.
#include "snapshot/sound.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "scenes/hulls.h"

namespace {

using namespace life;
using ingot::Capsule;
using ingot::ShapeDef;
using ingot::Sphere;
using scenes::cube_hull;
using scenes::rock_hull;

struct Traits : ingot::Scene {
    static constexpr int max_bodies = 4, max_manifolds = 24, max_overlaps = 8;
    static constexpr bool translates = true, filters = true, rolling_resistance = true, surface_velocities = true;
    using shapes = ingot::Shapes<Sphere, ingot::Box, ingot::Hull, ingot::HalfSpace>;
    static constexpr ingot::ConvexHull hulls[] = {cube_hull.hull.value.view(), rock_hull.hull.value.view()};
};
struct OfSeveral : Traits {
    static constexpr int max_shapes_of_body = 3;
};
struct Sleepy : Traits {
    static constexpr bool sleeps = true;
};
struct Chosen : ingot::Scene {
    static constexpr int max_bodies = 4, max_manifolds = 8;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
    using solver = ingot::HybridIslands<4>;
};

/// Slots of the bodies below.
enum Slot { floor_slot, rock_slot, ball_slot, sensor_slot };

template <class S>
void fill(World<S>& world) {
    clear(world);
    ASSERT_EQ(world.set_gravity({0, 0, -10}), Status::ok);
    BodyDef floor = ground();
    floor.friction = scalar(0.6);
    const BodyId on = world.add(floor).value;
    BodyDef rock = plain_body({0, 0, scalar(0.5)}, ingot::hull_of<S>(0));
    rock.mass = cube_hull.mass;
    ASSERT_TRUE(world.add(rock).ok());
    BodyDef ball = plain_body({3, 0, scalar(0.5)}, Sphere{scalar(0.5)});
    ball.state.v_CM = {1, 0, 0};
    BodyDef sensor = plain_body({0, 0, 1}, ingot::Box{{2, 2, 2}});
    sensor.immovable = sensor.sensor = true;
    BodyId of_ball{};
    if constexpr (ingot::has_compounds<S>) {
        ball.shape = {};
        ball.mass.I_body = {1, 1, 1};
        ShapeDef parts[2];
        parts[0].shape = Sphere{scalar(0.5)};
        parts[1].shape = ingot::hull_of<S>(1);
        parts[1].r = {0, 0, scalar(0.75)};
        of_ball = world.add(ball, parts).value;
    } else {
        of_ball = world.add(ball).value;
    }
    ASSERT_TRUE(world.add(sensor).ok());
    ASSERT_EQ(world.set_rolling_resistance(of_ball, scalar(0.01)), Status::ok);
    ASSERT_EQ(world.set_surface_velocity(on, {0, scalar(0.125), 0}), Status::ok);
}

template <class S>
Sound<S> after(int steps) {
    Sound<S> sound;
    fill(*sound.world);
    for (int step_i = 0; step_i < steps; ++step_i) EXPECT_TRUE(ingot::step(*sound.world, h).clean());
    sound.keep();
    return sound;
}

template <class S>
void refuses_materials_and_sensors_of_no_world() {
    const Sound<S> sound = after<S>(5);
    sound.accepts(sound.bytes, "what was saved");
    sound.refuses_what_is_not_finite();
    const auto &lever = sound.field(ball_slot, "rolling_resistance"), &belt = sound.field(floor_slot, "surface_velocity.x");
    sound.refuses(sound.with_real(lever, scalar(-0.01)), "a lever below nothing");
    sound.refuses(sound.with_real(lever, limits::size_max * 2), "a lever longer than any shape");
    sound.accepts(sound.with_real(lever, limits::size_max), "the longest lever");
    sound.refuses(sound.with_real(belt, limits::speed_max * 2), "a belt that is too fast");
    sound.accepts(sound.with_real(belt, -limits::speed_max), "the fastest belt");
    sound.refuses(sound.with(sound.field(sensor_slot, "sensor"), 2), "half a sensor");
    sound.accepts(sound.with(sound.field(sensor_slot, "sensor"), 0), "none");
    sound.refuses(sound.with(sound.field(ball_slot, "shape.kind"), static_cast<uint64_t>(ingot::ShapeKind::capsule)), "a kind the scene has not");
}
TEST(DamagedTraits, of_materials_and_sensors) { refuses_materials_and_sensors_of_no_world<Sleepy>(); }
TEST(DamagedTraits, of_materials_and_sensors_by_shape) { refuses_materials_and_sensors_of_no_world<OfSeveral>(); }

/// A hull is a number and the size that goes with it.
template <class S>
void refuses_hulls_of_no_scene() {
    const Sound<S> sound = after<S>(5);
    const auto &radius = sound.field(rock_slot, "shape.size.x"), &form = sound.field(rock_slot, "shape.size.y");
    const Bytes other = sound.with_real(form, 1);
    sound.refuses(other, "the size of another hull");
    sound.accepts(Sound<S>::sealed([&] {
                      ingot::ScalarBits bits;
                      const scalar of_other = S::hulls[1].radius;
                      memcpy(&bits, &of_other, sizeof bits);
                      return Sound<S>::put(other, radius.offset, bits, radius.size);
                  }()),
                  "the other hull");
    sound.refuses(sound.with_real(form, 2), "a hull too many");
    sound.refuses(sound.with_real(form, -1), "a hull before the first");
    sound.refuses(sound.with_real(form, scalar(0.5)), "between two hulls");
}
TEST(DamagedTraits, of_hulls) { refuses_hulls_of_no_scene<Sleepy>(); }
TEST(DamagedTraits, of_hulls_by_shape) { refuses_hulls_of_no_scene<OfSeveral>(); }

/// Hulls are part of what a scene is, to a nanometre.
struct OtherHulls : Sleepy {
    static constexpr ingot::ConvexHull hulls[] = {rock_hull.hull.value.view(), cube_hull.hull.value.view()};
};
TEST(DamagedTraits, of_none_but_for_a_scene_of_other_hulls) {
    EXPECT_NE(ingot::scene_signature<Sleepy>(), ingot::scene_signature<OtherHulls>());
    const Sound<Sleepy> sound = after<Sleepy>(5);
    const auto other = std::make_unique<World<OtherHulls>>(), before = std::make_unique<World<OtherHulls>>();
    fill(*other);
    copy(*before, *other);
    EXPECT_EQ(ingot::load_snapshot(*other, sound.bytes.data(), sound.bytes.size()), Status::other_scene);
    EXPECT_TRUE(same_bytes(*other, *before));
}

/// So are the shapes that it names, each of them.
template <class Left>
struct Named : ingot::Scene {
    using shapes = Left;
};
TEST(DamagedTraits, of_none_but_for_a_scene_of_other_shapes) {
    using namespace ingot;
    const uint64_t all = scene_signature<Named<Shapes<Sphere, Capsule, Box, Cylinder, HalfSpace>>>();
    EXPECT_NE(all, (scene_signature<Named<Shapes<Capsule, Box, Cylinder, HalfSpace>>>()));
    EXPECT_NE(all, (scene_signature<Named<Shapes<Sphere, Box, Cylinder, HalfSpace>>>()));
    EXPECT_NE(all, (scene_signature<Named<Shapes<Sphere, Capsule, Cylinder, HalfSpace>>>()));
    EXPECT_NE(all, (scene_signature<Named<Shapes<Sphere, Capsule, Box, HalfSpace>>>()));
    EXPECT_NE(all, (scene_signature<Named<Shapes<Sphere, Capsule, Box, Cylinder>>>()));
}

TEST(DamagedTraits, of_the_shapes_of_a_body) {
    const Sound<OfSeveral> sound = after<OfSeveral>(5);
    ASSERT_EQ(sound.field(ball_slot, "shapes").bits, 2u);
    sound.refuses(sound.with(sound.field(ball_slot, "shapes"), 4), "more shapes than a body may have");
    sound.refuses(sound.with(sound.field(ball_slot, "shapes"), 1), "bytes of a shape that is not counted");
    sound.refuses(sound.with(sound.field(ball_slot, "shape.kind"), static_cast<uint64_t>(ingot::ShapeKind::none)), "a shape that is none");
    sound.refuses(sound.with_real(sound.field(ball_slot, "shape.size.x"), -1), "a ball of no size");
    sound.refuses(sound.with_real(sound.field(ball_slot, "shape.r.z", 1), limits::position_max * 2), "a place out of range");
    sound.refuses(sound.with_real(sound.field(ball_slot, "shape.A.c0.x", 1), -1), "a shape that is mirrored");
    sound.accepts(sound.with_real(sound.field(ball_slot, "shape.r.z", 1), scalar(0.875)), "another place");
}

/// The shapes of one body do not touch each other.
TEST(DamagedTraits, of_two_shapes_of_a_body_that_touch) {
    const Sound<OfSeveral> sound = after<OfSeveral>(5);
    const auto &A = sound.field(-1, "body_A"), &B = sound.field(-1, "body_B");
    ASSERT_EQ(A.bits, static_cast<uint64_t>(OfSeveral::max_shapes_of_body * floor_slot));
    ASSERT_EQ(B.bits, static_cast<uint64_t>(OfSeveral::max_shapes_of_body * rock_slot));
    sound.refuses(sound.with(B, A.bits + 1), "two shapes of the ground");
    sound.accepts(sound.with(B, B.bits + 1), "another shape of the rock");
    sound.refuses(sound.with(B, OfSeveral::max_bodies * OfSeveral::max_shapes_of_body), "a shape the scene has not");
}

TEST(DamagedTraits, of_sleep) {
    const Sound<Sleepy> sound = after<Sleepy>(30);
    const auto &awake = sound.field(rock_slot, "awake"), &rest_time = sound.field(rock_slot, "rest_time");
    ASSERT_EQ(awake.bits, 1u);
    sound.refuses(sound.with(awake, 3), "neither awake nor asleep");
    sound.refuses(sound.with(sound.field(ball_slot, "awake"), 0), "a sleeper that moves");
    sound.refuses(sound.with(sound.field(ball_slot, "awake"), 2), "one that is due and moves");
    sound.refuses(sound.with_real(rest_time, scalar(-0.25)), "slow for less than nothing");
    sound.refuses(sound.with_real(rest_time, Sleepy::sleep_time * 2), "slow for longer than one stays awake");
    sound.accepts(sound.with_real(rest_time, Sleepy::sleep_time), "about to fall asleep");
}

/// A heavy box on a light one, for the direct solver: what it counts of each contact.
TEST(DamagedTraits, of_what_sweeps_left_unsettled) {
    Sound<Chosen> sound;
    clear(*sound.world);
    ASSERT_EQ(sound.world->set_gravity({0, 0, -10}), Status::ok);
    ASSERT_TRUE(sound.world->add(ground()).ok());
    const ingot::Box box{{scalar(0.5), scalar(0.5), scalar(0.5)}};
    for (int body_i = 0; body_i < 2; ++body_i) {
        BodyDef def = plain_body({0, 0, scalar(body_i) + scalar(0.5)}, box);
        const scalar M = body_i == 0 ? 1 : 1000, I = M / 6;
        def.mass = mass_of(M, {I, I, I});
        ASSERT_TRUE(sound.world->add(def).ok());
    }
    EXPECT_EQ(ingot::step(*sound.world, h).direct, ingot::DirectBits::solved);
    sound.keep();
    sound.accepts(sound.bytes, "what was saved");
    sound.refuses_what_is_not_finite();
    const auto& unsettled = sound.field(-1, "unsettled");
    sound.refuses(sound.with(unsettled, limits::unsettled_steps + 1), "longer than is counted");
    sound.accepts(sound.with(unsettled, limits::unsettled_steps), "as long as is counted");
}

}  // namespace

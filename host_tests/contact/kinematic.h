// SPDX-License-Identifier: MIT
// Scenes and worlds of kinematic_test.cpp and kinematic_world_test.cpp.
#pragma once

#include <ingot/ingot.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "reference/brief_types.h"

namespace kinematic {

using namespace ingot;
using ingot_reference::BriefTypes;

constexpr scalar g = scalar(9.8125);
constexpr int rates[] = {30, 60, 120, 240, 1000};

template <class Solver, bool sleepy = false, bool is_continuous = false, class Search = AllPairs>
struct Yard : Scene {
    static constexpr int max_bodies = 48, max_manifolds = 300;
    static constexpr bool translates = true, kinematic_bodies = true, sleeps = sleepy, continuous = is_continuous, reads_contacts = true;
    using solver = Solver;
    using broad_phase = Search;
    using shapes = Shapes<Sphere, Capsule, Box, HalfSpace>;
};
using Swept = Yard<BlockSweeps>;
using Hybrid = Yard<HybridIslands<>>;
using Light = Yard<SequentialImpulses>;
using SweptAsleep = Yard<BlockSweeps, true, false, SortedTree>;
using SweptFast = Yard<BlockSweeps, false, true>;
using HybridFast = Yard<HybridIslands<20, 10>, true, true, SortedTree>;
using LightFast = Yard<SequentialImpulses, false, true>;
struct Impacts : Scene {
    static constexpr int max_bodies = 8, max_contacts = 60;
    static constexpr bool translates = true, kinematic_bodies = true;
    using solver = FrictionlessImpacts;
    using shapes = Shapes<Sphere, Box, HalfSpace>;
};
struct Rich : Yard<BlockSweeps> {
    static constexpr bool rolling_resistance = true, surface_velocities = true;
    static constexpr int max_shapes_of_body = 2, max_pairs = 1500, max_events = 60, max_overlaps = 20;
};

template <class S>
World<S>& empty_world(int which = 0, const Vector& gravity = {0, 0, -g}) {
    static World<S> worlds[2];
    World<S>& world = worlds[which];
    std::memset(static_cast<void*>(&world), 0, sizeof world);
    EXPECT_EQ(world.set_gravity(gravity), Status::ok);
    return world;
}
inline BodyDef platform(const Vector& half, const UserPose& pose = {}, const UserMotion& motion = {}) {
    BodyDef def;
    def.kinematic = true;
    def.shape = Box{half};
    def.friction = scalar(0.8);
    def.state = {pose.r, motion.v, pose.A, motion.omega};
    return def;
}
inline BodyDef cube(scalar half, const UserPose& pose, const UserMotion& motion = {}) {
    BodyDef def;
    def.mass = principal(solid_box(500, {half, half, half})).value;
    def.shape = Box{{half, half, half}};
    def.friction = scalar(0.8);
    def.state = body_state(def.mass, pose, motion);
    return def;
}
inline BodyDef ball(scalar radius, const Vector& r, const Vector& v = {}) {
    BodyDef def;
    def.mass = principal(solid_sphere(1000, radius)).value;
    def.shape = Sphere{radius};
    def.state.r_CM = r;
    def.state.v_CM = v;
    return def;
}
template <class S>
BodyId add(World<S>& world, const BodyDef& def) {
    const Result<BodyId> id = world.add(def);
    EXPECT_EQ(id.status, Status::ok);
    return id.value;
}
template <class S>
BodyState state(const World<S>& world, BodyId id) {
    return world.state(id).value;
}
inline double length(const Vector& v) { return std::sqrt(static_cast<double>(length_sq(v))); }
inline scalar of(double x) { return static_cast<scalar>(x); }

}  // namespace kinematic

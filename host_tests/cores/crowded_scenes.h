// SPDX-License-Identifier: MIT
// Scenes of a crowd, which together name what a scene may name.
#pragma once

#include "crowd.h"

namespace cores_test {

struct Plain : Crowded {};
struct Sleepers : Crowded {
    static constexpr bool sleeps = true, kinematic_bodies = true, continuous = true, filters = true;
    static constexpr scalar sleep_time = scalar(0.125), sleep_speed = scalar(0.05);
    static constexpr int max_events = 4000, max_overlaps = 64;
};
struct Materials : Crowded {
    static constexpr bool rolling_resistance = true, surface_velocities = true, reads_contacts = true, recycles_manifolds = false;
    static constexpr int max_shapes_of_body = 2, max_events = 4000;
};
struct Locked : Crowded {
    static constexpr bool axis_locks = true, compensated_sums = true, kinematic_bodies = true;
    using broad_phase = ingot::AllPairs;
};
struct Balls : Crowded {
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;
};
struct Fast : Crowded {
    static constexpr bool continuous = true, kinematic_bodies = true, rolling_resistance = true;
    static constexpr int max_events = 4000;
    using broad_phase = ingot::QueryTree;
};
struct Full : Crowded {
    static constexpr int max_manifolds = 200, max_pairs = 300, work_budget = 16 * 200;
};
/// With room for a heap, but not for all of it, nor for all visits.
struct Scarce : Crowded {
    static constexpr int max_manifolds = 500, max_pairs = 900, work_budget = 16 * 500;
};
struct OnLevels : Crowded {
    static constexpr ingot::LevelTable levels[] = {level_test::roof.view(), level_test::hill.value.view()};
    static constexpr bool sleeps = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace, ingot::Level>;
};
struct Joined : Crowded {
    static constexpr int max_joints = 20;
    using joints = ingot::Joints<ingot::BallJoint>;
};
struct Hybrid : Crowded {
    using solver = ingot::HybridIslands<12, 10>;
};
struct Pointwise : Crowded {
    using solver = ingot::SequentialImpulses;
    static constexpr bool bounces = false;
};

}  // namespace cores_test

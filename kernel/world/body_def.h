// SPDX-License-Identifier: MIT
#pragma once

#include "../body/axis_locks.h"
#include "../body/check_body.h"
#include "../broad_phase/body_filter.h"
#include "../level/level_table.h"
#include "../math/rotation.h"
#include "../shape/shapes.h"

namespace ingot { inline namespace INGOT_ABI {

/// What World::add needs to know of a body.
struct BodyDef {
    MassProperties mass{};       ///< see body/mass_properties.h; not looked at for an immovable or kinematic body
    /// of the principal frame; an immovable body has v_CM = L = 0. body_state() makes it of a pose, a velocity and an angular velocity
    BodyState state{};
    Shape shape{};               ///< Sphere, Box ... in the principal frame, hulls by hull_of; none: the body touches nothing
    scalar restitution = 0;      ///< e of Fig. 4, 0 .. 1; of a pair the larger counts
    scalar friction = scalar(0.5); ///< coefficient mu, 0 and more; of a pair the geometric mean counts
    BodyFilter filter = meets_all; ///< whom it meets; for scenes with filters
    bool sensor = false;         ///< notes who is in it and touches nothing; for scenes with max_overlaps
    bool immovable = false;      ///< neither force nor impulse moves it
    /// A platform, lift, door, flipper, turntable: neither force nor impulse moves it. It goes on with state.v_CM and state.L, which of such a body
    /// is its angular velocity, rad/s. For scenes with kinematic_bodies
    bool kinematic = false;
    uint8_t locks = 0;           ///< axes of the world that it does not move along, or turn about: AxisLocks; for scenes with axis_locks
};

/// What World::add_level needs to know of a level.
struct LevelDef {
    int number = 0;                        ///< of Scene::levels
    Vector r{};                            ///< m, world, of the origin of the level's frame
    Matrix A = identity_matrix<scalar>();  ///< level to world, a rotation
    scalar restitution = 0;                ///< as in BodyDef
    scalar friction = scalar(0.5);         ///< as in BodyDef
    BodyFilter filter = meets_all;         ///< as in BodyDef
};

} }  // namespace ingot

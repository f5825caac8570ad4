// SPDX-License-Identifier: MIT
// What queries ask of a level: triangle after triangle of those that its tree tells.
#pragma once

#include "../narrow_phase/collide_level.h"
#include "cast_shape.h"

namespace ingot { inline namespace INGOT_ABI {

/// A ray in the frame of the level's box: see Level.
RayEntry ray_on_level(const LevelTable& level, const LocalRay& ray);
/// Where a moving shape meets a level from outside: its triangles, none of which has a thickness here; see cast_on_shape. level: placed.
ShapeEntry cast_on_level(const PlacedShape& moving, const Vector& way, const PlacedShape& level, const LevelTable& table, scalar fraction_max);
/// True where a shape overlaps or touches a triangle, from either side; what is below a triangle, and does not reach it, is beside the level.
bool overlaps_level(const PlacedShape& shape, const PlacedShape& level, const LevelTable& table);
/// The point of a level nearest to the middle of a ball without extent, as one point of a manifold; none further than `within`, m. Whoever is behind
/// the triangle that is nearest has a distance below zero.
/// Cost: boxes about the point that double until there is something in them.
void point_on_level(const PlacedShape& point, const PlacedShape& level, const LevelTable& table, scalar within, Manifold& manifold);

} }  // namespace ingot

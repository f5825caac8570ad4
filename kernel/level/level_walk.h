// SPDX-License-Identifier: MIT
// Which triangles of a level are where. All in the level's frame.
//
// Whatever bytes the tables have, a walk reads what is in them and ends; only counts and places of the arrays have to be true (check_level).
#pragma once

#include "../base/status.h"
#include "height_walk.h"
#include "mesh_walk.h"

namespace ingot { inline namespace INGOT_ABI {

/// The triangle of this number, which for_triangles_in has told.
LevelTriangle triangle_of(const LevelTable& level, uint32_t number);

/// Calls each(const LevelTriangle&) for every triangle whose own box meets the box low .. high, m; which come first the tables alone decide. Boxes
/// of triangles of heights reach down without end, as the ground does: what lies below it meets what is above. Nothing meets a box that is inside
/// out, or has a NaN. Bounded by the tables. Cost: a node a comparison of four boxes, in integers; of heights, a block one of its greatest height.
template <class Each>
void for_triangles_in(const LevelTable& level, const Vector& low, const Vector& high, const Each& each) {
    MeshWalk of_mesh;
    HeightWalk of_heights;
    const bool is_mesh = level.is_mesh();
    if (!(is_mesh ? begin_walk(level, low, high, of_mesh) : begin_walk(level, low, high, of_heights))) return;
    LevelTriangle triangle;
    // One loop for both, as `each` is long. bound: triangles of the level
    while (is_mesh ? next_triangle(level, of_mesh, triangle) : next_triangle(level, of_heights, triangle)) each(triangle);
}

/// Where a ray meets a level first, from outside.
struct LevelHit {
    scalar fraction;  ///< of the way
    uint32_t triangle;
};
/// False where the way from `from` meets no triangle from outside within its length. Watertight: a ray through an edge or a corner meets one of
/// its triangles.
/// Of heights, a ray that comes from below meets nothing. Of those at the same place, the triangle of the least number. Cost: nodes, or blocks, along
/// the ray.
bool cast_ray_on_level(const LevelTable& level, const Vector& from, const Vector& way, LevelHit& hit);

/// Errors: bad_shape (a table that is empty, or both; numbers beyond the arrays, a node that is its own child, a depth above the bound, a step that
/// is no power of two, a checksum that is not that of the tables). Cost: every byte of the tables, once. Needed for tables from outside only.
Status check_level(const LevelTable& level);

}}  // namespace ingot::INGOT_ABI

// SPDX-License-Identifier: MIT
// Which triangles of a level are where. All in the level's frame.
#pragma once

#include "../base/status.h"
#include "level_table.h"

namespace ingot { inline namespace INGOT_ABI {

/// The triangle of this number, which for_triangles_in has told.
LevelTriangle triangle_of(const LevelTable& level, uint32_t number);

/// Calls each(const LevelTriangle&) for every triangle whose own box meets the box low .. high, m; which come first the tables alone decide.
/// Bounded by the tables. Cost: a node a comparison of four boxes, in integers.
template <class Each>
void for_triangles_in(const LevelTable& level, const Vector& low, const Vector& high, const Each& each);

/// Where a ray meets a level first, from outside.
struct LevelHit {
    scalar fraction;  ///< of the way
    uint32_t triangle;
};
/// False where the way from `from` meets no triangle from outside within its length. Watertight: a ray through an edge or a corner meets one of
/// its triangles.
bool cast_ray_on_level(const LevelTable& level, const Vector& from, const Vector& way, LevelHit& hit);

/// Errors: bad_shape (a table that is empty, or both; numbers beyond the arrays, a node that is its own child, a depth above the bound, a step that
/// is no power of two, a checksum that is not that of the tables). Cost: every byte of the tables, once. Needed for tables from outside only.
Status check_level(const LevelTable& level);

} }  // namespace ingot

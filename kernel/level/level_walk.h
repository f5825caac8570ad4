// SPDX-License-Identifier: MIT
// Which triangles of a level are where. All in the level's frame.
//
// Whatever bytes the tables have, a walk reads what is in them and ends; only counts and places of the arrays have to be true (check_level).
#pragma once

#include "../base/status.h"
#include "level_table.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where a walk through a mesh is.
struct MeshWalk {
    int low[3], high[3];  ///< what is asked for, in steps
    int waiting;          ///< nodes on the stack
    int nodes_left;       ///< as many as there are, each once
    int leaves;           ///< of the node looked at last, that are still to be looked at
    uint16_t next[MeshNode::children], end[MeshNode::children];  ///< triangles of these leaves
    uint16_t stack[MeshTable::stack_max];
};

/// The triangle of this number, which for_triangles_in has told.
LevelTriangle triangle_of(const LevelTable& level, uint32_t number);

/// Begins a walk through what meets a box, m. False where nothing does.
bool begin_walk(const LevelTable& level, const Vector& low, const Vector& high, MeshWalk& walk);
/// The next triangle of a walk; false at its end.
bool next_triangle(const LevelTable& level, MeshWalk& walk, LevelTriangle& triangle);

/// Calls each(const LevelTriangle&) for every triangle whose own box meets the box low .. high, m; which come first the tables alone decide.
/// Nothing meets a box that is inside out, or has a NaN. Bounded by the tables. Cost: a node a comparison of four boxes, in integers.
template <class Each>
void for_triangles_in(const LevelTable& level, const Vector& low, const Vector& high, const Each& each) {
    LevelTriangle triangle;
    MeshWalk mesh;
    if (level.is_mesh() && begin_walk(level, low, high, mesh))
        while (next_triangle(level, mesh, triangle)) each(triangle);  // bound: triangles of the mesh
}

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

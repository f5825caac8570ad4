// SPDX-License-Identifier: MIT
#pragma once

#include "level_table.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where a walk through a mesh is.
struct MeshWalk {
    int low[3], high[3];                                         ///< what is asked for, in steps
    int waiting;                                                 ///< nodes on the stack
    int nodes_left;                                              ///< as many as there are, each once
    int leaves;                                                  ///< of the node looked at last, that are still to be looked at
    uint16_t next[MeshNode::children], end[MeshNode::children];  ///< triangles of these leaves
    uint16_t stack[MeshTable::stack_max];
};

/// See triangle_of.
LevelTriangle triangle_of_mesh(const LevelTable& level, uint32_t number);

/// Begins a walk through what meets a box, m. False where nothing does.
bool begin_walk(const LevelTable& level, const Vector& low, const Vector& high, MeshWalk& walk);
/// The next triangle of a walk; false at its end.
bool next_triangle(const LevelTable& level, MeshWalk& walk, LevelTriangle& triangle);

}}  // namespace ingot::INGOT_ABI

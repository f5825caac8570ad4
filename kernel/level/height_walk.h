// SPDX-License-Identifier: MIT
#pragma once

#include "height_grid.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where a walk through a field of heights is.
struct HeightWalk {
    grid::Place place;
    int least;  ///< steps: triangles below it are not met
    int half;   ///< triangle of the cell that comes next; 2: none
};

/// Least and greatest height of a block of a level from 1 on, steps.
const uint16_t* extremes_of_block(const HeightTable& heights, int level, int x, int y);

/// Corners of a triangle of a field as heights in steps: by its number. And its cell.
struct HeightTriangle {
    int column, row;    ///< of the cell
    int samples[3][2];  ///< column and row of each corner
    int heights[3];     ///< steps
};
HeightTriangle height_triangle(const HeightTable& heights, uint32_t number);

/// See triangle_of.
LevelTriangle triangle_of_heights(const LevelTable& level, uint32_t number);

/// Begins a walk through what meets a box, m: ground is solid, so what lies below the ground meets what is above it. False where nothing does.
bool begin_walk(const LevelTable& level, const Vector& low, const Vector& high, HeightWalk& walk);
/// The next triangle of a walk; false at its end.
bool next_triangle(const LevelTable& level, HeightWalk& walk, LevelTriangle& triangle);

/// Cells between low and high along an axis, m, of so many samples. False where there are none.
bool cells_between(scalar low, scalar high, scalar origin, scalar spacing, int samples, int& first, int& last);

}}  // namespace ingot::INGOT_ABI

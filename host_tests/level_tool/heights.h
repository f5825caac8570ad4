// SPDX-License-Identifier: MIT
// A grid of heights as a table.
#pragma once

#include "input.h"
#include "level_data.h"

namespace level_tool {

struct HeightPlacing {
    double step = 0;             ///< m
    double spacing[2] = {1, 1};  ///< m
    double low = 0, high = 0;    ///< m, what black and white are; the same: levels of grey are steps
    bool other_diagonal = false;
    bool in_bytes = false;
};

/// Heights in steps above the least. Cells with a corner that is a hole are holes. moved_by: steps, at most, that a sample moved to fit into a byte.
Refusal build_heights(const HeightGrid& grid, const HeightPlacing& placing, HeightData& data, int& moved_by);

}  // namespace level_tool

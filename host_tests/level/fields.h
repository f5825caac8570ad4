// SPDX-License-Identifier: MIT
// Fields of heights drawn at random.
#pragma once

#include "meshes.h"

namespace level_test {

using Field = level_tool::HeightData;

/// Heights as `height` says, by column and row; one cell of `holes` is none, where that is not 0.
template <class Height>
Field field(Random& random, int columns, int rows, bool other_diagonal, int holes, const Height& height) {
    Field made;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) made.heights.push_back(static_cast<uint16_t>(height(column, row)));
    if (holes > 0)
        for (int i = 0; i < (columns - 1) * (rows - 1); ++i)
            made.cells.push_back(between(random, 1, holes) == 1 ? ingot::HeightTable::hole : static_cast<uint8_t>(i % 255));
    made.view.heights.spacing_x = ingot::scalar(0.75);
    made.view.heights.spacing_y = ingot::scalar(1.3f);
    made.view.heights.other_diagonal = other_diagonal;
    made.view.step = ingot::scalar(1) / 256;
    made.view.origin = {ingot::scalar(-3.1f), ingot::scalar(17.7f), ingot::scalar(-2)};
    level_tool::finish_heights(made, columns, rows);
    return made;
}

/// Triangles that are there, by number.
inline std::vector<uint32_t> triangles_of(const ingot::LevelTable& level) {
    std::vector<uint32_t> numbers;
    if (level.is_mesh())
        for (uint32_t i = 0; i < level.mesh.triangle_count; ++i) numbers.push_back(i);
    const auto cells = static_cast<uint32_t>(ingot::grid::cells_of(level.heights.columns) * ingot::grid::cells_of(level.heights.rows));
    for (uint32_t i = 0; i < 2 * cells; ++i)
        if (level.heights.cells == nullptr || level.heights.cells[i / 2] != ingot::HeightTable::hole) numbers.push_back(i);
    return numbers;
}

}  // namespace level_test

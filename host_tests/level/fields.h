// SPDX-License-Identifier: MIT
// Fields of heights drawn at random.
#pragma once

#include <ingot/level/height_field_of.h>

#include "meshes.h"

namespace level_test {

/// A field with its arrays. `view` points into them.
struct Field {
    std::vector<uint16_t> heights, extremes;
    std::vector<uint8_t> cells;
    ingot::LevelTable view;

    Field() = default;
    Field(Field&&) = default;
    Field& operator=(Field&&) = default;
    Field(const Field&) = delete;
    Field& operator=(const Field&) = delete;
};

/// Heights as `height` says, by column and row; one cell of `holes` is none, where that is not 0.
template <class Height>
Field field(Random& random, int columns, int rows, bool other_diagonal, int holes, const Height& height) {
    Field made;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) made.heights.push_back(static_cast<uint16_t>(height(column, row)));
    if (holes > 0)
        for (int i = 0; i < (columns - 1) * (rows - 1); ++i)
            made.cells.push_back(between(random, 1, holes) == 1 ? ingot::HeightTable::hole : static_cast<uint8_t>(i % 255));
    made.extremes.resize(static_cast<size_t>(ingot::grid::extremes_of(columns, rows)));
    ingot::grid::fill_extremes(made.heights.data(), columns, rows, made.extremes.data());
    made.view.heights = {made.heights.data(),         made.cells.empty() ? nullptr : made.cells.data(),
                         made.extremes.data(),        static_cast<uint16_t>(columns),
                         static_cast<uint16_t>(rows), ingot::scalar(0.75),
                         ingot::scalar(1.3),          other_diagonal};
    made.view.step = ingot::scalar(1) / 256;
    made.view.origin = {ingot::scalar(-3.1), ingot::scalar(17.7), ingot::scalar(-2)};
    made.view.low = ingot::grid::low_of(made.view);
    made.view.high = ingot::grid::high_of(made.view);
    made.view.checksum = checksum_of(made.view);
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

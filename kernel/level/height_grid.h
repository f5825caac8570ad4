// SPDX-License-Identifier: MIT
// Cells of a field of heights, and the blocks above them: 8 by 8 cells, 8 by 8 of these, and so on up to one block.
#pragma once

#include "../base/limits.h"
#include "level_table.h"

namespace ingot { inline namespace INGOT_ABI { namespace grid {

inline constexpr int levels_max = 6;  ///< of blocks: 8^6 is beyond 65534 cells

/// Cells along an axis with so many samples; of none, none.
constexpr int cells_of(int samples) { return samples < 2 ? 0 : samples - 1; }

/// Blocks along an axis of so many cells; of level 0 the cells.
constexpr int blocks_of(int cells, int level) { return static_cast<int>((static_cast<int64_t>(cells) + (int64_t{1} << 3 * level) - 1) >> 3 * level); }

/// Levels of blocks, up to the one that is one block.
constexpr int levels_of(int columns, int rows) {
    int level = 1;
    while (level < levels_max && (blocks_of(cells_of(columns), level) > 1 || blocks_of(cells_of(rows), level) > 1)) ++level;  // bound: levels_max
    return level;
}

/// Blocks below this level: where its first one is in HeightTable::extremes, by two.
constexpr int64_t blocks_before(int columns, int rows, int level) {
    int64_t blocks = 0;
    for (int i = 1; i < level; ++i)  // bound: levels_max
        blocks += static_cast<int64_t>(blocks_of(cells_of(columns), i)) * blocks_of(cells_of(rows), i);
    return blocks;
}

/// Numbers in HeightTable::extremes.
constexpr int64_t extremes_of(int columns, int rows) { return 2 * blocks_before(columns, rows, levels_of(columns, rows) + 1); }

/// Blocks of bytes along an axis of so many samples.
constexpr int byte_blocks_of(int samples) { return (samples + HeightBlock::side - 1) / HeightBlock::side; }
constexpr int64_t byte_blocks_of(int columns, int rows) { return static_cast<int64_t>(byte_blocks_of(columns)) * byte_blocks_of(rows); }

/// A sample, steps: 0 .. 65535 in a table that check_level has seen; in any other no more than 24 bits.
constexpr int height_at(const HeightTable& heights, int column, int row) {
    const int64_t sample = static_cast<int64_t>(row) * heights.columns + column;
    if (heights.bytes == nullptr) return heights.heights[sample];
    const int64_t block = static_cast<int64_t>(row / HeightBlock::side) * byte_blocks_of(heights.columns) + column / HeightBlock::side;
    return heights.blocks[block].base + (heights.bytes[sample] << (heights.blocks[block].shift & 15));
}

/// Triangles have 32 bits for their number.
constexpr int64_t cells_max = int64_t{1} << 31;

/// Least and greatest height, steps.
struct Extremes {
    uint16_t least{65535}, most{};

    constexpr void hold(uint16_t low, uint16_t high) {
        least = low < least ? low : least;
        most = high > most ? high : most;
    }
};

/// Of a block, from what is a level below: samples, or blocks.
constexpr Extremes extremes_of_block(const HeightTable& heights, const uint16_t* extremes, int level, int x, int y) {
    const int columns = heights.columns, rows = heights.rows;
    const int width = blocks_of(cells_of(columns), level - 1), length = blocks_of(cells_of(rows), level - 1);
    const int64_t below = level == 1 ? 0 : 2 * blocks_before(columns, rows, level - 1);
    // Of samples both ends of the last cell are part of the block.
    const int more = level == 1 ? 1 : 0;
    const int end_x = (8 * x + 8 < width ? 8 * x + 8 : width) + more, end_y = (8 * y + 8 < length ? 8 * y + 8 : length) + more;
    Extremes found{};
    for (int j = 8 * y; j < end_y; ++j)        // bound: 9
        for (int i = 8 * x; i < end_x; ++i) {  // bound: 9
            if (level == 1) {
                const auto height = static_cast<uint16_t>(height_at(heights, i, j));
                found.hold(height, height);
            } else {
                const uint16_t* block = extremes + below + 2 * (static_cast<int64_t>(j) * width + i);
                found.hold(block[0], block[1]);
            }
        }
    return found;
}

/// Fills what HeightTable::extremes has to be.
constexpr void fill_extremes(const HeightTable& heights, uint16_t* extremes) {
    const int columns = heights.columns, rows = heights.rows;
    int64_t to = 0;
    const int levels = levels_of(columns, rows);
    for (int level = 1; level <= levels; ++level) {  // bound: levels_max
        const int width = blocks_of(cells_of(columns), level), length = blocks_of(cells_of(rows), level);
        for (int y = 0; y < length; ++y)       // bound: the field
            for (int x = 0; x < width; ++x) {  // bound: the field
                const Extremes found = extremes_of_block(heights, extremes, level, x, y);
                extremes[to++] = found.least;
                extremes[to++] = found.most;
            }
    }
}

/// The box of a field, m: of what lies on top.
constexpr Vector low_of(const LevelTable& level) {
    const uint16_t* all = level.heights.extremes + extremes_of(level.heights.columns, level.heights.rows) - 2;
    return {level.origin.x, level.origin.y, level.origin.z + level.step * static_cast<scalar>(all[0])};
}
constexpr Vector high_of(const LevelTable& level) {
    const HeightTable& heights = level.heights;
    const uint16_t* all = heights.extremes + extremes_of(heights.columns, heights.rows) - 2;
    return {level.origin.x + heights.spacing_x * static_cast<scalar>(heights.columns - 1),
            level.origin.y + heights.spacing_y * static_cast<scalar>(heights.rows - 1), level.origin.z + level.step * static_cast<scalar>(all[1])};
}

/// Spacing in which samples are apart, wherever rounding puts them.
constexpr bool is_spacing(scalar spacing, scalar origin) {
    return spacing >= limits::size_min && spacing <= limits::size_max && abs(origin) <= spacing * scalar(0.25) / epsilon;
}

/// Where a walk over a rectangle of cells is: at a block of a level, or at a cell. Blocks are visited row by row, and what is in one before the next.
struct Place {
    int first[2]{}, last[2]{};  ///< cells asked for, by axis
    int level{}, at[2]{};       ///< block of this level, or cell
    int top{};                  ///< the lowest level that has one block with all of the rectangle
    bool is_new{};              ///< not looked at yet

    /// The last block of the level, by axis, within the block above it.
    constexpr int end(int axis) const {
        const int of_rectangle = last[axis] >> 3 * level, of_block = at[axis] | 7;
        return of_rectangle < of_block ? of_rectangle : of_block;
    }
    constexpr int begin(int axis) const {
        const int of_rectangle = first[axis] >> 3 * level, of_block = at[axis] & ~7;
        return of_rectangle > of_block ? of_rectangle : of_block;
    }
    constexpr void descend() {
        --level;
        for (int axis = 0; axis < 2; ++axis) {
            const int of_rectangle = first[axis] >> 3 * level, of_block = at[axis] << 3;
            at[axis] = of_rectangle > of_block ? of_rectangle : of_block;
        }
    }
    /// On, without what is in the block. False at the end.
    constexpr bool advance() {
        is_new = true;
        for (; level < top; ++level, at[0] >>= 3, at[1] >>= 3) {  // bound: levels_max
            if (at[0] < end(0)) {
                ++at[0];
                return true;
            }
            if (at[1] < end(1)) {
                at[0] = begin(0);
                ++at[1];
                return true;
            }
        }
        return false;
    }
};

/// The walk over a rectangle that is not empty.
constexpr Place place_over(int first_x, int last_x, int first_y, int last_y) {
    Place place{{first_x, first_y}, {last_x, last_y}};
    // bound: levels_max: cells are below 8^6
    while (place.first[0] >> 3 * place.top != place.last[0] >> 3 * place.top || place.first[1] >> 3 * place.top != place.last[1] >> 3 * place.top)
        ++place.top;
    place.level = place.top;
    place.at[0] = first_x >> 3 * place.top;
    place.at[1] = first_y >> 3 * place.top;
    place.is_new = true;
    return place;
}

}}}  // namespace ingot::INGOT_ABI::grid

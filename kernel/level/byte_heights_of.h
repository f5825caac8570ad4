// SPDX-License-Identifier: MIT
// A field of heights in bytes as a table, by the compiler: half the flash. Blocks of 16 by 16 samples have a least height and steps of their own.
//
//     static constexpr auto hill = ingot::byte_heights_of<3, 2>(heights, 1, 1, ingot::scalar(1) / 64);
//     static_assert(hill.ok() && hill.value.furthest == 0);                                  // no sample was moved
//     static constexpr ingot::LevelTable levels[] = {hill.value.view()};
#pragma once

#include "height_field_of.h"

namespace ingot { inline namespace INGOT_ABI {

namespace grid {

/// The least shift with which the heights of a block, from its least to its greatest, fit into a byte.
constexpr int shift_of(int range) {
    int shift = 0;
    while ((range + ((1 << shift) >> 1)) >> shift > 255) ++shift;  // bound: HeightBlock::shift_max: 65535 + 256 is below 512 times 256
    return shift;
}

/// The byte that is nearest to a height, and no more than 16 bits hold.
constexpr uint8_t nearest_byte(int height, const HeightBlock& block) {
    const int byte = (height - block.base + ((1 << block.shift) >> 1)) >> block.shift;
    return static_cast<uint8_t>(block.base + (byte << block.shift) > lattice::last ? byte - 1 : byte);
}

/// Fills HeightTable::bytes and blocks. Returns: by how many steps a sample was moved at most; 0 where no block is higher than 255 steps.
constexpr int fill_bytes(const uint16_t* heights, int columns, int rows, uint8_t* bytes, HeightBlock* blocks) {
    constexpr int side = HeightBlock::side;
    int furthest = 0;
    const int width = byte_blocks_of(columns);
    for (int y = 0; y < byte_blocks_of(rows); ++y)  // bound: the field
        for (int x = 0; x < width; ++x) {           // bound: the field
            const int end_x = side * x + side < columns ? side * x + side : columns, end_y = side * y + side < rows ? side * y + side : rows;
            Extremes found{};
            for (int j = side * y; j < end_y; ++j)      // bound: HeightBlock::side
                for (int i = side * x; i < end_x; ++i)  // bound: HeightBlock::side
                    found.hold(heights[static_cast<int64_t>(j) * columns + i], heights[static_cast<int64_t>(j) * columns + i]);
            HeightBlock& block = blocks[static_cast<int64_t>(y) * width + x];
            block = {found.least, static_cast<uint8_t>(shift_of(found.most - found.least)), 0};
            for (int j = side * y; j < end_y; ++j)        // bound: HeightBlock::side
                for (int i = side * x; i < end_x; ++i) {  // bound: HeightBlock::side
                    const int64_t sample = static_cast<int64_t>(j) * columns + i;
                    bytes[sample] = nearest_byte(heights[sample], block);
                    const int moved = block.base + (bytes[sample] << block.shift) - heights[sample];
                    furthest = moved > furthest ? moved : -moved > furthest ? -moved : furthest;
                }
        }
    return furthest;
}

}  // namespace grid

/// A field of heights in bytes, with all that it points to but its cells.
template <unsigned columns, unsigned rows>
struct ByteHeightsOf {
    static constexpr auto block_count = static_cast<unsigned>(grid::byte_blocks_of(static_cast<int>(columns), static_cast<int>(rows)));
    HeightFieldOf<columns, rows> field{};  ///< its frame and its extremes; no samples
    uint8_t bytes[columns * rows]{};       ///< see HeightTable
    HeightBlock blocks[block_count]{};     ///< see HeightTable
    int furthest{};                        ///< steps: what a sample was moved by, at most

    /// As HeightFieldOf::view: it points here.
    constexpr LevelTable view() const {
        LevelTable level = field.view();
        level.heights.bytes = bytes;
        level.heights.blocks = blocks;
        return level;
    }
};

/// The table of a field of heights in bytes. Where a block of 16 by 16 samples is higher than 255 steps it has steps twice, four times ... as large,
/// up to 512 times, and each sample moves to the nearest: `furthest` tells how far. Neighbours share their samples, so nothing gapes.
///
/// Units, errors: as height_field_of; the samples need not stay.
/// Cost:          none at run time where all of it is constant. A field takes 1.08 bytes a sample, and one more with materials or holes.
template <unsigned columns, unsigned rows, unsigned samples>
constexpr Result<ByteHeightsOf<columns, rows>> byte_heights_of(const uint16_t (&heights)[samples], scalar spacing_x, scalar spacing_y, scalar step,
                                                               const HeightFieldOptions& options = {}) {
    const Result<HeightFieldOf<columns, rows>> field = height_field_of<columns, rows>(heights, spacing_x, spacing_y, step, options);
    Result<ByteHeightsOf<columns, rows>> result{};
    result.status = field.status;
    if (!result.ok()) return result;
    ByteHeightsOf<columns, rows>& made = result.value;
    made.furthest = grid::fill_bytes(heights, static_cast<int>(columns), static_cast<int>(rows), made.bytes, made.blocks);
    made.field = field.value;
    made.field.heights = nullptr;
    grid::fill_extremes(made.view().heights, made.field.extremes);
    made.field.checksum = checksum_of(made.view());
    return result;
}

}}  // namespace ingot::INGOT_ABI

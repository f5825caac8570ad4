// SPDX-License-Identifier: MIT
// A field of heights as a table, by the compiler.
//
//     static constexpr uint16_t heights[] = {0, 4, 8, 4, 0, 4};                                // 3 columns, 2 rows, in steps
//     static constexpr auto hill = ingot::height_field_of<3, 2>(heights, 1, 1, ingot::scalar(1) / 64);
//     static_assert(hill.ok());
//     static constexpr ingot::LevelTable levels[] = {hill.value.view()};
#pragma once

#include "../base/status.h"
#include "lattice.h"
#include "level_checksum.h"

namespace ingot { inline namespace INGOT_ABI {

/// A field over samples that are elsewhere: what it has of its own is their extremes.
template <unsigned columns, unsigned rows>
struct HeightFieldOf {
    static constexpr auto extreme_count = static_cast<unsigned>(grid::extremes_of(static_cast<int>(columns), static_cast<int>(rows)));
    const uint16_t* heights{};           ///< see HeightTable
    const uint8_t* cells{};              ///< see HeightTable
    uint16_t extremes[extreme_count]{};  ///< see HeightTable
    scalar spacing_x{}, spacing_y{};     ///< m, see HeightTable
    bool other_diagonal{};               ///< see HeightTable
    Vector origin{};                     ///< m, see LevelTable
    scalar step{};                       ///< m, see LevelTable
    uint32_t checksum{};                 ///< see LevelTable

    /// What LevelTables and the calls of level_walk.h take: it points here, and to the samples.
    constexpr LevelTable view() const {
        LevelTable level{};
        level.heights.heights = heights;
        level.heights.cells = cells;
        level.heights.extremes = extremes;
        level.heights.columns = static_cast<uint16_t>(columns);
        level.heights.rows = static_cast<uint16_t>(rows);
        level.heights.spacing_x = spacing_x;
        level.heights.spacing_y = spacing_y;
        level.heights.other_diagonal = other_diagonal;
        level.origin = origin;
        level.step = step;
        level.low = grid::low_of(level);
        level.high = grid::high_of(level);
        level.checksum = checksum;
        return level;
    }
};

/// What fields have beside their samples.
struct HeightFieldOptions {
    const uint8_t* cells{};  ///< a material for each cell, or HeightTable::hole; null: all 0
    bool other_diagonal{};   ///< see HeightTable
    Vector origin{};         ///< m, where the first sample is, of height 0; z a multiple of the step
};

namespace grid {

/// Whether a field may stand so: Status::ok, or what height_field_of answers.
constexpr Status check_placing(scalar spacing_x, scalar spacing_y, scalar step, const Vector& origin) {
    if (!is_finite(origin) || !is_finite(spacing_x) || !is_finite(spacing_y) || !is_finite(step)) return Status::not_finite;
    if (!lattice::is_step(step) || !lattice::is_origin(origin.z, step)) return Status::out_of_range;
    return is_spacing(spacing_x, origin.x) && is_spacing(spacing_y, origin.y) ? Status::ok : Status::out_of_range;
}

}  // namespace grid

/// The table of a field of heights. Samples, and cells, have static storage: the table points to them.
///
/// Units:   m; heights in steps, a power of two.
/// Errors:  not_finite, out_of_range (a step that is no power of two from 2^-20 to 2^20, a spacing beyond limits::size_min .. size_max, an origin
///          further away than 2^21 spacings or 2^23 steps, of double 2^50 and 2^52, or whose height is no multiple of the step).
/// Cost:    none at run time where all of it is constant. A field takes 2.07 bytes a sample, and one more with materials or holes; half of it by
///          byte_heights_of.h.
template <unsigned columns, unsigned rows, unsigned samples>
constexpr Result<HeightFieldOf<columns, rows>> height_field_of(const uint16_t (&heights)[samples], scalar spacing_x, scalar spacing_y, scalar step,
                                                               const HeightFieldOptions& options = {}) {
    static_assert(columns >= 2 && columns <= 65535 && rows >= 2 && rows <= 65535, "a field of heights has 2 to 65535 columns and rows");
    static_assert(samples == columns * rows, "a field of heights has a height for each column of each row");
    Result<HeightFieldOf<columns, rows>> result{};
    result.status = grid::check_placing(spacing_x, spacing_y, step, options.origin);
    if (!result.ok()) return result;
    HeightFieldOf<columns, rows>& field = result.value;
    field.heights = heights;
    field.cells = options.cells;
    field.spacing_x = spacing_x;
    field.spacing_y = spacing_y;
    field.other_diagonal = options.other_diagonal;
    field.origin = options.origin;
    field.step = step;
    grid::fill_extremes(field.view().heights, field.extremes);
    field.checksum = checksum_of(field.view());
    return result;
}

}}  // namespace ingot::INGOT_ABI

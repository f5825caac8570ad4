// SPDX-License-Identifier: MIT
#include "heights.h"

#include <cmath>

namespace level_tool {

namespace {

/// Heights in steps from that of the frame. A hole has the height of the sample before it, which makes no block higher.
Refusal in_steps(const HeightGrid& grid, const HeightPlacing& placing, std::vector<int64_t>& steps) {
    const bool has_range = grid.most > 0 && placing.low != placing.high;
    const double unit = has_range ? (placing.high - placing.low) / grid.most : grid.most > 0 ? placing.step : 1;
    int64_t before = 0;
    bool has_before = false;
    for (size_t i = 0; i < grid.heights.size(); ++i) {
        if (!grid.is_hole[i]) {
            const double height = std::floor(((has_range ? placing.low : 0) + grid.heights[i] * unit) / placing.step + 0.5);
            if (!(std::abs(height) <= 8388608))
                return "height " + std::to_string(i + 1) + " is further than 2^23 steps from 0: choose a larger --step";
            before = static_cast<int64_t>(height);
            if (!has_before) std::fill(steps.begin(), steps.end(), before);
            has_before = true;
        }
        steps.push_back(before);
    }
    return has_before ? "" : "there is no height in it";
}

}  // namespace

Refusal build_heights(const HeightGrid& grid, const HeightPlacing& placing, HeightData& data, int& moved_by) {
    std::vector<int64_t> steps;
    const Refusal refusal = in_steps(grid, placing, steps);
    if (!refusal.empty()) return refusal;
    const auto [least, most] = std::minmax_element(steps.begin(), steps.end());
    const int64_t base = *least;
    if (*most - base > ingot::lattice::last)
        return "it is " + std::to_string(*most - base) + " steps high, a field is up to 65535: choose --step " +
               std::to_string(std::exp2(std::ceil(std::log2(placing.step * static_cast<double>(*most - base) / 65535)))) + " or more";
    data = {};
    for (const int64_t height : steps) data.heights.push_back(static_cast<uint16_t>(height - base));
    const auto columns = static_cast<size_t>(grid.columns);
    const auto hole_at = [&](size_t column, size_t row) { return grid.is_hole[row * columns + column]; };
    if (std::find(grid.is_hole.begin(), grid.is_hole.end(), true) != grid.is_hole.end())
        for (size_t row = 0; row + 1 < static_cast<size_t>(grid.rows); ++row)
            for (size_t column = 0; column + 1 < columns; ++column)
                data.cells.push_back(hole_at(column, row) || hole_at(column + 1, row) || hole_at(column, row + 1) || hole_at(column + 1, row + 1)
                                         ? ingot::HeightTable::hole
                                         : uint8_t{0});
    data.view.step = static_cast<ingot::scalar>(placing.step);
    data.view.origin = {0, 0, static_cast<ingot::scalar>(static_cast<double>(base) * placing.step)};
    // Of float, so that the table is the same for both scalars.
    data.view.heights.spacing_x = static_cast<ingot::scalar>(static_cast<float>(placing.spacing[0]));
    data.view.heights.spacing_y = static_cast<ingot::scalar>(static_cast<float>(placing.spacing[1]));
    data.view.heights.other_diagonal = placing.other_diagonal;
    moved_by = placing.in_bytes ? put_into_bytes(data, grid.columns, grid.rows) : 0;
    finish_heights(data, grid.columns, grid.rows);
    return "";
}

}  // namespace level_tool

// SPDX-License-Identifier: MIT
#include "height_walk.h"

#include "lattice_steps.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

using grid::height_at;

int64_t cell_number(const HeightTable& heights, int column, int row) { return static_cast<int64_t>(row) * grid::cells_of(heights.columns) + column; }

/// What the cell has: its material, or that it is a hole.
uint8_t cell_at(const HeightTable& heights, int column, int row) {
    return heights.cells == nullptr ? uint8_t{0} : heights.cells[cell_number(heights, column, row)];
}

bool is_ground(const HeightTable& heights, int column, int row) {
    return column >= 0 && row >= 0 && column < grid::cells_of(heights.columns) && row < grid::cells_of(heights.rows) &&
           cell_at(heights, column, row) != HeightTable::hole;
}

/// By how much the far corners of both triangles at an edge rise above it, in steps: in integers, so what is flat is flat.
EdgeKind kind_of_fold(int rise) { return rise < 0 ? EdgeKind::convex : rise > 0 ? EdgeKind::concave : EdgeKind::flat; }

/// Of the edge along x that begins at this sample, between the cells (column, row - 1) and (column, row).
EdgeKind kind_along_x(const HeightTable& h, int column, int row) {
    if (!is_ground(h, column, row - 1) || !is_ground(h, column, row)) return EdgeKind::border;
    const int above = h.other_diagonal ? column : column + 1, below = h.other_diagonal ? column + 1 : column;
    return kind_of_fold(height_at(h, above, row + 1) - height_at(h, above, row) + height_at(h, below, row - 1) - height_at(h, below, row));
}

/// Of the edge along y that begins at this sample, between the cells (column - 1, row) and (column, row).
EdgeKind kind_along_y(const HeightTable& h, int column, int row) {
    if (!is_ground(h, column - 1, row) || !is_ground(h, column, row)) return EdgeKind::border;
    const int right = h.other_diagonal ? row : row + 1, left = h.other_diagonal ? row + 1 : row;
    return kind_of_fold(height_at(h, column + 1, right) - height_at(h, column, right) + height_at(h, column - 1, left) - height_at(h, column, left));
}

EdgeKind kind_of_diagonal(const HeightTable& h, int column, int row) {
    const int rise = height_at(h, column + 1, row) + height_at(h, column, row + 1) - height_at(h, column, row) - height_at(h, column + 1, row + 1);
    return kind_of_fold(h.other_diagonal ? -rise : rise);
}

/// Where the corners of both triangles of a cell are, by x and y.
constexpr uint8_t corner_places[2][2][3][2] = {{{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}},
                                               {{{0, 0}, {1, 0}, {0, 1}}, {{1, 0}, {1, 1}, {0, 1}}}};

uint8_t edges_of(const HeightTable& h, int column, int row, bool second) {
    const EdgeKind diagonal = kind_of_diagonal(h, column, row);
    const EdgeKind along_x = kind_along_x(h, column, second ? row + 1 : row);
    const bool is_right = second == h.other_diagonal;
    const EdgeKind along_y = kind_along_y(h, is_right ? column + 1 : column, row);
    // In the order of corner_places.
    const EdgeKind kinds[4][3] = {
        {along_x, along_y, diagonal}, {diagonal, along_x, along_y}, {along_x, diagonal, along_y}, {along_y, along_x, diagonal}};
    const EdgeKind(&of)[3] = kinds[(h.other_diagonal ? 2 : 0) + (second ? 1 : 0)];
    return static_cast<uint8_t>(static_cast<int>(of[0]) | static_cast<int>(of[1]) << 2 | static_cast<int>(of[2]) << 4);
}

/// The triangle in the lattice, with what the level knows of it.
LevelTriangle with_corners(const LevelTable& level, uint32_t number, const HeightTriangle& stored) {
    const HeightTable& heights = level.heights;
    LevelTriangle triangle{};
    triangle.number = number;
    for (int i = 0; i < 3; ++i)
        triangle.corners[i] = {corner_along(level.origin.x, heights.spacing_x, stored.samples[i][0]),
                               corner_along(level.origin.y, heights.spacing_y, stored.samples[i][1]),
                               corner_along(level.origin.z, level.step, stored.heights[i])};
    triangle.edges = edges_of(heights, stored.column, stored.row, number % 2 != 0);
    triangle.material = cell_at(heights, stored.column, stored.row);
    return triangle;
}

}  // namespace

const uint16_t* extremes_of_block(const HeightTable& heights, int level, int x, int y) {
    const int width = grid::blocks_of(grid::cells_of(heights.columns), level);
    return heights.extremes + 2 * (grid::blocks_before(heights.columns, heights.rows, level) + static_cast<int64_t>(y) * width + x);
}

HeightTriangle height_triangle(const HeightTable& heights, uint32_t number) {
    const auto width = static_cast<uint32_t>(grid::cells_of(heights.columns));
    const uint32_t cell = number / 2;
    HeightTriangle triangle{static_cast<int>(cell % width), static_cast<int>(cell / width), {}, {}};
    for (int i = 0; i < 3; ++i) {
        const uint8_t(&at)[2] = corner_places[heights.other_diagonal ? 1 : 0][number % 2][i];
        triangle.samples[i][0] = triangle.column + at[0];
        triangle.samples[i][1] = triangle.row + at[1];
        triangle.heights[i] = height_at(heights, triangle.samples[i][0], triangle.samples[i][1]);
    }
    return triangle;
}

LevelTriangle triangle_of_heights(const LevelTable& level, uint32_t number) {
    const HeightTable& heights = level.heights;
    if (number / 2 < static_cast<int64_t>(grid::cells_of(heights.columns)) * grid::cells_of(heights.rows))
        return with_corners(level, number, height_triangle(heights, number));
    LevelTriangle none{};
    none.number = number;
    return none;
}

bool cells_between(scalar low, scalar high, scalar origin, scalar spacing, int samples, int& first, int& last) {
    const scalar inv_spacing = 1 / spacing;
    // Samples lie where their sums are rounded to, so the quotient may be one off to either side.
    first = first_step_from(low, origin, spacing, inv_spacing);
    if (first > 0 && corner_along(origin, spacing, first - 1) >= low)
        --first;
    else if (corner_along(origin, spacing, first) < low)
        ++first;
    last = last_step_to(high, origin, spacing, inv_spacing);
    if (last >= 0 && last < 65535 && corner_along(origin, spacing, last + 1) <= high)
        ++last;
    else if (last >= 0 && corner_along(origin, spacing, last) > high)
        --last;
    if (first >= samples || last < 0) return false;
    first = first == 0 ? 0 : first - 1;  // the cell that ends at this sample
    last = last < samples - 1 ? last : samples - 2;
    return first <= last;
}

bool begin_walk(const LevelTable& level, const Vector& low, const Vector& high, HeightWalk& walk) {
    const HeightTable& heights = level.heights;
    if (!(low.x <= high.x && low.y <= high.y && low.z <= high.z) || heights.columns < 2 || heights.rows < 2) return false;
    int first[2] = {}, last[2] = {};
    if (!cells_between(low.x, high.x, level.origin.x, heights.spacing_x, heights.columns, first[0], last[0]) ||
        !cells_between(low.y, high.y, level.origin.y, heights.spacing_y, heights.rows, first[1], last[1]))
        return false;
    walk.least = first_step_from(low.z, level.origin.z, level.step, 1 / level.step);
    walk.place = grid::place_over(first[0], last[0], first[1], last[1]);
    walk.half = 2;
    return true;
}

bool next_triangle(const LevelTable& level, HeightWalk& walk, LevelTriangle& triangle) {
    const HeightTable& heights = level.heights;
    grid::Place& place = walk.place;
    // bound: blocks and triangles of the field: each turn takes one away
    while (true) {
        if (place.is_new) {
            place.is_new = false;
            if (place.level > 0) {
                if (extremes_of_block(heights, place.level, place.at[0], place.at[1])[1] >= walk.least) {
                    place.descend();
                    place.is_new = true;
                    continue;
                }
            } else {
                walk.half = is_ground(heights, place.at[0], place.at[1]) ? 0 : 2;
            }
        }
        if (place.level == 0 && walk.half < 2) {
            const auto number = static_cast<uint32_t>(2 * cell_number(heights, place.at[0], place.at[1]) + walk.half++);
            const HeightTriangle candidate = height_triangle(heights, number);
            if (candidate.heights[0] < walk.least && candidate.heights[1] < walk.least && candidate.heights[2] < walk.least) continue;
            triangle = with_corners(level, number, candidate);
            return true;
        }
        if (!place.advance()) return false;
    }
}

}}  // namespace ingot::INGOT_ABI

// SPDX-License-Identifier: MIT
// Shapes as lines: a wireframe is a list that is nowhere in memory. How many lines there are, and the line of a number.
#pragma once

#include "../shape/placed_shape.h"

namespace ingot { inline namespace INGOT_ABI {

/// From a to b, m, world.
struct Line {
    Vector a{}, b{};  ///< m, world: an end
};

inline constexpr int lines_of_circle = 16;  ///< chords; they miss the circle by 2 % of its radius
inline constexpr int lines_of_half_space = 22;  ///< a net of ten by ten cells
inline constexpr int lines_of_box = 12;
/// The most that a shape has, which is a capsule; a hull has as many as edges, up to 255.
inline constexpr int lines_of_capsule = 4 * lines_of_circle + 4;

/// Lines of a shape; 0 for none.
int line_count(const PlacedShape& shape);

/// One of them, 0 <= line_i < line_count(shape). Ends lie on the surface, to rounding.
///
/// cell: m, of the net that stands for a half space, which is endless; its middle is where the normal through the origin of the shape's frame meets
///       the face.
/// Cost: about 60 flops.
Line line_of(const PlacedShape& shape, int line_i, scalar cell);

/// An edge of a box along the world axes, 0 <= line_i < lines_of_box.
Line line_of_bounds(const Vector& low, const Vector& high, int line_i);

} }  // namespace ingot

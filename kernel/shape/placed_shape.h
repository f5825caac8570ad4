// SPDX-License-Identifier: MIT
#pragma once

#include "../math/mat3.h"
#include "convex_hull.h"
#include "shapes.h"

namespace ingot { inline namespace INGOT_ABI {

/// A shape and where it is, as the narrow phase and the queries take it.
struct PlacedShape {
    Shape shape{};  ///< in its own frame
    Vector r{};              ///< m, world position of the origin of the shape's own frame
    Matrix A = identity_matrix<scalar>();  ///< shape to world, orthonormal
    const ConvexHull* hull = nullptr;  ///< for ShapeKind::hull; else null
};

} }  // namespace ingot

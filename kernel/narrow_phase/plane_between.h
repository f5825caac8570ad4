// SPDX-License-Identifier: MIT
#pragma once

#include "nearest_points.h"

namespace ingot { inline namespace INGOT_ABI {

/// A plane between two shapes: unit normal from B to A, and how far they are apart along it.
struct PlaneBetween {
    Vector n;
    scalar gap;
};

/// The plane of the nearest points. As shapes come near, the rounding of those points turns it by epsilon size / distance; planes of
/// faces and of crossed edges have no such loss, and often are the ones.
/// Needs: shapes that are apart, and what closest_points says of them.
PlaneBetween plane_between(const PlacedShape& A, const PlacedShape& B, const Nearest& nearest);

/// How far two shapes are apart along n (unit, from B to A), m; negative where they overlap along it. B may be a half space: then n is its normal.
scalar gap_along(const PlacedShape& A, const PlacedShape& B, const Vector& n);

/// The plane across n (unit, from B to A) of shapes that may overlap, or a better one, of any of their faces or of edges: with a negative gap where
/// they do. Cost: a pair of supports for each face.
PlaneBetween plane_along(const PlacedShape& A, const PlacedShape& B, const Vector& n);

} }  // namespace ingot

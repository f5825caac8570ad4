// SPDX-License-Identifier: MIT
// Supports of convex shapes, and the nearest points of two of them.
#pragma once

#include "../shape/placed_shape.h"

namespace ingot { inline namespace INGOT_ABI {

// A shape is a core and a radius about it: a ball is a point, a capsule a stretch of a line, the others are their own core.

/// Radius about the core, m.
INGOT_INLINE scalar core_radius(const PlacedShape& s) {
    return s.shape.kind == ShapeKind::sphere || s.shape.kind == ShapeKind::capsule ? s.shape.size.x : scalar(0);
}

/// The point of the core that is furthest along the direction (of any length but zero), in the shape's own frame.
Vector core_support(const PlacedShape& s, const Vector& direction_body);

/// The point of the shape furthest along the unit vector n. Not for half spaces.
/// Frames: world. Units: m. Where several are furthest, always the same one.
Vector support_point(const PlacedShape& s, const Vector& n);

/// How far two shapes are apart, and where they are nearest.
struct Nearest {
    scalar distance;  ///< m, between the surfaces; 0 where they overlap
    Vector n;         ///< unit, from B to A; where cores overlap: zero
    Vector P_A, P_B;  ///< m, world, on the surfaces; where they overlap: somewhere inside both
    bool overlap;     ///< they touch or overlap, to a few roundings of their sizes
    scalar at_least;  ///< m; the distance is proven to be no less: A and B have a plane and this much between them
};

/// The nearest points of two convex shapes; one may be a half space.
///
/// Accuracy: limits::nearest_accuracy of the distance, and a few roundings of the sizes. Overlap has no depth here: the
///           collide_* routines have it.
/// Cost:     two supports and about 100 flops an iteration; 3 to 6 of them for polyhedra, at most
///           limits::nearest_iterations_max. Stops early where the distance is seen to exceed `enough`.
/// Source:   Gilbert, Johnson, Keerthi, "A fast procedure for computing the distance between complex objects in
///           three-dimensional space", 1988; van den Bergen, "A fast and robust GJK implementation", 1999.
Nearest closest_points(const PlacedShape& A, const PlacedShape& B, scalar enough = scalar_max);

/// True where they touch or overlap.
bool overlap(const PlacedShape& A, const PlacedShape& B);

/// The same for the cores alone: what collide_* is made of.
///
/// known_gap: m, how far they are apart along some direction, where the caller has found one. Corners of long thin shapes are all but in a
/// plane, rounding then turns inside and outside round, and what is apart by 200 roundings of its length may look enclosed (a rod of 15 m, 2
/// cm thick, 0.4 mm away).
Nearest nearest_cores(const PlacedShape& A, const PlacedShape& B, scalar enough, scalar known_gap = 0);

} }  // namespace ingot

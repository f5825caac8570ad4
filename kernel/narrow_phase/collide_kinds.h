// SPDX-License-Identifier: MIT
// Which routine is for which two shapes. The only file that names the routines of the narrow phase.
#pragma once

#include "collide_pairs.h"

namespace ingot { inline namespace INGOT_ABI {

/// The routine for the two shapes; A has the kind that comes first. Only the routines of shapes that the scene names are linked.
/// False for a pair that has none. before: of the last step, or null. knows_balls: false where two balls never come to it.
template <class Shapes, bool knows_balls = true>
bool collide_pair(const PlacedShape& A, const PlacedShape& B, const Margin& margin, Manifold& manifold, const Manifold* before) {
#define INGOT_PAIR(a, b)                                                             \
    if constexpr (Shapes::has(ShapeKind::a) && Shapes::has(ShapeKind::b))            \
        if (A.shape.kind == ShapeKind::a && B.shape.kind == ShapeKind::b) return collide_##a##_##b(A, B, margin, manifold, before), true
    if constexpr (knows_balls) INGOT_PAIR(sphere, sphere);
    INGOT_PAIR(sphere, capsule);
    INGOT_PAIR(sphere, box);
    INGOT_PAIR(sphere, cylinder);
    INGOT_PAIR(sphere, hull);
    INGOT_PAIR(sphere, half_space);
    INGOT_PAIR(capsule, capsule);
    INGOT_PAIR(capsule, box);
    INGOT_PAIR(capsule, cylinder);
    INGOT_PAIR(capsule, hull);
    INGOT_PAIR(capsule, half_space);
    INGOT_PAIR(box, box);
    INGOT_PAIR(box, cylinder);
    INGOT_PAIR(box, hull);
    INGOT_PAIR(box, half_space);
    INGOT_PAIR(cylinder, cylinder);
    INGOT_PAIR(cylinder, hull);
    INGOT_PAIR(cylinder, half_space);
    INGOT_PAIR(hull, hull);
    INGOT_PAIR(hull, half_space);
#undef INGOT_PAIR
    return false;
}

/// The same for any shape of the scene, and a half space, whether the scene names it or not.
template <class Shapes>
bool collide_with_half_space(const PlacedShape& A, const PlacedShape& half_space, const Margin& margin, Manifold& manifold, const Manifold* before) {
    if constexpr (Shapes::has(ShapeKind::sphere))
        if (A.shape.kind == ShapeKind::sphere) return collide_sphere_half_space(A, half_space, margin, manifold, before), true;
    if constexpr (Shapes::has(ShapeKind::capsule))
        if (A.shape.kind == ShapeKind::capsule) return collide_capsule_half_space(A, half_space, margin, manifold, before), true;
    if constexpr (Shapes::has(ShapeKind::box))
        if (A.shape.kind == ShapeKind::box) return collide_box_half_space(A, half_space, margin, manifold, before), true;
    if constexpr (Shapes::has(ShapeKind::cylinder))
        if (A.shape.kind == ShapeKind::cylinder) return collide_cylinder_half_space(A, half_space, margin, manifold, before), true;
    if constexpr (Shapes::has(ShapeKind::hull))
        if (A.shape.kind == ShapeKind::hull) return collide_hull_half_space(A, half_space, margin, manifold, before), true;
    return false;
}

/// Two shapes of the scene, and no points for a pair that has no routine.
template <class Shapes, bool knows_balls = true>
bool collide_shapes(const PlacedShape& A, const PlacedShape& B, const Margin& margin, Manifold& manifold, const Manifold& before) {
    manifold.n = {};
    manifold.count = 0;
    return collide_pair<Shapes, knows_balls>(A, B, margin, manifold, &before);
}

} }  // namespace ingot

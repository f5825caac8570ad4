// SPDX-License-Identifier: MIT
#pragma once

#include "cast_ray.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where a shape that moves without turning meets another.
struct ShapeEntry {
    bool meets;
    scalar fraction;  ///< of the way
    Vector P, n;      ///< on B; from B to the moving shape
};

/// Conservative advancement: the nearest points give a plane between the shapes, and the way to that plane can be gone at once. The
/// distance of convex shapes is a convex function of the way, so this is Newton's method on it from the one side, and never too far.
///
/// Ends with a gap of limits::cast_gap of the smaller shape, and the roundings of the positions. After limits::cast_iterations_max
/// (a way that all but grazes) it is taken for met where it is: too early, never too late.
/// Needs: `moving` no half space. Frames: world. Source: Mirtich, "Impulse-based dynamic simulation", 1996, 2.3.
ShapeEntry cast_on_shape(const PlacedShape& moving, const Vector& way, const PlacedShape& B, scalar fraction_max);

/// See level_queries.h.
ShapeEntry cast_on_level(const PlacedShape& moving, const Vector& way, const PlacedShape& level, const LevelTable& table, scalar fraction_max);

template <class Shapes>
ShapeEntry cast_on_placed(const PlacedShape& moving, const Vector& way, const PlacedShape& B, scalar fraction_max) {
    if constexpr (Shapes::has(ShapeKind::level))
        if (B.shape.kind == ShapeKind::level) return cast_on_level(moving, way, B, *Shapes::level_of(B.shape), fraction_max);
    return cast_on_shape(moving, way, B, fraction_max);
}

/// Where a moving shape meets that of a slot, no further than fraction_max.
template <class Shapes>
bool cast_shape_on_slot(const EveryShape& all, const PlacedShape& moving, const Vector& way, int slot, scalar fraction_max, SlotHit& hit) {
    const ShapeEntry entry = cast_on_placed<Shapes>(moving, way, placed_body<Shapes>(all.bodies, all.surfaces, slot), fraction_max);
    if (entry.meets) hit = {slot, entry.fraction, entry.P, entry.n};
    return entry.meets;
}

/// The body that a moving shape meets first; see cast_ray.
template <class Shapes, class All, class Sees>
SlotHit cast_shape(const All& all, const PlacedShape& moving, const Vector& way, const Sees& sees) {
    MovingBall ball = {moving.r, way, bounding_radius(moving.shape), 1, &moving};
    SlotHit hit = {no_slot, 1, moving.r + way, {}};
    look_along(all, ball, [&](int slot) {
        SlotHit of_slot;
        if (!sees(slot) || !cast_shape_on_slot<Shapes>(all, moving, way, slot, ball.fraction, of_slot)) return;
        if (hit.slot != no_slot && !is_before(of_slot.fraction, slot, hit.fraction, hit.slot)) return;
        hit = of_slot;
        ball.fraction = hit.fraction;
    });
    return hit;
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "../level/level_table.h"
#include "query_filter.h"
#include "ray_on_shapes.h"
#include "shapes_of_tree.h"

namespace ingot { inline namespace INGOT_ABI {

/// What a query finds, by slot.
struct SlotHit {
    int slot;  ///< no_slot: nothing
    scalar fraction;
    Vector P, n;
};

/// Whether the one is met before the other: of two at the same place the one of the lower slot, in whatever order they are looked at.
INGOT_INLINE bool is_before(const scalar& at, int slot, const scalar& other_at, int other_slot) {
    return at < other_at || (at == other_at && slot < other_slot);
}

/// See level_queries.h.
RayEntry ray_on_level(const LevelTable& level, const LocalRay& ray);

/// The routine for a shape; only those of shapes that the scene names are linked.
template <class Shapes>
RayEntry ray_on_shape(const PlacedShape& s, const LocalRay& ray) {
#define INGOT_RAY(name)                              \
    if constexpr (Shapes::has(ShapeKind::name))      \
        if (s.shape.kind == ShapeKind::name) return ray_on_##name(s.shape, ray)
    INGOT_RAY(sphere);
    INGOT_RAY(capsule);
    INGOT_RAY(box);
    INGOT_RAY(cylinder);
    INGOT_RAY(half_space);
#undef INGOT_RAY
    if constexpr (Shapes::has(ShapeKind::hull))
        if (s.shape.kind == ShapeKind::hull && s.hull != nullptr) return ray_on_hull(*s.hull, ray);
    return {false, 1, {}};
}

/// The same of levels, whose tables the scene has.
template <class Shapes>
RayEntry ray_on_placed(const PlacedShape& s, const LocalRay& ray) {
    if constexpr (Shapes::has(ShapeKind::level))
        if (s.shape.kind == ShapeKind::level) return ray_on_level(*Shapes::level_of(s.shape), ray);
    return ray_on_shape<Shapes>(s, ray);
}

/// Where a ray enters the shape of a slot.
template <class Shapes>
bool cast_ray_on_slot(const EveryShape& all, const Vector& from, const Vector& way, int slot, SlotHit& hit) {
    const PlacedShape body = placed_body<Shapes>(all.bodies, all.surfaces, slot);
    const RayEntry entry = ray_on_placed<Shapes>(body, {transpose_times(body.A, from - body.r), transpose_times(body.A, way)});
    if (!entry.meets) return false;
    const Vector n = length_sq(entry.n) > 0 ? body.A * entry.n : way * (-1 / sqrt(length_sq(way)));
    hit = {slot, entry.fraction, from + way * entry.fraction, n};
    return true;
}

/// The body that a ray enters first; of bodies it enters at the same place, that of the lowest slot.
///
/// all: an EveryShape, or ShapesOfTree. from, way: m, world. sees(slot): which bodies count. A ray that begins inside a body meets it at once, its n
/// against the way.
template <class Shapes, class All, class Sees>
SlotHit cast_ray(const All& all, const Vector& from, const Vector& way, const Sees& sees) {
    MovingBall point = {from, way, 0, 1, nullptr};
    SlotHit hit = {no_slot, 1, from + way, {}};
    look_along(all, point, [&](int slot) {
        SlotHit of_slot;
        if (!sees(slot) || !cast_ray_on_slot<Shapes>(all, from, way, slot, of_slot)) return;
        if (hit.slot != no_slot && !is_before(of_slot.fraction, slot, hit.fraction, hit.slot)) return;
        hit = of_slot;
        point.fraction = hit.fraction;
    });
    return hit;
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "../narrow_phase/collide_pairs.h"
#include "level_queries.h"
#include "cast_ray.h"

namespace ingot { inline namespace INGOT_ABI {

/// What is nearest to a point, by slot.
struct SlotNearest {
    int slot;  ///< no_slot: nothing
    scalar distance;
    Vector P, n;
};

/// A ball of radius zero against a shape, by the routines of the narrow phase.
template <class Shapes>
void point_on_shape(const PlacedShape& point, const PlacedShape& s, Manifold& manifold) {
    manifold.count = 0;
#define INGOT_POINT(name)                            \
    if constexpr (Shapes::has(ShapeKind::name))      \
        if (s.shape.kind == ShapeKind::name) return collide_sphere_##name(point, s, limits::unbounded, manifold)
    INGOT_POINT(sphere);
    INGOT_POINT(capsule);
    INGOT_POINT(box);
    INGOT_POINT(cylinder);
    INGOT_POINT(hull);
    INGOT_POINT(half_space);
#undef INGOT_POINT
}
/// The same of levels too, whose tables the scene has; of these no further than `within`, m.
template <class Shapes>
void point_on_placed(const PlacedShape& point, const PlacedShape& s, [[maybe_unused]] scalar within, Manifold& manifold) {
    if constexpr (Shapes::has(ShapeKind::level))
        if (s.shape.kind == ShapeKind::level) return point_on_level(point, s, *Shapes::level_of(s.shape), within, manifold);
    point_on_shape<Shapes>(point, s, manifold);
}

/// The body whose surface is nearest to a point, no further away than `within`, m; inside of several, the one it is deepest in. Behind a level, where
/// there is no end to the inside, what counts is how far its surface is.
/// Of bodies at the same distance the one of the lowest slot. Distances carry a few roundings of the sizes and of |point - r_CM|.
template <class Shapes, class All, class Sees>
SlotNearest find_nearest(const All& all, const Vector& point, scalar within, const Sees& sees) {
    const PlacedShape ball = {{ShapeKind::sphere, {}, 0}, point, identity_matrix<scalar>(), nullptr};
    SlotNearest nearest = {no_slot, within, point, {}};
    scalar least = within;
    look_about(all, point, least, [&](int slot) {
        if (!sees(slot)) return;
        const PlacedShape shape = placed_body<Shapes>(all.bodies, all.surfaces, slot);
        Manifold manifold;
        point_on_placed<Shapes>(ball, shape, least, manifold);
        if (manifold.count == 0) return;
        const scalar distance = manifold.points[0].separation;
        const scalar far = Shapes::has(ShapeKind::level) && shape.shape.kind == ShapeKind::level ? abs(distance) : distance;
        if (!(nearest.slot == no_slot ? far <= least : is_before(far, slot, least, nearest.slot))) return;
        least = far;
        nearest = {slot, distance, manifold.points[0].P - manifold.n * (distance * scalar(0.5)), manifold.n};
    });
    return nearest;
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "level_queries.h"
#include "../narrow_phase/nearest_points.h"
#include "shapes_of_tree.h"

namespace ingot { inline namespace INGOT_ABI {

/// True where the shape overlaps or touches that of a slot, to a few roundings of the sizes. Needs: no half space.
template <class Shapes>
bool overlaps_slot(const EveryShape& all, const PlacedShape& shape, int slot) {
    const PlacedShape body = placed_body<Shapes>(all.bodies, all.surfaces, slot);
    if constexpr (Shapes::has(ShapeKind::level))
        if (body.shape.kind == ShapeKind::level) return overlaps_level(shape, body, *Shapes::level_of(body.shape));
    return closest_points(shape, body).overlap;
}

/// Calls found(slot) for every shape that counts and that the shape overlaps or touches. In the order of slots, where all is an EveryShape; in any,
/// where it is ShapesOfTree.
template <class Shapes, class All, class Sees, class Found>
void find_overlaps(const All& all, const PlacedShape& shape, const Sees& sees, const Found& found) {
    const MovingBall ball = {shape.r, {}, bounding_radius(shape.shape), 0, &shape};
    look_along(all, ball, [&](int slot) {
        if (sees(slot) && overlaps_slot<Shapes>(all, shape, slot)) found(slot);
    });
}

} }  // namespace ingot

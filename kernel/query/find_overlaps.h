// SPDX-License-Identifier: MIT
#pragma once

#include "../narrow_phase/nearest_points.h"
#include "candidates.h"

namespace ingot { inline namespace INGOT_ABI {

/// Calls found(slot), in the order of slots, for every body that the shape overlaps or touches, to a few roundings of the sizes.
/// Needs: no half space.
template <class Shapes, class Sees, class Found>
void find_overlaps(const BodyView& bodies, const SurfaceView& surfaces, const PlacedShape& shape, const Sees& sees, const Found& found) {
    const MovingBall ball = {shape.r, {}, bounding_radius(shape.shape), 0};
    look_along(bodies, surfaces, ball, [&](int slot) {
        if (sees(slot) && closest_points(shape, placed_body<Shapes>(bodies, surfaces, slot)).overlap) found(slot);
    });
}

} }  // namespace ingot

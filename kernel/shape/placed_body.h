// SPDX-License-Identifier: MIT
#pragma once

#include "surface.h"
#include "placed_shape.h"

namespace ingot { inline namespace INGOT_ABI {

/// The body of a slot as narrow phase and queries take it. Shapes::hull_of knows the forms of the scene's hulls: see ShapesOf.
template <class Shapes>
INGOT_INLINE PlacedShape placed_body(const BodyView& bodies, const SurfaceView& surfaces, int slot) {
    const Place at = place_of(slot);
    const Shape& shape = surfaces.surfaces[slot].shape;
    return {shape, lane_of(bodies.translation[at.tile].r_CM, at.lane), lane_of(bodies.rotation[at.tile].A, at.lane), Shapes::hull_of(shape)};
}

} }  // namespace ingot

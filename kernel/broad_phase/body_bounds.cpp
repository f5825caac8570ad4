// SPDX-License-Identifier: MIT
#include "body_bounds.h"

#include "bound_shape.h"

namespace ingot { inline namespace INGOT_ABI {

using namespace bounding;

namespace {

/// A body that cannot move needs no skin.
INGOT_INLINE void widen(BoundsTile& tile, lane inv_M) {
    const lane tenth = select(inv_M > lane{}, splat<lane>(skin_share), lane{});
    for (int axis = 0; axis < 3; ++axis) {
        const lane low = load(tile.low[axis]), high = load(tile.high[axis]), skin = max((high - low) * tenth, lane{});
        store(tile.fat_low[axis], low - skin);
        store(tile.fat_high[axis], high + skin);
    }
}

}  // namespace

void invalidate_bounds(BoundsTile* bounds, int slot) {
    const Place at = place_of(slot);
    set_lane(bounds[at.tile].fat_low, at.lane, nowhere);
    set_lane(bounds[at.tile].fat_high, at.lane, -nowhere);
}

template <bool only_balls>
bool refresh_bounds(const BodyView& bodies, const SurfaceView& surfaces, scalar h, BoundsTile* bounds, bool bounded) {
    mask left = splat<lane>(1) < lane{};
    // bound: max_bodies max_shapes_of_body / lanes, rounded up: the view of all shapes
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {
        if (!bounded) bound_tile<only_balls>(bodies, surfaces, tile_i, h, bounds[tile_i]);
        left = either(left, left_bounds(bounds[tile_i]));
    }
    if (!any(left)) return false;
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) widen(bounds[tile_i], load(bodies.translation[tile_i].inv_M));
    return true;
}

// The linker takes the one that the scene calls.
template bool refresh_bounds<false>(const BodyView&, const SurfaceView&, scalar, BoundsTile*, bool);
template bool refresh_bounds<true>(const BodyView&, const SurfaceView&, scalar, BoundsTile*, bool);

void shrink_bounds(const BodyView& bodies, BoundsTile* bounds) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {
        BoundsTile& tile = bounds[tile_i];
        INGOT_COPY_BYTES(tile.fat_low, tile.low, sizeof tile.low);
        INGOT_COPY_BYTES(tile.fat_high, tile.high, sizeof tile.high);
    }
}

} }  // namespace ingot

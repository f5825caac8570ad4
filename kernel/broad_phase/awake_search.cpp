// SPDX-License-Identifier: MIT
#include "awake_search.h"

#include "bound_shape.h"

namespace ingot { inline namespace INGOT_ABI {

bool refresh_bounds_of(const SearchView& search, scalar h, int slot) {
    const Place at = place_of(slot);
    BoundsTile& tile = search.bounds[at.tile];
    bounding::bound(search.shapes, search.surfaces.surfaces[slot], at, h, tile);
    bool left = false;
    for (int axis = 0; axis < 3; ++axis)
        left = left || tile.low[axis][at.lane] < tile.fat_low[axis][at.lane] || tile.fat_high[axis][at.lane] < tile.high[axis][at.lane];
    return left;
}

void empty_bounds(BoundsTile* bounds, int slot) {
    bounding::set_bounds(bounds[place_of(slot).tile], place_of(slot).lane, bounding::nowhere, -bounding::nowhere);
    invalidate_bounds(bounds, slot);
}

void fatten_bounds_of(const SearchView& search, int slot) {
    const Place at = place_of(slot);
    BoundsTile& tile = search.bounds[at.tile];
    const scalar share = search.moves(slot) ? bounding::skin_share : scalar(0);
    for (int axis = 0; axis < 3; ++axis) {
        const scalar low = tile.low[axis][at.lane], high = tile.high[axis][at.lane], skin = max((high - low) * share, scalar(0));
        tile.fat_low[axis][at.lane] = low - skin;
        tile.fat_high[axis][at.lane] = high + skin;
    }
}

} }  // namespace ingot

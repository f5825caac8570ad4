// SPDX-License-Identifier: MIT
#include "search_view.h"

#include "bound_shape.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// A tile that never was bounded: its shapes are in no fat AABB.
void begin_tile(const SearchView& search, int tile_i) {
    if (!is_blank(search.bounds[tile_i])) return;
    for (int lane_i = 0; lane_i < lanes; ++lane_i) empty_bounds(search.bounds, tile_i * lanes + lane_i);
}

}  // namespace

void bound_shapes(const SearchView& search, scalar h, const TaskRange& tiles) {
    for (int tile_i = tiles.begin; tile_i < tiles.end; ++tile_i) {  // bound: max_bodies max_shapes_of_body / lanes, rounded up
        begin_tile(search, tile_i);
        bounding::bound_tile(search.shapes, search.surfaces, tile_i, h, search.bounds[tile_i]);
    }
}

int refresh_bounds_and_due(const SearchView& search, scalar h, uint32_t* due, bool bounded) {
    int count = 0;
    // bound: max_bodies max_shapes_of_body / lanes, rounded up: the view of all shapes
    for (int tile_i = 0; tile_i < search.shapes.tile_count; ++tile_i) {
        BoundsTile& tile = search.bounds[tile_i];
        if (!bounded) {
            begin_tile(search, tile_i);
            bounding::bound_tile(search.shapes, search.surfaces, tile_i, h, tile);
        }
        unsigned left = bits(bounding::left_bounds(tile));
        // bound: lanes: left has a bit a lane
        for (int slot = tile_i * lanes; left != 0; ++slot, left >>= 1) {
            if ((left & 1u) == 0) continue;
            search.set(slot, SearchFlag::searched | SearchFlag::due);
            fatten_bounds_of(search, slot);
            due[count++] = static_cast<uint32_t>(slot);
        }
    }
    return count;
}

void bound_shape(const SearchView& search, scalar h, int slot) {
    const Place at = place_of(slot);
    bounding::bound(search.shapes, search.surfaces, at, h, search.bounds[at.tile]);
}

bool refresh_bounds_of(const SearchView& search, scalar h, int slot) {
    bound_shape(search, h, slot);
    return has_left_bounds(search, slot);
}

bool has_left_bounds(const SearchView& search, int slot) {
    const Place at = place_of(slot);
    const BoundsTile& tile = search.bounds[at.tile];
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

// SPDX-License-Identifier: MIT
#include "all_pairs.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Lanes of a tile that are searched for.
unsigned searched_of(const SearchView& search, int tile_i) {
    unsigned searched = 0;
    for (int lane_i = 0; lane_i < lanes; ++lane_i) searched |= search.has(tile_i * lanes + lane_i, SearchFlag::searched) ? 1u << lane_i : 0u;
    return searched;
}

}  // namespace

void find_all_awake_pairs(const SearchView& search, const PairList& pairs) {
    *pairs.count = *pairs.lost = 0;
    // bound: max_bodies max_shapes_of_body, rounded up to whole tiles
    for (int slot_A = 0; slot_A < search.shapes.tile_count * lanes; ++slot_A) {
        const Place A = place_of(slot_A);
        const Vector low = lane_of(search.bounds[A.tile].fat_low, A.lane), high = lane_of(search.bounds[A.tile].fat_high, A.lane);
        if (!(low.x <= high.x)) continue;
        const bool A_searched = search.has(slot_A, SearchFlag::searched);
        const bool A_moves = search.moves(slot_A);
        // bound: max_bodies max_shapes_of_body / lanes, rounded up
        for (int tile_B = A.tile; tile_B < search.shapes.tile_count; ++tile_B) {
            const BoundsTile& B = search.bounds[tile_B];
            unsigned found = A_searched ? all_lanes : searched_of(search, tile_B);
            if (found == 0) continue;
            mask overlap = splat<lane>(1) > lane{};
            const scalar low_of[3] = {low.x, low.y, low.z}, high_of[3] = {high.x, high.y, high.z};
            for (int axis = 0; axis < 3; ++axis)
                overlap =
                    both(overlap, both(load(B.fat_low[axis]) <= splat<lane>(high_of[axis]), splat<lane>(low_of[axis]) <= load(B.fat_high[axis])));
            if (!any(overlap)) continue;
            found &= bits(A_moves ? overlap : both(overlap, load(search.shapes.translation[tile_B].inv_M) > lane{}));
            if (tile_B == A.tile) found &= ~((2u << A.lane) - 1u);
            // bound: lanes: found has a bit a lane
            for (int lane_B = 0; found != 0; ++lane_B, found >>= 1)
                if ((found & 1u) != 0) pairs.add(slot_A, tile_B * lanes + lane_B);
        }
    }
}

} }  // namespace ingot

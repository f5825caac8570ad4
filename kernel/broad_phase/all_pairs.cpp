// SPDX-License-Identifier: MIT
#include "all_pairs.h"

namespace ingot { inline namespace INGOT_ABI {

void find_all_pairs(const BodyView& bodies, const BoundsTile* bounds, const PairList& pairs) {
    *pairs.count = *pairs.lost = 0;
    // bound: max_bodies max_shapes_of_body, rounded up to whole tiles: the view of all shapes
    for (int slot_A = 0; slot_A < bodies.tile_count * lanes; ++slot_A) {
        const Place A = place_of(slot_A);
        const Vector low = lane_of(bounds[A.tile].fat_low, A.lane), high = lane_of(bounds[A.tile].fat_high, A.lane);
        if (!(low.x <= high.x)) continue;
        const lane low_x = splat<lane>(low.x), low_y = splat<lane>(low.y), low_z = splat<lane>(low.z);
        const lane high_x = splat<lane>(high.x), high_y = splat<lane>(high.y), high_z = splat<lane>(high.z);
        const bool A_moves = bodies.translation[A.tile].inv_M[A.lane] > 0;
        // bound: max_bodies max_shapes_of_body / lanes, rounded up: the view of all shapes
        for (int tile_B = A.tile; tile_B < bodies.tile_count; ++tile_B) {
            const BoundsTile& B = bounds[tile_B];
            const mask along_x = both(load(B.fat_low[0]) <= high_x, low_x <= load(B.fat_high[0]));
            const mask along_y = both(load(B.fat_low[1]) <= high_y, low_y <= load(B.fat_high[1]));
            const mask along_z = both(load(B.fat_low[2]) <= high_z, low_z <= load(B.fat_high[2]));
            const mask overlap = both(both(along_x, along_y), along_z);
            if (!any(overlap)) continue;
            unsigned found = bits(A_moves ? overlap : both(overlap, load(bodies.translation[tile_B].inv_M) > lane{}));
            if (tile_B == A.tile) found &= ~((2u << A.lane) - 1u);
            // bound: lanes: found has a bit a lane
            for (int lane_B = 0; found != 0; ++lane_B, found >>= 1)
                if ((found & 1u) != 0) pairs.add(slot_A, tile_B * lanes + lane_B);
        }
    }
}

template <class View>
bool search_all_pairs(const View& search, scalar h, const PairList& pairs, bool bounded) {
    const bool left = refresh_bounds<View::only_balls>(search.shapes, search.surfaces, h, search.bounds, bounded);
    if (left) find_all_pairs(search.shapes, search.bounds, pairs);
    const bool crowded = *pairs.lost > 0;
    if (crowded) {
        shrink_bounds(search.shapes, search.bounds);
        find_all_pairs(search.shapes, search.bounds, pairs);
    }
    return left || crowded;
}

// The linker takes the one that the scene calls.
template bool search_all_pairs(const SearchView&, scalar, const PairList&, bool);
template bool search_all_pairs(const BallSearchView&, scalar, const PairList&, bool);

} }  // namespace ingot

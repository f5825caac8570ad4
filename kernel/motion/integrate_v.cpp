// SPDX-License-Identifier: MIT
#include "integrate_v.h"

#include "../base/limits.h"
#include "acceleration.h"

namespace ingot { inline namespace INGOT_ABI {

void integrate_v(const BodyView& bodies, scalar h, const Vector& gravity) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {  // bound: max_bodies / lanes, rounded up
        TranslationTile& tile = bodies.translation[tile_i];
        store_if_within(limits::speed_runaway, tile.v_CM, load(tile.v_CM) + acceleration(tile, gravity) * splat<lane>(h), tile.bad);
    }
}

} }  // namespace ingot

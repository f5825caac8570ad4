// SPDX-License-Identifier: MIT
#include "integrate_L.h"

namespace ingot { inline namespace INGOT_ABI {

void integrate_L(const BodyView& bodies, scalar h) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {  // bound: max_bodies / lanes, rounded up
        RotationTile& tile = bodies.rotation[tile_i];
        const Vec3<lane> tau_T = load(tile.tau_T);
        const auto kicked = abs(tau_T.x) + abs(tau_T.y) + abs(tau_T.z) > lane{};
        if (!any(kicked)) continue;
        store_if_within(scalar_max, tile.L, load(tile.L) + tau_T * splat<lane>(h), tile.bad);
        tile.kicked = static_cast<uint16_t>(tile.kicked | bits(kicked));
    }
}

void clear_forces(const BodyView& bodies) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {
        store(bodies.rotation[tile_i].tau_T, Vec3<lane>{});
        if (bodies.translation != nullptr) store(bodies.translation[tile_i].F_T, Vec3<lane>{});
    }
}

} }  // namespace ingot

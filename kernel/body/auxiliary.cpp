// SPDX-License-Identifier: MIT
#include "auxiliary.h"

#include "kinematics.h"

namespace ingot { inline namespace INGOT_ABI {

Vector omega_of(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    const RotationTile& tile = bodies.rotation[at.tile];
    const Vector inv_I_body = lane_of(tile.inv_I_ratio, at.lane) * tile.inv_I_scale[at.lane];
    return spin_of(lane_of(tile.A, at.lane), inv_I_body, lane_of(tile.L, at.lane));
}

void refresh_inv_I_world(const BodyView& bodies) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {  // bound: max_bodies / lanes, rounded up
        const RotationTile& tile = bodies.rotation[tile_i];
        const Vec3<lane> inv_I_body = load(tile.inv_I_ratio) * load(tile.inv_I_scale);
        store(bodies.translation[tile_i].inv_I_world, inverse_inertia_world(load(tile.A), inv_I_body));
    }
}

void mark_runaway_spins(const BodyView& bodies) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {
        RotationTile& tile = bodies.rotation[tile_i];
        const Vec3<lane> inv_I_body = load(tile.inv_I_ratio) * load(tile.inv_I_scale);
        mark_bad(tile.bad, is_within_runaway(spin_of(load(tile.A), inv_I_body, load(tile.L))));
    }
}

} }  // namespace ingot

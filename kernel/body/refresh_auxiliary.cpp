// SPDX-License-Identifier: MIT
#include "refresh_auxiliary.h"

#include "../base/limits.h"
#include "kinematics.h"

namespace ingot { inline namespace INGOT_ABI {

void refresh_auxiliary(const BodyView& bodies) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {
        RotationTile& tile = bodies.rotation[tile_i];
        const Vec3<lane> inv_I_body = load(tile.inv_I_ratio) * load(tile.inv_I_scale);
        const Sym3<lane> inv_I_world = inverse_inertia_world(load(tile.A), inv_I_body);
        const Vec3<lane> omega = inv_I_world * load(tile.L);
        const mask good = length_sq(omega) <= splat<lane>(limits::spin_runaway * limits::spin_runaway);
        store(tile.inv_I_world, inv_I_world);
        store(tile.omega, select(good, omega, Vec3<lane>{}));
        mark_bad(tile.bad, good);
    }
}

void refresh_auxiliary_of(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    RotationTile& tile = bodies.rotation[at.tile];
    const Vector inv_I_body = lane_of(tile.inv_I_ratio, at.lane) * tile.inv_I_scale[at.lane];
    const SymmetricMatrix inv_I_world = inverse_inertia_world(lane_of(tile.A, at.lane), inv_I_body);
    set_lane(tile.inv_I_world, at.lane, inv_I_world);
    set_lane(tile.omega, at.lane, inv_I_world * lane_of(tile.L, at.lane));
}

} }  // namespace ingot

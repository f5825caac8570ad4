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
    refresh_auxiliary({bodies.rotation + place_of(slot).tile, nullptr, nullptr, nullptr, 1});
}

} }  // namespace ingot

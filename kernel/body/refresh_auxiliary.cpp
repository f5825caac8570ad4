// SPDX-License-Identifier: MIT
#include "refresh_auxiliary.h"

#include "../base/limits.h"
#include "kinematics.h"

namespace ingot { inline namespace INGOT_ABI {

void refresh_omega(const BodyView& bodies) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {
        RotationTile& tile = bodies.rotation[tile_i];
        const Mat3<lane> A = load(tile.A);
        const Vec3<lane> inv_I_body = load(tile.inv_I_ratio) * load(tile.inv_I_scale);
        const Vec3<lane> omega = A * scaled(inv_I_body, transpose_times(A, load(tile.L)));
        const mask good = length_sq(omega) <= splat<lane>(limits::spin_runaway * limits::spin_runaway);
        store(tile.omega, select(good, omega, Vec3<lane>{}));
        mark_bad(tile.bad, good);
    }
}

void refresh_omega_of(const BodyView& bodies, int slot) {
    refresh_omega({bodies.rotation + place_of(slot).tile, nullptr, nullptr, nullptr, 1});
}

void refresh_inv_I_world(const BodyView& bodies) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {
        const RotationTile& tile = bodies.rotation[tile_i];
        const Vec3<lane> inv_I_body = load(tile.inv_I_ratio) * load(tile.inv_I_scale);
        store(bodies.translation[tile_i].inv_I_world, inverse_inertia_world(load(tile.A), inv_I_body));
    }
}

} }  // namespace ingot

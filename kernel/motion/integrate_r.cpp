// SPDX-License-Identifier: MIT
#include "integrate_r.h"

#include "../base/limits.h"
#include "acceleration.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

INGOT_INLINE void store_position(TranslationTile& tile, const Vec3<lane>& r) {
    store_if_within(limits::position_max, tile.r_CM, r, tile.bad);
}

}  // namespace

void integrate_r(const BodyView& bodies, scalar h, const Vector& gravity) {
    const lane step = splat<lane>(h), half_step = splat<lane>(h * scalar(0.5));
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {  // bound: max_bodies / lanes, rounded up
        TranslationTile& tile = bodies.translation[tile_i];
        const Vec3<lane> v_mid = load(tile.v_CM) - acceleration(tile, gravity) * half_step;
        store_position(tile, load(tile.r_CM) + v_mid * step);
    }
}

void drift_r(const BodyView& bodies, scalar h) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {
        TranslationTile& tile = bodies.translation[tile_i];
        store_position(tile, load(tile.r_CM) + load(tile.v_CM) * splat<lane>(h));
    }
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#include "integrate_r.h"

#include "../base/limits.h"
#include "acceleration.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Infinite where a coordinate is beyond limits::position_max, so that store_if_finite refuses it.
INGOT_INLINE lane within_range(lane coordinate) {
    const lane limit = splat<lane>(limits::position_max);
    return select(abs(coordinate) <= limit, coordinate, splat<lane>(scalar(__builtin_huge_valf())));
}

INGOT_INLINE void store_position(TranslationTile& tile, const Vec3<lane>& r) {
    store_if_finite(tile.r_CM, {within_range(r.x), within_range(r.y), within_range(r.z)}, tile.bad);
}

}  // namespace

void integrate_r(const BodyView& bodies, scalar h, const Vector& gravity) {
    const lane step = splat<lane>(h), half_step = splat<lane>(h * scalar(0.5));
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {
        TranslationTile& tile = bodies.translation[tile_i];
        const Vec3<lane> v_mid = load(tile.v_CM) - acceleration(tile, gravity) * half_step;
        store_position(tile, load(tile.r_CM) + v_mid * step);
    }
}

void integrate_r_listing1(const BodyView& bodies, scalar h) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {
        TranslationTile& tile = bodies.translation[tile_i];
        store_position(tile, load(tile.r_CM) + load(tile.v_CM) * splat<lane>(h));
    }
}

} }  // namespace ingot

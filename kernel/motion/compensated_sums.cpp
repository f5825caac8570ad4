// SPDX-License-Identifier: MIT
#include "compensated_sums.h"

#include "../base/limits.h"
#include "acceleration.h"
#include "turn.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

INGOT_INLINE lane rest_of(lane low, lane seen, lane value) { return select(both(value >= seen, value <= seen), low, lane{}); }

/// value + increment of the bodies that move, with what the sum knew beyond it; the others keep their value and what they know.
INGOT_INLINE Vec3<lane> added(SumTile& sum, const Vec3<lane>& value, const Vec3<lane>& increment, mask moving) {
    const Vec3<lane> low = load(sum.low), seen = load(sum.seen);
    const Vec3<lane> due = increment + Vec3<lane>{rest_of(low.x, seen.x, value.x), rest_of(low.y, seen.y, value.y), rest_of(low.z, seen.z, value.z)};
    Vec3<lane> total, rest;
    add_exactly(value.x, due.x, total.x, rest.x);
    add_exactly(value.y, due.y, total.y, rest.y);
    add_exactly(value.z, due.z, total.z, rest.z);
    store(sum.low, select(moving, rest, low));
    store(sum.seen, select(moving, total, seen));
    return select(moving, total, value);
}

INGOT_INLINE mask moving_of(const SumView& sums, int tile_i) {
    return mask_from_bits(sums.awake != nullptr ? sums.awake[tile_i] : all_lanes);
}

}  // namespace

Vector remainder_of(const SumTile& sum, int lane_i, const Vector& value) {
    const Vector low = lane_of(sum.low, lane_i), seen = lane_of(sum.seen, lane_i);
    return {value.x == seen.x ? low.x : 0, value.y == seen.y ? low.y : 0, value.z == seen.z ? low.z : 0};
}

void set_remainder(SumTile& sum, int lane_i, const Vector& value, const Vector& low) {
    set_lane(sum.low, lane_i, low);
    set_lane(sum.seen, lane_i, value);
}

void integrate_L_in_sums(const BodyView& bodies, const SumView& sums, scalar h) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {  // bound: max_bodies / lanes, rounded up
        RotationTile& tile = bodies.rotation[tile_i];
        const Vec3<lane> tau_T = load(tile.tau_T);
        const mask kicked = abs(tau_T.x) + abs(tau_T.y) + abs(tau_T.z) > lane{};
        if (!any(kicked)) continue;
        const mask moving = both(kicked, moving_of(sums, tile_i));
        store_if_within(scalar_max, tile.L, added(sums.L[tile_i], load(tile.L), tau_T * splat<lane>(h), moving), tile.bad);
        tile.kicked = static_cast<uint16_t>(tile.kicked | bits(kicked));
    }
}

void integrate_v_in_sums(const BodyView& bodies, const SumView& sums, scalar h, const Vector& gravity) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {  // bound: max_bodies / lanes, rounded up
        TranslationTile& tile = bodies.translation[tile_i];
        const Vec3<lane> change = acceleration(tile, gravity) * splat<lane>(h);
        store_if_within(limits::speed_runaway, tile.v_CM, added(sums.v_CM[tile_i], load(tile.v_CM), change, moving_of(sums, tile_i)), tile.bad);
    }
}

void integrate_r_in_sums(const BodyView& bodies, const SumView& sums, scalar h, const Vector& gravity) {
    const lane step = splat<lane>(h), half_step = splat<lane>(h * scalar(0.5));
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {  // bound: max_bodies / lanes, rounded up
        TranslationTile& tile = bodies.translation[tile_i];
        const Vec3<lane> v_mid = load(tile.v_CM) - acceleration(tile, gravity) * half_step;
        store_if_within(limits::position_max, tile.r_CM, added(sums.r_CM[tile_i], load(tile.r_CM), v_mid * step, moving_of(sums, tile_i)), tile.bad);
    }
}

} }  // namespace ingot

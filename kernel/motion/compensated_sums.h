// SPDX-License-Identifier: MIT
// Sums of L, v_CM and r_CM that keep what their roundings take off, for scenes with compensated_sums: at a thousand steps a second, in float, an
// increment is so short beside its sum that most of its digits are lost.
#pragma once

#include "../body/body_tiles.h"

namespace ingot { inline namespace INGOT_ABI {

/// What a sum of each body of a tile knows beyond its last bit.
///
/// Valid while the sum is still the one that was stored: what a contact, an impulse or a user put in its place has no remainder.
struct alignas(tile_alignment) SumTile {
    scalar low[3][lanes];   ///< the sum is its value + low
    scalar seen[3][lanes];  ///< the value as it was stored
};

/// The sums of the bodies of a view, tile by tile. r_CM and v_CM are null in scenes that do not translate.
struct SumView {
    SumTile *L, *v_CM, *r_CM;
    const uint16_t* awake;  ///< a bit a lane: other bodies keep theirs; null: all move
};

/// What a sum of one body knows beyond `value`; 0 in each component that is no longer the one that was stored.
Vector remainder_of(const SumTile& sum, int lane_i, const Vector& value);
void set_remainder(SumTile& sum, int lane_i, const Vector& value, const Vector& low);

/// integrate_L, integrate_v and integrate_r with sums that lose nothing.
///
/// Keeps:   each sum to a rounding of its value, whatever h and however many the steps; of the increments their own roundings stay.
/// Cost:    36 flops more a sum. Source: Knuth, The Art of Computer Programming 2, 4.2.2; Neumaier 1974.
void integrate_L_in_sums(const BodyView& bodies, const SumView& sums, scalar h);
void integrate_v_in_sums(const BodyView& bodies, const SumView& sums, scalar h, const Vector& gravity);
void integrate_r_in_sums(const BodyView& bodies, const SumView& sums, scalar h, const Vector& gravity);

} }  // namespace ingot

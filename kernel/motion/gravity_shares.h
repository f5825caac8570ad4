// SPDX-License-Identifier: MIT
#pragma once

#include "../body/body_tiles.h"

namespace ingot { inline namespace INGOT_ABI {

/// Bodies feel their own share of gravity: F_T += (share - 1) M gravity, before any stage reads F_T.
///
/// So every scheme and solver, which add the whole of gravity to F_T / M, take share times gravity, to the rounding of M: a body of share 0 keeps
/// about 1e-7 of it in float, and none where its mass is a power of two.
/// Shapes:  shares: one a slot. Units: gravity m s^-2. Cost: a division and 8 flops a body.
inline void add_gravity_share(const BodyView& bodies, const Vector& gravity, const scalar* shares, int slot) {
    const Place at = place_of(slot);
    TranslationTile& tile = bodies.translation[at.tile];
    const scalar inv_M = tile.inv_M[at.lane];
    if (inv_M > 0 && shares[slot] != 1) set_lane(tile.F_T, at.lane, lane_of(tile.F_T, at.lane) + gravity * ((shares[slot] - 1) / inv_M));
}
inline void add_gravity_shares(const BodyView& bodies, const Vector& gravity, const scalar* shares, int slots_used) {
    for (int slot = 0; slot < slots_used; ++slot) add_gravity_share(bodies, gravity, shares, slot);  // bound: max_bodies
}

} }  // namespace ingot

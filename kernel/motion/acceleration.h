// SPDX-License-Identifier: MIT
#pragma once

#include "../body/body_tiles.h"

namespace ingot { inline namespace INGOT_ABI {

/// a = F_T / M + gravity (Hecker 1997, Eq. 14); zero for immovable bodies.
INGOT_INLINE Vec3<lane> acceleration(const TranslationTile& tile, const Vector& gravity) {
    const lane inv_M = load(tile.inv_M);
    const auto movable = inv_M > lane{};
    const Vec3<lane> g = {select(movable, splat<lane>(gravity.x), lane{}), select(movable, splat<lane>(gravity.y), lane{}),
                          select(movable, splat<lane>(gravity.z), lane{})};
    return load(tile.F_T) * inv_M + g;
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "../body/body_tiles.h"

namespace ingot { inline namespace INGOT_ABI {

inline constexpr uint64_t state_hash_seed = 0xcbf29ce484222325u;

/// Adds the primary state of the body of one slot (A with its low part, L, r_CM, v_CM) to a hash: FNV-1a, 64 bits, over
/// the bits of the numbers from the lowest byte up, so that it is one number on every target and for every lane count.
uint64_t hash_body(const BodyView& bodies, int slot, uint64_t hash);

/// Adds one number, by its bits.
uint64_t hash_number(uint64_t hash, scalar x);

/// Adds what a body's sleep depends on: see RestView.
uint64_t hash_rest(bool awake, scalar rest_time, uint64_t hash);

} }  // namespace ingot

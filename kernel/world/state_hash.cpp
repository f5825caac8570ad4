// SPDX-License-Identifier: MIT
#include "state_hash.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

#if INGOT_DOUBLE
using Bits = uint64_t;
#else
using Bits = uint32_t;
#endif

uint64_t with_number(uint64_t hash, scalar x) {
    Bits b;
    INGOT_COPY_BYTES(&b, &x, sizeof b);
    for (unsigned byte_i = 0; byte_i < sizeof b; ++byte_i) {
        hash = (hash ^ static_cast<uint64_t>(b & 0xffu)) * 0x100000001b3u;
        b >>= 8;
    }
    return hash;
}

/// A lane of so many rows, one after the other.
uint64_t hash_rows(uint64_t hash, const scalar* first, int rows) {
    // bound: 9: numbers of a matrix
    for (int row_i = 0; row_i < rows; ++row_i) hash = with_number(hash, first[row_i * lanes]);
    return hash;
}

template <unsigned rows>
uint64_t hash_lane(uint64_t hash, const scalar (&numbers)[rows][lanes], int lane_i) {
    return hash_rows(hash, &numbers[0][lane_i], static_cast<int>(rows));
}

}  // namespace

uint64_t hash_body(const BodyView& bodies, int slot, uint64_t hash) {
    const Place at = place_of(slot);
    const RotationTile& rotation = bodies.rotation[at.tile];
    hash = hash_lane(hash, rotation.A, at.lane);
    hash = hash_lane(hash, rotation.L, at.lane);
    if (bodies.compensation != nullptr) hash = hash_lane(hash, bodies.compensation[at.tile].A_low, at.lane);
    if (bodies.translation == nullptr) return hash;
    hash = hash_lane(hash, bodies.translation[at.tile].r_CM, at.lane);
    return hash_lane(hash, bodies.translation[at.tile].v_CM, at.lane);
}

uint64_t hash_number(uint64_t hash, scalar x) { return hash_rows(hash, &x, 1); }

uint64_t hash_rest(bool awake, scalar rest_time, uint64_t hash) { return hash_number((hash ^ (awake ? 1u : 0u)) * 0x100000001b3u, rest_time); }

} }  // namespace ingot

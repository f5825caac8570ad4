// SPDX-License-Identifier: MIT
#pragma once

#include "body_bounds.h"

namespace ingot { inline namespace INGOT_ABI {

inline constexpr uint16_t no_record = 65535;
/// Within a step: it touches, and there is no record for it. See crowd.h.
inline constexpr uint16_t refused_record = no_record - 1;

/// Two bodies that may touch: slots, A the lower one, and what is known of their contact.
struct BodyPair {
    uint16_t body_A, body_B;
    uint16_t record;  ///< index of a ManifoldRecord, or no_record

    uint32_t key() const { return static_cast<uint32_t>(body_A) << 16 | body_B; }
};

/// The pairs of the last search, sorted by slots, without their capacity.
struct PairList {
    BodyPair* pairs;
    int capacity;
    uint16_t* count;
    uint16_t* lost;   ///< in the last search: no room

    INGOT_INLINE void add(int A, int B) const {
        if (*count < capacity)
            pairs[(*count)++] = {static_cast<uint16_t>(A), static_cast<uint16_t>(B), no_record};
        else if (*lost < 65535)
            ++*lost;
    }
};

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "body_bounds.h"

namespace ingot { inline namespace INGOT_ABI {

inline constexpr uint16_t no_record = 65535;

/// Two bodies that may touch: slots, A the lower one, and what is known of their contact.
struct BodyPair {
    uint16_t body_A, body_B;
    uint16_t record;  ///< index of a ManifoldRecord, or no_record

    uint32_t key() const { return static_cast<uint32_t>(body_A) << 16 | body_B; }
};

/// Where a broad phase puts what it finds. It goes on counting what no longer fits.
struct PairSink {
    BodyPair* pairs;
    int capacity;
    int count;
    int lost;

    INGOT_INLINE void add(int A, int B) {
        if (count == capacity) {
            ++lost;
            return;
        }
        pairs[count++] = {static_cast<uint16_t>(A < B ? A : B), static_cast<uint16_t>(A < B ? B : A), no_record};
    }
};

} }  // namespace ingot

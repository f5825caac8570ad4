// SPDX-License-Identifier: MIT
#pragma once

#include "body_bounds.h"

namespace ingot { inline namespace INGOT_ABI {

inline constexpr Index no_record = index_max;
/// Within a step: it touches, and there is no record for it. See crowd.h.
inline constexpr Index refused_record = no_record - 1;

/// Two bodies that may touch: slots, A the lower one, and what is known of their contact.
struct BodyPair {
    Index body_A, body_B;
    Index record;  ///< index of a ManifoldRecord, or no_record

    PairKey key() const { return key_of(body_A, body_B); }
};

/// The pairs of the last search, sorted by slots, without their capacity.
struct PairList {
    BodyPair* pairs;
    int capacity;
    Index* count;
    Index* lost;   ///< in the last search: no room

    INGOT_INLINE void add(int A, int B) const {
        if (*count < capacity)
            pairs[(*count)++] = {static_cast<Index>(A), static_cast<Index>(B), no_record};
        else if (*lost < index_max)
            ++*lost;
    }
};

} }  // namespace ingot

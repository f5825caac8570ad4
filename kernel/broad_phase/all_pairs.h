// SPDX-License-Identifier: MIT
#pragma once

#include "body_pairs.h"

namespace ingot { inline namespace INGOT_ABI {

/// Every pair whose fat AABBs overlap and of which one can move, sorted by slots.
///
/// Tests `lanes` bodies at once. Cost: n^2 / (2 lanes) tests of boxes, the least there is up to a few hundred bodies.
/// Full: pairs of the lowest slots are kept.
void find_all_pairs(const BodyView& bodies, const BoundsTile* bounds, const PairList& pairs);

/// `using broad_phase = ingot::AllPairs;`, for up to a few hundred bodies.
struct AllPairs {
    static constexpr const char* name = "all_pairs";
    template <int max_bodies, int max_pairs>
    struct Memory {
        void find_pairs(const BodyView& bodies, const BoundsTile* bounds, const PairList& pairs) { find_all_pairs(bodies, bounds, pairs); }
    };
};

} }  // namespace ingot

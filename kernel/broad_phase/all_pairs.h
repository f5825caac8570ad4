// SPDX-License-Identifier: MIT
#pragma once

#include "awake_search.h"

namespace ingot { inline namespace INGOT_ABI {

/// Every pair whose fat AABBs overlap and of which one can move, sorted by slots.
///
/// Tests `lanes` bodies at once. Cost: n^2 / (2 lanes) tests of boxes, the least there is up to a few hundred bodies.
/// Full: pairs of the lowest slots are kept.
void find_all_pairs(const BodyView& bodies, const BoundsTile* bounds, const PairList& pairs);

/// The same, without pairs of two shapes at rest: see awake_search.h.
void find_all_awake_pairs(const SearchView& search, const PairList& pairs);

/// `using broad_phase = ingot::AllPairs;`, for up to a few hundred bodies.
struct AllPairs {
    static constexpr const char* name = "all_pairs";
    template <int max_bodies, int max_pairs>
    struct Memory {
        void find_pairs(const BodyView& bodies, const BoundsTile* bounds, const PairList& pairs) { find_all_pairs(bodies, bounds, pairs); }
    };

    /// For scenes whose bodies sleep. It has no search of its own for shapes that are due: all pairs are found anew.
    template <int max_bodies, int max_pairs>
    struct AwakeMemory {
        static uint32_t* due_shapes() { return nullptr; }
        static void find_awake_pairs(const SearchView& search, const PairList& pairs) { find_all_awake_pairs(search, pairs); }
        static void find_due_pairs(const SearchView& search, int, const PairList& pairs) { find_all_awake_pairs(search, pairs); }
    };
};

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "awake_search.h"

namespace ingot { inline namespace INGOT_ABI {

/// Every pair whose fat AABBs overlap and of which one can move, sorted by slots.
///
/// Tests `lanes` bodies at once. Cost: n^2 / (2 lanes) tests of boxes, the least there is up to a few hundred bodies.
/// Full: pairs of the lowest slots are kept.
void find_all_pairs(const BodyView& bodies, const BoundsTile* bounds, const PairList& pairs);

/// The same but for pairs of two shapes that rest: see awake_search.h.
void find_all_awake_pairs(const SearchView& search, const PairList& pairs);

/// What it knows of who is near: nothing.
struct NoTree {};
template <class Tree>
inline constexpr bool is_tree = true;
template <>
inline constexpr bool is_tree<NoTree> = false;

/// `using broad_phase = ingot::AllPairs;`, for up to a few hundred bodies.
struct AllPairs {
    static constexpr const char* name = "all_pairs";
    template <int max_bodies, int max_pairs>
    struct Memory {
        static constexpr NoTree tree_of_bounds() { return {}; }
        void find_pairs(const BodyView& bodies, const BoundsTile* bounds, const PairList& pairs) { find_all_pairs(bodies, bounds, pairs); }
    };

    /// For scenes whose bodies sleep. The pairs of those that are due are found with all others.
    template <int max_bodies, int max_pairs>
    struct AwakeMemory {
        static constexpr NoTree tree_of_bounds() { return {}; }
        static uint32_t* due_shapes() { return nullptr; }
        static void find_awake_pairs(const SearchView& search, const PairList& pairs) { find_all_awake_pairs(search, pairs); }
        static void find_due_pairs(const SearchView& search, int, const PairList& pairs) { find_all_awake_pairs(search, pairs); }
    };
};

} }  // namespace ingot

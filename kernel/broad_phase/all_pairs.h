// SPDX-License-Identifier: MIT
#pragma once

#include "search_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Every pair whose fat AABBs overlap and of which one can move, sorted by slots.
///
/// Tests `lanes` bodies at once. Cost: n^2 / (2 lanes) tests of boxes, the least there is up to a few hundred bodies.
/// Full: pairs of the lowest slots are kept; which it is in the end is for keep_urgent_pairs to say.
void find_all_pairs(const BodyView& bodies, const BoundsTile* bounds, const PairList& pairs);

/// The same, without pairs of two shapes at rest: see search_view.h.
void find_all_awake_pairs(const SearchView& search, const PairList& pairs);

/// Bounds of the step, and a search where a shape has left its fat AABB. True when the list has changed. See stages.h, find_pairs.
/// bounded: shapes have been by bound_shapes. View: SearchView, or BallSearchView.
template <class View>
bool search_all_pairs(const View& search, scalar h, const PairList& pairs, bool bounded);

/// What it knows of who is near: nothing.
struct NoTree {};
template <class Tree>
inline constexpr bool is_tree = true;
template <>
inline constexpr bool is_tree<NoTree> = false;

/// `using broad_phase = ingot::AllPairs;`, for up to a few hundred bodies.
struct AllPairs {
    static constexpr const char* name = "all_pairs";
    static constexpr bool answers_queries = false;
    template <int max_bodies, int max_pairs>
    struct Memory {
        static constexpr uint8_t* search_flags = nullptr;
        static constexpr NoTree tree_of_bounds() { return {}; }

        static void find_pairs(const SearchView& search, const PairList& pairs) { find_all_pairs(search.shapes, search.bounds, pairs); }
        template <class View>
        static bool search(const View& search, scalar h, const PairList& pairs, bool bounded) {
            return search_all_pairs(search, h, pairs, bounded);
        }
    };

    /// For scenes whose bodies sleep. It has no search of its own for shapes that are due: all pairs are found anew.
    template <int max_bodies, int max_pairs>
    struct AwakeMemory {
        static constexpr NoTree tree_of_bounds() { return {}; }
        static uint32_t* due_shapes() { return nullptr; }
        static void find_pairs(const SearchView& search, const PairList& pairs) { find_all_awake_pairs(search, pairs); }
        static void find_due_pairs(const SearchView& search, int, const PairList& pairs) { find_all_awake_pairs(search, pairs); }
    };
};

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "search_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Bodies of a leaf: so many that one vector instruction tests them all, and the same number for every `lanes` up to 8.
inline constexpr int leaf_bodies = lanes > 8 ? lanes : 8;

struct TreeBox {
    Vector low, high;  ///< m
};
struct alignas(tile_alignment) TreeLeaf {
    scalar low[3][leaf_bodies], high[3][leaf_bodies];  ///< m; empty boxes where it has fewer bodies
    Index slot[leaf_bodies];
    uint8_t moves[leaf_bodies];
};
/// A body on its way along the Morton curve.
struct TreeKey {
    uint32_t code;
    Index slot;
};

/// What the tree works on, without its capacities.
///
/// Bodies are sorted along a Morton curve through their centres and packed in this order into leaves, over which a complete binary tree of boxes
/// stands: no pointers, no insertion, no balance to keep; sizes may be mixed. Each leaf looks for the leaves after it that it overlaps.
/// Source: Morton order as in Lauterbach et al. 2009 (LBVH); the implicit tree over leaves is ours.
///
/// It is kept over several steps: a shape that left its fat AABB keeps its place in the order of the last sorting, and the boxes above it are made
/// anew. It is then found wherever it is, but boxes grow; when many have left their places, the tree is built again. What a search finds does not
/// depend on it.
struct SortedTreeView {
    TreeLeaf* leaves;
    TreeBox* boxes;              ///< 2 leaf_places; box 1 holds all, box i holds 2 i and 2 i + 1, box leaf_places + k is that of leaf k
    int leaf_places;             ///< a power of two
    TreeKey *keys, *other_keys;
    BodyPair* other_pairs;       ///< as many as pairs
    uint32_t* counters;          ///< as many as bodies and spare lanes, and 1024 at least; until a search sorts, the shapes that are due
    Index* place;             ///< by slot: 1 + where it is in the leaves; 0: nowhere
    Index* used;              ///< places in the leaves that hold a shape, or held one
    Index* moved;             ///< shapes that are no more where the tree was built for
};

/// Every pair of which one is searched for and one can move and whose fat AABBs overlap, sorted by slots: what find_all_awake_pairs finds.
/// Cost: near-linear in shapes. Full: some are kept, and lost counts the others; which are kept in the end is for keep_urgent_pairs to say.
void find_pairs_by_tree(const SearchView& search, const SortedTreeView& tree, const PairList& pairs);

/// The same where the list holds those of the last search, and due[0 .. due_count) are the shapes that are due, in any order. Their pairs are without
/// records after it. Cost: O(log shapes) a shape that is due, and a walk along the list; near-linear in all shapes where most of them are due.
void find_due_pairs_by_tree(const SearchView& search, const SortedTreeView& tree, const uint32_t* due, int due_count, const PairList& pairs);

/// Bounds of the step, and a search for the shapes that have left their fat AABBs, where nothing sleeps. True when the list has changed. See
/// stages.h, find_pairs.
bool search_by_tree(const SearchView& search, const SortedTreeView& tree, scalar h, const PairList& pairs, bool bounded);

/// `using broad_phase = ingot::SortedTree;`, for hundreds to tens of thousands of bodies.
struct SortedTree {
    static constexpr const char* name = "sorted_tree";
    static constexpr bool answers_queries = false;  ///< see QueryTree
    template <int max_bodies, int max_pairs>
    struct TreeMemory {
        static constexpr int leaf_count = (max_bodies + leaf_bodies - 1) / leaf_bodies;
        static constexpr int places() {
            int n = 1;
            // bound: log2(max_bodies max_shapes_of_body): n doubles; computed by the compiler
            while (n < leaf_count) n *= 2;
            return n;
        }
        static constexpr unsigned shape_slots = static_cast<unsigned>((max_bodies + lanes - 1) / lanes * lanes);
        static constexpr int counter_count = max_bodies + lanes > 1024 ? max_bodies + lanes : 1024;

        TreeLeaf leaves[static_cast<unsigned>(leaf_count)] = {};
        TreeBox boxes[2u * static_cast<unsigned>(places())] = {};
        TreeKey keys[static_cast<unsigned>(max_bodies)] = {}, other_keys[static_cast<unsigned>(max_bodies)] = {};
        BodyPair other_pairs[static_cast<unsigned>(max_pairs)] = {};
        uint32_t counters[static_cast<unsigned>(counter_count)] = {};
        Index place[shape_slots] = {};
        Index places_used = 0, shapes_moved = 0;

        SortedTreeView sorted() { return {leaves, boxes, places(), keys, other_keys, other_pairs, counters, place, &places_used, &shapes_moved}; }
        SortedTreeView tree_of_bounds() { return sorted(); }
        void find_pairs(const SearchView& search, const PairList& pairs) { find_pairs_by_tree(search, sorted(), pairs); }
    };

    template <int max_bodies, int max_pairs>
    struct Memory : TreeMemory<max_bodies, max_pairs> {
        uint8_t search_flags[Memory::shape_slots] = {};

        bool search(const SearchView& search, scalar h, const PairList& pairs, bool bounded) {
            return search_by_tree(search, this->sorted(), h, pairs, bounded);
        }
    };

    /// For scenes whose bodies sleep; they have the flags of the search.
    template <int max_bodies, int max_pairs>
    struct AwakeMemory : TreeMemory<max_bodies, max_pairs> {
        uint32_t* due_shapes() { return this->counters; }
        void find_due_pairs(const SearchView& search, int due_count, const PairList& pairs) {
            find_due_pairs_by_tree(search, this->sorted(), due_shapes(), due_count, pairs);
        }
    };
};

} }  // namespace ingot

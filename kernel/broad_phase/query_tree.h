// SPDX-License-Identifier: MIT
#pragma once

#include "sorted_tree.h"

namespace ingot { inline namespace INGOT_ABI {

/// `using broad_phase = ingot::QueryTree;`: SortedTree, for scenes that ask for rays, casts, overlaps or what is nearest among hundreds of bodies.
///
/// The search for pairs needs no more of a tree than that it holds the fat AABBs of the last search. Queries ask where bodies are now: so the end of
/// a step, and whatever adds, moves or reshapes a body, sees to it that the boxes hold its shapes there (hold_shapes). A tree that was not built anew
/// in a step gets an order made for queries, once (part_leaves). A body elsewhere than it was keeps its place in the order until the tree is built
/// again; many of those make queries slower, and none wrong.
/// Memory, pairs and the bits of a step are those of SortedTree. Cost: hold_shapes for each shape that is awake, in every step; part_leaves.
struct QueryTree : SortedTree {
    static constexpr const char* name = "query_tree";
    static constexpr bool answers_queries = true;
};

} }  // namespace ingot

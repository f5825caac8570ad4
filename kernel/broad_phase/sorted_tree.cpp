// SPDX-License-Identifier: MIT
#include "sorted_tree.h"

#include "tree_walk.h"

namespace ingot { inline namespace INGOT_ABI {

void find_pairs_by_tree(const BodyView& bodies, const BoundsTile* bounds, const SortedTreeView& tree, const PairList& pairs) {
    using namespace trees;
    *pairs.count = *pairs.lost = 0;
    search_tree(tree, build_tree(bodies, bounds, tree), pairs, [](int, int) { return true; });
    sort_pairs(tree, pairs, bodies.tile_count * lanes);
}

} }  // namespace ingot

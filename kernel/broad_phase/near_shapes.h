// SPDX-License-Identifier: MIT
// Shapes near a box, from the tree of the last search: for who has to know more of a step than its pairs.
#pragma once

#include "tree_walk.h"

namespace ingot { inline namespace INGOT_ABI {

/// Calls each(shape slot) for the shapes whose fat AABBs overlap the box, in the order of the tree. Cost: O(log shapes), and what it finds.
template <class Each>
void for_near_shapes(const SortedTreeView& tree, const TreeBox& box, const Each& each) {
    // bound: 2 leaf_places: every turn goes down or to the next box in the order of the tree, whose last has none: 0
    for (int box_i = 1; box_i != 0;) {
        const bool meets = trees::overlap(tree.boxes[box_i], box);
        if (meets && box_i < tree.leaf_places) {
            box_i *= 2;
            continue;
        }
        if (meets) {
            const TreeLeaf& leaf = tree.leaves[box_i - tree.leaf_places];
            for (int i = 0; i < leaf_bodies; ++i) {
                const TreeBox of_shape = {{leaf.low[0][i], leaf.low[1][i], leaf.low[2][i]}, {leaf.high[0][i], leaf.high[1][i], leaf.high[2][i]}};
                if (trees::overlap(of_shape, box)) each(static_cast<int>(leaf.slot[i]));
            }
        }
        box_i = trees::next_box(box_i);
    }
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "sorted_tree.h"

namespace ingot { inline namespace INGOT_ABI {

/// The order of a tree is made one for queries, once it has outlived a step: every box is cut at its middle shape, along its longest side.
///
/// Along the Morton curve a box of many shapes may be two clouds far apart, and a ray looks into much that it does not come near. The curve is
/// faster made, so a tree that is built anew in every step stays as it is; to be called at the end of each.
/// Returns: true where the order has changed; boxes then hold all shapes where they are now.
/// Cost:    O(shapes log(shapes)) once for a tree, and never more than 21 times that however centres lie. No memory beside the tree's.
/// Source:  median splits as in Bentley, "Multidimensional binary search trees", 1975; the tree is the implicit one of SortedTreeView.
bool part_leaves(const SearchView& search, const SortedTreeView& tree);

} }  // namespace ingot

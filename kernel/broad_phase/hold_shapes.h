// SPDX-License-Identifier: MIT
#pragma once

#include "sorted_tree.h"

namespace ingot { inline namespace INGOT_ABI {

/// Shapes have places in the tree, and their boxes there hold them where they are now, beside their fat AABBs. See QueryTree.
///
/// slot: from the first to the one before the last. Those that are none are left alone. Before a search has built the tree nothing is done.
/// Cost: about 40 flops a shape; O(log shapes) more for one that its box does not hold yet.
void hold_shapes(const SearchView& search, const SortedTreeView& tree, int first, int last);

} }  // namespace ingot

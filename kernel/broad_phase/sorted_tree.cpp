// SPDX-License-Identifier: MIT
#include "sorted_tree.h"

#include "../base/sort_in_tail.h"
#include "tree_walk.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

using namespace trees;

/// The tree, with a place for each shape.
void build_with_places(const SearchView& search, const SortedTreeView& tree) {
    // bound: max_bodies max_shapes_of_body, rounded up to whole tiles
    for (int slot = 0; slot < search.shapes.tile_count * lanes; ++slot) {
        tree.place[slot] = 0;
        search.clear(slot, SearchFlag::moved);
    }
    const int count = build_tree(search.shapes, search.bounds, tree);
    note_places(tree, count);
    *tree.used = static_cast<Index>(count);
    *tree.moved = 0;
}

/// A shape has another fat AABB, or is new, or gone.
void replace(const SearchView& search, const SortedTreeView& tree, int slot) {
    const TreeBox box = box_of(search.bounds, slot);
    if (!search.has(slot, SearchFlag::moved)) ++*tree.moved;
    search.set(slot, SearchFlag::moved);
    put_in_place(tree, slot, box, search.moves(slot));
}

/// Pairs of one shape with those of a leaf. Of two that are due the lower finds the pair.
void test_leaf(const SearchView& search, const TreeBox& box, int slot, bool moves, const TreeLeaf& leaf, const PairList& pairs) {
    const scalar low[3] = {box.low.x, box.low.y, box.low.z}, high[3] = {box.high.x, box.high.y, box.high.z};
    for (int first = 0; first < leaf_bodies; first += lanes) {
        mask meet = splat<lane>(1) > lane{};
        for (int axis = 0; axis < 3; ++axis)
            meet = both(meet, both(load(leaf.low[axis] + first) <= splat<lane>(high[axis]), splat<lane>(low[axis]) <= load(leaf.high[axis] + first)));
        unsigned found = bits(meet);
        // bound: lanes: found has a bit a lane
        for (int k = first; found != 0; ++k, found >>= 1) {
            const int other = leaf.slot[k];
            if ((found & 1u) == 0 || other == slot || !(moves || leaf.moves[k] != 0)) continue;
            if (other < slot && search.has(other, SearchFlag::due)) continue;
            pairs.add(other < slot ? other : slot, other < slot ? slot : other);
        }
    }
}

void find_pairs_of(const SearchView& search, const SortedTreeView& tree, int slot, const PairList& pairs) {
    const TreeBox box = box_of(search.bounds, slot);
    if (!(box.low.x <= box.high.x)) return;
    const bool moves = search.moves(slot);
    // bound: 2 leaf_places: every turn goes down or to the next box in the order of the tree, whose last has none: 0
    for (int box_i = 1; box_i != 0;) {
        const bool meets = overlap(tree.boxes[box_i], box);
        if (meets && box_i < tree.leaf_places) {
            box_i *= 2;
            continue;
        }
        if (meets) test_leaf(search, box, slot, moves, tree.leaves[box_i - tree.leaf_places], pairs);
        box_i = next_box(box_i);
    }
}

/// Below this many the tree is as good as new.
constexpr int moved_min = 64;

}  // namespace

void find_pairs_by_tree(const SearchView& search, const SortedTreeView& tree, const PairList& pairs) {
    *pairs.count = *pairs.lost = 0;
    build_with_places(search, tree);
    search_tree(tree, *tree.used, pairs,
                [&](int A, int B) { return search.has(A, SearchFlag::searched) || search.has(B, SearchFlag::searched); });
    sort_pairs(tree, pairs, search.shapes.tile_count * lanes);
    for (int slot = 0; slot < search.shapes.tile_count * lanes; ++slot) search.clear(slot, SearchFlag::due);
}

void find_due_pairs_by_tree(const SearchView& search, const SortedTreeView& tree, const uint32_t* due, int due_count, const PairList& pairs) {
    if (2 * due_count > *tree.used) return find_pairs_by_tree(search, tree, pairs);
    int kept = 0;
    // bound: pairs_with_own of scene.h
    for (int pair_i = 0; pair_i < *pairs.count; ++pair_i) {
        const BodyPair pair = pairs.pairs[pair_i];
        if (!search.has(pair.body_A, SearchFlag::due) && !search.has(pair.body_B, SearchFlag::due)) pairs.pairs[kept++] = pair;
    }
    *pairs.count = static_cast<Index>(kept);
    // bound: max_bodies max_shapes_of_body
    for (int due_i = 0; due_i < due_count; ++due_i) replace(search, tree, static_cast<int>(due[due_i]));
    for (int due_i = 0; due_i < due_count; ++due_i) find_pairs_of(search, tree, static_cast<int>(due[due_i]), pairs);
    for (int due_i = 0; due_i < due_count; ++due_i) search.clear(static_cast<int>(due[due_i]), SearchFlag::due);
    sort_in_tail(pairs.pairs, kept, *pairs.count, tree.other_pairs);
    if (*tree.moved > moved_min + *tree.used / 2) build_with_places(search, tree);
}

bool search_by_tree(const SearchView& search, const SortedTreeView& tree, scalar h, const PairList& pairs, bool bounded) {
    const bool crowded = *pairs.lost > 0;
    const int due = refresh_bounds_and_due(search, h, tree.counters, bounded);
    if (due > 0 && !crowded) find_due_pairs_by_tree(search, tree, tree.counters, due, pairs);
    if (*pairs.lost > 0) {
        shrink_bounds(search.shapes, search.bounds);
        find_pairs_by_tree(search, tree, pairs);
    }
    return due > 0 || crowded;
}

} }  // namespace ingot

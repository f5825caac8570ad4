// SPDX-License-Identifier: MIT
// What the searches by a tree have in common: how it is built, and how it is walked.
#pragma once

#include "sorted_tree.h"

#include "../base/limits.h"

namespace ingot { inline namespace INGOT_ABI { namespace trees {

inline constexpr scalar no_place = 2 * limits::unbounded;
inline constexpr TreeBox nothing = {{no_place, no_place, no_place}, {-no_place, -no_place, -no_place}};
inline constexpr int code_bits = 10;  // along each axis
inline constexpr int levels_max = INGOT_INDEX_BITS == 32 ? 22 : 14;  // of boxes, those of leaves among them: index_max shapes, 8 of them in a leaf

inline TreeBox around(const TreeBox& a, const TreeBox& b) { return {min(a.low, b.low), max(a.high, b.high)}; }

inline bool overlap(const TreeBox& a, const TreeBox& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y && a.low.z <= b.high.z && b.low.z <= a.high.z;
}

inline TreeBox box_of(const BoundsTile* bounds, int slot) {
    const Place at = place_of(slot);
    return {lane_of(bounds[at.tile].fat_low, at.lane), lane_of(bounds[at.tile].fat_high, at.lane)};
}
/// A box without an end on a side counts as if it lay at the origin, so that it does not spoil the order of the others.
inline scalar centre(scalar low, scalar high) {
    return low <= -limits::unbounded || high >= limits::unbounded ? scalar(0) : (low + high) * scalar(0.5);
}
inline Vector centre_of(const TreeBox& box) { return {centre(box.low.x, box.high.x), centre(box.low.y, box.high.y), centre(box.low.z, box.high.z)}; }

/// Spreads the bits of a coordinate to every third place.
inline uint32_t spread(uint32_t x) {
    x = (x | x << 16) & 0x030000ffu;
    x = (x | x << 8) & 0x0300f00fu;
    x = (x | x << 4) & 0x030c30c3u;
    return (x | x << 2) & 0x09249249u;
}

inline uint32_t cell(scalar x, scalar low, scalar cells_per_metre) {
    constexpr scalar last = (1 << code_bits) - 1;
    const scalar at = (x - low) * cells_per_metre;
    return at > 0 ? static_cast<uint32_t>(at < last ? at : last) : 0;
}

/// Keys of all bodies that have bounds, in the order of the slots. Returns how many.
inline int make_keys(const BodyView& bodies, const BoundsTile* bounds, const SortedTreeView& tree) {
    int count = 0;
    TreeBox all = nothing;
    // bound: max_bodies max_shapes_of_body, rounded up to whole tiles: only a member named slot is written, of a key
    for (int slot = 0; slot < bodies.tile_count * lanes; ++slot) {
        const TreeBox box = box_of(bounds, slot);
        if (!(box.low.x <= box.high.x)) continue;
        const Vector centre = centre_of(box);
        all = around(all, {centre, centre});
        tree.keys[count++].slot = static_cast<Index>(slot);
    }
    const Vector size = all.high - all.low;
    const auto cells_per_metre = [](scalar extent) { return extent > 0 ? (1 << code_bits) / extent : scalar(0); };
    const Vector per_metre = {cells_per_metre(size.x), cells_per_metre(size.y), cells_per_metre(size.z)};
    // bound: max_bodies max_shapes_of_body
    for (int key_i = 0; key_i < count; ++key_i) {
        TreeKey& key = tree.keys[key_i];
        const Vector c = centre_of(box_of(bounds, key.slot));
        key.code = spread(cell(c.x, all.low.x, per_metre.x)) | spread(cell(c.y, all.low.y, per_metre.y)) << 1 |
                   spread(cell(c.z, all.low.z, per_metre.z)) << 2;
    }
    return count;
}

/// Stable sort by counting: `bucket` gives a number below bucket_count.
template <class Item, class Bucket>
void sort_by(const Item* from, Item* to, int count, uint32_t* counters, int bucket_count, const Bucket& bucket) {
    // bound: 1 << code_bits, or the slots of all shapes: max_bodies max_shapes_of_body, rounded up to whole tiles
    for (int i = 0; i < bucket_count; ++i) counters[i] = 0;
    // bound: max_bodies max_shapes_of_body, or pairs_with_own of scene.h
    for (int i = 0; i < count; ++i) ++counters[bucket(from[i])];
    uint32_t sum = 0;
    for (int i = 0; i < bucket_count; ++i) {
        const uint32_t size = counters[i];
        counters[i] = sum;
        sum += size;
    }
    for (int i = 0; i < count; ++i) to[counters[bucket(from[i])]++] = from[i];
}

inline void sort_keys(const SortedTreeView& tree, int count) {
    TreeKey *from = tree.keys, *to = tree.other_keys;
    for (int pass_i = 0; pass_i < 3; ++pass_i) {
        sort_by(from, to, count, tree.counters, 1 << code_bits,
                [&](const TreeKey& key) { return key.code >> code_bits * pass_i & ((1u << code_bits) - 1); });
        TreeKey* const sorted = to;
        to = from;
        from = sorted;
    }
}

/// Leaves from the sorted keys, which three passes leave in other_keys.
inline void make_leaves(const BodyView& bodies, const BoundsTile* bounds, const SortedTreeView& tree, int body_count) {
    const int leaf_count = (body_count + leaf_bodies - 1) / leaf_bodies;
    // bound: max_bodies max_shapes_of_body / leaf_bodies, rounded up to a power of two
    for (int leaf_i = 0; leaf_i < tree.leaf_places; ++leaf_i) {
        TreeBox all = nothing;
        for (int i = 0; leaf_i < leaf_count && i < leaf_bodies; ++i) {
            const int key_i = leaf_i * leaf_bodies + i;
            const bool there = key_i < body_count;
            const int slot = there ? tree.other_keys[key_i].slot : 0;
            const TreeBox box = there ? box_of(bounds, slot) : nothing;
            TreeLeaf& leaf = tree.leaves[leaf_i];
            const scalar low[3] = {box.low.x, box.low.y, box.low.z}, high[3] = {box.high.x, box.high.y, box.high.z};
            for (int axis = 0; axis < 3; ++axis) {
                leaf.low[axis][i] = low[axis];
                leaf.high[axis][i] = high[axis];
            }
            const Place at = place_of(slot);
            leaf.slot[i] = static_cast<Index>(slot);
            leaf.moves[i] = there && bodies.translation[at.tile].inv_M[at.lane] > 0;
            all = around(all, box);
        }
        tree.boxes[tree.leaf_places + leaf_i] = all;
    }
    // bound: max_bodies max_shapes_of_body / leaf_bodies, rounded up to a power of two
    for (int box_i = tree.leaf_places - 1; box_i > 0; --box_i) tree.boxes[box_i] = around(tree.boxes[2 * box_i], tree.boxes[2 * box_i + 1]);
}

/// Where each shape of the order is.
inline void note_places(const SortedTreeView& tree, int count) {
    // bound: max_bodies max_shapes_of_body
    for (int key_i = 0; key_i < count; ++key_i) tree.place[tree.other_keys[key_i].slot] = static_cast<Index>(key_i + 1);
}

inline void set_leaf(TreeLeaf& leaf, int i, const TreeBox& box, int slot, bool moves) {
    const scalar low[3] = {box.low.x, box.low.y, box.low.z}, high[3] = {box.high.x, box.high.y, box.high.z};
    for (int axis = 0; axis < 3; ++axis) {
        leaf.low[axis][i] = low[axis];
        leaf.high[axis][i] = high[axis];
    }
    leaf.slot[i] = static_cast<Index>(slot);
    leaf.moves[i] = moves ? 1 : 0;
}

/// The box of a leaf and those above it.
inline void refit(const SortedTreeView& tree, int leaf_i) {
    const TreeLeaf& leaf = tree.leaves[leaf_i];
    TreeBox all = nothing;
    for (int i = 0; i < leaf_bodies; ++i)
        all = around(all, {{leaf.low[0][i], leaf.low[1][i], leaf.low[2][i]}, {leaf.high[0][i], leaf.high[1][i], leaf.high[2][i]}});
    int box_i = tree.leaf_places + leaf_i;
    tree.boxes[box_i] = all;
    // bound: log2(leaf_places): box_i halves each turn
    for (box_i /= 2; box_i > 0; box_i /= 2) tree.boxes[box_i] = around(tree.boxes[2 * box_i], tree.boxes[2 * box_i + 1]);
}

/// A shape has this box from now on: in its place, or in the next free one. One that has neither box nor place gets none.
INGOT_INLINE void put_in_place(const SortedTreeView& tree, int slot, const TreeBox& box, bool moves) {
    if (tree.place[slot] == 0) {
        if (!(box.low.x <= box.high.x)) return;
        const int place = (*tree.used)++;
        tree.place[slot] = static_cast<Index>(place + 1);
        if (place % leaf_bodies == 0)
            for (int i = 0; i < leaf_bodies; ++i) set_leaf(tree.leaves[place / leaf_bodies], i, nothing, 0, false);
    }
    const int place = tree.place[slot] - 1;
    set_leaf(tree.leaves[place / leaf_bodies], place % leaf_bodies, box, slot, moves);
    refit(tree, place / leaf_bodies);
}

/// The pairs between two leaves, or within one, for which wanted(slot, slot) is true.
template <class Wanted>
INGOT_INLINE void test_leaves(const TreeLeaf& A, const TreeLeaf& B, const PairList& pairs, const Wanted& wanted) {
    const bool same = &A == &B;
    for (int i = 0; i < leaf_bodies; ++i) {
        if (!(A.low[0][i] <= A.high[0][i])) continue;
        lane low[3], high[3];
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = splat<lane>(A.low[axis][i]);
            high[axis] = splat<lane>(A.high[axis][i]);
        }
        for (int first = 0; first < leaf_bodies; first += lanes) {
            mask meet = splat<lane>(1) > lane{};
            for (int axis = 0; axis < 3; ++axis)
                meet = both(meet, both(load(B.low[axis] + first) <= high[axis], low[axis] <= load(B.high[axis] + first)));
            unsigned found = bits(meet);
            // bound: lanes: found has a bit a lane
            for (int k = first; found != 0; ++k, found >>= 1) {
                if ((found & 1u) == 0 || (same && k <= i) || (A.moves[i] | B.moves[k]) == 0) continue;
                const Index a = A.slot[i], b = B.slot[k];
                if (wanted(a, b)) pairs.add(a < b ? a : b, a < b ? b : a);
            }
        }
    }
}

/// The next box after one whose inside is done with; 0 after the last.
inline int next_box(int box_i) {
    // bound: log2(leaf_places) + 1: a bit falls out each turn
    while ((box_i & 1) != 0) box_i >>= 1;
    return box_i == 0 ? 0 : box_i + 1;
}

inline void sort_pairs(const SortedTreeView& tree, const PairList& pairs, int slot_count) {
    sort_by(pairs.pairs, tree.other_pairs, *pairs.count, tree.counters, slot_count, [](const BodyPair& pair) { return pair.body_B; });
    sort_by(tree.other_pairs, pairs.pairs, *pairs.count, tree.counters, slot_count, [](const BodyPair& pair) { return pair.body_A; });
}

/// The tree over all bodies that have fat AABBs. Returns how many.
inline int build_tree(const BodyView& bodies, const BoundsTile* bounds, const SortedTreeView& tree) {
    const int body_count = make_keys(bodies, bounds, tree);
    sort_keys(tree, body_count);
    make_leaves(bodies, bounds, tree, body_count);
    return body_count;
}

/// Each leaf looks for the leaves after it that it overlaps.
template <class Wanted>
INGOT_INLINE void search_tree(const SortedTreeView& tree, int body_count, const PairList& pairs, const Wanted& wanted) {
    const int leaf_count = (body_count + leaf_bodies - 1) / leaf_bodies;
    // bound: max_bodies max_shapes_of_body / leaf_bodies, rounded up
    for (int leaf_i = 0; leaf_i < leaf_count; ++leaf_i) {
        const TreeLeaf& leaf = tree.leaves[leaf_i];
        const TreeBox& box = tree.boxes[tree.leaf_places + leaf_i];
        test_leaves(leaf, leaf, pairs, wanted);
        // bound: 2 leaf_places: every turn goes down or to the next box in the order of the tree, whose last has none: 0
        for (int box_i = next_box(tree.leaf_places + leaf_i); box_i != 0;) {
            const bool meets = overlap(tree.boxes[box_i], box);
            if (meets && box_i < tree.leaf_places) {
                box_i *= 2;
                continue;
            }
            if (meets) test_leaves(leaf, tree.leaves[box_i - tree.leaf_places], pairs, wanted);
            box_i = next_box(box_i);
        }
    }
}

} } }  // namespace ingot::trees

// SPDX-License-Identifier: MIT
#include "crowd.h"

#include "../base/report.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// How far the bounds of two shapes overlap, along the axis where it is least, m.
scalar overlap_of_bounds(const BoundsTile* bounds, const BodyPair& pair) {
    const TreeBox A = trees::box_of(bounds, pair.body_A), B = trees::box_of(bounds, pair.body_B);
    const Vector low = max(A.low, B.low), high = min(A.high, B.high), size = high - low;
    const scalar least = size.x < size.y ? size.x : size.y;
    return least < size.z ? least : size.z;
}

Index rank_of_pair(const SearchView& search, const HeldPairs& held, const BodyPair& pair) {
    const bool is_held = place_in(held.pairs, held.count, pair.key()) >= 0;
    // Bounds overlap before shapes do, and by more: half of what they overlap by is as good a guess as any.
    const scalar urgency = overlap_of_bounds(search.bounds, pair) / (2 * lesser_radius(search.surfaces, pair)) - 1;
    return rank_of(!search.moves(pair.body_A) || !search.moves(pair.body_B), urgency + (is_held ? limits::crowd_patience : scalar(0)));
}

}  // namespace

int place_in(const BodyPair* pairs, int count, PairKey key) {
    int low = 0, high = count;
    // bound: log2 of the count: what is between them halves each turn
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (pairs[middle].key() < key)
            low = middle + 1;
        else
            high = middle;
    }
    return low < count && pairs[low].key() == key ? low : -1;
}

void NextNeighbours::note(int slot) {
    if (is_full() && slot >= slots[room - 1]) return;
    if (!is_full()) ++count;
    int at = count - 1;
    // bound: NextNeighbours::room
    for (; at > 0 && slots[at - 1] > slot; --at) slots[at] = slots[at - 1];
    slots[at] = static_cast<Index>(slot);
}

template <class Tree>
void keep_urgent_pairs(const SearchView& search, const Tree& tree, const PairsOfInterest& of_interest, const HeldPairs& held, const PairList& list) {
    const auto rank_in_pair = [](const BodyPair& pair) { return pair.record; };
    const FullList<decltype(rank_in_pair)> full{list.pairs, list.capacity, rank_in_pair};
    *list.count = *list.lost = 0;
    for_near_pairs(search, tree, of_interest, [&](int A, int B) {
        BodyPair pair = {static_cast<Index>(A), static_cast<Index>(B), 0};
        pair.record = rank_of_pair(search, held, pair);
        if (*list.count < list.capacity) {
            list.pairs[(*list.count)++] = pair;
            if (*list.count == list.capacity) full.make();
            return;
        }
        count(*list.lost);
        if (full.gives_way(list.pairs[0], pair)) full.replace_top(pair);
    });
    sort_by_key(list.pairs, *list.count);
    for (int pair_i = 0; pair_i < *list.count; ++pair_i) list.pairs[pair_i].record = no_record;  // bound: pairs_with_own of scene.h
}
// The linker takes the one that the scene calls.
template void keep_urgent_pairs<NoTree>(const SearchView&, const NoTree&, const PairsOfInterest&, const HeldPairs&, const PairList&);
template void keep_urgent_pairs<SortedTreeView>(const SearchView&, const SortedTreeView&, const PairsOfInterest&, const HeldPairs&, const PairList&);

} }  // namespace ingot

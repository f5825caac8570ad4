// SPDX-License-Identifier: MIT
#pragma once

#include "config.h"

namespace ingot { inline namespace INGOT_ABI {

/// Copies byte by byte what the members leave between them too: so equal lists are equal bytes.
template <class Item>
INGOT_INLINE void copy_item(Item& to, const Item& from) {
    INGOT_COPY_BYTES(static_cast<void*>(&to), static_cast<const void*>(&from), sizeof to);
}

/// Sorts items by key(), in place. Equal keys come in no order.
///
/// Cost:   about 2 n log2 n comparisons, at worst too.
/// Source: Williams, "Algorithm 232: Heapsort", 1964.
template <class Item>
void sort_by_key(Item* items, int count) {
    const auto exchange = [items](int a, int b) {
        alignas(Item) unsigned char kept[sizeof(Item)];
        INGOT_COPY_BYTES(kept, static_cast<const void*>(items + a), sizeof kept);
        copy_item(items[a], items[b]);
        INGOT_COPY_BYTES(static_cast<void*>(items + b), kept, sizeof kept);
    };
    const auto sift = [items, &exchange](int parent, int end) {
        // bound: log2 of the count: child more than doubles each turn
        for (int child = 2 * parent + 1; child < end; parent = child, child = 2 * parent + 1) {
            if (child + 1 < end && items[child].key() < items[child + 1].key()) ++child;
            if (!(items[parent].key() < items[child].key())) return;
            exchange(parent, child);
        }
    };
    // bound: of the list: max_pairs, max_manifolds
    for (int parent = count / 2 - 1; parent >= 0; --parent) sift(parent, count);
    // bound: of the list: max_pairs, max_manifolds
    for (int end = count - 1; end > 0; --end) {
        exchange(0, end);
        sift(0, end);
    }
}

/// Items [0, sorted) are sorted; those behind them come in any order, and are sorted in. scratch has room for as many as there are of these.
/// Cost: sort_by_key of the tail, and a walk along those that stand behind its first.
template <class Item>
void sort_in_tail(Item* items, int sorted, int count, Item* scratch) {
    const int tail = count - sorted;
    if (tail <= 0) return;
    sort_by_key(items + sorted, tail);
    // bound: of the list: max_pairs, max_manifolds
    for (int i = 0; i < tail; ++i) copy_item(scratch[i], items[sorted + i]);
    int from = sorted - 1, new_i = tail - 1;
    // bound: of the list: each turn places one, and new_i falls whenever from does not; below zero from stays
    for (int to = count - 1; new_i >= 0; --to) {
        if (from >= 0 && scratch[new_i].key() < items[from].key())
            copy_item(items[to], items[from--]);
        else
            copy_item(items[to], scratch[new_i--]);
    }
}

} }  // namespace ingot

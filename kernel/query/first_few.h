// SPDX-License-Identifier: MIT
#pragma once

#include "query_filter.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of entries that come in any order the first few, as many as there is room for: a heap, the last of them first. IsBefore: bool(Entry, Entry).
template <class Entry, class IsBefore>
class FirstFew {
public:
    FirstFew(Entry* entries, int capacity) : entries_(entries), capacity_(capacity) {}

    /// Cost: O(log capacity).
    void add(const Entry& entry) {
        if (held_ == capacity_) {
            if (held_ > 0 && is_before_(entry, entries_[0])) sink(held_, entry);
            return;
        }
        int place = held_++;
        // bound: log2 of the entries that are held: place halves each turn
        for (; place > 0 && is_before_(entries_[(place - 1) / 2], entry); place = (place - 1) / 2) entries_[place] = entries_[(place - 1) / 2];
        entries_[place] = entry;
    }
    /// In order; nothing can be added after it.
    void sort() {
        // bound: max_bodies: entries that are held
        for (int end = held_ - 1; end > 0; --end) {
            const Entry last = entries_[end];
            entries_[end] = entries_[0];
            sink(end, last);
        }
    }

private:
    /// In the place of the first of entries_[0 .. end).
    void sink(int end, const Entry& entry) {
        int place = 0;
        // bound: log2 of the entries that are held: child more than doubles each turn
        for (int child = 1; child < end; child = 2 * place + 1) {
            if (child + 1 < end && is_before_(entries_[child], entries_[child + 1])) ++child;
            if (!is_before_(entry, entries_[child])) break;
            entries_[place] = entries_[child];
            place = child;
        }
        entries_[place] = entry;
    }

    Entry* entries_;
    int capacity_, held_ = 0;
    IsBefore is_before_;
};

struct HasLowerSlot {
    bool operator()(const BodyId& a, const BodyId& b) const { return a.slot < b.slot; }
};
/// Of two at the same place the lower slot is first.
struct IsMetBefore {
    bool operator()(const QueryHit& a, const QueryHit& b) const {
        return a.fraction < b.fraction || (!(b.fraction < a.fraction) && a.body.slot < b.body.slot);
    }
};

} }  // namespace ingot

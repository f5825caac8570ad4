// SPDX-License-Identifier: MIT
#pragma once

#include "../base/ids.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of ids that come in any order, those of the lowest slots, as many as there is room for: a heap, the highest slot first.
class LowestIds {
public:
    LowestIds(BodyId* ids, int capacity) : ids_(ids), capacity_(capacity) {}

    /// Cost: O(log capacity).
    void add(BodyId id) {
        if (held_ == capacity_) {
            if (held_ > 0 && id.slot < ids_[0].slot) sink(held_, id);
            return;
        }
        int place = held_++;
        // bound: log2 of the ids that are held: place halves each turn
        for (; place > 0 && ids_[(place - 1) / 2].slot < id.slot; place = (place - 1) / 2) ids_[place] = ids_[(place - 1) / 2];
        ids_[place] = id;
    }
    /// In the order of slots; nothing can be added after it.
    void sort() {
        // bound: max_bodies: ids that are held
        for (int end = held_ - 1; end > 0; --end) {
            const BodyId last = ids_[end];
            ids_[end] = ids_[0];
            sink(end, last);
        }
    }

private:
    /// In the place of the first of ids_[0 .. end).
    void sink(int end, BodyId id) {
        int place = 0;
        // bound: log2 of the ids that are held: child more than doubles each turn
        for (int child = 1; child < end; child = 2 * place + 1) {
            if (child + 1 < end && ids_[child].slot < ids_[child + 1].slot) ++child;
            if (ids_[child].slot <= id.slot) break;
            ids_[place] = ids_[child];
            place = child;
        }
        ids_[place] = id;
    }

    BodyId* ids_;
    int capacity_, held_ = 0;
};

} }  // namespace ingot

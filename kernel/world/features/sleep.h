// SPDX-License-Identifier: MIT
// Bodies at rest that are left out of the step, and fast ones that are followed within it.
#pragma once

#include "../../base/sort_in_tail.h"
#include "../../continuous/body_path.h"
#include "../../island/islands.h"
#include "../../sleep/at_rest.h"
#include "../../sleep/fall_asleep.h"
#include "../../sleep/wake.h"
#include "joints.h"
#include "manifolds.h"
#include "sensors_and_events.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of the manifolds that have come back behind the first `sorted`, those that touch go to the list of those that do.
template <class S>
void list_woken_touch(Storage<S>& storage, int sorted) {
    const PairOfBodiesList touching = storage.touching_list();
    const uint32_t* generation_of = storage.generation_of_shapes(storage.generation);
    const int touched = *touching.count;
    for (int pair_i = sorted; pair_i < storage.manifold_count; ++pair_i) {  // bound: max_manifolds
        const BodyPair& pair = storage.pairs[pair_i];
        if (storage.touches_aside[pair.record] == 0) continue;
        storage.touches_aside[pair.record] = 0;
        if (*touching.count == touching.capacity) continue;  // only of a snapshot that says of more than there are that they touch
        write_pair(touching.pairs[(*touching.count)++],
                   {pair.body_A, pair.body_B, generation_of[pair.body_A], generation_of[pair.body_B], false});
    }
    sort_in_tail(touching.pairs, touched, *touching.count, storage.touching_before);
}

/// Manifolds that have come back behind the first `sorted` take their place among those of the step.
template <class S>
void sort_in_woken(Storage<S>& storage, int sorted) {
    if constexpr (has_events<S>) list_woken_touch(storage, sorted);
    sort_in_tail(storage.pairs, sorted, storage.manifold_count, storage.awake_pairs);
}

/// Whatever wakes between two steps or at the begin of one: call(manifolds) brings manifolds back.
template <class S, class Call>
void wake_by(Storage<S>& storage, const Call& call) {
    const int sorted = storage.manifold_count;
    call(storage.manifold_view());
    sort_in_woken(storage, sorted);
}

/// Leaves the pairs of a sorted list one by one, in the order of their keys.
struct ListWithout {
    PairOfBodiesList list;
    int from = 0, kept = 0;

    /// True when the pair was in the list. Needs: keys that rise from call to call.
    bool take(PairKey key) {
        // bound: max_manifolds, in all calls
        while (from < *list.count && list.pairs[from].key() < key) copy_item(list.pairs[kept++], list.pairs[from++]);
        const bool found = from < *list.count && list.pairs[from].key() == key;
        from += found ? 1 : 0;
        return found;
    }
    void close() {
        while (from < *list.count) copy_item(list.pairs[kept++], list.pairs[from++]);  // bound: max_manifolds
        *list.count = static_cast<Index>(kept);
    }
};

/// Manifolds of what rests leave the lists of the step.
template <class S>
void put_aside(Storage<S>& storage) {
    if constexpr (has_events<S>) {
        ListWithout touching{storage.touching_list()};
        put_manifolds_aside(storage.bodies(), storage.rest_view(), storage.manifold_view(), [&](const BodyPair& pair) {
            if (touching.take(pair.key())) storage.touches_aside[pair.record] = 1;
        });
        touching.close();
    } else {
        put_manifolds_aside(storage.bodies(), storage.rest_view(), storage.manifold_view(), [](const BodyPair&) {});
    }
}

/// Contacts that a snapshot holds.
template <class S>
int saved_manifold_count([[maybe_unused]] const Storage<S>& storage) {
    int count = 0;
    if constexpr (stacks<S>) count = storage.manifold_count;
    if constexpr (S::sleeps) count += storage.aside_count;
    return count;
}

/// Calls each(pair) for all contacts in the order of slots: those of the step, and those that are put aside. These lie in no order: all are sorted at
/// the end of the room that their contacts are going to be written to, which never reaches one that is still to be read.
template <class S, class Each>
void for_manifolds(const Storage<S>& storage, [[maybe_unused]] uint8_t* room, [[maybe_unused]] size_t bytes_of_manifold, const Each& each) {
    if constexpr (S::sleeps) {
        const int count = saved_manifold_count(storage);
        const size_t spare = static_cast<size_t>(count) * (bytes_of_manifold - sizeof(PairBytes));
        PairBytes* const sorted = reinterpret_cast<PairBytes*>(room + spare);
        int listed = 0;
        for (int pair_i = 0; pair_i < storage.manifold_count; ++pair_i) sorted[listed++] = bytes_of(storage.pairs[pair_i]);  // bound: max_manifolds
        for (int record_i = 0; record_i < storage.records_used; ++record_i) {  // bound: max_manifolds
            const BodyPair& aside = storage.pairs_aside[record_i];
            if (aside.record != 0) sorted[listed++] = bytes_of({aside.body_A, aside.body_B, static_cast<Index>(record_i)});
        }
        sort_by_key(sorted, count);
        for (int pair_i = 0; pair_i < count; ++pair_i) each(sorted[pair_i].pair());  // bound: max_manifolds
    } else {
        for (int pair_i = 0; pair_i < storage.manifold_count; ++pair_i) each(storage.pairs[pair_i]);
    }
}

/// Slots without a shape overlap nothing: a search that looks at what is awake makes no bounds for them.
template <class S>
void empty_bounds(Storage<S>& storage, int first, int last) {
    for (int shape_slot = first; shape_slot <= last; ++shape_slot) empty_bounds(storage.bounds, shape_slot);  // bound: max_shapes_of_body and lanes
}

namespace features {

struct Continuous : Feature {
    template <class S>
    static constexpr bool named = S::continuous;

    template <class S, bool present>
    struct Memory {
        BodyPath paths[static_cast<unsigned>(S::max_bodies)] = {};
        Index followed[static_cast<unsigned>(S::max_bodies)] = {};  ///< see FollowedBodies
    };
    template <class S>
    struct Memory<S, false> {};

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::continuous);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(!S::continuous || stacks<S>,
                      "fast bodies are followed in scenes of contacts with friction: set max_manifolds, or continuous = false");
        return true;
    }
};

/// Of manifolds that are put aside, which touch: the list of those that do holds the pairs of the step alone.
struct TouchAside : Feature {
    static constexpr uint32_t part = 1u << 18;
    template <class S>
    static constexpr bool named = S::sleeps && has_events<S>;

    template <class S, bool present>
    struct Memory {
        uint8_t touches_aside[static_cast<unsigned>(S::max_manifolds)] = {};  ///< by record; 0 for those of the step
    };
    template <class S>
    struct Memory<S, false> {};

    struct OfManifold : NoNumbers {
        uint8_t touches;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("touches_aside", touches);
        }
        template <class S>
        void take(const Storage<S>& storage, const BodyPair& pair) {
            touches = storage.touches_aside[pair.record];
        }
        template <class S>
        void put(Storage<S>& storage, Index record) const {
            storage.touches_aside[record] = touches;
        }
        template <class S>
        bool is_valid(const ManifoldContext&) const {
            return touches <= 1;
        }
    };
};

struct Sleep : Feature {
    static constexpr uint32_t part = 4096;
    template <class S>
    static constexpr bool named = S::sleeps;

    template <class S, bool present>
    struct Memory {
        static constexpr unsigned tiles = static_cast<unsigned>(tile_capacity<S>);
        static constexpr unsigned shape_slots = static_cast<unsigned>(shape_tile_capacity<S> * lanes);
        static constexpr int tile_words = ActiveTiles::words_for(tile_capacity<S>), word_words = ActiveTiles::words_for(tile_words);

        uint32_t active_tiles[static_cast<unsigned>(tile_words)] = {}, active_words[static_cast<unsigned>(word_words)] = {};
        scalar rest_time[static_cast<unsigned>(S::max_bodies)] = {};
        uint16_t awake[tiles] = {}, settling[tiles] = {};
        Index parent[tiles * lanes] = {}, next_body[tiles * lanes] = {}, aside[tiles * lanes] = {};
        BodyPair awake_pairs[static_cast<unsigned>(S::max_manifolds)] = {};  ///< between two steps: room to sort in
        BodyPair pairs_aside[static_cast<unsigned>(S::max_manifolds)] = {};
        Index awake_pair_count = 0, aside_count = 0;
        uint8_t marks[tiles * lanes] = {};
        uint8_t search_flags[shape_slots] = {};
        uint8_t bounds_are_made = 0;  ///< 0: no step was taken since the world began or was loaded

        RestView rest_view() {
            return {awake, settling, {active_tiles, active_words, word_words}, rest_time, parent, next_body, marks, aside, pairs_aside,
                    &aside_count, S::max_shapes_of_body};
        }
        bool is_awake(int slot) const { return RestView::has(awake, slot); }
    };
    template <class S>
    struct Memory<S, false> {};

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::sleeps);
        each(scalar(S::sleep_speed));
        each(scalar(S::sleep_time));
    }
    template <class S>
    static constexpr bool check() {
        static_assert(!S::sleeps || stacks<S>, "sleep is for scenes of contacts with friction: set max_manifolds, or sleeps = false");
        static_assert(S::sleep_speed >= 0 && S::sleep_speed <= limits::speed_runaway, "bodies at rest move at 0 m/s or more: set sleep_speed");
        static_assert(S::sleep_time >= 0 && S::sleep_time <= scalar(1e6), "bodies fall asleep after 0 to 1000000 s: set sleep_time");
        return true;
    }
    template <class S>
    static void begin_body(Storage<S>& storage, int slot, const BodyDef&) {
        begin_awake(storage.rest_view(), slot);
    }
    template <class S>
    static void before_removal(Storage<S>& storage, int slot) {
        wake_by(storage, [&](const ManifoldView& manifolds) {
            wake_touching_and_leave(storage.bodies(), storage.rest_view(), manifolds, slot);
        });
    }
    template <class S>
    static void forget_shape(Storage<S>& storage, int shape_slot) {
        storage.search_view().clear(shape_slot, SearchFlag::searched);
    }
    template <class S>
    static uint64_t hash_body(const Storage<S>& storage, int slot, uint64_t hash) {
        return hash_rest(storage.is_awake(slot), storage.rest_time[slot], hash);
    }
    template <class S>
    static void finish_load(Storage<S>& storage) {
        join_all_islands(storage.bodies(), storage.rest_view(), storage.manifold_view());
        if constexpr (has_joints<S>) Figures::join_islands(storage, true);
        put_aside(storage);
    }

    struct OfBody : NoNumbers {
        SavedRest saved;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            saved.numbers(each);
        }
        template <class S>
        void take(const Storage<S>& storage, int slot) {
            const bool settling = RestView::has(storage.settling, slot);
            saved = {static_cast<uint8_t>(storage.is_awake(slot) ? 1 : settling ? 2 : 0), storage.rest_time[slot]};
        }
        template <class S>
        void put(Storage<S>& storage, int slot) const {
            if (saved.awake == 1) storage.rest_view().wake(slot);
            if (saved.awake == 2) storage.rest_view().settle(slot);
            storage.rest_time[slot] = saved.rest_time;
        }
        template <class S>
        bool is_valid(const SavedBody& body) const {
            return ingot::is_valid(saved, body, S::sleep_time);
        }
    };
};

}  // namespace features

} }  // namespace ingot

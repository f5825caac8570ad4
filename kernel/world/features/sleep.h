// SPDX-License-Identifier: MIT
// Bodies at rest that are left out of the step, and fast ones that are followed within it.
#pragma once

#include "../../continuous/body_path.h"
#include "../../island/islands.h"
#include "../../sleep/at_rest.h"
#include "../../sleep/fall_asleep.h"
#include "../../sleep/wake.h"
#include "manifolds.h"

namespace ingot { inline namespace INGOT_ABI {

struct Continuous : Feature {
    template <class S>
    static constexpr bool named = S::continuous;

    template <class S, bool present>
    struct Memory {
        BodyPath paths[static_cast<unsigned>(S::max_bodies)] = {};
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
        static_assert(!S::continuous || (!has_compounds<S> && !S::shapes::has(ShapeKind::hull)),
                      "fast bodies are followed where each has one shape, and none is a hull: set continuous = false");
        static_assert(!S::continuous || !S::sleeps, "fast bodies are followed where nothing sleeps: set continuous or sleeps = false");
        return true;
    }
};

struct Sleep : Feature {
    static constexpr uint32_t part = 4096;
    template <class S>
    static constexpr bool named = S::sleeps;

    template <class S, bool present>
    struct Memory {
        static constexpr unsigned tiles = static_cast<unsigned>(tile_capacity<S>);
        uint16_t awake[tiles] = {}, settling[tiles] = {};
        scalar rest_time[static_cast<unsigned>(S::max_bodies)] = {};
        uint16_t parent[tiles * lanes] = {};
        uint8_t marks[tiles * lanes] = {};
        BodyPair awake_pairs[static_cast<unsigned>(S::max_manifolds)] = {};
        uint16_t awake_pair_count = 0;

        RestView rest_view() { return {awake, settling, rest_time, parent, marks}; }
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
        static_assert(!S::sleeps || !has_field<S>, "a force_field does not let bodies sleep, for it may change: leave it out, or set sleeps = false");
        static_assert(!S::sleeps || !has_compounds<S>, "bodies of several shapes do not sleep: set max_shapes_of_body = 1, or sleeps = false");
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
        wake_touching_and_leave(storage.bodies(), storage.rest_view(), storage.manifolds_of_bodies(), slot);
    }
    template <class S>
    static uint64_t hash_body(const Storage<S>& storage, int slot, uint64_t hash) {
        return hash_rest(storage.is_awake(slot), storage.rest_time[slot], hash);
    }
    template <class S>
    static void finish_load(Storage<S>& storage) {
        join_all_islands(storage.bodies(), storage.rest_view(), storage.manifolds_of_bodies());
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
            if (saved.awake == 1) RestView::set(storage.awake, slot);
            if (saved.awake == 2) RestView::set(storage.settling, slot);
            storage.rest_time[slot] = saved.rest_time;
        }
        template <class S>
        bool is_valid(const SavedBody& body) const {
            return ingot::is_valid(saved, body, S::sleep_time);
        }
    };
};

} }  // namespace ingot

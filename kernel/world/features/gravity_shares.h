// SPDX-License-Identifier: MIT
// Bodies that feel more or less of gravity than others: what floats, falls slowly, or rises.
#pragma once

#include "../../island/rest_view.h"
#include "../../motion/gravity_shares.h"
#include "motion.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

struct GravityShares : Feature {
    static constexpr uint32_t part = 1u << 17;
    template <class S>
    static constexpr bool named = S::gravity_shares;

    template <class S, bool present>
    struct Memory {
        scalar shares_of_gravity[static_cast<unsigned>(S::max_bodies)] = {};  ///< by slot
    };
    template <class S>
    struct Memory<S, false> {};

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::gravity_shares);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(!S::gravity_shares || S::translates, "bodies that feel gravity move: set translates = true, or gravity_shares = false");
        return true;
    }
    template <class S>
    static void begin_body(Storage<S>& storage, int slot, const BodyDef&) {
        storage.shares_of_gravity[slot] = 1;
    }
    template <class S>
    static void forget_body(Storage<S>& storage, int slot) {
        storage.shares_of_gravity[slot] = 0;
    }
    template <class S>
    static uint64_t hash_body(const Storage<S>& storage, int slot, uint64_t hash) {
        return hash_number(hash, storage.shares_of_gravity[slot]);
    }
    template <class S>
    static void sum_forces(Storage<S>& storage, scalar) {
        const BodyView bodies = storage.bodies();
        if constexpr (S::sleeps)
            for_awake(storage.rest_view(), [&](int slot) { add_gravity_share(bodies, storage.gravity, storage.shares_of_gravity, slot); });
        else
            add_gravity_shares(bodies, storage.gravity, storage.shares_of_gravity, storage.slots_used);
    }

    struct OfBody : NoNumbers {
        scalar share;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("gravity_share", share);
        }
        template <class S>
        void take(const Storage<S>& storage, int slot) {
            share = storage.shares_of_gravity[slot];
        }
        template <class S>
        void put(Storage<S>& storage, int slot) const {
            storage.shares_of_gravity[slot] = share;
        }
        template <class S>
        bool is_valid(const SavedBody&) const {
            return abs(share) <= limits::gravity_share_max;
        }
    };
};

} } }  // namespace ingot::features

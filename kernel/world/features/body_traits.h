// SPDX-License-Identifier: MIT
// What a body may have beside mass and state: a word of its user, forces in its own axes, damping.
#pragma once

#include "../../island/rest_view.h"
#include "../../motion/body_forces.h"
#include "../../motion/damping.h"
#include "motion.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

/// Moves nothing, and is no part of the state's hash.
struct UserData : Feature {
    static constexpr uint32_t part = 1u << 24;
    template <class S>
    static constexpr bool named = S::user_data;

    template <class S, bool present>
    struct Memory {
        uint32_t user_words[static_cast<unsigned>(S::max_bodies)] = {};  ///< by slot
    };
    template <class S>
    struct Memory<S, false> {};

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::user_data);
    }
    template <class S>
    static void forget_body(Storage<S>& storage, int slot) {
        storage.user_words[slot] = 0;
    }

    struct OfBody : NoNumbers {
        uint32_t word;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("user_data", word);
        }
        template <class S>
        void take(const Storage<S>& storage, int slot) {
            word = storage.user_words[slot];
        }
        template <class S>
        void put(Storage<S>& storage, int slot) const {
            storage.user_words[slot] = word;
        }
    };
};

struct BodyForces : Feature {
    static constexpr uint32_t part = 1u << 25;
    template <class S>
    static constexpr bool named = S::body_forces;

    template <class S, bool present>
    struct Memory {
        BodyForceTile body_forces[tile_capacity<S>] = {};
    };
    template <class S>
    struct Memory<S, false> {};

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::body_forces);
    }
    template <class S>
    static void forget_body(Storage<S>& storage, int slot) {
        write(storage.body_forces[place_of(slot).tile], place_of(slot).lane, {}, {});
    }
    template <class S>
    static void sum_forces([[maybe_unused]] Storage<S>& storage, [[maybe_unused]] scalar h) {
        if constexpr (!halves_body_forces<S>) sum_in_middle(storage, h);
    }
    /// As forces of the step, turned to where the body will be in its middle.
    template <class S>
    static void sum_in_middle(Storage<S>& storage, scalar h) {
        const BodyView bodies = storage.bodies();
        const scalar ahead = S::rotation::as_printed ? 0 : h / 2;
        const auto sum = [&](int tile_i) {
            BodyForceTile& tile = storage.body_forces[tile_i];
            if (!any_pushed(tile)) return;
            const HeldInBody held(tile);
            add_field_forces_to(bodies, tile_i, Forcing<HeldInBody>{held, {}, 0}, ahead);
            clear_forces(tile);
        };
        if constexpr (S::sleeps)
            storage.rest_view().active.for_each(sum);
        else
            for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) sum(tile_i);  // bound: max_bodies / lanes, rounded up
    }
    static void write(BodyForceTile& tile, int lane_i, const Vector& F_body, const Vector& tau_body) {
        set_lane(tile.F_body, lane_i, F_body);
        set_lane(tile.tau_body, lane_i, tau_body);
    }

    struct OfBody : NoNumbers {
        Vector F_body, tau_body;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("F_body", F_body);
            each("tau_body", tau_body);
        }
        template <class S>
        void take(const Storage<S>& storage, int slot) {
            const BodyForceTile& tile = storage.body_forces[place_of(slot).tile];
            F_body = lane_of(tile.F_body, place_of(slot).lane);
            tau_body = lane_of(tile.tau_body, place_of(slot).lane);
        }
        template <class S>
        void put(Storage<S>& storage, int slot) const {
            write(storage.body_forces[place_of(slot).tile], place_of(slot).lane, F_body, tau_body);
        }
        template <class S>
        bool is_valid(const SavedBody& body) const {
            const bool none = length_sq(F_body) == 0 && length_sq(tau_body) == 0;
            return check_vector(F_body, limits::force_max) == Status::ok && check_vector(tau_body, limits::torque_max) == Status::ok &&
                   (S::translates || length_sq(F_body) == 0) && (none || body.inv_I_scale > 0);
        }
    };
};

struct BodyDamping : Feature {
    static constexpr uint32_t part = 1u << 26;
    template <class S>
    static constexpr bool named = S::damping;

    template <class S, bool present>
    struct Memory {
        Damping damping[static_cast<unsigned>(S::max_bodies)] = {};  ///< by slot
    };
    template <class S>
    struct Memory<S, false> {};

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::damping);
    }
    template <class S>
    static void forget_body(Storage<S>& storage, int slot) {
        storage.damping[slot] = {};
    }
    template <class S>
    static uint64_t hash_body(const Storage<S>& storage, int slot, uint64_t hash) {
        return hash_number(hash_number(hash, storage.damping[slot].linear), storage.damping[slot].angular);
    }
    template <class S>
    static void damp(Storage<S>& storage, scalar h) {
        const BodyView bodies = storage.bodies();
        const auto damp = [&](int slot) { add_damping(bodies, storage.damping[slot], h, slot); };
        if constexpr (S::sleeps)
            for_awake(storage.rest_view(), damp);
        else
            for (int slot = 0; slot < storage.slots_used; ++slot) damp(slot);  // bound: max_bodies
    }

    struct OfBody : NoNumbers {
        Damping damping;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("damping.linear", damping.linear);
            each("damping.angular", damping.angular);
        }
        template <class S>
        void take(const Storage<S>& storage, int slot) {
            damping = storage.damping[slot];
        }
        template <class S>
        void put(Storage<S>& storage, int slot) const {
            storage.damping[slot] = damping;
        }
        template <class S>
        bool is_valid(const SavedBody&) const {
            return check_damping(damping) == Status::ok;
        }
    };
};

} } }  // namespace ingot::features

// SPDX-License-Identifier: MIT
// Sums of L, v_CM and r_CM with what their roundings take off.
#pragma once

#include "../../motion/compensated_sums.h"
#include "motion.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

/// A body that is added, set or edited begins without remainders; one that sleeps keeps that of its place.
struct CompensatedSums : Feature {
    static constexpr uint32_t part = 1u << 28;
    template <class S>
    static constexpr bool named = S::compensated_sums;

    template <class S, bool present>
    struct Memory {
        static constexpr unsigned place_capacity = S::translates ? static_cast<unsigned>(tile_capacity<S>) : 1u;
        SumTile L_sums[tile_capacity<S>] = {};
        SumTile v_sums[place_capacity] = {}, r_sums[place_capacity] = {};

        /// From tile `first` on.
        SumView sums(int first, const uint16_t* awake) {
            return {L_sums + first, S::translates ? v_sums + first : nullptr, S::translates ? r_sums + first : nullptr,
                    awake != nullptr ? awake + first : nullptr};
        }
    };
    template <class S>
    struct Memory<S, false> {};

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::compensated_sums);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(!S::compensated_sums || !S::rotation::as_printed, "Listing 1 sums as it was printed: leave compensated_sums out");
        static_assert(!S::compensated_sums || !flies_in_field<S>, "flights through a field sum by themselves: leave compensated_sums out");
        return true;
    }
    template <class S>
    static void forget_body(Storage<S>& storage, int slot) {
        OfBody{}.put(storage, slot);
    }
    template <class S>
    static uint64_t hash_body(const Storage<S>& storage, int slot, uint64_t hash) {
        OfBody of_body;
        of_body.take(storage, slot);
        const auto with = [](uint64_t before, const Vector& low) { return hash_number(hash_number(hash_number(before, low.x), low.y), low.z); };
        return with(with(with(hash, of_body.L_low), of_body.v_low), of_body.r_low);
    }

    struct OfBody : NoNumbers {
        Vector L_low = {}, v_low = {}, r_low = {};

        template <class Each>
        constexpr void numbers(Each& each, uint32_t parts) {
            each("L_low", L_low);
            if ((parts & SnapshotPart::translation) == 0) return;
            each("v_low", v_low);
            each("r_low", r_low);
        }
        template <class S>
        void take(const Storage<S>& storage, int slot) {
            const Place at = place_of(slot);
            const BodyView bodies = storage.bodies();
            L_low = remainder_of(storage.L_sums[at.tile], at.lane, lane_of(bodies.rotation[at.tile].L, at.lane));
            if constexpr (S::translates) {
                v_low = remainder_of(storage.v_sums[at.tile], at.lane, lane_of(bodies.translation[at.tile].v_CM, at.lane));
                r_low = remainder_of(storage.r_sums[at.tile], at.lane, lane_of(bodies.translation[at.tile].r_CM, at.lane));
            }
        }
        template <class S>
        void put(Storage<S>& storage, int slot) const {
            const Place at = place_of(slot);
            const BodyView bodies = storage.bodies();
            set_remainder(storage.L_sums[at.tile], at.lane, lane_of(bodies.rotation[at.tile].L, at.lane), L_low);
            if constexpr (S::translates) {
                set_remainder(storage.v_sums[at.tile], at.lane, lane_of(bodies.translation[at.tile].v_CM, at.lane), v_low);
                set_remainder(storage.r_sums[at.tile], at.lane, lane_of(bodies.translation[at.tile].r_CM, at.lane), r_low);
            }
        }
        /// A remainder is no more than half the last bit of its sum.
        template <class S>
        bool is_valid(const SavedBody& body) const {
            const auto fits = [](const Vector& low, const Vector& sum) {
                return abs(low.x) <= epsilon * abs(sum.x) && abs(low.y) <= epsilon * abs(sum.y) && abs(low.z) <= epsilon * abs(sum.z);
            };
            return fits(L_low, body.L) && (!S::translates || (fits(v_low, body.v_CM) && fits(r_low, body.r_CM)));
        }
    };
};

} } }  // namespace ingot::features

// SPDX-License-Identifier: MIT
// What contacts are to be read beside what the solver keeps: the impulses of all substeps, and the places of impacts without friction.
#pragma once

#include "../../constraint/impact_note.h"
#include "manifolds.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

template <class S, bool of_manifolds>
struct ReadPart {
    ImpulseSum impulse_sums[static_cast<unsigned>(S::max_manifolds)] = {};  ///< by record

    ImpulseSum* sums_of_impulses() { return impulse_sums; }
    /// Of the pairs that the step may solve.
    void clear_impulse_sums(const ManifoldView& moving) {
        for (int pair_i = 0; pair_i < *moving.count; ++pair_i) impulse_sums[moving.pairs[pair_i].record] = {};  // bound: max_manifolds
    }
};
template <class S>
struct ReadPart<S, false> {
    Vector contact_places[static_cast<unsigned>(S::max_contacts)] = {};  ///< m, world
};

/// Of manifolds: their impulses are saved, because what the last step told is.
struct ReadsContacts : Feature {
    static constexpr uint32_t part = 1u << 27;
    template <class S>
    static constexpr bool named = S::reads_contacts && has_shapes<S>;

    template <class S, bool present>
    struct Memory : ReadPart<S, stacks<S>> {};
    template <class S>
    struct Memory<S, false> {
        static constexpr ImpulseSum* sums_of_impulses() { return nullptr; }
        static void clear_impulse_sums(const ManifoldView&) {}
    };

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::reads_contacts);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(!S::reads_contacts || has_shapes<S>,
                      "contacts are read where bodies touch: set max_manifolds or max_contacts, or reads_contacts = false");
        return true;
    }

    struct OfManifold : NoNumbers {
        ImpulseSum sum;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            for (scalar& j : sum.j) each("j_sum", j);
            each("j_sum.friction", sum.friction);
        }
        template <class S>
        void take(const Storage<S>& storage, const BodyPair& pair) {
            sum = storage.impulse_sums[pair.record];
        }
        template <class S>
        void put(Storage<S>& storage, Index record) const {
            storage.impulse_sums[record] = sum;
        }
        template <class S>
        bool is_valid(const ManifoldContext&) const {
            bool sound = is_finite(sum.friction);
            for (const scalar j : sum.j) sound = sound && is_finite(j);
            return sound;
        }
    };
};

} } }  // namespace ingot::features

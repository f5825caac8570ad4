// SPDX-License-Identifier: MIT
// How bodies move: translation, compensated orientation, the return of energy, the force field. Their numbers of a body are in SavedBody, for they
// are checked together.
#pragma once

#include "../../island/rest_view.h"
#include "../../motion/forced_flight.h"
#include "../../sleep/fall_asleep.h"
#include "feature.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

template <class S>
inline constexpr int tile_capacity = (S::max_bodies + lanes - 1) / lanes;

/// The order that a method tells of itself; 0 if it tells none.
template <class Method, class = void>
inline constexpr int order_of = 0;
template <class Method>
inline constexpr int order_of<Method, decltype(static_cast<void>(Method::order))> = Method::order;

/// And its limit of substeps.
template <class Method, class = void>
inline constexpr int substeps_of = 0;
template <class Method>
inline constexpr int substeps_of<Method, decltype(static_cast<void>(Method::substeps))> = Method::substeps;

/// How many bodies there are, and how they turn.
struct Rotation : Feature {
    template <class S>
    static constexpr bool named = true;
    template <class S, bool>
    struct Memory {};

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::max_bodies);
        each(S::rotation::name);
        each(order_of<typename S::rotation>);
        each(substeps_of<typename S::rotation>);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(S::max_bodies >= 1 && S::max_bodies <= index_max + 1, "a scene holds 1 to 65536 bodies: set max_bodies");
        return true;
    }
};

struct Translation : Feature {
    static constexpr uint32_t part = SnapshotPart::translation;
    template <class S>
    static constexpr bool named = S::translates;

    template <class S, bool present>
    struct Memory {
        TranslationTile translation[tile_capacity<S>] = {};
        Vector gravity = {};  ///< m s^-2
        TranslationTile* translation_tiles() { return translation; }
        Vector gravity_or_none() const { return gravity; }
    };
    template <class S>
    struct Memory<S, false> {
        TranslationTile* translation_tiles() { return nullptr; }
        Vector gravity_or_none() const { return {}; }
    };

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::translates);
    }

    struct OfWorld : NoNumbers {
        Vector gravity;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("gravity", gravity);
        }
        template <class S>
        void take(const Storage<S>& storage) {
            gravity = storage.gravity;
        }
        template <class S>
        void put(Storage<S>& storage) const {
            storage.gravity = gravity;
        }
        template <class S>
        bool is_valid(const SavedWorld&) const {
            return check_vector(gravity, limits::gravity_max) == Status::ok;
        }
    };
};

struct Compensation : Feature {
    static constexpr uint32_t part = SnapshotPart::compensation;
    template <class S>
    static constexpr bool named = S::rotation::compensates;

    template <class S, bool present>
    struct Memory {
        CompensationTile compensation[tile_capacity<S>] = {};
        CompensationTile* compensation_tiles() { return compensation; }
    };
    template <class S>
    struct Memory<S, false> {
        CompensationTile* compensation_tiles() { return nullptr; }
    };

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::rotation::compensates);
    }
};

struct EnergyReturn : Feature {
    static constexpr uint32_t part = SnapshotPart::energy;
    template <class S>
    static constexpr bool named = S::rotation::returns_energy;

    template <class S, bool present>
    struct Memory {
        EnergyTile energy[tile_capacity<S>] = {};
        scalar h_1 = 0;  ///< s, of the first step: energies are kept in units of its square
        EnergyTile* energy_tiles() { return energy; }
        scalar energy_unit(scalar h) {
            if (h == h_1) return 1;
            if (h_1 == 0) h_1 = h;
            const scalar ratio = h / h_1;
            return ratio * ratio;
        }
    };
    template <class S>
    struct Memory<S, false> {
        EnergyTile* energy_tiles() { return nullptr; }
        scalar energy_unit(scalar) { return 1; }
    };

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::rotation::returns_energy);
    }

    struct OfWorld : NoNumbers {
        scalar h_1;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("h_1", h_1);
        }
        template <class S>
        void take(const Storage<S>& storage) {
            h_1 = storage.h_1;
        }
        template <class S>
        void put(Storage<S>& storage) const {
            storage.h_1 = h_1;
        }
        template <class S>
        bool is_valid(const SavedWorld&) const {
            return h_1 == 0 || check_step(h_1) == Status::ok;
        }
    };
};

/// True for fields that name their numbers: see motion/force_field.h.
template <class Field, class = void>
inline constexpr bool names_its_numbers = false;
template <class Field>
inline constexpr bool names_its_numbers<Field, decltype(any_of<Field>().numbers(any_of<ByteCounter>()))> = true;

/// What a field's numbers are, not what they amount to: their names and kinds.
class FieldSignature : public NumberStream<FieldSignature> {
public:
    constexpr void name(const char* text) {
        for (; *text != 0; ++text) add(static_cast<uint8_t>(*text));  // bound: the text ends with a zero
        add(0);
    }
    template <class T>
    constexpr void integer(const T&) {
        add(sizeof(T));
    }
    constexpr void real(const scalar&) { add(1); }
    constexpr uint64_t hash() const { return hash_; }

private:
    constexpr void add(uint64_t number) { hash_ = (hash_ ^ number) * 0x100000001b3u; }
    uint64_t hash_ = state_hash_seed;
};

/// A field in which bodies sleep: its numbers are compared, not who asked for them.
struct SteadyField : Feature {
    static constexpr uint32_t part = 1u << 19;
    template <class S>
    static constexpr bool named = has_field<S> && S::sleeps;

    template <class S, bool present>
    struct Memory {
        typename S::force_field field_before = {};                  ///< of the last step
        scalar pull_sq[static_cast<unsigned>(S::max_bodies)] = {};  ///< (m s^-2)^2, of gravity and what the field and the user add, in this step
        uint8_t field_changed = 0;                                  ///< since the last step of a world that was saved then

        const scalar* pull_of_bodies() const { return pull_sq; }
    };
    template <class S>
    struct Memory<S, false> {
        static constexpr const scalar* pull_of_bodies() { return nullptr; }
    };

    template <class S>
    static constexpr bool check() {
        static_assert(!S::sleeps || !has_field<S> || S::force_field::is_steady,
                      "bodies sleep in a force_field that does not change by itself: give it is_steady = true, or set sleeps = false");
        return true;
    }
    /// True where the numbers of the field are not those of the last step.
    template <class S>
    static bool changed(const Storage<S>& storage) {
        return storage.field_changed != 0 ||
               (storage.bounds_are_made != 0 && !INGOT_SAME_BYTES(&storage.field, &storage.field_before, sizeof storage.field));
    }

    struct OfWorld : NoNumbers {
        uint8_t changed;  ///< what sleeps is to wake

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("field_changed", changed);
        }
        template <class S>
        void take(const Storage<S>& storage) {
            changed = SteadyField::changed(storage) ? 1 : 0;
        }
        template <class S>
        void put(Storage<S>& storage) const {
            storage.field_changed = changed;
        }
        template <class S>
        bool is_valid(const SavedWorld&) const {
            return changed <= 1;
        }
    };
};

/// Time, and the field. The field's own numbers are the user's: a snapshot writes them after those of the world.
struct FieldOfForce : Feature {
    static constexpr uint32_t part = 16;
    template <class S>
    static constexpr bool named = has_field<S>;

    template <class S, bool present>
    struct Memory {
        typename S::force_field field = {};
        scalar t = 0, t_low = 0;  ///< s; t + t_low is the time

        Forcing<typename S::force_field> forcing(const Vector& gravity) const { return {field, gravity, t}; }
        void advance_time(scalar h) {  // Kahan: rounding does not add up over the steps
            const scalar due = h + t_low, t_next = t + due;
            t_low = due - (t_next - t);
            t = t_next;
        }
    };
    template <class S>
    struct Memory<S, false> {};

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::flight::name);
        each(S::flight::order);
        if constexpr (names_its_numbers<typename S::force_field>) {
            typename S::force_field field{};
            FieldSignature signature;
            field.numbers(signature);
            each(signature.hash());
        }
    }
    template <class S>
    static constexpr bool check() {
        static_assert(flies_in_field<S> || S::flight::order == 2,
                      "a flight of order 4 is for scenes with a force_field, without contacts, and not for Listing 1: leave it out");
        static_assert(S::flight::takes_velocities || !S::force_field::depends_on_velocity,
                      "this flight takes no field that depends on velocity: name CommutatorFree4 or KickDriftKick");
        static_assert(__is_trivially_copyable(typename S::force_field), "a force_field is made of plain numbers: memcpy keeps it");
        return true;
    }

    /// Where no flight integrates the field.
    template <class S>
    static void sum_forces([[maybe_unused]] Storage<S>& storage, [[maybe_unused]] scalar h) {
        if constexpr (S::sleeps) {
            const RestView rest = storage.rest_view();
            const BodyView bodies = storage.bodies();
            rest.active.for_each([&](int tile_i) {
                if (rest.awake[tile_i] != 0) add_field_forces_to(bodies, tile_i, storage.forcing(storage.gravity), h / 2);
            });
            note_pulls(bodies, rest, storage.gravity, storage.pull_sq);
        } else if constexpr (!flies_in_field<S>)
            add_field_forces(storage.bodies(), storage.forcing(storage.gravity_or_none()), S::rotation::as_printed ? 0 : h / 2);
    }

    struct OfWorld : NoNumbers {
        scalar t, t_low;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("t", t);
            each("t_low", t_low);
        }
        template <class S>
        void take(const Storage<S>& storage) {
            t = storage.t;
            t_low = storage.t_low;
        }
        template <class S>
        void put(Storage<S>& storage) const {
            storage.t = t;
            storage.t_low = t_low;
        }
        template <class S>
        bool is_valid(const SavedWorld&) const {
            return t >= 0 && is_finite(t) && is_finite(t_low);
        }
    };
};

} } }  // namespace ingot::features

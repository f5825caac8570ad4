// SPDX-License-Identifier: MIT
// Bodies that do not move along, or turn about, some axes of the world: see body/axis_locks.h.
#pragma once

#include "../../body/axis_locks.h"
#include "../../island/rest_view.h"
#include "materials.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

/// Where a body with locks was as the step began. Solvers keep locks to rounding; that a coordinate keeps its bits is made sure of from here.
struct HeldPlace {
    Vector r_CM;
    Matrix A;
    Vector L, L_mean;  ///< kg m^2 s^-1, at the end of the step and over it, while the scene's rotation turns others
    uint32_t of_step;  ///< Storage::steps + 1 then; another number: the body has slept
};

/// What solves contacts of such scenes is compiled for all materials: surfaces of a scene that names none roll freely, and stand still.
template <class S, bool present>
struct IdleMaterialPart : StillBeltPart<S, true>, FreeRollingPart<S, true> {
    template <class View>
    void show_idle_materials(View& view) {
        this->show_still_belts(view);
        this->show_free_rolling(view);
    }
};
template <class S>
struct IdleMaterialPart<S, false> {};

/// A body's numbers in a snapshot are its locks. Their bit among the parts is that of limits of joints: see SnapshotPart::locks.
struct LockedAxes : Feature {
    template <class S>
    static constexpr bool named = S::axis_locks;

    template <class S, bool present>
    struct Memory : IdleMaterialPart<S, stacks<S> && !solves_pointwise<S> && !has_materials<S>> {
        uint8_t locks[static_cast<unsigned>(S::max_bodies)] = {};  ///< by slot; see AxisLocks
        HeldPlace held_places[static_cast<unsigned>(S::max_bodies)] = {};
    };
    template <class S>
    struct Memory<S, false> {};

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        if constexpr (S::axis_locks) each(S::axis_locks);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(!S::axis_locks || !S::rotation::as_printed, "Listing 1 turns bodies about any axis, as it was printed: leave axis_locks out");
        static_assert(!S::axis_locks || !flies_in_field<S>, "flights through a field turn bodies about any axis: leave axis_locks out, or the field");
        static_assert(!S::axis_locks || !has_joints<S>,
                      "locks are joints to the world that no figure knows of: leave axis_locks out, or join the bodies to the world");
        static_assert(!S::axis_locks || !stacks<S> || !solves_directly<S>,
                      "a direct solve takes the mass of a body for one along all axes: with axis_locks name BlockSweeps");
        return true;
    }
    /// Fig. 4 and the sequential solver take the mass of a body for one along all axes.
    template <class S>
    static constexpr bool locks_translations = S::axis_locks && S::translates && !collides<S> && !(stacks<S> && solves_pointwise<S>);
    template <class S>
    static Status check_locks(unsigned locks) {
        if ((locks & ~AxisLocks::all) != 0) return Status::out_of_range;
        return !locks_translations<S> && translations_locked(locks) != 0 ? Status::not_in_scene : Status::ok;
    }
    static constexpr bool checks_definitions = true;
    template <class S>
    static Status check_def(const BodyDef& def) {
        if constexpr (S::axis_locks)
            return check_locks<S>(def.locks);
        else
            return def.locks == 0 ? Status::ok : Status::not_in_scene;
    }
    template <class S>
    static void begin_body(Storage<S>& storage, int slot, const BodyDef& def) {
        storage.locks[slot] = def.locks;
        hold(storage, slot);
    }
    template <class S>
    static void forget_body(Storage<S>& storage, int slot) {
        storage.locks[slot] = 0;
        storage.held_places[slot] = {};
    }
    template <class S>
    static uint64_t hash_body(const Storage<S>& storage, int slot, uint64_t hash) {
        return hash_number(hash, static_cast<scalar>(storage.locks[slot]));
    }
    /// Nothing moves along locked axes from now on.
    template <class S>
    static void hold(Storage<S>& storage, int slot) {
        if (storage.locks[slot] != 0) hold_motion(storage.bodies(), slot, storage.locks[slot]);
    }

    /// Calls each(slot, locks) for the bodies with locks that move in the step.
    template <class S, class Each>
    static void for_locked(Storage<S>& storage, const Each& each) {
        const BodyView bodies = storage.bodies();
        const auto look = [&](int slot) {
            if (storage.locks[slot] != 0 && is_dynamic(bodies, slot)) each(slot, static_cast<unsigned>(storage.locks[slot]));
        };
        if constexpr (S::sleeps)
            for_awake(storage.rest_view(), look);
        else
            for (int slot = 0; slot < storage.slots_used; ++slot) look(slot);  // bound: max_bodies
    }
    /// The same for those that began it so.
    template <class S, class Each>
    static void for_held(Storage<S>& storage, const Each& each) {
        for_locked(storage, [&](int slot, unsigned locks) {
            if (storage.held_places[slot].of_step == storage.steps + 1) each(slot, locks, storage.held_places[slot]);
        });
    }
    /// What acts along locked axes the locks bear. Comes last of all forces.
    template <class S>
    static void sum_forces(Storage<S>& storage, scalar) {
        const BodyView bodies = storage.bodies();
        for_locked(storage, [&](int slot, unsigned locks) {
            storage.held_places[slot] = {r_CM_or_none<S>(bodies, slot),
                                         lane_of(bodies.rotation[place_of(slot).tile].A, place_of(slot).lane), {}, {}, storage.steps + 1};
            hold_forces(bodies, slot, locks, storage.gravity_or_none());
        });
    }

    struct OfBody : NoNumbers {
        uint8_t locks;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("locks", locks);
        }
        template <class S>
        void take(const Storage<S>& storage, int slot) {
            locks = storage.locks[slot];
        }
        template <class S>
        void put(Storage<S>& storage, int slot) const {
            storage.locks[slot] = locks;
        }
        template <class S>
        bool is_valid(const SavedBody& body) const {
            if (check_locks<S>(locks) != Status::ok) return false;
            const auto is_still = [](const Vector& v, unsigned axes) {
                const Vector free = free_part(v, axes);
                return free.x == v.x && free.y == v.y && free.z == v.z;
            };
            return (!S::translates || is_still(body.v_CM, translations_locked(locks))) && (rotations_locked(locks) != 7 || is_still(body.L, 7));
        }
    };

private:
    template <class S>
    static Vector r_CM_or_none(const BodyView& bodies, int slot) {
        if constexpr (S::translates) return r_CM_of(bodies, slot);
        return {};
    }
};

} } }  // namespace ingot::features

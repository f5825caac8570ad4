// SPDX-License-Identifier: MIT
// Bodies that move as they are told: see body/kinematic_motion.h.
#pragma once

#include "../../body/kinematic_motion.h"
#include "../../solver/sequential/point_view.h"
#include "manifolds.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

/// What solvers keep of contacts with kinematic bodies.
template <class S, bool present>
struct KinematicContactPart {
    If<solves_pointwise<S>, KinematicPoint, KinematicContact> kinematic_contacts[static_cast<unsigned>(S::max_manifolds)] = {};

    template <class View>
    void show_kinematic(View& view, const KinematicBody* of_slots) {
        if constexpr (solves_pointwise<S>)
            view.kinematic = {kinematic_contacts, of_slots};
        else
            view.kinematic = {kinematic_contacts, of_slots, S::max_bodies + 1, 0};
    }
};
template <class S>
struct KinematicContactPart<S, false> {};

struct KinematicBodies : Feature {
    static constexpr uint32_t part = 1u << 29;
    template <class S>
    static constexpr bool named = S::kinematic_bodies;

    template <class S, bool present>
    struct Memory : KinematicContactPart<S, stacks<S>> {
        KinematicBody kinematic[static_cast<unsigned>(S::max_bodies)] = {};  ///< by slot
    };
    template <class S>
    struct Memory<S, false> {};

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::kinematic_bodies);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(!S::kinematic_bodies || has_shapes<S>,
                      "kinematic bodies carry and push others: set max_manifolds or max_contacts, or kinematic_bodies = false");
        static_assert(!S::kinematic_bodies || !stacks<S> || S::max_bodies + S::max_manifolds <= index_max - 1,
                      "with kinematic_bodies a scene holds up to 65534 bodies and manifolds together: lower max_bodies or max_manifolds");
        return true;
    }
    static constexpr bool checks_definitions = true;
    template <class S>
    static Status check_def(const BodyDef& def) {
        if (!def.kinematic) return Status::ok;
        if (!S::kinematic_bodies) return Status::not_in_scene;
        if (def.immovable) return Status::immovable;
        if (def.shape.kind == ShapeKind::half_space) return Status::bad_shape;
        return check_kinematic_motion(def.state.v_CM, def.state.L);
    }
    /// Its body as the tiles hold it between two steps.
    static BodyDef standing(const BodyDef& def) {
        BodyDef still = def;
        still.immovable = true;
        still.state.v_CM = still.state.L = {};
        return still;
    }
    template <class S>
    static void begin_body(Storage<S>& storage, int slot, const BodyDef& def) {
        if (def.kinematic) set_kinematic_motion(storage.kinematic[slot], def.state.v_CM, def.state.L);
    }
    template <class S>
    static void forget_body(Storage<S>& storage, int slot) {
        storage.kinematic[slot] = {};
    }
    template <class S>
    static uint64_t hash_body(const Storage<S>& storage, int slot, uint64_t hash) {
        const KinematicBody& body = storage.kinematic[slot];
        if (!is_kinematic(body)) return hash;
        const Vector vectors[] = {body.v_CM,      body.omega,     body.v_CM_before, body.omega_before, body.r_CM_goal, body.A_goal.c0,
                                  body.A_goal.c1, body.A_goal.c2, body.r_CM_low,    body.A_low.c0,     body.A_low.c1,  body.A_low.c2};
        for (const Vector& v : vectors) hash = hash_number(hash_number(hash_number(hash, v.x), v.y), v.z);
        return hash_number(hash, static_cast<scalar>(body.goal));
    }

    /// Calls each(slot, body) for the bodies that the step moves by themselves.
    template <class S, class Each>
    static void for_moving(Storage<S>& storage, const Each& each) {
        for (int slot = 0; slot < storage.slots_used; ++slot)  // bound: max_bodies
            if (moves(storage.kinematic[slot])) each(slot, storage.kinematic[slot]);
    }

    /// Calls each(body) for the others.
    template <class S, class Each>
    static void for_standing(Storage<S>& storage, const Each& each) {
        for (int slot = 0; slot < storage.slots_used; ++slot)
            if (is_kinematic(storage.kinematic[slot]) && !moves(storage.kinematic[slot])) each(storage.kinematic[slot]);
    }

    struct OfBody : NoNumbers {
        uint8_t goal;
        KinematicBody body;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("kinematic.goal", goal);
            each("kinematic.v_CM", body.v_CM);
            each("kinematic.omega", body.omega);
            each("kinematic.v_CM_before", body.v_CM_before);
            each("kinematic.omega_before", body.omega_before);
            each("kinematic.r_CM_goal", body.r_CM_goal);
            each("kinematic.A_goal", body.A_goal);
            each("kinematic.r_CM_low", body.r_CM_low);
            each("kinematic.A_low", body.A_low);
        }
        template <class S>
        void take(const Storage<S>& storage, int slot) {
            body = storage.kinematic[slot];
            goal = static_cast<uint8_t>(body.goal);
        }
        template <class S>
        void put(Storage<S>& storage, int slot) const {
            storage.kinematic[slot] = body;
            storage.kinematic[slot].v_CM_change = storage.kinematic[slot].omega_change = {};
            storage.kinematic[slot].goal = static_cast<KinematicGoal>(goal);
        }
        template <class S>
        bool is_valid(const SavedBody& saved) const {
            KinematicBody read = body;
            read.goal = static_cast<KinematicGoal>(goal);
            if (goal > static_cast<uint8_t>(KinematicGoal::pose) || !ingot::is_valid(read)) return false;
            return !is_kinematic(read) || (saved.inv_I_scale == 0 && (saved.flags & SavedBody::frozen) == 0);
        }
    };
};

} } }  // namespace ingot::features

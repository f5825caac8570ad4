// SPDX-License-Identifier: MIT
// What every part of World stands on: the memory, ids, and the sentences for what a scene does not name.
#pragma once

#include "../base/ids.h"
#include "../body/freeze_bad_bodies.h"
#include "../query/query_filter.h"
#include "storage.h"

namespace ingot { inline namespace INGOT_ABI {

/// Slots and ids of a world.
template <class S>
class WorldSlots {
    static_assert(check_scene<S>(), "");

protected:
    static constexpr bool translation_only() {
        static_assert(S::translates, "this scene names no translation: set translates = true");
        return true;
    }
    static constexpr bool field_only() {
        static_assert(has_field<S>, "this scene names no field: set force_field");
        return true;
    }
    static constexpr bool filters_only() {
        static_assert(S::filters, "this scene names no filters: set filters = true");
        return true;
    }
    static constexpr bool sensors_only() {
        static_assert(has_sensors<S>, "this scene names no sensors: set max_overlaps");
        return true;
    }
    static constexpr bool events_only() {
        static_assert(has_events<S>, "this scene names no events: set max_events");
        return true;
    }
    static constexpr bool sleep_only() {
        static_assert(S::sleeps, "bodies of this scene do not sleep: set sleeps = true");
        return true;
    }
    static constexpr bool compounds_only() {
        static_assert(has_compounds<S>, "bodies of this scene have one shape: set max_shapes_of_body");
        return true;
    }
    static constexpr bool rolling_only() {
        static_assert(S::rolling_resistance, "shapes of this scene roll freely: set rolling_resistance = true");
        return true;
    }
    static constexpr bool belts_only() {
        static_assert(S::surface_velocities, "surfaces of this scene do not move: set surface_velocities = true");
        return true;
    }
    static constexpr bool shares_only() {
        static_assert(S::gravity_shares, "bodies of this scene feel all of gravity: set gravity_shares = true");
        return true;
    }
    static constexpr bool body_forces_only() {
        static_assert(S::body_forces, "no forces of this scene turn with a body: set body_forces = true");
        return true;
    }
    static constexpr bool damping_only() {
        static_assert(S::damping, "nothing dies away in this scene: set damping = true");
        return true;
    }
    static constexpr bool locks_only() {
        static_assert(S::axis_locks, "bodies of this scene move along all axes: set axis_locks = true");
        return true;
    }
    static constexpr bool user_data_only() {
        static_assert(S::user_data, "bodies of this scene hold no word of yours: set user_data = true");
        return true;
    }
    static constexpr bool kinematic_only() {
        static_assert(S::kinematic_bodies, "no body of this scene moves by itself: set kinematic_bodies = true");
        return true;
    }
    static constexpr bool levels_only() {
        static_assert(has_levels<S>, "this scene names no level: set levels");
        return true;
    }
    static constexpr bool shapes_only() {
        static_assert(has_shapes<S>, "this scene keeps no shapes: set max_manifolds or max_contacts");
        return true;
    }

    /// Passes on the answer of a call, which wakes what sleeps where it did something.
    Status touched([[maybe_unused]] int slot, Status status) {
        if constexpr (S::axis_locks)
            if (status == Status::ok) features::LockedAxes::hold(storage_, slot);
        if constexpr (S::sleeps)
            if (status == Status::ok)
                wake_by(storage_, [&](const ManifoldView& manifolds) { wake_touching(storage_.bodies(), storage_.rest_view(), manifolds, slot); });
        if constexpr (S::sleeps && has_joints<S>)
            if (status == Status::ok && !is_dynamic(storage_.bodies(), slot)) features::Figures::wake_hanging(storage_, slot);
        return status;
    }
    /// The same of a call that sets a motion: what sums knew beyond the one before is gone.
    Status moved(int slot, Status status) {
        if constexpr (S::compensated_sums)
            if (status == Status::ok) features::CompensatedSums::forget_body(storage_, slot);
        if constexpr (queries_by_tree<S>)
            if (status == Status::ok) storage_.hold_shapes(slot);
        return touched(slot, status);
    }
    /// About locked axes it is 0, and not the rounding of that.
    INGOT_INLINE Vector spin_of_slot(int slot) const {
        if constexpr (S::axis_locks)
            return free_part(omega_of(storage_.bodies(), slot), rotations_locked(storage_.locks[slot]));
        else
            return omega_of(storage_.bodies(), slot);
    }
    INGOT_INLINE Result<scalar> collide_slots(int slot_A, int slot_B, const Vector& P, const Vector& n, scalar e) {
        if constexpr (S::axis_locks)
            return collide_locked_bodies(storage_.bodies(), storage_.locks, slot_A, slot_B, P, n, e);
        else
            return collide_bodies(storage_.bodies(), slot_A, slot_B, P, n, e);
    }
    bool sleeps_in(int slot) const { return is_dynamic(storage_.bodies(), slot) && !storage_.is_awake(slot); }
    Result<int> find_movable(BodyId id) const {
        const Result<int> slot = find(id);
        if (!slot.ok() || is_dynamic(storage_.bodies(), slot.value)) return slot;
        return {ingot::is_frozen(storage_.bodies(), slot.value) ? Status::frozen : Status::immovable, 0};
    }

    BodyId first_id(const PairOfBodies& pair) const { return {body_of(pair.body_A), storage_.world_tag, pair.generation_A}; }
    BodyId second_id(const PairOfBodies& pair) const { return {body_of(pair.body_B), storage_.world_tag, pair.generation_B}; }

    // Slots of shapes are those of bodies, where a body has one shape.

    static Index body_of(int shape_slot) { return static_cast<Index>(shape_slot / S::max_shapes_of_body); }
    static int number_of_shape(int shape_slot) { return shape_slot == no_slot ? 0 : shape_slot % S::max_shapes_of_body; }
    BodyId id_of_shape(int shape_slot) const { return shape_slot == no_slot ? BodyId{} : id_of_owner(body_of(shape_slot)); }

    bool lives(int slot) const { return storage_.lives(slot); }
    /// The first slot from this one on in which a body lives; slots_used if there is none.
    int next_living(int slot) const {
        if constexpr (S::max_bodies == 1)
            return slot == 0 && lives(0) ? 0 : 1;  // a search for one would be more than the rest
        else
            return ingot::next_living(storage_.generation, slot, storage_.slots_used);
    }

    /// The body of a level has the slot of the first of its shapes.
    BodyId id_of_owner(int slot) const { return id_of(storage_.owner_of(slot)); }
    BodyId id_of(int slot) const { return {static_cast<Index>(slot), storage_.world_tag, storage_.generation[slot]}; }

    Result<int> find(BodyId id) const {
        if (id.world_tag != storage_.world_tag && id.generation != 0) return {Status::foreign_id, 0};
        if (id.slot >= storage_.slots_used || (id.generation & 1u) == 0 || storage_.generation[id.slot] != id.generation)
            return {Status::stale_id, 0};
        return {Status::ok, id.slot};
    }

    /// The slot of a shape of a body.
    Result<int> find_shape(BodyId id, int shape_i) const {
        const Result<int> slot = find(id);
        if (!slot.ok()) return slot;
        if (shape_i < 0 || shape_i >= S::max_shapes_of_body) return {Status::out_of_range, 0};
        const int shape_slot = slot.value * S::max_shapes_of_body + shape_i;
        return {storage_.surfaces[shape_slot].shape.kind == ShapeKind::none ? Status::out_of_range : Status::ok, shape_slot};
    }

    Storage<S> storage_ = {};
};

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// The part of World that is of contacts: who may touch, surfaces, sensors, events, sleep.
#pragma once

#include "world_dynamics.h"

namespace ingot { inline namespace INGOT_ABI {

/// A body that was in a sensor in the last step.
struct OverlapInfo {
    BodyId sensor{}, visitor{};  ///< who was in whom
    int sensor_shape{}, visitor_shape{};  ///< which of their shapes, where a body has several; else 0
};
/// Calls of World, see world.h.
template <class S>
class WorldContacts : public WorldDynamics<S> {
protected:
    using Base = WorldDynamics<S>;
    using Base::storage_;
    using Base::filters_only;
    using Base::sensors_only;
    using Base::events_only;
    using Base::sleep_only;
    using Base::rolling_only;
    using Base::belts_only;
    using Base::touched;
    using Base::sleeps_in;
    using Base::find_movable;
    using Base::first_id;
    using Base::second_id;
    using Base::number_of_shape;
    using Base::lives;
    using Base::id_of;
    using Base::find;
    using Base::find_shape;

public:
    /// Room that the world needed in the last step, whose report this is; of manifolds the most in all steps since it began or was loaded.
    /// Numbers of what the scene has not are 0. Pairs that are lost count as if they touched.
    RoomNeeded room_needed([[maybe_unused]] const StepReport& report) const {
        RoomNeeded room;
        if constexpr (stacks<S>) {
            room.max_pairs = storage_.pairs_lost == 0 ? storage_.found_count : features::pair_capacity<S> + storage_.pairs_lost;
            room.max_manifolds = storage_.records_used + report.contacts_lost;
        }
        if constexpr (collides<S>) room.max_contacts = storage_.contact_count + report.contacts_lost;
        if constexpr (has_sensors<S>) room.max_overlaps = storage_.overlap_count + report.overlaps_lost;
        if constexpr (has_events<S>) room.max_events = storage_.event_count + report.events_lost;
        return room;
    }

    // Whom a body meets, in scenes with filters: two bodies do when each is of a category that the other's mask names.

    /// What set_filter, or BodyDef, has set. Errors: those of ids.
    Result<BodyFilter> filter(BodyId id) const {
        static_assert(filters_only());
        const Result<int> slot = find(id);
        if (!slot.ok()) return {slot.status, {}};
        return {Status::ok, storage_.filters[slot.value]};
    }
    /// From the next step on; what touched and may no longer loses its contact then.
    Status set_filter(BodyId id, const BodyFilter& filter) {
        static_assert(filters_only());
        const Result<int> slot = find(id);
        if (!slot.ok()) return slot.status;
        storage_.over_bodies_of(slot.value, [&](int of_body) {
            storage_.filters[of_body] = filter;
            (void)touched(of_body, Status::ok);
        });
        return Status::ok;
    }

    // What surfaces may have beside friction and restitution, in scenes with rolling_resistance or surface_velocities: of a body, or of one of its
    // several shapes. A body that is added has neither. May be changed at any time, and counts from the next step on.
    // Errors: out_of_range (a shape that the body has not; a number beyond its range), not_finite.

    /// m, >= 0: how far ahead of the middle of a contact its load is carried, the classical coefficient of rolling friction. Of a pair the larger
    /// counts. A ball of radius R slows by (5/7) g lever / R as it rolls on flat ground, and stays where it is up to tan(alpha) = lever / R.
    /// A tyre on a road: 1 % of its radius; steel on steel: half a millimetre; a ball on grass: a tenth of its radius.
    Status set_rolling_resistance(BodyId id, scalar lever, int shape_i = 0) {
        static_assert(rolling_only());
        const Result<int> shape_slot = find_shape(id, shape_i);
        if (!shape_slot.ok()) return shape_slot.status;
        if (!is_finite(lever)) return Status::not_finite;
        if (!(lever >= 0 && lever <= limits::size_max)) return Status::out_of_range;
        storage_.over_shapes_of(shape_slot.value, [&](int one) {
            storage_.rolling_levers[one] = lever + scalar(0);  // -0 becomes +0: one value, one set of bits
            (void)touched(one / S::max_shapes_of_body, Status::ok);
        });
        return Status::ok;
    }
    /// What set_rolling_resistance has set, m. Errors: those of ids, out_of_range (a shape that the body has not).
    Result<scalar> rolling_resistance(BodyId id, int shape_i = 0) const {
        static_assert(rolling_only());
        const Result<int> shape_slot = find_shape(id, shape_i);
        if (!shape_slot.ok()) return {shape_slot.status, 0};
        return {Status::ok, storage_.rolling_levers[shape_slot.value]};
    }

    /// m/s, in the axes of the shape (a body's, where it has one): how the surface moves over it, as a conveyor belt does. What touches it is
    /// drawn along by friction, and comes to rest on the belt; the body itself does not move, but for what pushes back. Of a velocity only what
    /// lies along the surface counts. Up to limits::speed_max. In scenes that sleep, what lies on a belt that is no faster than Scene::sleep_speed
    /// falls asleep there.
    Status set_surface_velocity(BodyId id, const Vector& velocity, int shape_i = 0) {
        static_assert(belts_only());
        const Result<int> shape_slot = find_shape(id, shape_i);
        if (!shape_slot.ok()) return shape_slot.status;
        const Status status = check_vector(velocity, limits::speed_max);
        if (status != Status::ok) return status;
        storage_.over_shapes_of(shape_slot.value, [&](int one) {
            storage_.surface_velocities[one] = velocity + Vector{};
            (void)touched(one / S::max_shapes_of_body, Status::ok);
        });
        return Status::ok;
    }
    /// What set_surface_velocity has set, m/s, in the axes of the shape. Errors: those of rolling_resistance.
    Result<Vector> surface_velocity(BodyId id, int shape_i = 0) const {
        static_assert(belts_only());
        const Result<int> shape_slot = find_shape(id, shape_i);
        if (!shape_slot.ok()) return {shape_slot.status, {}};
        return {Status::ok, storage_.surface_velocities[shape_slot.value]};
    }

    // Bodies in sensors, as they were at the begin of the last step, and those that passed one in flight; 0 <= index < overlap_count(), in the
    // order of slots.
    // Full: those that come first in this order are kept, the others count in StepReport::overlaps_lost.

    /// How many there are.
    int overlap_count() const {
        static_assert(sensors_only());
        return storage_.overlap_count;
    }
    /// One of them. Errors: out_of_range.
    Result<OverlapInfo> overlap(int index) const {
        static_assert(sensors_only());
        if (index < 0 || index >= storage_.overlap_count || index >= S::max_overlaps) return {Status::out_of_range, {}};
        const PairOfBodies& pair = storage_.overlaps[index];
        return {Status::ok, {first_id(pair), second_id(pair), number_of_shape(pair.body_A), number_of_shape(pair.body_B)}};
    }

    /// What the last step has to tell of contacts and sensors: see EventKind. Until the next step, whatever is added or removed.
    ///
    /// Order: ends, leaves, begins, enters, hits, each in the order of slots. Full: what comes later in this order is not told and
    /// counts in StepReport::events_lost; who touches whom is kept all the same, so an end may come without its begin.
    /// A body that is removed ends its contacts in the next step, under the id it had.
    EventView events() const {
        static_assert(events_only());
        return {storage_.events, storage_.event_count};
    }

    // Sleep, in scenes with `sleeps`. Bodies that touch, or are near enough to, are one island; it falls asleep when all of it was at rest for
    // Scene::sleep_time. It then costs next to nothing and keeps its bits, at v_CM = L = 0, until something wakes it, all of it at once: a body
    // that moves and comes near enough for a manifold; one that is added there; a call that sets the state, the filter, a force or an impulse
    // of one of its bodies, or removes one, or does so with an immovable body that it touches; another gravity. What is called for every step keeps
    // an island awake. Queries and sensors see bodies that sleep.

    /// False for bodies that cannot move, and for ids of none.
    bool is_asleep(BodyId id) const {
        static_assert(sleep_only());
        const Result<int> slot = find(id);
        return slot.ok() && sleeps_in(slot.value);
    }
    /// Wakes the island of a body. Errors: immovable, frozen.
    Status wake(BodyId id) {
        static_assert(sleep_only());
        const Result<int> slot = find_movable(id);
        if (slot.ok())
            wake_by(storage_, [&](const ManifoldView& manifolds) { wake_island(storage_.bodies(), storage_.rest_view(), manifolds, slot.value); });
        return slot.status;
    }
    /// Takes a body for one that was at rest for Scene::sleep_time: its island need not wait for it, and falls asleep in the next step if all of it
    /// is at rest. So what is put down at rest is asleep from the start. Errors: immovable, frozen.
    Status sleep(BodyId id) {
        static_assert(sleep_only());
        const Result<int> slot = find_movable(id);
        if (slot.ok()) storage_.rest_time[slot.value] = S::sleep_time;
        return slot.status;
    }
    /// Bodies that sleep. Cost: O(max_bodies).
    int asleep_count() const {
        static_assert(sleep_only());
        int count = 0;
        for (int slot = 0; slot < storage_.slots_used; ++slot)  // bound: max_bodies
            count += lives(slot) && sleeps_in(slot) ? 1 : 0;
        return count;
    }
    /// Bodies that can move and do not sleep. Cost: O(max_bodies).
    int awake_count() const {
        static_assert(sleep_only());
        int count = 0;
        for (int slot = 0; slot < storage_.slots_used; ++slot)  // bound: max_bodies
            count += lives(slot) && is_dynamic(storage_.bodies(), slot) && storage_.is_awake(slot) ? 1 : 0;
        return count;
    }
    /// Islands of bodies that are awake, as the last step found them; a body that was added since is one by itself. Cost: O(max_bodies).
    int awake_island_count() const {
        static_assert(sleep_only());
        int count = 0;
        for (int slot = 0; slot < storage_.slots_used; ++slot)  // bound: max_bodies
            count += lives(slot) && is_dynamic(storage_.bodies(), slot) && storage_.is_awake(slot) && storage_.parent[slot] == slot ? 1 : 0;
        return count;
    }
    /// Islands that sleep. Cost: O(max_bodies).
    int asleep_island_count() const {
        static_assert(sleep_only());
        int count = 0;
        for (int slot = 0; slot < storage_.slots_used; ++slot)  // bound: max_bodies
            count += lives(slot) && sleeps_in(slot) && storage_.parent[slot] == slot ? 1 : 0;
        return count;
    }
};

} }  // namespace ingot

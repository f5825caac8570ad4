// SPDX-License-Identifier: MIT
#pragma once

#include "../base/ids.h"
#include "../base/limits.h"
#include "../body/auxiliary.h"
#include "../body/energy_momentum.h"
#include "../body/freeze_bad_bodies.h"
#include "../query/cast_ray.h"
#include "../query/cast_shape.h"
#include "../query/check_query.h"
#include "../query/find_nearest.h"
#include "../query/find_overlaps.h"
#include "edit_bodies.h"
#include "state_hash.h"
#include "storage.h"

#include <stddef.h>

namespace ingot { inline namespace INGOT_ABI {

/// One contact of the last step, as World::contact tells it.
struct ContactInfo {
    BodyId A{}, B{};
    Vector n{};         ///< unit normal from B to A, world
    scalar separation{};  ///< m, at the begin of the step; negative where the shapes overlap
    scalar j{};         ///< N s, given to A along n, and to B against it, in the step
};

/// A body that was in a sensor in the last step.
struct OverlapInfo {
    BodyId sensor{}, visitor{};
    int sensor_shape{}, visitor_shape{};  ///< which of their shapes, where a body has several; else 0
};

/// All there is of a simulated world: one object of a size known at compile time, which holds no pointer.
///
/// A world of zero bytes is a valid empty world. memcpy makes a snapshot, and copying it back restores it: the steps that
/// follow are the same to the bit. For files and other machines: snapshot.h.
///
/// Every call that can be refused answers with a Status, in every build, and has then left the world bitwise unchanged.
/// Calls that take a BodyId answer stale_id (removed, null, never given out) or foreign_id (of a world with another tag).
/// Units are SI; vectors and points are in world axes unless they say body. Cost is O(1) unless said.
template <class User>
class World {
    using S = SceneOf<User>;
    static_assert(check_scene<S>(), "");

public:
    using scene = S;
    static constexpr int max_bodies = S::max_bodies;

    // Bodies.

    /// Adds a body in the lowest free slot.
    /// Errors: no_room, and what BodyDef's parts may have wrong: see check_mass_properties, check_state, check_shape;
    ///         bad_restitution; bad_friction; immovable (one that has a velocity); not_in_scene (a shape the scene does not name, a filter, a
    ///         sensor or a restitution where it names none, a place or velocity where it does not translate); bad_shape (a half space that can
    ///         move, a hull that is none of the scene's).
    /// Cost:   O(1), or O(max_bodies) after removals.
    Result<BodyId> add(const BodyDef& def) {
        const Status status = check_add(def);
        if (status != Status::ok) return {status, {}};
        const int slot = free_slot();
        if (slot == max_bodies) return {Status::no_room, {}};

        write_slot(slot, def);
        write_shape(slot, 0, def, {{}, identity_matrix<scalar>()});
        if constexpr (has_compounds<S>) place_shapes(storage_.bodies(), storage_.compound_view(), slot);
        return {Status::ok, id_of(slot)};
    }

    /// Adds a body of several shapes: see shape/compound.h. The definition has no shape of its own; its restitution, friction and sensor are
    /// not looked at.
    /// Errors: those of add, for the definition and each shape; out_of_range (fewer than one; a place beyond limits::position_max), no_room (more
    ///         than max_shapes_of_body), bad_shape (one that is none; a definition with a shape), not_a_rotation (an A, or mass.A_principal).
    Result<BodyId> add(const BodyDef& def, const ShapeDef* shapes, int shape_count) {
        static_assert(compounds_only());
        Status status = check_mass_frame(def.mass);
        if (def.shape.kind != ShapeKind::none) status = Status::bad_shape;
        if (shapes == nullptr || shape_count < 1) status = Status::out_of_range;
        if (shape_count > S::max_shapes_of_body) status = Status::no_room;
        // bound: max_shapes_of_body: more are refused before
        for (int shape_i = 0; shape_i < shape_count && status == Status::ok; ++shape_i) {
            status = check_place(shapes[shape_i], def.mass);
            if (status == Status::ok) status = check_add(with_shape(def, shapes[shape_i]));
        }
        if (status != Status::ok) return {status, {}};
        const int slot = free_slot();
        if (slot == max_bodies) return {Status::no_room, {}};

        write_slot(slot, def);
        for (int shape_i = 0; shape_i < shape_count; ++shape_i) {
            const ShapePlace place = place_in_body(shapes[shape_i], def.mass);
            write_shape(slot, shape_i, with_shape(def, shapes[shape_i]), {place.r + Vector{}, nearest_rotation(place.A)});
        }
        place_shapes(storage_.bodies(), storage_.compound_view(), slot);
        return {Status::ok, id_of(slot)};
    }
    template <unsigned N>
    Result<BodyId> add(const BodyDef& def, const ShapeDef (&shapes)[N]) {
        return add(def, shapes, static_cast<int>(N));
    }

    /// Takes a body out. Its id, and every copy of it, is stale from now on.
    Status remove(BodyId id) {
        const Result<int> slot = find(id);
        if (!slot.ok()) return slot.status;
        Features::over_named<S>([&](auto feature) { decltype(feature)::before_removal(storage_, slot.value); });
        ++storage_.generation[slot.value];
        if (slot.value < storage_.free_hint) storage_.free_hint = slot.value;
        set_identity_body(storage_.bodies(), slot.value);
        storage_.set_generation_of_shapes(slot.value, storage_.generation[slot.value]);
        // bound: max_shapes_of_body
        for (int shape_slot = slot.value * S::max_shapes_of_body; shape_slot < (slot.value + 1) * S::max_shapes_of_body; ++shape_slot)
            Features::over_named<S>([&](auto feature) { decltype(feature)::forget_shape(storage_, shape_slot); });
        Features::over_named<S>([&](auto feature) { decltype(feature)::forget_body(storage_, slot.value); });
        return Status::ok;
    }

    bool is_alive(BodyId id) const { return find(id).ok(); }

    /// True for a body that legal input drove to a value that is not finite: it stands still until it is removed.
    bool is_frozen(BodyId id) const {
        const Result<int> slot = find(id);
        return slot.ok() && ingot::is_frozen(storage_.bodies(), slot.value);
    }

    /// Bodies that live in the world. Cost: O(max_bodies).
    int body_count() const {
        int count = 0;
        for (int slot = 0; slot < storage_.slots_used; ++slot) count += lives(slot) ? 1 : 0;  // bound: max_bodies
        return count;
    }

    /// The id of the living body of a slot, 0 <= slot < max_bodies; the null id if none lives there. For walking all bodies.
    BodyId body_at(int slot) const { return slot >= 0 && slot < storage_.slots_used && lives(slot) ? id_of(slot) : BodyId{}; }

    // State.

    Result<BodyState> state(BodyId id) const {
        const Result<int> slot = find(id);
        if (!slot.ok()) return {slot.status, {}};
        return {Status::ok, read_state(storage_.bodies(), slot.value)};
    }

    /// Errors: those of check_state, frozen, immovable (a velocity for a body that has none), not_in_scene.
    Status set_state(BodyId id, const BodyState& state) {
        const Result<int> slot = find(id);
        if constexpr (has_compounds<S>) {
            const Status status = slot.ok() ? write_state(storage_.bodies(), slot.value, state) : slot.status;
            if (status == Status::ok) place_shapes(storage_.bodies(), storage_.compound_view(), slot.value);
            return slot.ok() ? touched(slot.value, status) : status;
        }
        return slot.ok() ? touched(slot.value, write_state(storage_.bodies(), slot.value, state)) : slot.status;
    }

    /// Mass, kg, to the rounding of two divisions; 0 for an immovable body.
    Result<scalar> mass(BodyId id) const {
        static_assert(translation_only());
        const Result<int> slot = find(id);
        if (!slot.ok()) return {slot.status, 0};
        const Place at = place_of(slot.value);
        const scalar inv_M = storage_.translation[at.tile].inv_M[at.lane];
        return {Status::ok, inv_M > 0 ? 1 / inv_M : 0};
    }

    /// Angular velocity, rad/s, world (Eq. 18).
    Result<Vector> omega(BodyId id) const {
        const Result<int> slot = find(id);
        if (!slot.ok()) return {slot.status, {}};
        return {Status::ok, omega_of(storage_.bodies(), slot.value)};
    }

    // Forces of the next step; they are summed, act over the whole of it, and are gone after it.
    // Errors: not_finite, out_of_range (a summand or the sum beyond limits::force_max, torque_max), immovable, frozen.

    /// A force F, N, at the world point P, m: F_T += F, tau_T += (P - r_CM) x F (Eqs. 14 and 16).
    Status add_force(BodyId id, const Vector& F, const Vector& P) {
        static_assert(translation_only());
        const Result<int> slot = find(id);
        if (!slot.ok()) return slot.status;
        const Status status = check_vector(P, limits::position_max);
        if (status != Status::ok) return status;
        return touched(slot.value, accumulate_force(storage_.bodies(), slot.value, F, moment_about_centre(storage_.bodies(), slot.value, F, P)));
    }

    /// A force at the centre of mass, N: it does not turn the body.
    Status add_central_force(BodyId id, const Vector& F) {
        static_assert(translation_only());
        const Result<int> slot = find(id);
        return slot.ok() ? touched(slot.value, accumulate_force(storage_.bodies(), slot.value, F, {})) : slot.status;
    }

    /// A torque, N m.
    Status add_torque(BodyId id, const Vector& tau) {
        const Result<int> slot = find(id);
        return slot.ok() ? touched(slot.value, accumulate_force(storage_.bodies(), slot.value, {}, tau)) : slot.status;
    }

    // Impulses, which act at once.
    // Errors: not_finite, out_of_range (the impulse, or the velocity it leads to), immovable, frozen.

    /// An impulse j, N s, at the world point P, m: v_CM += j / M, L += (P - r_CM) x j.
    Status apply_impulse(BodyId id, const Vector& j, const Vector& P) {
        static_assert(translation_only());
        const Result<int> slot = find(id);
        if (!slot.ok()) return slot.status;
        const Status status = check_vector(P, limits::position_max);
        if (status != Status::ok) return status;
        return touched(slot.value, accumulate_impulse(storage_.bodies(), slot.value, j, moment_about_centre(storage_.bodies(), slot.value, j, P)));
    }

    /// An impulse through the centre of mass, N s.
    Status apply_central_impulse(BodyId id, const Vector& j) {
        static_assert(translation_only());
        const Result<int> slot = find(id);
        return slot.ok() ? touched(slot.value, accumulate_impulse(storage_.bodies(), slot.value, j, {})) : slot.status;
    }

    /// An angular impulse, N m s: L += k.
    Status apply_angular_impulse(BodyId id, const Vector& k) {
        const Result<int> slot = find(id);
        return slot.ok() ? touched(slot.value, accumulate_impulse(storage_.bodies(), slot.value, {}, k)) : slot.status;
    }

    /// Lets two bodies collide at the world point P with unit normal n from B to A and restitution e (Fig. 4).
    /// Returns: the impulse, N s; 0 when the points separate.
    /// Errors:  not_finite, out_of_range, bad_direction, bad_restitution, immovable (both), frozen (either).
    Result<scalar> collide(BodyId id_A, BodyId id_B, const Vector& P, const Vector& n, scalar e) {
        static_assert(translation_only());
        const Result<int> slot_A = find(id_A), slot_B = find(id_B);
        if (!slot_A.ok() || !slot_B.ok()) return {slot_A.ok() ? slot_B.status : slot_A.status, 0};
        if (slot_A.value == slot_B.value) return {Status::bad_shape, 0};
        const Result<scalar> j = collide_bodies(storage_.bodies(), slot_A.value, slot_B.value, P, n, e);
        if constexpr (S::sleeps)
            if (j.ok() && j.value != 0) (void)touched(slot_A.value, touched(slot_B.value, j.status));
        return j;
    }

    /// Gravity of all bodies, m s^-2. Errors: not_finite, out_of_range (limits::gravity_max).
    Status set_gravity(const Vector& gravity) {
        static_assert(translation_only());
        const Status status = check_vector(gravity, limits::gravity_max);
        if constexpr (S::sleeps)
            if (status == Status::ok && !same(storage_.gravity, gravity))
                wake_by(storage_, [this](const ManifoldView& manifolds) { wake_all(storage_.bodies(), storage_.rest_view(), manifolds); });
        if (status == Status::ok) storage_.gravity = gravity + Vector{};
        return status;
    }
    Vector gravity() const {
        static_assert(translation_only());
        return storage_.gravity;
    }

    /// The field of the scene, to read its numbers and to set them; they are taken as they are.
    typename S::force_field& force_field() {
        static_assert(field_only());
        return storage_.field;
    }
    const typename S::force_field& force_field() const {
        static_assert(field_only());
        return storage_.field;
    }
    /// Sum of all h, s, of a world with a field: its BodyMotion::t at the begin of the next step.
    scalar time() const {
        static_assert(field_only());
        return storage_.t;
    }

    // Sums over all bodies. Immovable bodies count nothing. Cost: O(max_bodies).

    scalar kinetic_energy() const { return kinetic_energy_of_all(storage_.bodies()); }             ///< J
    Vector linear_momentum() const { return linear_momentum_of_all(storage_.bodies()); }           ///< kg m/s
    Vector angular_momentum() const { return angular_momentum_of_all(storage_.bodies()); }         ///< kg m^2/s, about the origin

    // The same of one body.

    Result<scalar> kinetic_energy(BodyId id) const {
        const Result<int> slot = find(id);
        if (!slot.ok()) return {slot.status, 0};
        return {Status::ok, kinetic_energy_of(storage_.bodies(), slot.value)};
    }
    Result<Vector> linear_momentum(BodyId id) const {
        const Result<int> slot = find(id);
        if (!slot.ok()) return {slot.status, {}};
        return {Status::ok, linear_momentum_of(storage_.bodies(), slot.value)};
    }
    Result<Vector> angular_momentum(BodyId id) const {
        const Result<int> slot = find(id);
        if (!slot.ok()) return {slot.status, {}};
        return {Status::ok, angular_momentum_of(storage_.bodies(), slot.value)};
    }

    // Contacts of the last step, 0 <= index < contact_count().

    int contact_count() const {
        static_assert(contacts_only());
        return storage_.contact_count;
    }
    Result<ContactInfo> contact(int index) const {
        static_assert(contacts_only());
        if (index < 0 || index >= storage_.contact_count) return {Status::out_of_range, {}};
        const Contact& c = storage_.contacts[index];
        return {Status::ok, {id_of(c.body_A), id_of(c.body_B), c.n, c.separation, c.j_total}};
    }

    // Whom a body meets, in scenes with filters: two bodies do when each is of a category that the other's mask names.

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
        if (slot.ok()) storage_.filters[slot.value] = filter;
        return slot.ok() ? touched(slot.value, Status::ok) : slot.status;
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
        storage_.rolling_levers[shape_slot.value] = lever + scalar(0);  // -0 becomes +0: one value, one set of bits
        return touched(shape_slot.value / S::max_shapes_of_body, Status::ok);
    }
    Result<scalar> rolling_resistance(BodyId id, int shape_i = 0) const {
        static_assert(rolling_only());
        const Result<int> shape_slot = find_shape(id, shape_i);
        if (!shape_slot.ok()) return {shape_slot.status, 0};
        return {Status::ok, storage_.rolling_levers[shape_slot.value]};
    }

    /// m/s, in the axes of the shape (a body's, where it has one): how the surface moves over it, as a conveyor belt does. What touches it is
    /// drawn along by friction, and comes to rest on the belt; the body itself does not move, but for what pushes back. Of a velocity only what
    /// lies along the surface counts. Up to limits::speed_max.
    Status set_surface_velocity(BodyId id, const Vector& velocity, int shape_i = 0) {
        static_assert(belts_only());
        const Result<int> shape_slot = find_shape(id, shape_i);
        if (!shape_slot.ok()) return shape_slot.status;
        const Status status = check_vector(velocity, limits::speed_max);
        if (status != Status::ok) return status;
        storage_.surface_velocities[shape_slot.value] = velocity + Vector{};
        return touched(shape_slot.value / S::max_shapes_of_body, Status::ok);
    }
    Result<Vector> surface_velocity(BodyId id, int shape_i = 0) const {
        static_assert(belts_only());
        const Result<int> shape_slot = find_shape(id, shape_i);
        if (!shape_slot.ok()) return {shape_slot.status, {}};
        return {Status::ok, storage_.surface_velocities[shape_slot.value]};
    }

    // Bodies in sensors, as they were at the begin of the last step; 0 <= index < overlap_count(), in the order of slots.
    // Full: those that come first in this order are kept, the others count in StepReport::overlaps_lost.

    int overlap_count() const {
        static_assert(sensors_only());
        return storage_.overlap_count;
    }
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
        for (int slot = 0; slot < storage_.slots_used; ++slot) count += lives(slot) && sleeps_in(slot) ? 1 : 0;
        return count;
    }
    /// Islands that sleep. Cost: O(max_bodies).
    int asleep_island_count() const {
        static_assert(sleep_only());
        int count = 0;
        for (int slot = 0; slot < storage_.slots_used; ++slot) count += lives(slot) && sleeps_in(slot) && storage_.parent[slot] == slot ? 1 : 0;
        return count;
    }

    // Queries, of bodies where they are now: they change nothing, and may be asked between any two calls.
    // Which bodies count says the filter; with except, a body that is gone answers stale_id.
    // Cost: all bodies' bounding balls, `lanes` at once, and the shapes of those that come near.

    /// The first body on the way of a ray from a point, m. See QueryHit.
    /// Errors: not_finite, out_of_range (beyond limits::position_max), bad_direction (a way shorter than limits::size_min).
    Result<QueryHit> cast_ray(const Vector& from, const Vector& way, const QueryFilter& filter = {}) const {
        static_assert(shapes_only());
        const Result<int> except = slot_of_exception(filter);
        const Status status = except.ok() ? check_way(from, way) : except.status;
        if (status != Status::ok) return {status, {}};
        const SlotHit hit = ingot::cast_ray<ShapesOf<S>>(storage_.shapes(), storage_.surface_view(), from, way, sees(filter, except.value));
        return {Status::ok, {id_of_shape(hit.slot), hit.fraction, hit.P, hit.n, number_of_shape(hit.slot)}};
    }

    /// The first body on the way of a shape that does not turn, m; it stops short of it by limits::cast_gap. See QueryHit.
    /// Errors: those of cast_ray, of check_shape and check_rotation; bad_shape (none, a half space, a hull without its form).
    Result<QueryHit> cast_shape(const PlacedShape& shape, const Vector& way, const QueryFilter& filter = {}) const {
        static_assert(shapes_only());
        const Result<int> except = slot_of_exception(filter);
        Status status = except.ok() ? check_query_shape(shape) : except.status;
        if (status == Status::ok) status = check_way(shape.r, way);
        if (status != Status::ok) return {status, {}};
        const PlacedShape moving = {shape.shape, shape.r, nearest_rotation(shape.A), shape.hull};
        const SlotHit hit = ingot::cast_shape<ShapesOf<S>>(storage_.shapes(), storage_.surface_view(), moving, way, sees(filter, except.value));
        return {Status::ok, {id_of_shape(hit.slot), hit.fraction, hit.P, hit.n, number_of_shape(hit.slot)}};
    }

    /// All bodies that a shape overlaps or touches, in the order of slots, into found[0 .. capacity).
    /// Returns: how many there are. More than capacity: those of the lowest slots are kept.
    /// Errors:  those of cast_shape; out_of_range (a capacity below zero).
    Result<int> find_overlaps(const PlacedShape& shape, BodyId* found, int capacity, const QueryFilter& filter = {}) const {
        static_assert(shapes_only());
        const Result<int> except = slot_of_exception(filter);
        Status status = except.ok() ? check_query_shape(shape) : except.status;
        if (status == Status::ok && capacity < 0) status = Status::out_of_range;
        if (status != Status::ok) return {status, 0};
        int count = 0;
        [[maybe_unused]] int last = no_slot;
        const PlacedShape still = {shape.shape, shape.r, nearest_rotation(shape.A), shape.hull};
        ingot::find_overlaps<ShapesOf<S>>(storage_.shapes(), storage_.surface_view(), still, sees(filter, except.value), [&](int slot) {
            if constexpr (has_compounds<S>) {
                if (slot / S::max_shapes_of_body == last) return;  // by another of its shapes
                last = slot / S::max_shapes_of_body;
            }
            if (count < capacity) found[count] = id_of_shape(slot);
            ++count;
        });
        return {Status::ok, count};
    }

    /// The body whose surface is nearest to a point, no further away than `within`, m. See QueryNearest.
    /// Errors: not_finite, out_of_range (beyond limits::position_max; within below zero).
    Result<QueryNearest> find_nearest(const Vector& point, scalar within, const QueryFilter& filter = {}) const {
        static_assert(shapes_only());
        const Result<int> except = slot_of_exception(filter);
        Status status = except.ok() ? check_vector(point, limits::position_max) : except.status;
        if (status == Status::ok && !is_finite(within)) status = Status::not_finite;
        if (status == Status::ok && !(within >= 0 && within <= limits::position_max)) status = Status::out_of_range;
        if (status != Status::ok) return {status, {}};
        const SlotNearest nearest =
            ingot::find_nearest<ShapesOf<S>>(storage_.shapes(), storage_.surface_view(), point, within, sees(filter, except.value));
        return {Status::ok, {id_of_shape(nearest.slot), nearest.distance, nearest.P, nearest.n, number_of_shape(nearest.slot)}};
    }

    // The world as a whole.

    /// 64 bits that are equal when the primary state of all bodies is bitwise equal, on every target and for every lane
    /// count. Cost: O(max_bodies).
    uint64_t state_hash() const {
        uint64_t hash = state_hash_seed;
        for (int slot = 0; slot < storage_.slots_used; ++slot)
            if (lives(slot)) hash = hash_of(slot, hash);
        return hash;
    }

    /// Steps taken so far.
    uint32_t step_count() const { return storage_.steps; }

    /// Tells the ids of this world from those of another: they are then foreign_id there. Set it in every world of a program that has two, before
    /// anything is added: worlds of one tag take each other's ids, see BodyId. Errors: not_empty, once a body was added.
    Status set_tag(uint16_t tag) {
        if (storage_.slots_used != 0) return Status::not_empty;
        storage_.world_tag = tag;
        return Status::ok;
    }

private:
    template <class Any>
    friend StepReport step(World<Any>& world, scalar h);
    template <class Any>
    friend Result<size_t> save_snapshot(const World<Any>& world, uint8_t* bytes, size_t room);
    template <class Any>
    friend Status load_snapshot(World<Any>& world, const uint8_t* bytes, size_t size);

    static constexpr bool translation_only() {
        static_assert(S::translates, "this scene names no translation: set translates = true");
        return true;
    }
    static constexpr bool field_only() {
        static_assert(has_field<S>, "this scene names no field: set force_field");
        return true;
    }
    static constexpr bool contacts_only() {
        static_assert(collides<S>, "this scene names no contacts: set max_contacts");
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

    static constexpr bool shapes_only() {
        static_assert(has_shapes<S>, "this scene keeps no shapes: set max_manifolds or max_contacts");
        return true;
    }

    /// All that World::add asks of a body of one shape.
    Status check_add(const BodyDef& def) const {
        Status status = Status::ok;
        if constexpr (has_shapes<S>) status = check_surface(def);
        if (status == Status::ok) status = check_definition(def, S::translates, has_shapes<S> && S::shapes::has(def.shape.kind));
        if (status == Status::ok && !ShapesOf<S>::names_its_hull(def.shape)) status = Status::bad_shape;
        Features::over_all([&](auto feature) {
            const Status of_feature = decltype(feature)::template check_def<S>(def);
            if (of_feature != Status::ok) status = of_feature;
        });
        if constexpr (has_shapes<S> && !S::bounces)
            if (def.restitution > 0) status = Status::not_in_scene;
        return status;
    }

    void write_slot(int slot, const BodyDef& def) {
        if (slot == storage_.slots_used) begin_slot();
        storage_.free_hint = slot + 1;
        ++storage_.generation[slot];
        write_body(storage_.bodies(), slot, def);
        storage_.set_generation_of_shapes(slot, storage_.generation[slot]);
        Features::over_named<S>([&](auto feature) { decltype(feature)::begin_body(storage_, slot, def); });
    }
    void write_shape(int slot, int shape_i, const BodyDef& def, const ShapePlace& place) {
        const int shape_slot = slot * S::max_shapes_of_body + shape_i;
        Features::over_named<S>([&](auto feature) { decltype(feature)::begin_shape(storage_, shape_slot, def, place); });
    }
    /// Passes on the answer of a call, which wakes what sleeps where it did something.
    Status touched([[maybe_unused]] int slot, Status status) {
        if constexpr (S::sleeps)
            if (status == Status::ok)
                wake_by(storage_, [&](const ManifoldView& manifolds) { wake_touching(storage_.bodies(), storage_.rest_view(), manifolds, slot); });
        return status;
    }
    uint64_t hash_of(int slot, uint64_t hash) const {
        hash = hash_body(storage_.bodies(), slot, hash);
        Features::over_named<S>([&](auto feature) { hash = decltype(feature)::hash_body(storage_, slot, hash); });
        return hash;
    }
    bool sleeps_in(int slot) const { return is_dynamic(storage_.bodies(), slot) && !storage_.is_awake(slot); }
    Result<int> find_movable(BodyId id) const {
        const Result<int> slot = find(id);
        if (!slot.ok() || is_dynamic(storage_.bodies(), slot.value)) return slot;
        return {ingot::is_frozen(storage_.bodies(), slot.value) ? Status::frozen : Status::immovable, 0};
    }
    static bool same(const Vector& a, const Vector& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

    /// The slot that a query leaves out.
    Result<int> slot_of_exception(const QueryFilter& filter) const {
        return filter.except.generation == 0 ? Result<int>{Status::ok, no_slot} : find(filter.except);
    }
    /// Which bodies a query looks at, slot by slot.
    auto sees(const QueryFilter& filter, int except) const {
        return [this, filter, except](int slot) {
            if (slot / S::max_shapes_of_body == except || !meet(filter.filter, storage_.filter_view().of(slot))) return false;
            if constexpr (has_sensors<S>) return filter.sensors || storage_.is_sensor[slot] == 0;
            return true;
        };
    }

    BodyId first_id(const PairOfBodies& pair) const { return {body_of(pair.body_A), storage_.world_tag, pair.generation_A}; }
    BodyId second_id(const PairOfBodies& pair) const { return {body_of(pair.body_B), storage_.world_tag, pair.generation_B}; }

    // Slots of shapes are those of bodies, where a body has one shape.

    static uint16_t body_of(int shape_slot) { return static_cast<uint16_t>(shape_slot / S::max_shapes_of_body); }
    static int number_of_shape(int shape_slot) { return shape_slot == no_slot ? 0 : shape_slot % S::max_shapes_of_body; }
    BodyId id_of_shape(int shape_slot) const { return shape_slot == no_slot ? BodyId{} : id_of(body_of(shape_slot)); }

    bool lives(int slot) const { return storage_.lives(slot); }

    BodyId id_of(int slot) const { return {static_cast<uint16_t>(slot), storage_.world_tag, storage_.generation[slot]}; }

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

    /// The lowest slot that is free and whose generation is not used up; max_bodies if there is none.
    int free_slot() const {
        // bound: itself
        for (int slot = storage_.free_hint; slot < max_bodies; ++slot)
            if (!lives(slot) && storage_.generation[slot] != UINT32_MAX - 1) return slot;
        return max_bodies;
    }

    /// Takes a new slot into use. With the first lane of a tile all its lanes become the identity body.
    void begin_slot() {
        const int slot = storage_.slots_used++;
        if constexpr (has_compounds<S>) begin_shape_slots(slot);
        if (slot % lanes != 0) return;
        for (int lane_i = 0; lane_i < lanes; ++lane_i) set_identity_body(storage_.bodies(), slot + lane_i);
        if constexpr (S::sleeps && !has_compounds<S>) empty_bounds(slot, slot + lanes - 1);
    }
    /// The same for the slots of its shapes.
    void begin_shape_slots(int slot) {
        const int first = slot * S::max_shapes_of_body, last = first + S::max_shapes_of_body - 1;
        // bound: max_shapes_of_body and lanes
        for (int shape_slot = first; shape_slot <= last / lanes * lanes + lanes - 1; ++shape_slot) set_identity_body(storage_.shapes(), shape_slot);
        if constexpr (S::sleeps) empty_bounds(first, last / lanes * lanes + lanes - 1);
    }

    /// Slots without a shape overlap nothing: a search that looks at what is awake makes no bounds for them.
    void empty_bounds(int first, int last) {
        // bound: max_shapes_of_body and lanes
        for (int shape_slot = first; shape_slot <= last; ++shape_slot) ingot::empty_bounds(storage_.bounds, shape_slot);
    }

    Storage<S> storage_ = {};
};

} }  // namespace ingot

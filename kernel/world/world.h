// SPDX-License-Identifier: MIT
#pragma once

#include "../base/ids.h"
#include "../base/limits.h"
#include "../body/auxiliary.h"
#include "../body/energy_momentum.h"
#include "../body/freeze_bad_bodies.h"
#include "edit_bodies.h"
#include "state_hash.h"
#include "storage.h"

namespace ingot { inline namespace INGOT_ABI {

/// One contact of the last step, as World::contact tells it.
struct ContactInfo {
    BodyId A, B;
    Vector n;           ///< unit normal from B to A, world
    scalar separation;  ///< m, at the begin of the step; negative where the shapes overlap
    scalar j;           ///< N s, given to A along n, and to B against it, in the step
};

/// All there is of a simulated world: one object of a size known at compile time, which holds no pointer.
///
/// A world of zero bytes is a valid empty world. memcpy makes a snapshot, and copying it back restores it: the steps that
/// follow are the same to the bit.
///
/// Every call that can be refused answers with a Status, in every build, and has then left the world bitwise unchanged.
/// Calls that take a BodyId answer stale_id (removed, null, never given out) or foreign_id (of a world with another tag).
/// Units are SI; vectors and points are in world axes unless they say body. Cost is O(1) unless said.
template <class S>
class World {
    static_assert(check_scene<S>(), "");

public:
    using scene = S;
    static constexpr int max_bodies = S::max_bodies;

    // Bodies.

    /// Adds a body in the lowest free slot.
    /// Errors: no_room, and what BodyDef's parts may have wrong: see check_mass_properties, check_state, check_shape;
    ///         bad_restitution; immovable (one that has a velocity); not_in_scene (a shape the scene does not name, a
    ///         place or velocity where it does not translate); bad_shape (a half space that can move).
    /// Cost:   O(1), or O(max_bodies) after removals.
    Result<BodyId> add(const BodyDef& def) {
        Status status = Status::ok;
        if constexpr (has_shapes<S>) status = check_surface(def);
        if (status == Status::ok) status = check_definition(def, S::translates, has_shapes<S> && S::shapes::has(def.shape.kind));
        if (status != Status::ok) return {status, {}};
        const int slot = free_slot();
        if (slot == max_bodies) return {Status::no_room, {}};

        if (slot == storage_.slots_used) begin_slot();
        storage_.free_hint = slot + 1;
        ++storage_.generation[slot];
        write_body(storage_.bodies(), slot, def);
        if constexpr (has_shapes<S>) storage_.surfaces[slot] = {def.shape, bounding_radius(def.shape), def.restitution, def.friction};
        return {Status::ok, id_of(slot)};
    }

    /// Takes a body out. Its id, and every copy of it, is stale from now on.
    Status remove(BodyId id) {
        const Result<int> slot = find(id);
        if (!slot.ok()) return slot.status;
        ++storage_.generation[slot.value];
        if (slot.value < storage_.free_hint) storage_.free_hint = slot.value;
        set_identity_body(storage_.bodies(), slot.value);
        if constexpr (has_shapes<S>) storage_.surfaces[slot.value] = {};
        if constexpr (collides<S>) storage_.contact_count = 0;
        if constexpr (stacks<S>) forget_contacts(storage_.manifold_view(), storage_.pair_list(), storage_.bounds, slot.value);
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
        for (int slot = 0; slot < storage_.slots_used; ++slot) count += lives(slot) ? 1 : 0;
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
        return slot.ok() ? write_state(storage_.bodies(), slot.value, state) : slot.status;
    }

    /// Mass, kg, to the rounding of two divisions; 0 for an immovable body.
    Result<scalar> mass(BodyId id) const {
        translation_only();
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
        translation_only();
        const Result<int> slot = find(id);
        if (!slot.ok()) return slot.status;
        const Status status = check_vector(P, limits::position_max);
        if (status != Status::ok) return status;
        return accumulate_force(storage_.bodies(), slot.value, F, moment_about_centre(storage_.bodies(), slot.value, F, P));
    }

    /// A force at the centre of mass, N: it does not turn the body.
    Status add_central_force(BodyId id, const Vector& F) {
        translation_only();
        const Result<int> slot = find(id);
        return slot.ok() ? accumulate_force(storage_.bodies(), slot.value, F, {}) : slot.status;
    }

    /// A torque, N m.
    Status add_torque(BodyId id, const Vector& tau) {
        const Result<int> slot = find(id);
        return slot.ok() ? accumulate_force(storage_.bodies(), slot.value, {}, tau) : slot.status;
    }

    // Impulses, which act at once.
    // Errors: not_finite, out_of_range (the impulse, or the velocity it leads to), immovable, frozen.

    /// An impulse j, N s, at the world point P, m: v_CM += j / M, L += (P - r_CM) x j.
    Status apply_impulse(BodyId id, const Vector& j, const Vector& P) {
        translation_only();
        const Result<int> slot = find(id);
        if (!slot.ok()) return slot.status;
        const Status status = check_vector(P, limits::position_max);
        if (status != Status::ok) return status;
        return accumulate_impulse(storage_.bodies(), slot.value, j, moment_about_centre(storage_.bodies(), slot.value, j, P));
    }

    /// An impulse through the centre of mass, N s.
    Status apply_central_impulse(BodyId id, const Vector& j) {
        translation_only();
        const Result<int> slot = find(id);
        return slot.ok() ? accumulate_impulse(storage_.bodies(), slot.value, j, {}) : slot.status;
    }

    /// An angular impulse, N m s: L += k.
    Status apply_angular_impulse(BodyId id, const Vector& k) {
        const Result<int> slot = find(id);
        return slot.ok() ? accumulate_impulse(storage_.bodies(), slot.value, {}, k) : slot.status;
    }

    /// Lets two bodies collide at the world point P with unit normal n from B to A and restitution e (Fig. 4).
    /// Returns: the impulse, N s; 0 when the points separate.
    /// Errors:  not_finite, out_of_range, bad_direction, bad_restitution, immovable (both), frozen (either).
    Result<scalar> collide(BodyId id_A, BodyId id_B, const Vector& P, const Vector& n, scalar e) {
        translation_only();
        const Result<int> slot_A = find(id_A), slot_B = find(id_B);
        if (!slot_A.ok() || !slot_B.ok()) return {slot_A.ok() ? slot_B.status : slot_A.status, 0};
        if (slot_A.value == slot_B.value) return {Status::bad_shape, 0};
        return collide_bodies(storage_.bodies(), slot_A.value, slot_B.value, P, n, e);
    }

    /// Gravity of all bodies, m s^-2. Errors: not_finite, out_of_range (limits::gravity_max).
    Status set_gravity(const Vector& gravity) {
        translation_only();
        const Status status = check_vector(gravity, limits::gravity_max);
        if (status == Status::ok) storage_.gravity = gravity + Vector{};
        return status;
    }
    Vector gravity() const {
        translation_only();
        return storage_.gravity;
    }

    /// The field of the scene, to read its numbers and to set them; they are taken as they are.
    typename S::force_field& force_field() {
        field_only();
        return storage_.field;
    }
    const typename S::force_field& force_field() const {
        field_only();
        return storage_.field;
    }
    /// Sum of all h, s, of a world with a field: its BodyMotion::t at the begin of the next step.
    scalar time() const {
        field_only();
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
        contacts_only();
        return storage_.contact_count;
    }
    Result<ContactInfo> contact(int index) const {
        contacts_only();
        if (index < 0 || index >= storage_.contact_count) return {Status::out_of_range, {}};
        const Contact& c = storage_.contacts[index];
        return {Status::ok, {id_of(c.body_A), id_of(c.body_B), c.n, c.separation, c.j_total}};
    }

    // The world as a whole.

    /// 64 bits that are equal when the primary state of all bodies is bitwise equal, on every target and for every lane
    /// count. Cost: O(max_bodies).
    uint64_t state_hash() const {
        uint64_t hash = state_hash_seed;
        for (int slot = 0; slot < storage_.slots_used; ++slot)
            if (lives(slot)) hash = hash_body(storage_.bodies(), slot, hash);
        return hash;
    }

    /// Steps taken so far.
    uint32_t step_count() const { return storage_.steps; }

    /// Tells the ids of this world from those of another of the same scene. Errors: not_empty, once a body was added.
    Status set_tag(uint16_t tag) {
        if (storage_.slots_used != 0) return Status::not_empty;
        storage_.world_tag = tag;
        return Status::ok;
    }

private:
    template <class Any>
    friend StepReport step(World<Any>& world, scalar h);

    static constexpr void translation_only() {
        static_assert(S::translates, "this scene names no translation: set translates = true");
    }
    static constexpr void field_only() {
        static_assert(has_field<S>, "this scene names no field: set force_field");
    }
    static constexpr void contacts_only() {
        static_assert(collides<S>, "this scene names no contacts: set max_contacts");
    }

    bool lives(int slot) const { return (storage_.generation[slot] & 1u) != 0; }

    BodyId id_of(int slot) const { return {static_cast<uint16_t>(slot), storage_.world_tag, storage_.generation[slot]}; }

    Result<int> find(BodyId id) const {
        if (id.world_tag != storage_.world_tag && id.generation != 0) return {Status::foreign_id, 0};
        if (id.slot >= storage_.slots_used || (id.generation & 1u) == 0 || storage_.generation[id.slot] != id.generation)
            return {Status::stale_id, 0};
        return {Status::ok, id.slot};
    }

    /// The lowest slot that is free and whose generation is not used up; max_bodies if there is none.
    int free_slot() const {
        for (int slot = storage_.free_hint; slot < max_bodies; ++slot)
            if (!lives(slot) && storage_.generation[slot] != UINT32_MAX - 1) return slot;
        return max_bodies;
    }

    /// Takes a new slot into use. With the first lane of a tile all its lanes become the identity body.
    void begin_slot() {
        const int slot = storage_.slots_used++;
        if (slot % lanes != 0) return;
        for (int lane_i = 0; lane_i < lanes; ++lane_i) set_identity_body(storage_.bodies(), slot + lane_i);
    }

    Storage<S> storage_ = {};
};

} }  // namespace ingot

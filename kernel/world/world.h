// SPDX-License-Identifier: MIT
#pragma once

#include "../base/limits.h"
#include "../body/auxiliary.h"
#include "../body/energy_momentum.h"
#include "../body/freeze_bad_bodies.h"
#include "edit_bodies.h"
#include "state_hash.h"
#include "world_adds.h"

#include <stddef.h>

namespace ingot { inline namespace INGOT_ABI {

/// All there is of a simulated world: one object of a size known at compile time, which holds no pointer.
///
/// A world of zero bytes is a valid empty world. memcpy makes a snapshot, and copying it back restores it: the steps that
/// follow are the same to the bit. For files and other machines: snapshot.h.
///
/// Every call that can be refused answers with a Status, in every build, and has then left the world bitwise unchanged.
/// Calls that take a BodyId answer stale_id (removed, null, never given out) or foreign_id (of a world with another tag).
/// Units are SI; vectors and points are in world axes unless they say body. Cost is O(1) unless said.
///
/// Its calls stand in fifteen files: state of bodies and forces here, bodies that come and go in world_adds.h, what
/// scenes may name of a body in world_bodies.h, edits in world_edits.h, kinematic bodies in world_kinematic.h, joints and figures in
/// world_joints.h, drives in world_drives.h, what joints bear in world_reactions.h, rods and ropes in world_ties.h, equations of motion of figures in
/// world_dynamics.h, who touched in world_touching.h, who may in world_contacts.h, places in world_reads.h, queries in world_queries.h,
/// characters in world_mover.h.
template <class User>
class World : public WorldAdds<SceneOf<User>> {
    using S = SceneOf<User>;
    using Base = WorldAdds<S>;
    using Base::storage_;
    using Base::translation_only;
    using Base::field_only;
    using Base::compounds_only;
    using Base::touched;
    using Base::moved;
    using Base::lives;
    using Base::next_living;
    using Base::id_of;
    using Base::find;

public:
    using Base::is_alive;  // of a joint
    using Base::remove;

    using scene = S;                                  ///< what it is made of
    static constexpr int max_bodies = S::max_bodies;  ///< slots: see body_at

    // Bodies.

    bool is_alive(BodyId id) const { return find(id).ok(); }  ///< false for ids of none

    /// True for a body that legal input drove to a value that is not finite: it stands still until it is removed.
    bool is_frozen(BodyId id) const {
        const Result<int> slot = find(id);
        return slot.ok() && ingot::is_frozen(storage_.bodies(), slot.value);
    }

    /// Bodies that live in the world. Cost: O(max_bodies).
    int body_count() const {
        int count = 0;
        for (int slot = 0; slot < storage_.slots_used; ++slot) count += lives(slot) && storage_.owner_of(slot) == slot ? 1 : 0;  // bound: max_bodies
        return count;
    }

    /// The id of the living body of a slot, 0 <= slot < max_bodies; the null id if none lives there. For walking all bodies.
    BodyId body_at(int slot) const {
        const bool there = slot >= 0 && slot < storage_.slots_used && lives(slot);
        return there && storage_.owner_of(slot) == slot ? id_of(slot) : BodyId{};
    }

    // State.

    /// Where a body is and how it moves; of a kinematic body L is its angular velocity, rad/s. Errors: those of ids.
    Result<BodyState> state(BodyId id) const {
        const Result<int> slot = find(id);
        if (!slot.ok()) return {slot.status, {}};
        if constexpr (S::kinematic_bodies)
            if (ingot::is_kinematic(storage_.kinematic[slot.value])) return {Status::ok, this->kinematic_state(slot.value)};
        return {Status::ok, read_state(storage_.bodies(), slot.value)};
    }

    /// A body that is put away from its joints draws the others after it in the steps that follow, by ways that no velocity sees.
    /// A kinematic body is put there, whatever is in its way, and goes on with v_CM and, in the place of L, omega: see move_to for one that is to
    /// push others aside.
    /// Errors: those of check_state, frozen, immovable (a velocity for a body that has none), not_in_scene.
    Status set_state(BodyId id, const BodyState& state) {
        const Result<int> slot = find(id);
        if constexpr (has_levels<S>)
            if (slot.ok() && this->has_ground(slot.value)) return put_ground(slot.value, state);
        if constexpr (S::kinematic_bodies)
            if (slot.ok() && ingot::is_kinematic(storage_.kinematic[slot.value])) return this->put_kinematic(slot.value, state);
        if constexpr (has_compounds<S>) {
            const Status status = slot.ok() ? write_state(storage_.bodies(), slot.value, state) : slot.status;
            if (status == Status::ok) place_shapes(storage_.bodies(), storage_.compound_view(), slot.value);
            return slot.ok() ? moved(slot.value, status) : status;
        }
        return slot.ok() ? moved(slot.value, write_state(storage_.bodies(), slot.value, state)) : slot.status;
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
        if constexpr (S::kinematic_bodies)
            if (ingot::is_kinematic(storage_.kinematic[slot.value])) return {Status::ok, storage_.kinematic[slot.value].omega};
        return {Status::ok, this->spin_of_slot(slot.value)};
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
        const Result<scalar> j = this->collide_slots(slot_A.value, slot_B.value, P, n, e);
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
    /// As it is now, m s^-2; 0 until it is set.
    Vector gravity() const {
        static_assert(translation_only());
        return storage_.gravity;
    }

    /// The field of the scene, to read its numbers and to set them; they are taken as they are.
    typename S::force_field& force_field() {
        static_assert(field_only());
        return storage_.field;
    }
    /// The same, to read.
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

    // The same of one body. Errors: those of ids.

    /// J
    Result<scalar> kinetic_energy(BodyId id) const {
        const Result<int> slot = find(id);
        return {slot.status, slot.ok() ? kinetic_energy_of(storage_.bodies(), slot.value) : 0};
    }
    /// kg m/s
    Result<Vector> linear_momentum(BodyId id) const {
        const Result<int> slot = find(id);
        return {slot.status, slot.ok() ? linear_momentum_of(storage_.bodies(), slot.value) : Vector{}};
    }
    /// kg m^2/s, about the origin
    Result<Vector> angular_momentum(BodyId id) const {
        const Result<int> slot = find(id);
        return {slot.status, slot.ok() ? angular_momentum_of(storage_.bodies(), slot.value) : Vector{}};
    }

    // The world as a whole.

    /// 64 bits that are equal when the primary state of all bodies is bitwise equal, on every target and for every lane
    /// count. Cost: O(max_bodies).
    uint64_t state_hash() const {
        uint64_t hash = state_hash_seed;
        // bound: max_bodies
        for (int slot = next_living(0); slot < storage_.slots_used; slot = next_living(slot + 1)) hash = hash_of(slot, hash);
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
    /// All that a level takes.
    Status put_ground(int slot, const BodyState& state) {
        Status status = Status::ok;
        storage_.over_bodies_of(slot, [&](int of_body) {
            if (status == Status::ok) status = write_state(storage_.bodies(), of_body, state);
            if (status != Status::ok) return;
            if constexpr (has_compounds<S>) place_shapes(storage_.bodies(), storage_.compound_view(), of_body);
            status = moved(of_body, status);
        });
        return status;
    }

    template <class Any>
    friend StepReport step(World<Any>& world, scalar h);
    template <class Any>
    friend Result<size_t> save_snapshot(const World<Any>& world, uint8_t* bytes, size_t room);
    template <class Any>
    friend Status load_snapshot(World<Any>& world, const uint8_t* bytes, size_t size);

    uint64_t hash_of(int slot, uint64_t hash) const {
        hash = hash_body(storage_.bodies(), slot, hash);
        features::All::over_named<S>([&](auto feature) { hash = decltype(feature)::hash_body(storage_, slot, hash); });
        return hash;
    }
    static bool same(const Vector& a, const Vector& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
};

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// The part of World that is of one body: what a scene may name beside mass and state.
#pragma once

#include "world_slots.h"

namespace ingot { inline namespace INGOT_ABI {

/// Calls of World, see world.h.
template <class S>
class WorldBodies : public WorldSlots<S> {
protected:
    using Base = WorldSlots<S>;
    using Base::storage_;
    using Base::translation_only;
    using Base::shares_only;
    using Base::body_forces_only;
    using Base::damping_only;
    using Base::locks_only;
    using Base::user_data_only;
    using Base::touched;
    using Base::find;

public:
    /// What a body feels of gravity, in scenes with gravity_shares: 1 as it is added, 0 for one that floats, below 0 for one that rises. Exact to the
    /// rounding of the mass: see motion/gravity_shares.h. Errors: not_finite, out_of_range (beyond limits::gravity_share_max).
    Status set_gravity_share(BodyId id, scalar share) {
        static_assert(shares_only());
        const Result<int> slot = find(id);
        if (!slot.ok()) return slot.status;
        if (!is_finite(share)) return Status::not_finite;
        if (!(abs(share) <= limits::gravity_share_max)) return Status::out_of_range;
        storage_.shares_of_gravity[slot.value] = share + scalar(0);  // -0 becomes +0: one value, one set of bits
        return touched(slot.value, Status::ok);
    }
    /// What set_gravity_share has set; 1 as a body is added. Errors: those of ids.
    Result<scalar> gravity_share(BodyId id) const {
        static_assert(shares_only());
        const Result<int> slot = find(id);
        if (!slot.ok()) return {slot.status, 0};
        return {Status::ok, storage_.shares_of_gravity[slot.value]};
    }

    // Forces of the next step in the axes of the body, in scenes with body_forces: they turn with it over the step, which takes them where it will be
    // in the middle; where nothing touches, is joined, locked, sleeps or has compensated_sums, half where it begins and half where it ends. Otherwise
    // as add_force: they are summed, and gone after it.
    // Errors: not_finite, out_of_range (a summand or the sum beyond limits::force_max, torque_max), immovable, frozen.

    /// A force F_body, N, at the point r_body of the body, m from the centre of mass; both in body axes.
    Status add_body_force(BodyId id, const Vector& F_body, const Vector& r_body) {
        static_assert(body_forces_only() && translation_only());
        const Status status = check_vector(r_body, limits::position_max);
        return status == Status::ok ? hold_in_body(id, F_body, cross(r_body, F_body)) : find(id).ok() ? status : find(id).status;
    }
    /// A torque, N m, in body axes.
    Status add_body_torque(BodyId id, const Vector& tau_body) {
        static_assert(body_forces_only());
        return hold_in_body(id, {}, tau_body);
    }

    /// How a body slows down by itself, 1/s, in scenes with damping: without forces v_CM goes as exp(-linear t), L as exp(-angular t), at any step.
    /// A body that is added has none. What rests stays as it is; what falls comes to rest at g / linear, and linear h / 2 of it more.
    /// Errors: not_finite, out_of_range (outside 0 .. limits::damping_max).
    Status set_damping(BodyId id, const Damping& damping) {
        static_assert(damping_only());
        const Result<int> slot = find(id);
        if (!slot.ok()) return slot.status;
        const Status status = check_damping(damping);
        if (status == Status::ok) storage_.damping[slot.value] = {damping.linear + 0, damping.angular + 0};  // -0 becomes +0
        return touched(slot.value, status);
    }
    /// What set_damping has set, 1/s; none as a body is added. Errors: those of ids.
    Result<Damping> damping(BodyId id) const {
        static_assert(damping_only());
        const Result<int> slot = find(id);
        if (!slot.ok()) return {slot.status, {}};
        return {Status::ok, storage_.damping[slot.value]};
    }

    /// Axes of the world along which a body does not move, and about which it does not turn, in scenes with axis_locks: bits of AxisLocks. What it
    /// had of such a motion is gone, and what it has of the others stays: v_CM and L along them. A locked coordinate keeps its bits, whatever hits
    /// the body; one that cannot move keeps its locks for when it can. Wakes the body and what touches it.
    /// Errors: out_of_range (bits beyond AxisLocks::all), not_in_scene (a translation where nothing translates, or where contacts are those of
    ///         FrictionlessImpacts or SequentialImpulses, for which a body has one mass: these lock turns alone).
    Status set_locks(BodyId id, unsigned locks) {
        static_assert(locks_only());
        const Result<int> slot = find(id);
        if (!slot.ok()) return slot.status;
        const Status status = features::LockedAxes::check_locks<S>(locks);
        if (status == Status::ok) storage_.locks[slot.value] = static_cast<uint8_t>(locks);
        return touched(slot.value, status);
    }
    /// As set_locks, or BodyDef::locks, set them. Errors: those of ids.
    Result<unsigned> locks(BodyId id) const {
        static_assert(locks_only());
        const Result<int> slot = find(id);
        if (!slot.ok()) return {slot.status, 0};
        return {Status::ok, storage_.locks[slot.value]};
    }

    /// 32 bits that are yours, in scenes with user_data: an index, a tag, a pointer's offset. 0 as a body is added; snapshots hold it, the state hash
    /// does not, and it wakes nobody.
    Status set_user_data(BodyId id, uint32_t word) {
        static_assert(user_data_only());
        const Result<int> slot = find(id);
        if (slot.ok()) storage_.user_words[slot.value] = word;
        return slot.status;
    }
    /// What set_user_data has set. Errors: those of ids.
    Result<uint32_t> user_data(BodyId id) const {
        static_assert(user_data_only());
        const Result<int> slot = find(id);
        if (!slot.ok()) return {slot.status, 0};
        return {Status::ok, storage_.user_words[slot.value]};
    }

private:
    Status hold_in_body(BodyId id, const Vector& F_body, const Vector& tau_body) {
        const Result<int> slot = find(id);
        if (!slot.ok()) return slot.status;
        BodyForceTile& tile = storage_.body_forces[place_of(slot.value).tile];
        return touched(slot.value, accumulate_body_force(storage_.bodies(), tile, slot.value, F_body, tau_body));
    }
};

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// The part of World that moves kinematic bodies: platforms, lifts, doors, flippers, turntables.
#pragma once

#include "world_edits.h"

namespace ingot { inline namespace INGOT_ABI {

/// Calls of World, see world.h.
template <class S>
class WorldKinematic : public WorldEdits<S> {
protected:
    using Base = WorldEdits<S>;
    using Base::storage_;
    using Base::kinematic_only;
    using Base::touched;
    using Base::find;

public:
    // Kinematic bodies, in scenes with kinematic_bodies: a third kind beside bodies that can move and immovable ones. They go where they are told, in
    // the substeps of everything else, and nothing stops them: neither gravity, forces and impulses nor what is in their way. To contacts they
    // are infinitely heavy and move: friction carries, restitution throws, as v_CM + omega x r at each point asks for. Among themselves, and with
    // immovable bodies, they have no contacts. They join no islands. One that moves keeps awake what it touches and wakes what it meets; one that
    // stands still is as an immovable body. Energy and momentum of the world do not count them, and World::collide takes them for standing.
    // Their motion is exact: r_CM goes along a straight line, A turns by exp(omega h), and rounding does not add up; points go on arcs. What turns
    // about a hinge beside its middle has its body's centre there: World::add with parts. It turns by limits::kinematic_turn_max in a step at most.
    // With `continuous` fast bodies meet them where they are at the time of impact, and one that is itself fast, a flipper, meets what is in its way.
    // Without it what would get beyond one within a step does, as with immovable ones, and what a fast flipper hits leaves along the normal of the
    // begin of the step.
    // What is pressed between two of them that close, or against something fixed, yields by overlapping: overlaps are taken back at
    // limits::push_speed_max length_unit at most, and give no velocity.
    // Errors: immovable (a body that is not kinematic).

    /// It goes on with this velocity of its centre, m/s, and angular velocity, rad/s, world axes, until it is told otherwise.
    /// Errors: not_finite, out_of_range (a component beyond limits::speed_max, spin_max).
    Status set_velocity(BodyId id, const Vector& v_CM, const Vector& omega = {}) {
        static_assert(kinematic_only());
        const Result<int> slot = find_kinematic(id);
        const Status status = slot.ok() ? check_kinematic_motion(v_CM, omega) : slot.status;
        if (status == Status::ok) set_kinematic_motion(storage_.kinematic[slot.value], v_CM, omega);
        return slot.ok() ? touched(slot.value, status) : status;
    }

    /// The next step takes it to this pose, r_CM, m, and A, body to world, at a constant velocity and, by the shorter way, a constant spin; it is
    /// there to the bit at the end of the step, whatever h is, and stands still from then on. Called before each step, it follows an animation. What
    /// it touches is left with the velocity that it had. Farther than limits::speed_max h it is put there as by set_state.
    /// Errors: not_finite, out_of_range (beyond limits::position_max), not_a_rotation.
    Status move_to(BodyId id, const Vector& r_CM, const Matrix& A) {
        static_assert(kinematic_only());
        const Result<int> slot = find_kinematic(id);
        Status status = slot.ok() ? check_vector(r_CM, limits::position_max) : slot.status;
        if (status == Status::ok) status = check_rotation(A);
        if (status == Status::ok) {
            KinematicBody& body = storage_.kinematic[slot.value];
            set_kinematic_motion(body, {}, {});
            body.r_CM_goal = r_CM + Vector{};
            body.A_goal = nearest_rotation(A);
            body.goal = KinematicGoal::pose;
        }
        return slot.ok() ? touched(slot.value, status) : status;
    }

    /// A body is kinematic from now on, and stands still until it is told to move. One that is so already goes on: ok, and nothing changes.
    /// Errors: frozen, bad_shape (a half space: give it a large box; a level).
    Status set_kinematic(BodyId id) {
        static_assert(kinematic_only());
        const Result<int> slot = find(id);
        if (!slot.ok()) return slot.status;
        if (ingot::is_frozen(storage_.bodies(), slot.value)) return Status::frozen;
        if (ingot::is_kinematic(storage_.kinematic[slot.value])) return Status::ok;
        if (this->has_ground(slot.value)) return Status::bad_shape;
        const Status status = this->set_immovable(id);
        if (status == Status::ok) set_kinematic_motion(storage_.kinematic[slot.value], {}, {});
        return status;
    }
    /// False for ids of none.
    bool is_kinematic(BodyId id) const {
        static_assert(kinematic_only());
        return find_kinematic(id).ok();
    }

protected:
    /// See World::state.
    BodyState kinematic_state(int slot) const {
        BodyState now = read_state(storage_.bodies(), slot);
        now.v_CM = storage_.kinematic[slot].v_CM;
        now.L = storage_.kinematic[slot].omega;
        return now;
    }
    /// See World::set_state.
    Status put_kinematic(int slot, const BodyState& state) {
        Status status = check_kinematic_motion(state.v_CM, state.L);
        if (status == Status::ok) status = write_state(storage_.bodies(), slot, {state.r_CM, {}, state.A, {}});
        if (status != Status::ok) return status;
        KinematicBody& body = storage_.kinematic[slot];
        set_kinematic_motion(body, state.v_CM, state.L);
        body.r_CM_low = {};
        body.A_low = {};
        if constexpr (has_compounds<S>) place_shapes(storage_.bodies(), storage_.compound_view(), slot);
        storage_.hold_shapes(slot);
        return touched(slot, status);
    }

private:
    Result<int> find_kinematic(BodyId id) const {
        const Result<int> slot = find(id);
        if (!slot.ok() || ingot::is_kinematic(storage_.kinematic[slot.value])) return slot;
        return {ingot::is_frozen(storage_.bodies(), slot.value) ? Status::frozen : Status::immovable, 0};
    }
};

} }  // namespace ingot

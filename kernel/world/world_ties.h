// SPDX-License-Identifier: MIT
// The part of World for rods, ropes, targets and gears.
#pragma once

#include "world_reactions.h"

namespace ingot { inline namespace INGOT_ABI {

/// Calls of World, see world.h.
template <class S>
class WorldTies : public WorldReactions<S> {
protected:
    using Base = WorldReactions<S>;
    using Base::storage_;
    using Base::find;

    static constexpr bool ties_only() {
        static_assert(has_ties<S>, "this scene has no rods and ropes: put RodJoint or RopeJoint among its joints, and set max_loops");
        return true;
    }

public:
    // Rods and ropes, in scenes that name RodJoint or RopeJoint among their joints: see joint/joints.h.

    /// A rod or a rope becomes so long, m, by limits::reel_speed at most: what hangs on it is drawn in or let out. Wakes its bodies.
    /// Errors: those of ids, not_in_scene (another kind), not_finite, out_of_range (beyond limits::tie_length_min to limits::position_max).
    Status set_joint_length(JointId id, scalar length) {
        static_assert(ties_only());
        const Result<int> joint = find_tie(id);
        if (!joint.ok()) return joint.status;
        const Status status = check_length(length, S::length_unit);
        if (status != Status::ok) return status;
        TieRecord& tie = storage_.joint_ties[joint.value];
        // Of a rope what lies slack is taken off at once.
        const JointRecord& record = storage_.joints[joint.value];
        if (this->kind_of(joint.value) == JointKind::rope) tie.reeled = min(tie.reeled, max(length, this->distance_of(record)));
        tie.length = length;
        this->wake_sides(joint.value);
        return Status::ok;
    }
    /// How long it is, m: where a new length is still drawn in or let out, on its way. Errors: those of ids, not_in_scene.
    Result<scalar> joint_length(JointId id) const {
        static_assert(ties_only());
        const Result<int> joint = find_tie(id);
        if (!joint.ok()) return {joint.status, 0};
        return {Status::ok, storage_.joint_ties[joint.value].reeled};
    }
    /// How far its ends are apart, m. Errors: those of ids, not_in_scene.
    Result<scalar> joint_distance(JointId id) const {
        static_assert(ties_only());
        const Result<int> joint = find_tie(id);
        if (!joint.ok()) return {joint.status, 0};
        return {Status::ok, this->distance_of(storage_.joints[joint.value])};
    }

    // Targets, in scenes that name TargetJoint among their joints: see joint/target_record.h.

    /// How a body is drawn from now on. Wakes it. Errors: those of ids and of check_target_drive, not_in_scene (another kind).
    Status set_target_drive(JointId id, const TargetDrive& drive) {
        static_assert(targets_only());
        const Result<int> joint = find_target(id);
        const Status status = joint.ok() ? check_target_drive(drive) : joint.status;
        if (status != Status::ok) return status;
        storage_.joint_targets[joint.value].set(drive);
        this->wake_sides(joint.value);
        return Status::ok;
    }
    /// How a body is drawn, as set_target_drive has set it. Errors: those of ids, not_in_scene (another kind).
    Result<TargetDrive> target_drive(JointId id) const {
        static_assert(targets_only());
        const Result<int> joint = find_target(id);
        if (!joint.ok()) return {joint.status, {}};
        return {Status::ok, storage_.joint_targets[joint.value].drive()};
    }

    /// The point of the body that is drawn should be at P, m, world, as the next step begins, and go on with v, m/s; how its axes are wanted is left.
    /// An animation that says how fast it goes is followed without a lag. Wakes it.
    /// Errors: those of ids, not_in_scene (another kind), not_finite, out_of_range (P beyond limits::position_max, v beyond limits::speed_max).
    Status set_target(JointId id, const Vector& P, const Vector& v = {}) {
        static_assert(targets_only());
        const Result<int> joint = find_target(id);
        Status status = joint.ok() ? check_vector(P, limits::position_max) : joint.status;
        if (status == Status::ok) status = check_vector(v, limits::speed_max);
        if (status != Status::ok) return status;
        storage_.joints[joint.value].frame_A.anchor = P + Vector{};
        storage_.joint_targets[joint.value].velocity = v + Vector{};
        this->wake_sides(joint.value);
        return Status::ok;
    }
    /// The same, and its axes: A, body to world, as in BodyState, and how fast they turn, rad/s, world.
    /// Errors: those of set_target, not_a_rotation, out_of_range (omega beyond limits::drive_rate_max).
    Status set_target(JointId id, const Vector& P, const Matrix& A, const Vector& v = {}, const Vector& omega = {}) {
        static_assert(targets_only());
        Status status = check_rotation(A);
        if (status == Status::ok) status = check_vector(omega, limits::drive_rate_max);
        const Status of_place = find_target(id).ok() && status != Status::ok ? status : set_target(id, P, v);
        if (of_place != Status::ok) return of_place;
        const int joint_i = find_target(id).value;
        JointRecord& record = storage_.joints[joint_i];
        const Matrix nearest = nearest_rotation(A);
        record.frame_A.axis = nearest * record.frame_B.axis;
        record.frame_A.side = nearest * record.frame_B.side;
        storage_.joint_targets[joint_i].spin = omega + Vector{};
        return Status::ok;
    }
    /// What has drawn the body in the last step, at its point, N, world, mean of the step. Errors: those of ids, not_in_scene.
    Result<Vector> target_force(JointId id) const {
        static_assert(targets_only());
        const Result<int> joint = find_target(id);
        if (!joint.ok()) return {joint.status, {}};
        return {Status::ok, storage_.joint_targets[joint.value].force};
    }
    /// And what has turned it, N m, beside the moment of that force.
    Result<Vector> target_torque(JointId id) const {
        static_assert(targets_only());
        const Result<int> joint = find_target(id);
        if (!joint.ok()) return {joint.status, {}};
        return {Status::ok, storage_.joint_targets[joint.value].torque};
    }

    // Gears, in scenes that name GearJoint among their joints: see joint/joints.h.

    /// Couples two joints, hinges, sliders or wheels, as they are now: joint_B goes `ratio` times as far as joint_A from here on, rad to rad, of a
    /// slider m. Rates that are otherwise are brought to it by the next step, as by an impact. Wakes their bodies. Goes with either joint.
    /// A limit, motor or brake of a joint that its gear makes heavy, more than 6e4 times (in double 6e8) what it is without it, is lost in roundings
    /// and does nothing, nor is that told: give it to the other joint of the gear, where it is as exact as ever.
    /// Errors: no_room (as add_joint), those of ids, bad_joint (the same joint twice; a kind without a way of its own), not_in_scene (one of the two
    ///         does nothing for now), not_finite, out_of_range (0, or beyond limits::gear_ratio_max or its inverse), immovable (no side can move).
    /// Cost:   O(max_joints).
    Result<JointId> add_gear(JointId joint_A, JointId joint_B, scalar ratio) {
        static_assert(gears_only());
        GearRecord gear{};
        const Status status = check_gear(joint_A, joint_B, ratio, gear);
        if (status != Status::ok) return {status, {}};
        JointRecord record{};
        record.kind = JointKind::gear;
        record.frame_A = record.frame_B = {{}, {0, 0, 1}, {1, 0, 0}};
        record.body_A = record.body_B = no_body;
        record.resolved = record.bodies_meet = 1;
        name_bodies(storage_.bodies(), storage_.joint_lists(), gear, record);
        if (record.body_A == no_body && record.body_B == no_body) return {Status::immovable, {}};
        const int joint_i = this->free_joint();
        if (joint_i == S::max_joints) return {Status::no_room, {}};
        couple(storage_.bodies(), storage_.joints, gear);
        storage_.joints[joint_i] = record;
        storage_.joint_gears[joint_i] = gear;
        storage_.joint_lists().link(joint_i);
        if (!this->has_room_for_loop(joint_i)) {
            storage_.joint_lists().unlink(joint_i);
            storage_.joints[joint_i] = {};
            storage_.joint_gears[joint_i] = {};
            return {Status::no_room, {}};
        }
        if constexpr (has_joint_breaking<S>) storage_.joint_breaking[joint_i].strength = JointStrength{};
        ++storage_.joint_generation[joint_i];
        if (joint_i == storage_.joint_slots_used) ++storage_.joint_slots_used;
        this->wake_sides(joint_i);
        return {Status::ok, this->id_of_joint(joint_i)};
    }
    /// As add_gear was told. Errors: those of ids, not_in_scene (another kind).
    Result<scalar> gear_ratio(JointId id) const {
        static_assert(gears_only());
        const Result<int> joint = find(id);
        if (!joint.ok()) return {joint.status, 0};
        if (this->kind_of(joint.value) != JointKind::gear) return {Status::not_in_scene, 0};
        return {Status::ok, storage_.joint_gears[joint.value].ratio};
    }

private:
    static constexpr bool gears_only() {
        static_assert(has_gears<S>, "this scene has no gears: put GearJoint among its joints, and set max_loops");
        return true;
    }
    Status check_gear(JointId joint_A, JointId joint_B, scalar ratio, GearRecord& gear) const {
        const Result<int> A = find(joint_A), B = find(joint_B);
        if (!A.ok()) return A.status;
        if (!B.ok()) return B.status;
        if (A.value == B.value || !may_be_geared(this->kind_of(A.value)) || !may_be_geared(this->kind_of(B.value))) return Status::bad_joint;
        const JointKind kind_A = storage_.joints[A.value].kind, kind_B = storage_.joints[B.value].kind;
        if (kind_A == JointKind::none || kind_B == JointKind::none) return Status::not_in_scene;
        gear.joint[0] = static_cast<Index>(A.value);
        gear.joint[1] = static_cast<Index>(B.value);
        gear.ratio = ratio;
        return check_ratio(ratio, unit_of_travel(kind_A, 0, S::length_unit), unit_of_travel(kind_B, 0, S::length_unit));
    }
    static constexpr bool targets_only() {
        static_assert(has_targets<S>, "no body of this scene is drawn to a target: put TargetJoint among its joints, and set max_loops");
        return true;
    }
    Result<int> find_target(JointId id) const {
        const Result<int> joint = find(id);
        if (!joint.ok() || this->kind_of(joint.value) == JointKind::target) return joint;
        return {Status::not_in_scene, 0};
    }
    Result<int> find_tie(JointId id) const {
        const Result<int> joint = find(id);
        if (!joint.ok() || has_length(this->kind_of(joint.value))) return joint;
        return {Status::not_in_scene, 0};
    }
};

} }  // namespace ingot

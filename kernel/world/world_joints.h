// SPDX-License-Identifier: MIT
// The part of World that joins bodies.
#pragma once

#include "../figure/read_figure.h"
#include "../figure/read_joint.h"
#include "world_kinematic.h"

namespace ingot { inline namespace INGOT_ABI {

/// Calls of World, see world.h.
template <class S>
class WorldJoints : public WorldKinematic<S> {
protected:
    using Base = WorldKinematic<S>;
    using Base::storage_;
    using Base::touched;
    using Base::find;

    static constexpr bool joints_only() {
        static_assert(has_joints<S>, "this scene names no joints: set joints and max_joints");
        return true;
    }

public:
    // Joints, in scenes with max_joints: see joint/joints.h.

    /// Joins two bodies, or a body and the world, as they are now.
    /// Errors: no_room (max_joints are there; or it closes a loop, and max_loops do, or they have limits::loop_rows_max rows in its figure), those
    ///         of ids, of check_joint and of check_limits, not_in_scene (a kind, or limits, that the scene does not name), bad_joint (a body with
    ///         itself), immovable (neither can move), frozen.
    /// Cost:   O(max_joints) after removals, and where both of its bodies have joints already.
    Result<JointId> add_joint(const JointDef& def) {
        static_assert(joints_only());
        Index slot_A = no_body, slot_B = no_body;
        Status status = find_side(def.body_A, slot_A);
        if (status == Status::ok) status = find_side(def.body_B, slot_B);
        if (status == Status::ok) status = check_joint(def, S::joints::has_limits);
        if constexpr (has_ties<S>)
            if (status == Status::ok) status = check_tie(def, S::length_unit);
        if (status == Status::ok) status = check_limits_of(def.joint.kind, def.joint.limits);
        if (status == Status::ok && !S::joints::has(def.joint.kind)) status = Status::not_in_scene;
        if (status == Status::ok && slot_A == slot_B) status = Status::bad_joint;
        if constexpr (has_targets<S>)
            if (status == Status::ok && def.joint.kind == JointKind::target && slot_A != no_body) status = Status::bad_joint;
        if (status == Status::ok && !moves(slot_A) && !moves(slot_B)) status = Status::immovable;
        if constexpr (has_gears<S>)
            if (status == Status::ok && def.joint.kind == JointKind::gear) status = Status::bad_joint;  // see add_gear
        if constexpr (has_servos<S>)
            if (status == Status::ok && is_servo(def.joint.kind) && !moves(slot_B)) status = Status::immovable;
        if (status != Status::ok) return {status, {}};
        const int joint_i = free_joint();
        if (joint_i == S::max_joints) return {Status::no_room, {}};

        storage_.joints[joint_i] = record_of(def, storage_.bodies(), slot_A, slot_B, S::joints::has_limits);
        if constexpr (has_joint_limits<S>) storage_.joint_limits[joint_i].limits = def.joint.limits;
        if constexpr (has_joint_breaking<S>) storage_.joint_breaking[joint_i].strength = JointStrength{};
        if constexpr (has_ties<S>) begin_tie(joint_i, def);
        if constexpr (has_wheels<S>)
            if (def.joint.kind == JointKind::wheel)
                storage_.drive_of(joint_i, WheelJoint::steering).drive = SpringDrive{limits::drive_gain_max};
        storage_.joint_lists().link(joint_i);
        if (!has_room_for_loop(joint_i)) {
            storage_.joint_lists().unlink(joint_i);
            storage_.joints[joint_i] = {};
            if constexpr (has_joint_limits<S>) storage_.joint_limits[joint_i] = {};
            if constexpr (has_joint_breaking<S>) storage_.joint_breaking[joint_i].strength = {0, 0};
            if constexpr (has_ties<S>) storage_.joint_ties[joint_i] = {};
            if constexpr (has_targets<S>) storage_.joint_targets[joint_i] = {};
            return {Status::no_room, {}};
        }
        ++storage_.joint_generation[joint_i];
        if (joint_i == storage_.joint_slots_used) ++storage_.joint_slots_used;
        wake_sides(joint_i);
        return {Status::ok, id_of_joint(joint_i)};
    }

    /// Its bodies go their own ways. Gears of it go with it. Errors: those of ids.
    Status remove(JointId id) {
        static_assert(joints_only());
        const Result<int> joint = find(id);
        if (!joint.ok()) return joint.status;
        wake_sides(joint.value);
        features::Figures::take_out_gears_of(storage_, joint.value);
        features::Figures::take_out(storage_, joint.value);
        return Status::ok;
    }
    bool is_alive(JointId id) const { return find(id).ok(); }  ///< false for ids of none
    /// Joint in a slot, 0 .. max_joints - 1; the null id where there is none.
    JointId joint_at(int slot) const {
        static_assert(joints_only());
        return slot >= 0 && slot < storage_.joint_slots_used && storage_.joint_lives(slot) ? id_of_joint(slot) : JointId{};
    }

    /// Cost: O(max_joints).
    int joint_count() const {
        static_assert(joints_only());
        int count = 0;
        for (int joint_i = 0; joint_i < storage_.joint_slots_used; ++joint_i) count += storage_.joint_lives(joint_i) ? 1 : 0;  // bound: max_joints
        return count;
    }

    /// How far apart the two sides of a joint are, m: along what it locks. By how much a rod is longer or shorter than it should be; a rope longer;
    /// how far a target is; of a gear how far its joint B is from where its ratio wants it, rad, or m of a slider. 0 of a parallel joint and of a
    /// servo, which lock no way.
    Result<scalar> joint_gap(JointId id) const {
        static_assert(joints_only());
        const Result<int> joint = find(id);
        if (!joint.ok()) return {joint.status, 0};
        const auto& record = record_of_slot(joint.value);
        if constexpr (has_ties<S>)
            if (has_length(record.kind)) {
                const scalar over = distance_of(record) - storage_.joint_ties[joint.value].reeled;
                return {Status::ok, record.kind == JointKind::rope && over < 0 ? 0 : abs(over)};
            }
        if constexpr (has_gears<S>)
            if (record.kind == JointKind::gear)
                return {Status::ok, abs(gap_of(storage_.bodies(), storage_.joints, storage_.joint_gears[joint.value]))};
        if constexpr (has_ties<S>)
            if (record.kind == JointKind::parallel || is_servo(record.kind)) return {Status::ok, 0};
        return {Status::ok, gap_of(record, storage_.bodies())};
    }

    /// Where the free directions of a joint end from now on; what is beyond goes back slowly. Wakes its bodies.
    /// Errors: those of ids and of check_limits, not_in_scene (the kind has none).
    Status set_joint_limits(JointId id, const JointLimits& limits) {
        static_assert(joints_only());
        static_assert(S::joints::has_limits, "this scene's joints have no limits: name WithLimits among its joints");
        const Result<int> joint = find(id);
        if (!joint.ok()) return joint.status;
        const JointKind kind = kind_of(joint.value);
        if (limited_directions(kind) == 0) return Status::not_in_scene;
        const Status status = check_limits(kind, limits);
        if (status != Status::ok) return status;
        storage_.joint_limits[joint.value] = {};
        storage_.joint_limits[joint.value].limits = limits;
        wake_sides(joint.value);
        return Status::ok;
    }

    /// The angle of a hinge, or of a universal joint about the axis of A, and, with which = 1, of B; the twist of a ball joint, and, with which = 1,
    /// how far its axis has swung from the middle of its cone; of a wheel how far it has spun, and, with which = WheelJoint::steering, how far it is
    /// steered: rad, B against A; of a servo how far B has turned in the world. In scenes whose joints may have limits or drives the angles of a
    /// hinge, of a servo and of a wheel's spin go on over whole turns; else they are of -pi to pi.
    /// Errors: those of ids, not_in_scene (a kind that has no such angle).
    Result<scalar> joint_angle(JointId id, int which = 0) const {
        static_assert(joints_only());
        const Result<int> joint = find_turning(id, which);
        if (!joint.ok()) return {joint.status, 0};
        const JointRecord& record = record_of_slot(joint.value);
        if constexpr (has_servos<S>)
            if (is_servo(record.kind)) {
                const JointRecord measured = measured_by(record);
                const scalar angle = joint_values(measured, sides_of(measured)).of[0];
                return {Status::ok, angle_over_turns(angle, storage_.joint_angles[joint.value])};
            }
        if constexpr (has_wheels<S>)
            if (which == WheelJoint::steering) return {Status::ok, steering_angle(record, sides_of(record))};
        const scalar angle = joint_values(record, sides_of(record)).of[which];
        if constexpr (has_joint_rows<S>)
            if (record.kind == JointKind::hinge || is_wheel_of(record))
                return {Status::ok, angle_over_turns(angle, storage_.joint_angles[joint.value])};
        return {Status::ok, angle};
    }
    /// How fast it turns, rad/s. Errors: those of joint_angle.
    Result<scalar> joint_rate(JointId id, int which = 0) const {
        static_assert(joints_only());
        const Result<int> joint = find_turning(id, which);
        if (!joint.ok()) return {joint.status, 0};
        const JointRecord& record = record_of_slot(joint.value);
        if constexpr (has_servos<S>)
            if (is_servo(record.kind)) return {Status::ok, steering_rate(record, sides_of(measured_by(record)))};
        if constexpr (has_wheels<S>)
            if (which == WheelJoint::steering) return {Status::ok, steering_rate(record, sides_of(record))};
        return {Status::ok, joint_rates(record, sides_of(record)).of[which]};
    }
    /// How far a ball joint is turned, B against A, as a vector in the axes of A, rad, up to half a turn: as set_ball_drive takes its target.
    /// Errors: those of ids, not_in_scene (another kind).
    Result<Vector> ball_turn(JointId id) const {
        static_assert(joints_only());
        const Result<int> joint = find_ball(id);
        if (!joint.ok()) return {joint.status, {}};
        const JointRecord& record = record_of_slot(joint.value);
        return {Status::ok, ingot::ball_turn(record, sides_of(record))};
    }
    /// How fast it turns, rad/s, in the same axes. Errors: those of ball_turn.
    Result<Vector> ball_rate(JointId id) const {
        static_assert(joints_only());
        const Result<int> joint = find_ball(id);
        if (!joint.ok()) return {joint.status, {}};
        return {Status::ok, ingot::ball_rate(sides_of(record_of_slot(joint.value)))};
    }
    /// How far a slider, or a wheel, has gone along its axis, m, B against A. Errors: those of ids, not_in_scene (a kind that goes along no axis).
    Result<scalar> joint_travel(JointId id) const {
        static_assert(joints_only());
        const Result<int> joint = find_sliding(id);
        if (!joint.ok()) return {joint.status, 0};
        const JointRecord& record = record_of_slot(joint.value);
        return {Status::ok, joint_values(record, sides_of(record)).of[is_wheel_of(record) ? WheelJoint::travel : 0]};
    }
    /// How fast it goes, m/s. Errors: those of joint_travel.
    Result<scalar> joint_speed(JointId id) const {
        static_assert(joints_only());
        const Result<int> joint = find_sliding(id);
        if (!joint.ok()) return {joint.status, 0};
        const JointRecord& record = record_of_slot(joint.value);
        return {Status::ok, joint_rates(record, sides_of(record)).of[is_wheel_of(record) ? WheelJoint::travel : 0]};
    }

    // Figures, in scenes with joints.

    /// How all that hangs together with a body moves as one: the same whichever of its bodies is asked for.
    /// Errors: those of ids, immovable (also a kinematic body), frozen.
    /// Cost: about 80 flops a body of the figure, a look at each joint of it and at a bit of each slot; stack: 2 bytes for each body that may have
    /// joints, and a bit for each body.
    Result<FigureInfo> figure(BodyId id) const {
        static_assert(joints_only());
        const Result<int> slot = this->find_movable(id);
        if (!slot.ok()) return {slot.status, {}};
        return {Status::ok, figure_at(static_cast<Index>(slot.value))};
    }
    /// The same of the bodies of a joint. Errors: those of ids, not_in_scene (one that is broken or disabled: ask for its bodies), immovable (neither
    /// can move), frozen.
    Result<FigureInfo> figure(JointId id) const {
        static_assert(joints_only());
        const Result<int> joint = find(id);
        if (!joint.ok()) return {joint.status, {}};
        const JointRecord& record = storage_.joints[joint.value];
        if (record.kind == JointKind::none) return {Status::not_in_scene, {}};
        const bool of_A = moves(record.body_A);
        if (!of_A && !moves(record.body_B)) return {freezes(record.body_A) || freezes(record.body_B) ? Status::frozen : Status::immovable, {}};
        return {Status::ok, figure_at(of_A ? record.body_A : record.body_B)};
    }

protected:
    Result<int> find(JointId id) const {
        static_assert(joints_only());
        if (id.world_tag != storage_.world_tag && id.generation != 0) return {Status::foreign_id, 0};
        if (id.slot >= storage_.joint_slots_used || (id.generation & 1u) == 0 || storage_.joint_generation[id.slot] != id.generation)
            return {Status::stale_id, 0};
        return {Status::ok, id.slot};
    }

    JointKind kind_of(int joint_i) const { return features::kind_of_joint(storage_, joint_i); }
    /// Also as it was before it broke.
    If<has_joint_breaking<S>, JointRecord, const JointRecord&> record_of_slot(int joint_i) const {
        if constexpr (has_joint_breaking<S>) {
            JointRecord record = storage_.joints[joint_i];
            record.kind = kind_of(joint_i);
            return record;
        } else {
            return storage_.joints[joint_i];
        }
    }

    Result<int> find_ball(JointId id) const {
        const Result<int> joint = find(id);
        if (!joint.ok() || kind_of(joint.value) == JointKind::ball) return joint;
        return {Status::not_in_scene, 0};
    }
    JointBody side_of(Index slot) const {
        if (slot == no_body) return {};
        BodyState state = read_state(storage_.bodies(), slot);
        Vector omega = omega_of(storage_.bodies(), slot);
        if constexpr (S::kinematic_bodies)
            if (ingot::is_kinematic(storage_.kinematic[slot])) {
                state = this->kinematic_state(slot);
                omega = state.L;
            }
        return {state.r_CM, state.A, state.v_CM, omega};
    }
    JointPair sides_of(const JointRecord& joint) const { return {side_of(joint.body_A), side_of(joint.body_B)}; }
    /// m, between the ends of a rod or a rope.
    scalar distance_of(const JointRecord& joint) const {
        const BodyView bodies = storage_.bodies();
        return sqrt(length_sq(anchor_in_world(bodies, joint.body_B, joint.frame_B) - anchor_in_world(bodies, joint.body_A, joint.frame_A)));
    }
    void wake_sides(int joint_i) {
        const JointRecord& joint = storage_.joints[joint_i];
        if (moves(joint.body_A)) (void)touched(joint.body_A, Status::ok);
        if (moves(joint.body_B)) (void)touched(joint.body_B, Status::ok);
    }
    bool freezes(Index slot) const { return slot != no_body && ingot::is_frozen(storage_.bodies(), slot); }
    bool moves(Index slot) const { return slot != no_body && is_dynamic(storage_.bodies(), slot); }
    /// What has no other joint closes no loop.
    bool hangs_on_others(Index slot, int joint_i) {
        bool hangs = !moves(slot);
        if (!hangs) storage_.joint_lists().for_ends(slot, [&](int end) { hangs = hangs || end / 2 != joint_i; });
        return hangs;
    }
    /// Of a joint that is linked, but not told to the rest of the world yet.
    bool has_room_for_loop(int joint_i) {
        const JointRecord& joint = storage_.joints[joint_i];
        if (!is_tie(joint.kind) && (!hangs_on_others(joint.body_A, joint_i) || !hangs_on_others(joint.body_B, joint_i))) return true;
        const int joint_slots = joint_i < storage_.joint_slots_used ? storage_.joint_slots_used : joint_i + 1;
        return features::Figures::joints_without_room(storage_, joint_slots) == 0;
    }

    JointId id_of_joint(int joint_i) const { return {static_cast<Index>(joint_i), storage_.world_tag, storage_.joint_generation[joint_i]}; }
    int free_joint() const {
        int joint_i = 0;
        // bound: max_joints; a slot whose counter is used up is not given out again
        while (joint_i < storage_.joint_slots_used && (storage_.joint_lives(joint_i) || storage_.joint_generation[joint_i] == 0xfffffffeu)) ++joint_i;
        return joint_i;
    }

private:
    /// Known to be none where the scene has none.
    static bool is_wheel_of([[maybe_unused]] const JointRecord& record) {
        if constexpr (has_wheels<S>) return record.kind == JointKind::wheel;
        return false;
    }
    /// As a hinge of the world.
    static JointRecord measured_by(const JointRecord& servo) {
        JointRecord hinge = servo;
        hinge.kind = JointKind::hinge;
        hinge.body_A = no_body;
        return hinge;
    }
    Result<int> find_turning(JointId id, int which) const {
        const Result<int> joint = find(id);
        if (!joint.ok()) return joint;
        const JointKind kind = kind_of(joint.value);
        bool turns = kind != JointKind::slider && which >= 0 && which < limited_directions(kind);
        if constexpr (has_wheels<S>)
            if (kind == JointKind::wheel) turns = which == WheelJoint::spin || which == WheelJoint::steering;
        if constexpr (has_servos<S>) turns = turns || (kind == JointKind::servo && which == 0);
        return turns ? joint : Result<int>{Status::not_in_scene, 0};
    }
    Result<int> find_sliding(JointId id) const {
        const Result<int> joint = find(id);
        if (!joint.ok() || kind_of(joint.value) == JointKind::slider) return joint;
        if constexpr (has_wheels<S>)
            if (kind_of(joint.value) == JointKind::wheel) return joint;
        return {Status::not_in_scene, 0};
    }
    FigureInfo figure_at(Index slot) const {
        uint8_t bits[(static_cast<unsigned>(S::max_bodies) + 7) / 8] = {};
        Index room[features::Figures::Memory<S, true>::node_capacity + 1];
        const FigureMarks marks = {bits, room};
        mark_figure(storage_.bodies(), const_cast<Storage<S>&>(storage_).joint_lists(), slot, marks);  // a list that is only read
        return figure_of(storage_.bodies(), marks, storage_.slots_used);
    }
    static Status check_limits_of([[maybe_unused]] JointKind kind, const JointLimits& limits) {
        if constexpr (has_ties<S> && S::joints::has_limits)
            if (is_tie(kind)) {  // the length of a rod stands there
                const Status status = check_limits(kind, limits);
                return status == Status::ok && !has_length(kind) && limits_something(limits) ? Status::not_in_scene : status;
            }
        if constexpr (has_ties<S>)
            if (is_tie(kind)) return Status::ok;
        if constexpr (S::joints::has_limits) return check_limits(kind, limits);
        return limits_something(limits) ? Status::not_in_scene : Status::ok;
    }
    void begin_tie(int joint_i, const JointDef& def) {
        JointRecord& record = storage_.joints[joint_i];
        if constexpr (has_targets<S>)
            if (record.kind == JointKind::target) storage_.joint_targets[joint_i].set({});
        if (!has_length(record.kind)) return;
        record.frame_B.anchor = anchor_on(storage_.bodies(), record.body_B, def.P_B);
        const scalar length = length_of(def), apart = distance_of(record);
        storage_.joint_ties[joint_i] = {length, record.kind == JointKind::rope ? max(length, apart) : apart, apart, 0};
    }
    Status find_side(BodyId id, Index& slot) const {
        if (id == BodyId{}) return Status::ok;
        const Result<int> found = find(id);
        if (!found.ok()) return found.status;
        slot = static_cast<Index>(found.value);
        return ingot::is_frozen(storage_.bodies(), slot) ? Status::frozen : Status::ok;
    }
};

} }  // namespace ingot

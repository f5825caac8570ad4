// SPDX-License-Identifier: MIT
// The part of World that joins bodies.
#pragma once

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
    /// Errors: no_room (max_joints are there), those of ids and of check_joint, not_in_scene (a kind that the scene does not name), bad_joint (a body
    ///         with itself), immovable (neither can move), frozen.
    /// Cost:   O(max_joints) after removals.
    Result<JointId> add_joint(const JointDef& def) {
        static_assert(joints_only());
        Index slot_A = no_body, slot_B = no_body;
        Status status = find_side(def.body_A, slot_A);
        if (status == Status::ok) status = find_side(def.body_B, slot_B);
        if (status == Status::ok) status = check_joint(def);
        if (status == Status::ok && !S::joints::has(def.joint.kind)) status = Status::not_in_scene;
        if (status == Status::ok && slot_A == slot_B) status = Status::bad_joint;
        if (status == Status::ok && !moves(slot_A) && !moves(slot_B)) status = Status::immovable;
        if (status != Status::ok) return {status, {}};
        const int joint_i = free_joint();
        if (joint_i == S::max_joints) return {Status::no_room, {}};

        storage_.joints[joint_i] = record_of(def, storage_.bodies(), slot_A, slot_B);
        storage_.joint_lists().link(joint_i);
        ++storage_.joint_generation[joint_i];
        if (joint_i == storage_.joint_slots_used) ++storage_.joint_slots_used;
        wake_sides(joint_i);
        return {Status::ok, id_of_joint(joint_i)};
    }

    /// Its bodies go their own ways. Errors: those of ids.
    Status remove(JointId id) {
        static_assert(joints_only());
        const Result<int> joint = find(id);
        if (!joint.ok()) return joint.status;
        wake_sides(joint.value);
        features::Figures::take_out(storage_, joint.value);
        return Status::ok;
    }
    bool is_alive(JointId id) const { return find(id).ok(); }
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

    /// How far apart the two sides of a joint are, m: along what it locks.
    Result<scalar> joint_gap(JointId id) const {
        static_assert(joints_only());
        const Result<int> joint = find(id);
        if (!joint.ok()) return {joint.status, 0};
        return {Status::ok, gap_of(storage_.joints[joint.value], storage_.bodies())};
    }

protected:
    Result<int> find(JointId id) const {
        static_assert(joints_only());
        if (id.world_tag != storage_.world_tag && id.generation != 0) return {Status::foreign_id, 0};
        if (id.slot >= storage_.joint_slots_used || (id.generation & 1u) == 0 || storage_.joint_generation[id.slot] != id.generation)
            return {Status::stale_id, 0};
        return {Status::ok, id.slot};
    }

private:
    JointId id_of_joint(int joint_i) const { return {static_cast<Index>(joint_i), storage_.world_tag, storage_.joint_generation[joint_i]}; }
    int free_joint() const {
        int joint_i = 0;
        // bound: max_joints; a slot whose counter is used up is not given out again
        while (joint_i < storage_.joint_slots_used && (storage_.joint_lives(joint_i) || storage_.joint_generation[joint_i] == 0xfffffffeu)) ++joint_i;
        return joint_i;
    }
    bool moves(Index slot) const { return slot != no_body && is_dynamic(storage_.bodies(), slot); }
    Status find_side(BodyId id, Index& slot) const {
        if (id == BodyId{}) return Status::ok;
        const Result<int> found = find(id);
        if (!found.ok()) return found.status;
        slot = static_cast<Index>(found.value);
        return ingot::is_frozen(storage_.bodies(), slot) ? Status::frozen : Status::ok;
    }
    void wake_sides(int joint_i) {
        const JointRecord& joint = storage_.joints[joint_i];
        if (moves(joint.body_A)) (void)touched(joint.body_A, Status::ok);
        if (moves(joint.body_B)) (void)touched(joint.body_B, Status::ok);
    }
};

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// The part of World that tells what joints bear, and that breaks them.
#pragma once

#include "../joint/reactions.h"
#include "world_drives.h"

namespace ingot { inline namespace INGOT_ABI {

/// What a `for` goes over: JointBreak by JointBreak, in the order of slots. Until the next step; a joint that is removed, or enabled again, takes its
/// own along.
template <class S>
class BreakRange {
public:
    explicit BreakRange(const Storage<S>& storage) : storage_(storage) {}

    class Iterator {
    public:
        Iterator(const Storage<S>& storage, int joint_i) : storage_(storage), joint_i_(joint_i) { go_on(); }
        JointBreak operator*() const {
            return {{static_cast<Index>(joint_i_), storage_.world_tag, storage_.joint_generation[joint_i_]}, storage_.joint_reactions[joint_i_]};
        }
        Iterator& operator++() {
            ++joint_i_;
            go_on();
            return *this;
        }
        bool operator!=(const Iterator& other) const { return joint_i_ != other.joint_i_; }

    private:
        void go_on() {
            // bound: max_joints
            while (joint_i_ < storage_.joint_slots_used && storage_.joint_breaking[joint_i_].phase != JointPhase::breaks) ++joint_i_;
        }
        const Storage<S>& storage_;
        int joint_i_;
    };
    Iterator begin() const { return {storage_, 0}; }  ///< for a range for
    Iterator end() const { return {storage_, storage_.joint_slots_used}; }  ///< for a range for

private:
    const Storage<S>& storage_;
};

/// Calls of World, see world.h.
template <class S>
class WorldReactions : public WorldDrives<S> {
protected:
    using Base = WorldDrives<S>;
    using Base::storage_;
    using Base::find;

    static constexpr bool reactions_only() {
        static_assert(has_joints<S>, "this scene names no joints: set joints and max_joints");
        static_assert(!has_joints<S> || S::joints::has_reactions,
                      "what joints of this scene bear is not kept: name WithReactions, or WithBreaking, among its joints");
        return true;
    }
    static constexpr bool breaking_only() {
        static_assert(has_joints<S>, "this scene names no joints: set joints and max_joints");
        static_assert(!has_joints<S> || S::joints::may_break, "this scene's joints do not break: name WithBreaking among its joints");
        return true;
    }

public:
    // What joints bear, in scenes that name WithReactions or WithBreaking among their joints: see joint/reactions.h.

    /// Of the last step. A joint of bodies that sleep tells what it bore in their last step, as contacts do; one that does nothing, or that no step
    /// has seen, 0. So does a rope that is slack, and a servo, which locks nothing: see joint_torque. Of a gear it is what it gives along the way of
    /// its joint B, on its B. Of figures that move by EnergyMomentum it is what the step itself gave, without what a snap loses. Errors: those of
    /// ids.
    Result<JointReaction> joint_reaction(JointId id) const {
        static_assert(reactions_only());
        const Result<int> joint = find(id);
        if (!joint.ok()) return {joint.status, {}};
        return {Status::ok, storage_.joint_reactions[joint.value]};
    }

    // Joints that break, in scenes that name WithBreaking. One that is broken does nothing, and its bodies meet each other as filters say; it keeps
    // its slot and its id until it is removed, so it can be enabled again.

    /// What it bears from now on. Wakes its bodies. Errors: those of ids and of check_strength.
    Status set_joint_strength(JointId id, const JointStrength& strength) {
        static_assert(breaking_only());
        const Result<int> joint = find(id);
        if (!joint.ok()) return joint.status;
        const Status status = check_strength(strength);
        if (status != Status::ok) return status;
        storage_.joint_breaking[joint.value].strength = {strength.force + 0, strength.torque + 0};
        this->wake_sides(joint.value);
        return Status::ok;
    }
    /// What set_joint_strength has set. Errors: those of ids.
    Result<JointStrength> joint_strength(JointId id) const {
        static_assert(breaking_only());
        const Result<int> joint = find(id);
        if (!joint.ok()) return {joint.status, {}};
        return {Status::ok, storage_.joint_breaking[joint.value].strength};
    }

    /// False: the joint does nothing from now on. True: it works again, broken or not, with the angles it had. Where its sides are apart by then, it
    /// draws them together in a step; whole turns that a hinge made meanwhile are not counted. Wakes its bodies where it changes something.
    /// Errors: those of ids; where it begins to work frozen, immovable (neither body can move), bad_joint (its sides are off each other by more than
    ///         limits::mended_gap: put the bodies where they fit, or join them anew as they are), no_room (it would close a loop: see add_joint).
    Status set_joint_enabled(JointId id, bool enabled) {
        static_assert(breaking_only());
        const Result<int> joint = find(id);
        if (!joint.ok()) return joint.status;
        const bool works = storage_.joint_breaking[joint.value].phase == JointPhase::works;
        if (works == enabled) return Status::ok;
        if (!enabled) {
            this->wake_sides(joint.value);
            features::BreakableJoints::disable(storage_, joint.value, JointPhase::disabled);
            return Status::ok;
        }
        const Status status = check_sides(this->record_of_slot(joint.value), joint.value);
        if (status != Status::ok) return status;
        const JointPhase phase = storage_.joint_breaking[joint.value].phase;
        features::BreakableJoints::enable(storage_, joint.value);
        if (!this->has_room_for_loop(joint.value)) {
            features::BreakableJoints::disable(storage_, joint.value, phase);
            return Status::no_room;
        }
        storage_.joint_reactions[joint.value] = {};
        if constexpr (has_gears<S>)
            if (this->kind_of(joint.value) == JointKind::gear) couple(storage_.bodies(), storage_.joints, storage_.joint_gears[joint.value]);
        this->wake_sides(joint.value);
        return Status::ok;
    }
    /// Errors: those of ids.
    Result<bool> is_joint_enabled(JointId id) const {
        static_assert(breaking_only());
        const Result<int> joint = find(id);
        if (!joint.ok()) return {joint.status, false};
        return {Status::ok, storage_.joint_breaking[joint.value].phase == JointPhase::works};
    }
    /// True until it is enabled again. Errors: those of ids.
    Result<bool> is_joint_broken(JointId id) const {
        static_assert(breaking_only());
        const Result<int> joint = find(id);
        if (!joint.ok()) return {joint.status, false};
        return {Status::ok, storage_.joint_breaking[joint.value].phase >= JointPhase::broken};
    }

    /// The joints that broke in the last step: for (const ingot::JointBreak& broken : world.broken_joints()). They cannot be lost.
    /// Cost: a look at all joints.
    BreakRange<S> broken_joints() const {
        static_assert(breaking_only());
        return BreakRange<S>(storage_);
    }

private:
    Status check_sides(const JointRecord& joint, int joint_i) const {
        if (this->freezes(joint.body_A) || this->freezes(joint.body_B)) return Status::frozen;
        if (!this->moves(joint.body_A) && !this->moves(joint.body_B)) return Status::immovable;
        return misfit_of_joint(joint, joint_i) <= limits::mended_gap ? Status::ok : Status::bad_joint;
    }
    /// Of ties: what is too long, or a rod that is too short; axes that are not parallel. Others fit whatever their bodies do.
    scalar misfit_of_joint(const JointRecord& joint, [[maybe_unused]] int joint_i) const {
        if constexpr (has_ties<S>) {
            if (has_length(joint.kind)) {
                const scalar over = this->distance_of(joint) - storage_.joint_ties[joint_i].length;
                return joint.kind == JointKind::rope && over < 0 ? 0 : abs(over);
            }
            if (is_tie(joint.kind) && joint.kind != JointKind::parallel) return 0;
        }
        return misfit_of(joint, this->sides_of(joint));
    }
};

} }  // namespace ingot

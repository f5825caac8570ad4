// SPDX-License-Identifier: MIT
// Joints that tell what they bear, and that may break.
#pragma once

#include "../../figure/note_reactions.h"
#include "joints.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

/// Its numbers stand with those of joints.
struct ReadReactions : Feature {
    static constexpr uint32_t part = JointPart::reactions;
    template <class S>
    static constexpr bool named = has_joint_reactions<S>;

    template <class S, bool present>
    struct Memory {
        JointReaction joint_reactions[static_cast<unsigned>(S::max_joints)] = {};

        ReactionView reactions() { return {joint_reactions}; }
    };
    template <class S>
    struct Memory<S, false> {
        static NoReactions reactions() { return {}; }
    };

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        if constexpr (S::joints::has_reactions) each(S::joints::has_reactions);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(!S::joints::has_reactions || has_joints<S>,
                      "a scene without joints has none to read or to break: set max_joints, or drop WithReactions and WithBreaking");
        return true;
    }
};

/// Its numbers stand with those of joints.
struct BreakableJoints : Feature {
    template <class S>
    static constexpr bool named = has_joint_breaking<S>;

    template <class S, bool present>
    struct Memory {
        BreakRecord joint_breaking[static_cast<unsigned>(S::max_joints)] = {};
    };
    template <class S>
    struct Memory<S, false> {};

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        if constexpr (S::joints::may_break) each(S::joints::may_break);
    }

    /// The joint does nothing from now on. What it was is kept, but for what the last step left.
    template <class S>
    static void disable(Storage<S>& storage, int joint_i, JointPhase phase) {
        JointRecord& joint = storage.joints[joint_i];
        BreakRecord& record = storage.joint_breaking[joint_i];
        if (joint.kind != JointKind::none) {
            storage.joint_lists().unlink(joint_i);
            record.kind = joint.kind;
            joint.kind = JointKind::none;
            Figures::forget_impulses(storage, joint_i);
        }
        record.phase = phase;
    }
    /// It is linked in again.
    template <class S>
    static void enable(Storage<S>& storage, int joint_i) {
        BreakRecord& record = storage.joint_breaking[joint_i];
        storage.joints[joint_i].kind = record.kind;
        record.kind = JointKind::none;
        record.phase = JointPhase::works;
        storage.joint_lists().link(joint_i);
    }
    /// What broke in the step before has been told.
    template <class S>
    static void begin_step(Storage<S>& storage) {
        for (int joint_i = 0; joint_i < storage.joint_slots_used; ++joint_i) {  // bound: max_joints
            BreakRecord& record = storage.joint_breaking[joint_i];
            if (record.phase == JointPhase::works) continue;
            if (record.phase == JointPhase::breaks) record.phase = JointPhase::broken;
            Figures::forget_reaction(storage, joint_i);
        }
    }
    /// What has borne more than it can breaks, and its bodies begin their time of rest anew.
    template <class S>
    static void break_joints(Storage<S>& storage) {
        for (int joint_i = 0; joint_i < storage.joint_slots_used; ++joint_i) {  // bound: max_joints
            const JointRecord& joint = storage.joints[joint_i];
            if (joint.kind == JointKind::none || !breaks_under(storage.joint_reactions[joint_i], storage.joint_breaking[joint_i].strength)) continue;
            disable(storage, joint_i, JointPhase::breaks);
            if constexpr (S::sleeps) {
                if (joint.body_A != no_body) storage.rest_view().rest_time[joint.body_A] = 0;
                if (joint.body_B != no_body) storage.rest_view().rest_time[joint.body_B] = 0;
            }
        }
    }
};

} } }  // namespace ingot::features

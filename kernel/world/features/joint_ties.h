// SPDX-License-Identifier: MIT
// Rods, ropes, targets and gears.
#pragma once

#include "../../figure/gear_rows.h"
#include "../../figure/slack_ropes.h"
#include "../../joint/check_tie.h"
#include "joint_loops.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

/// Their numbers stand with those of joints.
struct TiedJoints : Feature {
    static constexpr uint32_t part = JointPart::ties;
    template <class S>
    static constexpr bool named = has_ties<S>;

    template <class S, bool present>
    struct Memory {
        TieRecord joint_ties[static_cast<unsigned>(S::max_joints)] = {};
        Index machines[Figures::figure_capacity<S>] = {};

        void show_ties(LoopView& view) {
            view.ties = joint_ties;
            view.machine_of = machines;
        }
    };
    template <class S>
    struct Memory<S, false> {
        template <class Loops>
        static void show_ties(Loops&) {}
    };

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        if constexpr (has_ties<S>)
            // bound: the kinds of joints
            for (int kind = static_cast<int>(JointKind::rod); is_tie(static_cast<JointKind>(kind)); ++kind)
                each(S::joints::has(static_cast<JointKind>(kind)));
        if constexpr (has_servos<S>) {
            each(S::joints::has(JointKind::servo));
            each(S::joints::has(JointKind::ball_servo));
        }
    }
    template <class S>
    static constexpr bool check() {
        static_assert(!has_servos<S> || has_loops<S>, "servos are rows beside the trees: set max_loops to how many there may be");
        static_assert(!has_servos<S> || S::joints::has_drives, "servos are driven: name WithDrives among the joints");
        static_assert(!has_ties<S> || has_servos<S> || has_loops<S>,
                      "rods, ropes, targets, parallel joints and gears are rows beside the trees: set max_loops to how many there may be");
        static_assert(!has_ties<S> || !S::figure_motion::is_implicit,
                      "the energy-momentum step has no rods, ropes and targets: leave figure_motion out, or these kinds");
        return true;
    }
};

/// Joints that are coupled. Their numbers stand with those of joints.
struct GearedJoints : Feature {
    template <class S>
    static constexpr bool named = has_gears<S>;

    template <class S, bool present>
    struct Memory {
        GearRecord joint_gears[static_cast<unsigned>(S::max_joints)] = {};
        GearMotion gear_motions[static_cast<unsigned>(S::max_joints)] = {};

        void show_gears(LoopView& view) {
            view.gears = joint_gears;
            view.gear_motions = gear_motions;
        }
    };
    template <class S>
    struct Memory<S, false> {
        template <class Loops>
        static void show_gears(Loops&) {}
    };

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        if constexpr (has_gears<S>) each(S::joints::has(JointKind::gear));
    }
    template <class S>
    static constexpr bool check() {
        static_assert(!has_gears<S> || S::joints::has(JointKind::hinge) || S::joints::has(JointKind::slider) || S::joints::has(JointKind::wheel),
                      "gears couple hinges, sliders and wheels: name one of them among the joints, or drop GearJoint");
        return true;
    }
};

/// Bodies that are drawn to a target. Their numbers stand with those of joints.
struct DrawnBodies : Feature {
    template <class S>
    static constexpr bool named = has_targets<S>;

    template <class S, bool present>
    struct Memory {
        TargetRecord joint_targets[static_cast<unsigned>(S::max_joints)] = {};
        TargetMotion target_motions[static_cast<unsigned>(S::max_joints)] = {};

        void show_targets(LoopView& view) {
            view.targets = joint_targets;
            view.target_motions = target_motions;
        }
    };
    template <class S>
    struct Memory<S, false> {
        template <class Loops>
        static void show_targets(Loops&) {}
    };

    /// What is drawn to a target that moves does not rest.
    template <class S>
    static void keep_awake(Storage<S>& storage) {
        for (int joint_i = 0; joint_i < storage.joint_slots_used; ++joint_i) {  // bound: max_joints
            const JointRecord& joint = storage.joints[joint_i];
            const TargetRecord& target = storage.joint_targets[joint_i];
            if (joint.kind != JointKind::target || length_sq(target.velocity) + length_sq(target.spin) == 0) continue;
            storage.rest_view().rest_time[joint.body_B] = 0;
        }
    }
};

} } }  // namespace ingot::features

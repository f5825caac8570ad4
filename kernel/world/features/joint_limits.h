// SPDX-License-Identifier: MIT
// Joints whose free directions may end.
#pragma once

#include "../../figure/joint_row.h"
#include "joints.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

/// Joints that have rows of their own, of limits or drives: where they are in their free directions. Its numbers stand with those of joints.
struct MovingJoints : Feature {
    template <class S>
    static constexpr bool named = has_joint_rows<S>;

    template <class S, bool present>
    struct Memory : ResponsePart<S, !stacks<S>> {
        static constexpr unsigned moving_capacity = static_cast<unsigned>(S::max_joints);
        static constexpr unsigned rows_of_joint = static_cast<unsigned>(S::joints::limits_of_joint() + S::joints::drives_of_joint());

        AngleRecord joint_angles[moving_capacity] = {};
        JointMotion joint_motions[moving_capacity] = {};
        JointRow joint_rows[moving_capacity * rows_of_joint] = {};
    };
    template <class S>
    struct Memory<S, false> {};
};

/// Its numbers stand with those of joints.
struct LimitedJoints : Feature {
    static constexpr uint32_t part = JointPart::limits;
    template <class S>
    static constexpr bool named = has_joint_limits<S>;

    template <class S, bool present>
    struct Memory {
        LimitRecord joint_limits[static_cast<unsigned>(S::max_joints)] = {};

        void show_limits(JointRowView& view) { view.limits = joint_limits; }
    };
    template <class S>
    struct Memory<S, false> {
        static void show_limits(JointRowView&) {}
    };

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::joints::has_limits);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(!S::joints::has_limits || S::joints::limits_of_joint() > 0, "no kind of this scene's joints may have limits: drop WithLimits");
        return true;
    }
};

} } }  // namespace ingot::features

// SPDX-License-Identifier: MIT
// Joints whose free directions may end.
#pragma once

#include "../../figure/joint_row.h"
#include "joints.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

/// Its numbers stand with those of joints.
struct LimitedJoints : Feature {
    static constexpr uint32_t part = JointPart::limits;
    template <class S>
    static constexpr bool named = has_joint_limits<S>;

    template <class S, bool present>
    struct Memory : ResponsePart<S, !stacks<S>> {
        static constexpr unsigned limited_capacity = static_cast<unsigned>(S::max_joints);
        static constexpr unsigned joint_row_capacity = limited_capacity * static_cast<unsigned>(S::joints::limits_of_joint());

        LimitRecord joint_limits[limited_capacity] = {};
        AngleRecord joint_angles[limited_capacity] = {};
        JointMotion joint_motions[limited_capacity] = {};
        JointRow joint_rows[joint_row_capacity] = {};
    };
    template <class S>
    struct Memory<S, false> {};

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

// SPDX-License-Identifier: MIT
// What a world keeps of the limits of a joint.
#pragma once

#include "joints.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of the free directions that may end. All of B against A.
struct LimitRecord {
    JointLimits limits{{{0, 0}, {0, 0}}, 0};  ///< zeros of what holds no joint: a world is all zero as it begins
    scalar j[2]{};      ///< N m s, N s, that a limit gave at which the joint was at rest in the last substep, scaled to one of Effort::substeps
    scalar leave[2]{};  ///< rad/s, m/s, with which the joint leaves a limit that it has met in the last substep; 0: with none
};

/// Of a hinge that may have limits or drives: its angle where it was last, in -pi .. pi, and the whole turns beside it.
struct AngleRecord {
    scalar angle{};  ///< rad
    int32_t turns{};
};

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// How much a scene pays for contacts with friction: base/effort.h.
#pragma once

#include "../../base/effort.h"
#include "feature.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

struct ContactEffort : Feature {
    template <class S>
    static constexpr bool named = S::effort.substeps != Effort{}.substeps || S::effort.sweeps != Effort{}.sweeps;
    template <class S, bool present>
    struct Memory {};

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::effort.substeps);
        each(S::effort.sweeps);
    }
    template <class S>
    static constexpr bool check() {
        constexpr int substeps = S::effort.substeps, sweeps = S::effort.sweeps;
        static_assert(!named<S> || stacks<S> || has_joints<S>,
                      "effort is for contacts with friction and joints: set max_manifolds or max_joints, or leave effort out");
        static_assert(substeps == 2 || substeps == 4 || substeps == 8 || substeps == Effort::substeps_max,
                      "a step has 2, 4, 8 or 16 substeps: set effort");
        static_assert(sweeps >= 1 && sweeps <= Effort::sweeps_max, "a substep has 1 to 16 sweeps: set effort");
        return true;
    }
};

} } }  // namespace ingot::features

// SPDX-License-Identifier: MIT
// How much work the solver of contacts may do in a step: base/work_budget.h.
#pragma once

#include "../../base/limits.h"
#include "feature.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

struct WorkBudget : Feature {
    template <class S>
    static constexpr bool named = S::work_budget != 0;
    template <class S, bool present>
    struct Memory {};

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::work_budget);
    }
    template <class S>
    static constexpr bool check() {
        // Each contact is visited once a substep; an island that turns out to accelerate begins again, see conduct_substeps.
        constexpr int of_manifold = limits::steady_substeps + S::effort.substeps, of_contact = 4;
        static_assert(S::work_budget == 0 || has_shapes<S>, "work_budget is of contacts: set max_manifolds or max_contacts, or work_budget = 0");
        static_assert(S::work_budget == 0 || (S::work_budget >= of_manifold * S::max_manifolds && S::work_budget < no_budget),
                      "work_budget is effort.substeps and 2 visits or more for each of max_manifolds: raise it, or lower max_manifolds");
        static_assert(S::work_budget == 0 || S::work_budget >= of_contact * S::max_contacts,
                      "work_budget is 4 visits or more for each of max_contacts: raise it, or lower max_contacts");
        return true;
    }
};

} } }  // namespace ingot::features

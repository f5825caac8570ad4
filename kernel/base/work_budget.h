// SPDX-License-Identifier: MIT
// How much work the solver of contacts may do in a step: see Scene::work_budget.
#pragma once

#include "config.h"

namespace ingot { inline namespace INGOT_ABI {

inline constexpr int no_budget = 1 << 30;

/// Sweeps that each island may have in a step so that all together make `visits` to their contacts, at most. 0: as many as they like.
///
/// Each contact has the same share, so an island that needs less than its own does what it does alone.
constexpr int sweeps_within(int visits, int contacts) { return visits == 0 ? no_budget : contacts > 0 ? visits / contacts : visits; }

/// Of the sweeps that an island has left, those for the substep at hand; `kept` for later, beside one for each substep that is left.
constexpr int share_of_substep(int left, int kept, int substeps_left) {
    const int share = (left - kept) / substeps_left;
    return share > 1 ? share : 1;
}

/// Visits that are left of a step, where there is no budget.
struct AnyVisits {
    constexpr explicit AnyVisits(int = 0) {}
    static constexpr void add(int) {}
    static constexpr bool some() { return true; }
    static constexpr bool take(int) { return true; }
    static constexpr bool take_spare(int, int) { return true; }
};

/// Visits that are left of a step, where contacts are solved one by one.
struct VisitsLeft {
    int count;

    constexpr explicit VisitsLeft(int visits) : count(visits) {}
    constexpr void add(int visits) { count += visits; }
    constexpr bool some() const { return count > 0; }
    /// False where so many are not left: then none are.
    constexpr bool take(int visits) {
        if (count == no_budget) return true;
        const bool enough = count >= visits;
        count = enough ? count - visits : 0;
        return enough;
    }
    /// Takes them where as many as `kept` are left besides.
    constexpr bool take_spare(int visits, int kept) { return count == no_budget || (count - kept >= visits && take(visits)); }
};

} }  // namespace ingot

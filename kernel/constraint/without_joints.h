// SPDX-License-Identifier: MIT
// Bodies with joints, of a solver's view that knows of some, or of none: see jointed_view.h.
#pragma once

#include "../base/config.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where no body has joints.
struct NoJointedBodies {
    static constexpr bool articulates = false;
};

template <class View>
INGOT_INLINE decltype(auto) jointed_of(View& solver) {
    if constexpr (View::articulates)
        return (solver.jointed);
    else
        return NoJointedBodies{};
}

} }  // namespace ingot

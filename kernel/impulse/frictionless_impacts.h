// SPDX-License-Identifier: MIT
#pragma once

#include "../base/config.h"

namespace ingot { inline namespace INGOT_ABI {

/// `using solver = ingot::FrictionlessImpacts;` of a scene: the article's collision. Points of contact are found anew in every step, up to
/// max_contacts; each gets the impulse that keeps it from closing, with restitution and without friction, and what presses on it is carried. Impacts
/// happen when shapes meet, within the step, so the way of a ball that bounces is right to rounding at every rate; the turn that an impact gives a
/// box begins with the step. For scenes that fly and bounce, on the smallest targets; nothing stacks.
/// Source: Hecker 1997, Fig. 4; solve_impacts.h says how several at one time are solved, impacts_in_step.h how they follow each other.
struct FrictionlessImpacts {
    static constexpr const char* name = "frictionless_impacts";
    static constexpr bool is_frictionless = true, is_direct = false, is_pointwise = false;

    /// Nothing: what a compiler meets on its way to the sentence that refuses a scene with max_manifolds.
    template <int, int, bool = false, bool = true>
    struct Memory {};
};

} }  // namespace ingot

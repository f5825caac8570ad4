// SPDX-License-Identifier: MIT
// Scenes that sleep, and their twins that do not.
#pragma once

#include <gtest/gtest.h>

#include "contact/play.h"

namespace ingot_sleep {

using namespace ingot_contact;
using namespace scenes;

template <int bodies, bool asleep = true, class BroadPhase = ingot::AllPairs, int manifolds = 8 * bodies, int pairs = 2 * manifolds>
struct Bedroom : Room<bodies, BroadPhase, true, manifolds, pairs> {
    static constexpr bool sleeps = asleep;
};

/// Steps in sleep_time, and one for what rounding adds to the sum of h.
inline int steps_to_sleep(scalar h) { return static_cast<int>(static_cast<double>(ingot::limits::sleep_time) / static_cast<double>(h)) + 2; }

}  // namespace ingot_sleep

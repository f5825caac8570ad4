// SPDX-License-Identifier: MIT
// Parties in one world, and the comparison of what happens to one of them there with what happens to it alone.
#pragma once

#include <cstdint>

#include "engine.h"

namespace company {

/// A party at a place.
struct Guest {
    Party party;
    Vector place;
};

/// How members of several parties come into their slots. The order within a party stays, and so does the place of the ground before all or
/// after all of them.
enum class Slots { one_by_one, party_by_party, last_party_first, shuffled };

struct Gathering {
    std::vector<Guest> guests;
    Slots slots = Slots::shuffled;
    uint64_t seed = 0;
    bool ground_first = true;
    int fillers = 0;  ///< bodies without a shape, strewn among the slots
};

/// h of a step: constant, or changing from step to step.
struct Rate {
    scalar h;
    bool varies = false;

    scalar of_step(int step_i) const { return varies ? h * (scalar(0.5) + scalar(0.25) * scalar(step_i % 5)) : h; }
};

/// Runs the gathering, and each of the watched guests alone at the same place, and compares r_CM, v_CM, A and L of each body, whether it sleeps,
/// and the events among the bodies of the guest, all bit by bit, after each step.
///
/// Returns: what differed first, in words; empty if nothing did.
std::string difference_in_company(const Engine& engine, const Gathering& gathering, const std::vector<int>& watched, Rate rate, int steps);

}  // namespace company

// SPDX-License-Identifier: MIT
// Bodies that belong together, as plain data: they know no solver, no capacity and no slot.
#pragma once

#include <string>
#include <vector>

#include "scenes/contact/placed_body.h"

namespace company {

using ingot::scalar;
using ingot::Vector;

/// A body of a party. What the world it comes into does not name (restitution, belts, rolling resistance, filters) it comes without.
struct Member {
    scenes::PlacedBody body;                ///< place about the origin of the party; the ground is at height 0
    std::vector<ingot::ShapeDef> parts = {};  ///< of a body of several shapes; else body.def.shape is its only one
    scalar rolling_lever = 0;               ///< m
    Vector surface_velocity = {};           ///< m/s
    int born = 0;                           ///< before which step it is added
};

/// What somebody does to a body before a step. One who is not in the world yet, or no more, is left alone.
struct Edit {
    enum Kind { impulse, angular_impulse, force, put, remove, wake, sleep, filter };
    int step;    ///< force: from this one on, in each of `count` steps
    Kind kind;
    int member;
    Vector v = {};  ///< N s; N m s; N; put: m about the origin of the party, at rest
    int count = 1;
};

/// It keeps within `reach` of its origin sideways; parties stand 30 m apart.
struct Party {
    std::string name;
    std::vector<Member> members;
    std::vector<Edit> edits = {};
    bool is_fast = false;  ///< for worlds that follow fast bodies: in others it would get out
    static constexpr scalar reach = 14;  ///< m
};

/// All that can be tested: see parties.cpp.
std::vector<Party> all_parties();
/// Those that make a world busy and touch nobody: balls that fall into a pit, by n^3, and cubes in a wall.
Party crowd_of_balls(int n);
Party wall_of_cubes(int base);
/// Those to whom things happen in the midst of a run: bodies come, go, are pushed, put elsewhere and driven out of range.
std::vector<Party> restless_parties();
/// Those that sleep, are woken by a call, by what comes, or by nothing.
std::vector<Party> sleepy_parties();

/// The party of this name.
Party party(const char* name);

}  // namespace company

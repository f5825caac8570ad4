// SPDX-License-Identifier: MIT
// A world behind one interface, so that parties, interleaving and comparison are compiled once and not for every solver.
#pragma once

#include <memory>

#include "party.h"

namespace company {

/// A world of one of the scene types of engines_*.cpp.
class AnyWorld {
public:
    virtual ~AnyWorld() = default;
    /// Adds a member at a place, without what the scene does not name.
    virtual ingot::Result<ingot::BodyId> add(const Member& member, const Vector& place) = 0;
    /// Does what the scene has a call for; the rest is nothing to it.
    virtual void edit(ingot::BodyId id, const Edit& edit, const Vector& place) = 0;
    virtual ingot::Status set_gravity(const Vector& gravity) = 0;
    virtual ingot::StepReport step(scalar h) = 0;
    virtual ingot::Result<ingot::BodyState> state(ingot::BodyId id) const = 0;
    virtual bool is_asleep(ingot::BodyId id) const = 0;
    virtual ingot::EventView events() const = 0;
};

struct Engine {
    const char* name;
    std::unique_ptr<AnyWorld> (*make)();
    bool (*takes)(const Party& party);  ///< it has the shapes of all members, and keeps fast ones in
    bool sleeps;
    bool has_friction;  ///< without it bodies slide away: a run ends when one leaves its place
};

/// All of them: engines_*.cpp.
const std::vector<Engine>& engines();
std::vector<Engine> engines_of_sweeps();
std::vector<Engine> engines_of_islands();
std::vector<Engine> engines_of_points();

}  // namespace company

// SPDX-License-Identifier: MIT
// What the adaptors of stages.h, kinematic_stages.h and schemes.h are handed.
#pragma once

#include "world.h"

namespace ingot { inline namespace INGOT_ABI {

struct NoSolver {};
template <class S>
constexpr auto solver_of_scene() {
    if constexpr (stacks<S>)
        return decltype(any_of<Storage<S>>().contact_solver()){};
    else
        return NoSolver{};
}

/// Contacts with friction in parts, each with a solver of its own: see shared_stages.h.
template <class Solver, int capacity>
struct PartsOfStep {
    SolverPart parts[static_cast<unsigned>(capacity)];
    Solver solvers[static_cast<unsigned>(capacity)];
    int count;  ///< 0: the step is solved as a whole
};
struct NoParts {};

/// One step on its way through the stages: what it works on, and what it has to say.
template <class S>
struct Step {
    Storage<S>& storage;
    scalar h;            ///< s
    const BodyView& bodies;
    StepReport& report;
    decltype(solver_of_scene<S>()) solver{};  ///< of contacts with friction: filled by advance, read by follow_fast_bodies
    If<solves_in_parts<S>, PartsOfStep<decltype(solver), tasks_max<typename S::workers>>, NoParts> parts{};
    FlightImpactList flights{};               ///< of fast bodies: for events
    If<S::work_budget == 0, AnyVisits, VisitsLeft> visits_left{S::work_budget - S::work_budget / 4};  ///< to contacts without friction
};

} }  // namespace ingot

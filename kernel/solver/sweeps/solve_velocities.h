// SPDX-License-Identifier: MIT
// The velocities of a substep, for whoever conducts it: solve_manifolds.h, and solve_directly.h for what it leaves.
#pragma once

#include "../../constraint/material_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// How a step is cut and its substeps are swept. Where contacts are few, chains of them are long for their number, and sweeps are cheap: many are
/// allowed, to a small residual, and all go up, which serves heavy bodies on light ones. Where they are many the number is fixed, larger while many
/// are young, and sweeps go up and down in turn, which carries the weight of a pile to the ground and back.
struct SweepPlan {
    int substeps;
    int sweeps_max;
    int sweeps_max_of_balls;  ///< where most normals are central
    bool up_and_down;
    scalar settled_speed;  ///< m/s
};

/// Calm: nothing that touches accelerated in the step before, and nothing has begun to touch since. A tall tower is not: what it sways by needs the
/// substeps, and no sweep over few sees it.
SweepPlan plan_sweeps(const SolverView& solver);

/// For a step that turns out not to be calm.
SweepPlan with_all_substeps(const SweepPlan& steady);

/// Sweeps until nothing changes by more than the plan's speed, or the rounding of the bodies' own. Returns how many.
template <class View>
int solve_velocities(const View& solver, const SweepPlan& plan, scalar& residual);

} }  // namespace ingot

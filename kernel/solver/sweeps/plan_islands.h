// SPDX-License-Identifier: MIT
// Islands of bodies that touch, how each is cut into substeps and swept, and which are solved together.
#pragma once

#include "../../base/report.h"
#include "../../constraint/jointed_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Finds the islands of the bodies that were taken in, and their plans. An island takes no notice of any other: what it does is the same
/// alone or beside anything.
///
/// A small island has few contacts, in chains that are long for their number, and sweeps are cheap: it may have many, down to a small residual. All
/// go up, which serves heavy bodies on light ones. In a large island the number of sweeps is fixed, larger while many contacts are new. They go up
/// and down in turn, which carries the weight of a pile to the ground and back. An island is steady when nothing in it accelerated in the step
/// before, and nothing has begun to touch since. A tall tower never counts as steady: it sways unless it has all substeps, and sweeps cannot tell.
/// A small island in which something turns far in a substep, see limits::turn_of_substep, has more of them, unless the scene has a work_budget.
/// Needs: find_levels.
template <class Joints>
void plan_islands(SolverView& solver, Joints& jointed, const BodyView& bodies, scalar h);

/// An island has the substeps of the figure that asks for most of them: it raises JointedBodies::doublings_of, and then its figures.
void spread_doublings(const SolverView& solver, const JointedBodies& jointed);

/// Begins the batch of all islands with a plan: bodies, order, and what its substeps need. False if there are none.
template <class Joints>
bool begin_batch(SolverView& solver, Joints& jointed, SweepPlan plan, const BodyView& bodies, const Vector& gravity);

/// After the last substep of a batch. Islands that turned out not to be steady begin again with the plan that follows.
/// The report tells the most sweeps that an island took, the largest residual, and how many islands were not settled. fall_speed: see fall_speed_of.
/// Islands with joints begin again where their figures ask for more substeps.
template <class Joints>
void end_batch(const SolverView& solver, const Joints& jointed, scalar fall_speed, StepReport& report);

/// Of a substep: how many sweeps an island may have, and to what speed.
void plan_sweeps(const SolverView& solver);

/// Sweeps beside those that the substeps to come need, the one at hand among them: what an island of a scene with a work_budget may spend otherwise.
int spare_sweeps(const SolverView& solver, const Island& island);

/// Turns the sweeps of an island on once more in its substep, as many as its budget has; false: none.
bool sweep_again(const SolverView& solver, Island& island);

/// m/s; how far rounding may put off the speeds of an island's bodies, as they are after the last kick.
scalar rounding_of_speeds(const Island& island, scalar unit);

inline bool is_steady(SweepPlan plan) { return plan == SweepPlan::small_steady || plan == SweepPlan::large_steady; }
/// How often the substeps of such a plan are halved.
inline int doublings_of(SweepPlan plan) { return static_cast<int>(plan) - static_cast<int>(SweepPlan::jointed); }
inline bool is_large(SweepPlan plan) { return plan == SweepPlan::large_steady || plan == SweepPlan::large || is_of_joints(plan); }

} }  // namespace ingot

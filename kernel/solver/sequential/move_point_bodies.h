// SPDX-License-Identifier: MIT
// Bodies on their way into the sequential solver, through its substeps, and out of it.
#pragma once

#include "../../constraint/without_joints.h"
#include "point_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Takes in the bodies that touch and can move, at the begin of a step. A body that forces drive beyond limits::speed_runaway or spin_runaway is
/// marked bad. For the others it then cannot move: its motion must not reach those that touch it.
void take_in_bodies(PointView& solver, const BodyView& bodies, const Vector& gravity, scalar h);

/// Finds the islands: bodies that touch, directly or through others that can move; and sorts the manifolds by them.
/// Cost: three looks at all manifolds and bodies.
void join_bodies(PointView& solver);

/// Lists the bodies and manifolds of the next island, in the order of their lowest bodies: the calls that follow are for these alone.
/// Returns: false after the last. Cost: a look at its manifolds.
bool next_island(PointView& solver);

/// The kick of a substep of h seconds by forces. Returns the speed of the fastest body, m/s, up to limits::rounding_speed_max.
scalar kick_bodies(const PointView& solver, scalar h);

/// The kick by forces and by the impulses of the substep before, where all of them are given again as they were: the velocity changes by as much as
/// it did then.
scalar kick_again(const PointView& solver);

/// What a substep was like.
struct SubstepOfPoints {
    bool some_hit;  ///< the velocity of a body changed by more than forces explain
    bool steady;      ///< no body accelerated: see limits::steady_acceleration
};
/// Displaces the bodies by a substep: by the mean of its velocities, or, where a body was hit, by the last.
SubstepOfPoints drift_bodies(const PointView& solver, scalar h);

/// Writes velocities and angular momenta to the bodies. F_T and tau_T get the forces with which integrate_r and integrate_A displace the bodies as
/// the solver has. The turn by which overlaps were taken back is part of the moment of displacement, and so of the mean angular momentum.
void write_contact_motion(const PointView& solver, const NoJointedBodies&, const BodyView& bodies, const Vector& gravity, scalar h);

/// There is nothing left to turn: see write_contact_motion.
inline void turn_by_corrections(const PointView&, const NoJointedBodies&, const BodyView&, scalar) {}

} }  // namespace ingot

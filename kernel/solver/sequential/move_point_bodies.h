// SPDX-License-Identifier: MIT
// Bodies on their way into the sequential solver, through its substeps, and out of it.
#pragma once

#include "point_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Takes in what touches and can move, at the begin of a step. A body that forces leave beyond limits::speed_runaway or spin_runaway is marked
/// bad and is to the others as if it could not move: what it does must not reach those that touch it.
void take_in_bodies(PointView& solver, const BodyView& bodies, const Vector& gravity, scalar h);

/// Finds the islands: bodies that touch, directly or through others that can move.
void join_bodies(const PointView& solver);

/// Takes the next island after the body of a slot in hand: all that follows is asked for its bodies and manifolds alone.
/// Returns: the slot of its lowest body; slot_count after the last. Cost: a look at all manifolds and bodies.
int next_island(PointView& solver, int slot);

/// The kick of a substep of h seconds by forces. Returns the speed of the fastest body, m/s, up to limits::rounding_speed_max.
scalar kick_bodies(const PointView& solver, scalar h);

/// The kick by forces and by the impulses of the substep before, where all of them are given again as they were: the velocity changes once more
/// by what it changed then.
scalar kick_again(const PointView& solver);

/// What a substep was like.
struct SubstepOfPoints {
    bool some_hit;  ///< the velocity of a body changed by more than forces explain
    bool steady;      ///< no body accelerated: see limits::steady_acceleration
};
/// Displaces the bodies by a substep: by the mean of its velocities, or, where a body was hit, by the last.
SubstepOfPoints drift_bodies(const PointView& solver, scalar h);

/// Leaves velocities and angular momenta in the bodies, and in F_T and tau_T the forces with which integrate_r and integrate_A displace them as the
/// solver has. What overlaps turned a body by is in the moment of its displacement, and so in the mean angular momentum it turns with.
void write_contact_motion(const PointView& solver, const BodyView& bodies, const Vector& gravity, scalar h);

/// There is nothing left to turn: see write_contact_motion.
inline void turn_by_corrections(const PointView&, const BodyView&, scalar) {}

} }  // namespace ingot

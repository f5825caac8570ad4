// SPDX-License-Identifier: MIT
// Bodies on their way through the solver: in, through the substeps, and out again.
#pragma once

#include "../../base/workers.h"
#include "../../constraint/jointed_view.h"
#include "../../constraint/locked_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Fills the solver's bodies with those that touch and can move. A body that forces drive out of the range within the step of h seconds is marked bad
/// and left out: for the others it is immovable already, as it will be from the next step on.
void take_in_bodies(SolverView& solver, const BodyView& bodies, const Vector& gravity, scalar h);

/// The same for bodies of figures, whether they touch anything or not. Names the figure of each.
void take_in_figures(SolverView& solver, NoJointedBodies& jointed, const BodyView& bodies, const Vector& gravity, scalar h);
void take_in_figures(SolverView& solver, JointedBodies& jointed, const BodyView& bodies, const Vector& gravity, scalar h);
/// A machine has one leader.
inline void lead_machines(const SolverView&, JointedBodies&, const NoLoops&) {}
void lead_machines(const SolverView& solver, JointedBodies& jointed, const LoopView& loops);

/// The bodies of the batch as they were at the begin of the step.
void take_in_again(const SolverView& solver, const BodyView& bodies, const Vector& gravity);

/// Once bodies are as they were at the begin of the step: forces along locked axes do nothing, and inv_I_world in the tiles is of what may turn.
inline void hold_bodies(const SolverView&, const BodyView&) {}
void hold_bodies(const LockedView& solver, const BodyView& bodies);

/// Forces of a substep of h seconds: v_CM += a h, L += tau h.
void kick_bodies(const SolverView& solver, scalar h);

/// Displacements of a substep: dp += h v, dth += h omega; by the trapezoid where the velocity changed smoothly, so that a steady acceleration is
/// exact. A change beyond 2 h |a| is an impact, which is flagged for the next warm start. The inertia of a body that turns goes along, in the tiles.
/// View: SolverView, or one with locks.
template <class View>
void drift_bodies(View& solver, const BodyView& bodies, scalar h);
/// The same for some of the batch, beside others; then, once for all of it, which islands have one that accelerates.
template <class View>
void drift_some_bodies(View& solver, const BodyView& bodies, scalar h);
void tell_unsteady_bodies(const SolverView& solver);

/// Gives the bodies that touch the motion that was found: v_CM and L of the end of the step, and in F_T and tau_T the constant force and torque that
/// lead to the same displacement. So integrate_r and the rotation displace them as they do in free flight.
/// Comes after integrate_v and integrate_L.
/// Not of bodies of figures: see keep_figures.
template <class Joints>
void write_contact_motion(const SolverView& solver, const Joints& jointed, const BodyView& bodies, const Vector& gravity, scalar h);

/// The same for a part of a step, beside others; and what there is to note in tiles that parts share, one part after the other: bodies that were left
/// out are among it.
void write_motion_of_part(const SolverView& solver, const BodyView& bodies, const Vector& gravity, scalar h);
void mark_motion_of_part(const SolverView& solver, const BodyView& bodies);

/// The small turns by which overlaps were taken back; and of bodies that turn, those by which they have the energy that their contacts left them.
/// Comes after the rotation.
template <class Joints>
void turn_by_corrections(const SolverView& solver, const Joints& jointed, const BodyView& bodies, scalar h);

void turn_by_corrections(const LockedView& solver, const NoJointedBodies& jointed, const BodyView& bodies, scalar h);
/// The same for some of the solver bodies, beside others.
void turn_some_by_corrections(const SolverView& solver, const TaskRange& of, const BodyView& bodies, scalar h);
void turn_some_by_corrections(const LockedView& solver, const TaskRange& of, const BodyView& bodies, scalar h);

} }  // namespace ingot

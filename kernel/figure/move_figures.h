// SPDX-License-Identifier: MIT
// A substep of figures that touch nothing, stage by stage; contacts work between pass_impulses and end_solve.
#pragma once

#include "loop_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// What the joints lack: how far each would be off its place at the end of the substep, if nothing acted, over h with the sign turned. Bodies go
/// by h v and turn as they do in free flight, to second order; so for the joint the step is SHAKE, which keeps energy. Where spins change much in
/// a substep, or tension is stiff, that is no help, and turns are taken to first order, which loses some: Figure::resolved says which.
/// Needs: place_joints, velocities after the forces. h: s, of the substep.
void begin_solve(const FigureView& view, const NoLoops& loops, scalar h);
void begin_solve(const FigureView& view, const LoopView& loops, scalar h);
/// The same of figures that touch nothing: what energy a machine has it has by itself, unless it may be driven, and its targets get less of it.
void begin_flight_solve(const FigureView& view, const NoLoops& loops, scalar h, bool driven);
void begin_flight_solve(const FigureView& view, const NoLoopsOfHinges& loops, scalar h, bool driven);
void begin_flight_solve(const FigureView& view, const LoopView& loops, scalar h, bool driven);

/// The same once more in a substep, of what gives way otherwise now: what the joints lack is as it was. No impulse is on any body, and no drive.
void clear_solve(const FigureView& view);

/// No impulse is on any body, and the cursors are nowhere.
void begin_passing(const FigureView& view);
/// An impulse F through the centre of mass and a moment T on one body.
void add_impulse(const FigureView& view, Index node, const Vector& F, const Vector& T);
/// From the impulses on each body to the change of every twist.
template <class Kinds = AnyKinds>
void pass_impulses(const FigureView& view);

/// Velocities are those of the solve. h: s, of the substep.
template <class Kinds = AnyKinds>
void end_solve(const FigureView& view, scalar h);

/// Bodies go on by a substep of h seconds. acceleration: m/s^2, of what floats and moves smoothly, as a whole: such a figure goes by the mean of its
/// velocities before and after the substep.
template <class Kinds = AnyKinds>
void drift_figures(const FigureView& view, scalar h);

/// Puts bodies where their joints want them, by displacements that no velocity sees. again: only those that are off by more than limits::joint_gap.
/// Bound: limits::pushes_max.
void push_figures(const FigureView& view, const NoLoops& loops, bool again);
void push_figures(const FigureView& view, const NoLoopsOfHinges& loops, bool again);
void push_figures(const FigureView& view, const LoopView& loops, bool again);

/// Contacts displace figures in between, see cursor.h: from nothing to a displacement of every body.
void begin_displacing(const FigureView& view);
void end_displacing(const FigureView& view, scalar h);

} }  // namespace ingot

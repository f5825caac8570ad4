// SPDX-License-Identifier: MIT
// Loops and ties through a substep: what their rows lack, and the impulses that make up for it.
#pragma once

#include "loop_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// How far the sides of each joint would be apart at the end of a substep of h seconds, if nothing acted: with the sign turned, over h. Needs:
/// place_loops; bodies as begin_solve leaves them.
void aim_loops(const FigureView& view, const LoopView& loops, const LoopFigure& of, scalar h);
/// The same of where they are now, for a push. Returns the square of the largest, rad or units of length.
scalar aim_pushes(const FigureView& view, const LoopView& loops, const LoopFigure& of);

/// Speeds that fit each joint where it is, whatever gap it has: what is reeled in goes on. After aim_loops.
void fit_loops(const FigureView& view, const LoopView& loops, const LoopFigure& of, scalar h);
/// They are left as they move.
void leave_out_targets(const LoopView& loops, const LoopFigure& of);
/// m/s, with which a machine is driven at most, by what moves as it is told and by what is reeled in. After aim_loops.
scalar driven_speed(const FigureView& view, const LoopView& loops, const LoopFigure& of);

/// The change of the twist of a body, at its q, by the solve.
Spatial<scalar> change_of_body(const FigureView& view, Index node);

/// After a way up and down without the loops: z of what the rows still lack. passed: their impulses so far were among those that went up and down.
void find_lacks(const FigureView& view, const LoopView& loops, const LoopFigure& of, bool passed);
/// The twists of all bodies of a figure as its loops change them. What z stands for is theirs now.
void close_loops(const FigureView& view, const LoopView& loops, const LoopFigure& of);

/// z becomes part of the impulses, where a figure does not stand.
void keep_lacks(const FigureView& view, const LoopView& loops);
/// Gives bodies the impulses of their loops. Between begin_passing and pass_impulses.
void add_loop_impulses(const FigureView& view, const LoopView& loops);
/// Those of their limits and drives alone.
void add_free_impulses(const FigureView& view, const LoopView& loops);

/// Of a contact's body: what the loops add to its twist at q, and what they feel of an impulse F through its centre of mass and a moment T.
Spatial<scalar> twist_of_loops(const FigureView& view, const LoopView& loops, Index node);
void feel_impulse(const FigureView& view, const LoopView& loops, Index node, const Vector& F, const Vector& T);
/// What they take from its response; and from what A answers to an impulse on B of the same figure.
Spatial6<scalar> response_of_loops(const FigureView& view, const LoopView& loops, Index node);
Spatial<scalar> response_across_loops(const FigureView& view, const LoopView& loops, Index node_A, Index node_B, const Spatial<scalar>& on_B);

/// Before contacts displace figures, and after: z is nothing, and all bodies have what it stands for.
void forget_lacks(const FigureView& view, const LoopView& loops);
void close_all_loops(const FigureView& view, const LoopView& loops);

/// After the last of all ways up and down: z of all figures becomes part of their impulses. Bodies have the velocities of closed loops.
void end_loops(const FigureView& view, const LoopView& loops);
/// After the last way: ropes that push are let go, and those that would be too long are taut from now on; what draws to a target with more than its
/// most gives that from now on, or is a row again. Their rows are factored again. False where there are none. From limits::rope_rounds on ropes are
/// let go, and targets held, alone: so a substep is solved again so often, and once for each of them, at most.
bool settle_rows(const FigureView& view, const LoopView& loops, int round);
/// No machine is settled, and none stands: a solve begins.
void open_machines(const FigureView& view, const LoopView& loops);

/// Of figures that touch nothing: two ways up and down. The second takes back what rounding, and limits::loop_compliance, have left of the first, and
/// tells joints of the tree what they give. Machines that are settled come to the same again. Bodies have what their trees alone give them: loops
/// close by close_all_loops.
void pass_looped(const FigureView& view, const LoopView& loops);
/// All of it.
void solve_loops(const FigureView& view, const LoopView& loops);

/// Joints keep their impulses, as those of the trees do in keep_figures.
void keep_loops(const FigureView& view, const LoopView& loops, int doublings);

} }  // namespace ingot

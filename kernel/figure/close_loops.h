// SPDX-License-Identifier: MIT
// Loops through a substep: what their rows lack, and the impulses that make up for it.
#pragma once

#include "loop_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// How far the sides of each joint would be apart at the end of a substep of h seconds, if nothing acted: with the sign turned, over h. Needs:
/// place_loops; bodies as begin_solve leaves them.
void aim_loops(const FigureView& view, const LoopView& loops, const LoopFigure& of, scalar h);
/// The same of where they are now, for a push. Returns the square of the largest, m or rad.
scalar aim_pushes(const FigureView& view, const LoopView& loops, const LoopFigure& of);

/// After a way up and down without the loops: z of what the rows still lack.
void find_lacks(const FigureView& view, const LoopView& loops, const LoopFigure& of);
/// The twists of all bodies of a figure as its loops change them. What z stands for is theirs now.
void close_loops(const FigureView& view, const LoopView& loops, const LoopFigure& of);

/// Both, of the figures of a group that have loops. After its own way up and down.
template <unsigned width>
INGOT_INLINE void close_rows(const FigureRows<width>&, const NoLoops&) {}
template <unsigned width>
INGOT_INLINE void close_rows(const FigureRows<width>& rows, const LoopView& loops) {
    for_looped(rows, loops, [&](const LoopFigure& of, int) {
        find_lacks(rows.view, loops, of);
        close_loops(rows.view, loops, of);
    });
}

/// z becomes part of the impulses.
void keep_lacks(const FigureView& view, const LoopView& loops);
/// Gives bodies the impulses of their loops. Between begin_passing and pass_impulses.
void add_loop_impulses(const FigureView& view, const LoopView& loops);

/// Of a contact's body: what the loops add to its twist at q, and what they feel of an impulse F through its centre of mass and a moment T.
Spatial<scalar> twist_of_loops(const FigureView& view, const LoopView& loops, Index node);
void feel_impulse(const FigureView& view, const LoopView& loops, Index node, const Vector& F, const Vector& T);
/// What they take from its response; and from what A answers to an impulse on B of the same figure.
Spatial6<scalar> response_of_loops(const FigureView& view, const LoopView& loops, Index node);
Spatial<scalar> response_across_loops(const FigureView& view, const LoopView& loops, Index node_A, Index node_B, const Spatial<scalar>& on_B);

/// Before contacts displace figures, and after: z is nothing, and all bodies have what it stands for.
void forget_lacks(const FigureView& view, const LoopView& loops);
void close_all_loops(const FigureView& view, const LoopView& loops);

/// After the last way up and down with all impulses: bodies have the velocities of the closed loops.
void end_loops(const FigureView& view, const LoopView& loops);
/// All of it, for figures that touch nothing. Two ways up and down: the second takes back what rounding, and limits::loop_compliance, have left of
/// the first, and tells joints of the tree what they give.
void solve_loops(const FigureView& view, const LoopView& loops);

/// Joints keep their impulses, as those of the trees do in keep_figures.
void keep_loops(const FigureView& view, const LoopView& loops, int doublings);

} }  // namespace ingot

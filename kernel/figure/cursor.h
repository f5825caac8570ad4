// SPDX-License-Identifier: MIT
// A cursor goes through each figure, from the body of one contact to the body of the next, along joints: so a contact sees all that the contacts of
// its figure before it have done, exactly, at the cost of the joints between them.
//
// Where the cursor is, a body knows of all impulses. On the way up each body hands its parent what it has got since; on the way down each gets the
// change of its twist. Bodies elsewhere are not up to date until the cursor comes.
#pragma once

#include "loop_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// From the impulses on each body to the changes of the roots, where the cursors are then: they take the rest along. And to the changes of bodies
/// that rows of loops ask for. again: bodies that nothing reaches hand on what they did before in this solve.
void pass_to_roots(const FigureView& view, const NoLoops& loops, bool again);
void pass_to_roots(const FigureView& view, const LoopView& loops, bool again);

/// Brings a body up to date.
void bring_cursor(const FigureView& view, const Spatial6Rows<1>* responses, Index node);

/// The changes of velocity of the centre of mass and of spin of the body where the cursor is.
Spatial<scalar> change_at_cursor(const FigureView& view, Index node);

/// An impulse F through the centre of mass and a moment T on the body where the cursor is.
void give_at_cursor(const FigureView& view, const Spatial6Rows<1>* responses, Index node, const Vector& F, const Vector& T);

/// All bodies are up to date, and the cursor is nowhere.
void take_cursors_away(const FigureView& view, const Spatial6Rows<1>* responses);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// Bodies that are drawn to a target: six rows that give way.
//
// With the poles of a substep, p their product and s their sum, a body by itself has the velocity u = p u_0 - (1 + p - s) e / h at its end; e: how
// far it is off. That is the row
//
//     J u + G j = -(1 + p - s) / (1 - p) e / h,      G = p / (1 - p) times what the body alone gives way by
//
// which stands among the others with G beside the rows' own compliance C: so what hangs on the body is seen, and the row is solved exactly with
// all of it. A force or a torque that is more than it may be is taken out of the rows and given as it is, along itself; and is a row again once it
// asks for less (settle_target).
#pragma once

#include "loop_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// A batch begins: nothing has been given, and nothing is at its most but what may give nothing.
void begin_targets(const LoopView& loops, const LoopFigure& of, scalar h);

/// What the rows ask for in a substep of h seconds. After hold_back_targets: what draws may give energy.
void aim_targets(const FigureView& view, const LoopView& loops, const LoopFigure& of, scalar h);

/// G j of a row, m/s, rad/s.
scalar give_of_target(const FigureView& view, const LoopView& loops, const LoopJoint& loop, int row);
/// G between two rows.
scalar give_between(const FigureView& view, const LoopView& loops, const LoopJoint& loop, int row, int other);

/// Whether a force or a torque was beyond its most, or is not any more; it changes then. more: what is to come to the impulses of the joint's rows.
bool settle_target(const FigureView& view, const LoopView& loops, LoopJoint& loop, const scalar* more, bool may_release);

/// What was given in the substep. After its last solve.
void note_targets(const FigureView& view, const LoopView& loops);
/// Means of the step, and targets that go on. doublings: of the batch.
void keep_target(const FigureView& view, const LoopView& loops, const LoopJoint& loop);

} }  // namespace ingot

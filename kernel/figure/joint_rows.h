// SPDX-License-Identifier: MIT
// Limits of joints in a substep: a row each, where a joint comes near to one.
//
// A row changes the rate of its direction so that the joint ends the substep within its range, where it would end without the solve being taken to
// second order; and a joint that is at its end already leaves it or stays. Rows give impulses of one sign a side. They are visited with a figure's
// cursor, so each sees exactly what its figure has got from the others, and they are solved as contacts are, by sweeps. What is left of an angle
// beyond its end is taken back by a push, which no velocity sees.
//
// Restitution: a joint that meets its limit ends the substep there, and leaves it in the next with what its speed would have been at the limit.
#pragma once

#include "joint_row.h"

namespace ingot { inline namespace INGOT_ABI {

// Rows: JointRowView; DrivenRowView, where drives have rows too: see joint_drives.h; or LoopedRowView, where joints close loops. A row of a joint
// that closes a loop is met as a contact of its two bodies is. All rows feel the loops of their machine, and these feel them, at once: see
// loop_view.h.

/// Which joints are near their limits, and how fast they are before forces act. Needs: place_joints, measure_joints.
template <class Rows>
void list_joint_rows(const FigureView& view, Rows& all, scalar h);

/// What the rows that do not stand ask for, and how the figures answer them. Those that rest get the impulses of the substep before. Needs:
/// begin_solve, responses.
template <class Rows>
void aim_joint_rows(const FigureView& view, const Rows& all, scalar h);

/// What joints remember of the solve: loads where they rest, and speeds with which they leave what they have met. Needs: changes of all bodies.
template <class Rows>
void note_joint_rows(const FigureView& view, const Rows& all, scalar h);

/// One visit. Returns by how much the rate was changed, rad/s or m/s. The figure's cursor is at the parent then, or at the root; at the child of a
/// joint that closes a loop. is_last: before anything of its machine is visited again all impulses pass through it anew, so nobody asks what bodies
/// have got of this one, and none is told.
template <class Rows>
scalar visit_joint_row(const FigureView& view, const Rows& all, JointRow& row, bool is_last = false);

/// Sweeps over the rows of each figure until none changes a rate by more than `settled`, or as often as limits::limit_sweeps_max. Of figures that
/// touch nothing. Needs: changes of all bodies; afterwards they are those of the cursor.
template <class Rows>
void settle_joint_rows(const FigureView& view, const Rows& all, scalar settled);

/// Gives the impulses of all rows as they stand to the drives of their joints. Needs: drives that are those of nothing else.
template <class Rows>
void give_joint_rows(const FigureView& view, const Rows& all);

/// Joints that are beyond their limits are pushed back; those that the step began with so, by no more than limits::limit_return h. Measures first:
/// gone: s, since that was done last.
void push_joint_rows(const FigureView& view, JointRowView& all, scalar h, scalar gone);
void push_joint_rows(const FigureView& view, LoopedRowView& all, scalar h, scalar gone);

} }  // namespace ingot

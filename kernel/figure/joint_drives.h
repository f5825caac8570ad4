// SPDX-License-Identifier: MIT
// Drives of joints in a substep.
//
// Torque at the end of the substep, with stiffness k, damping d, error e and rate v now, and dq the change of the rate by the solve:
//
//     j = h (feedforward - k (e + h (v + dq - target_rate)) - d (v + dq - target_rate)) = pull - R dq,      R = h d + h^2 k
//
// R stands beside the inertia D where the free direction is eliminated (factor_figures), and pull is the drive: so it is solved exactly, with
// all of the figure, whatever its stiffness. A drive that turns out to be beyond its largest torque is a row from then on in this substep, of
// compliance 1/R and with bounds, and the substep is solved again.
//
// What is tuned has k and d by which the poles of a substep are exp(h lambda) of the exact motion's; with a = h^2 k / J, b = h d / J they have the
// product 1 / (1 + a + b) and the sum 1 + (1 - a) of it.
#pragma once

#include "joint_row.h"

namespace ingot { inline namespace INGOT_ABI {

// Rows: DrivenRowView; or LoopedRowView, where joints close loops. Drives of such a joint stand in no factor: they are rows always, as limits are.

/// The batch begins: what drives move. Needs: factor_figures without drives, responses.
template <class Rows>
void begin_drives(const FigureView& view, const Rows& all);

/// What drives resist in a substep of h seconds. Before factor_figures with them.
template <class Rows>
void prepare_drives(const FigureView& view, const Rows& all, scalar h);

/// What a drive gives if its rate does not change; of a saturated one the row. Needs: begin_solve, measure_joints.
template <class Rows>
void aim_drive(const FigureView& view, const Rows& all, JointRow& row, scalar h);

/// Marks the drives that are beyond their largest torque: JointRow::gave_way of those that were not yet. True where there are some: their figures are
/// solved again. Needs: pass_impulses.
template <class Rows>
bool saturate_drives(const FigureView& view, const Rows& all);

/// What a drive gives in the solve as it stands, N m s, and the rate of its joint then, and without the solve, rad/s, along its row. Needs: changes
/// of all bodies.
struct DriveInSolve {
    scalar j, rate, rate_alone;
};
template <class Rows>
DriveInSolve drive_in_solve(const FigureView& view, const Rows& all, const JointRow& row);

/// What drives have given in the substep. Needs: pass_impulses.
template <class Rows>
void note_drives(const FigureView& view, const Rows& all);

/// Mean torques of the step, and targets that go on: of figures that do not begin it again. Before keep_figures. doublings: of the batch.
template <class Rows>
void keep_drives(const FigureView& view, const Rows& all, int doublings);

/// Where wheels are nearer to the root than what they carry: twists of that are taken on its suspension, where the wheel is. After place_joints.
/// False: there are none.
bool place_carriages(const FigureView& view);

/// Ball joints that have a drive, and wheels that are nearer to the root than what they carry, of the figures of the step. After build_figures.
template <class Rows>
void name_driven_kinds(const FigureView& view, const Rows& all);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "joint_row.h"
#include "loop_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where the joints are now: levers and axes in the world.
template <class Kinds = AnyKinds>
void place_joints(const FigureView& view);

/// The inertia of each body with all that hangs on it, from the leaves to the root, and what of it each joint leaves free: what the passes of
/// tree_passes.h work with. Needs: place_joints, of loops place_loops. h: s, of the substep.
///
/// A joint under tension T at an arm s turns its body back with the stiffness T s. Taken as known, that breaks at sqrt(T s / I) h > 2, whatever the
/// solver. So where h j.s of the last substep is beyond limits::stiff_tension of the least moment of inertia, half of it is added to the inertia
/// across the arm, and the figure counts as stiff: see solve_figures.
/// Source: the implicit treatment of Andrews, Teichmann and Kry, "Geometric stiffness for real-time constrained multibody dynamics", CGF 36 (2017).
template <class Loops>
void factor_figures(const FigureView& view, const Loops& loops, scalar h);

/// The same of joints that may have drives, which resist a change of their rates. Needs: prepare_drives.
void factor_figures(const FigureView& view, const DrivenRowView& all, scalar h);
void factor_figures(const FigureView& view, const LoopedRowView& all, scalar h);

} }  // namespace ingot

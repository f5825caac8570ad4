// SPDX-License-Identifier: MIT
// Where joints are in their free directions, through the substeps of a step.
#pragma once

#include "joint_row.h"

namespace ingot { inline namespace INGOT_ABI {

/// The batch begins: joints are where the bodies are, and remember their last step. Needs: group_figures.
template <class Rows>
void begin_joint_motions(const FigureView& view, const Rows& rows);

/// Joints are where the bodies have got to, in h seconds at the speeds that they have. Angles of hinges go on over whole turns.
template <class Rows>
void measure_joints(const FigureView& view, const Rows& rows, scalar h);

/// What joints remember of the step: of figures that do not begin it again. Before keep_figures. doublings: of the batch.
template <class Rows>
void keep_joint_motions(const FigureView& view, const Rows& rows, int doublings);

} }  // namespace ingot

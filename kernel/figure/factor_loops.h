// SPDX-License-Identifier: MIT
#pragma once

#include "loop_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where the joints that close loops are now: their rows. Needs: place_joints.
void place_loops(const FigureView& view, const LoopView& loops);
/// The same of the directions in which they may be limited and driven.
void place_free_rows(const FigureView& view, const LoopView& loops);

/// What bodies answer to the rows, and C = L L^T of them: see loop_view.h. Needs: place_loops, factor_figures.
/// Cost: a way up and down the figure for each row, n^2 / 2 of its n rows for each body, n^3 / 6 once.
void factor_loops(const FigureView& view, const LoopView& loops);
/// In the middle of a solve: of the machines that are not settled, which lack nothing yet. The others keep what they lack.
void factor_open_loops(const FigureView& view, const LoopView& loops);
void factor_loops_of(const FigureView& view, const LoopView& loops, LoopFigure& of);

} }  // namespace ingot

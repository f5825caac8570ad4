// SPDX-License-Identifier: MIT
// Newton's method for the end of a step of figures of one form, side by side: a guess, then pass by pass a look at the end and a move of it.
#pragma once

#include "newton_row.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// Figures at the begin of a step. Needs: place_joints.
template <unsigned width, class T = typename AllLanes<width>::T>
struct NewtonStep {
    FigureRows<width> figures;
    NewtonRow<1>* rows;   ///< as FigureView::rows
    scalar h;             ///< s; a part of a step of order 4 goes back in time, h < 0
    Ground<T> ground;     ///< at the begin
    Vec3<T> ground_way;   ///< m, that it goes in the step
    Mat3<T> ground_turn;  ///< R - 1 of its turn in the step
};

/// Whether passes know joints of a kind.
bool has_rows_for(JointKind kind);

/// A guess of the end: of free flight. Joints push as in the last step. Needs: NewtonRow::f.
template <unsigned width>
void begin_passes(const NewtonStep<width>& step);

/// Where bodies and joints would be at the end of the step, and by how much joints and balances are off. misfit: the square of the worst of each
/// figure, as a share of the size of bodies and of what is in the balances; scalar_max where something is no number.
template <unsigned width>
void look_at_end(const NewtonStep<width>& step, scalar (&misfit)[width]);

/// Moves the end to where nothing would be off if everything were linear. active: a bit for each lane whose figure moves. Needs: look_at_end.
template <unsigned width>
void move_end(const NewtonStep<width>& step, unsigned active);

} }  // namespace ingot

#pragma GCC diagnostic pop

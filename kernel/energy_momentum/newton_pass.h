// SPDX-License-Identifier: MIT
// One step of figures of one form, side by side, pass by pass.
#pragma once

#include "newton_row.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// Figures at the begin of a step of h seconds, which may be negative. Needs: place_joints.
template <unsigned width, class T = typename AllLanes<width>::T>
struct NewtonStep {
    FigureRows<width> figures;
    NewtonRow<1>* rows;  ///< as FigureView::rows
    scalar h;            ///< s
    Ground<T> ground;    ///< now
    Vec3<T> ground_way;  ///< m, that it goes in the step
    Mat3<T> ground_turn;  ///< R - 1 of its turn
};

/// Whether it has rows for joints of a kind.
bool has_rows_for(JointKind kind);

/// A guess of the end: as if joints pushed as in the last step. Needs: f.
template <unsigned width>
void begin_passes(const NewtonStep<width>& step);

/// Where things would be at the end of the step, and by how much joints and balances are off: gives the square of the worst of each figure, as a
/// share of the size of bodies and of what is in the balances.
template <unsigned width>
void look_at_end(const NewtonStep<width>& step, scalar (&misfit)[width]);

/// Moves the end to where all would fit if everything were linear, of figures that are `active`, a bit a lane. Needs: look_at_end.
template <unsigned width>
void move_end(const NewtonStep<width>& step, unsigned active);

} }  // namespace ingot

#pragma GCC diagnostic pop

// SPDX-License-Identifier: MIT
// What an energy-momentum step works on.
#pragma once

#include "../figure/ground.h"
#include "energy_momentum.h"
#include "tangent.h"

namespace ingot { inline namespace INGOT_ABI {

/// What the step of `width` bodies and their joints to their parents looks for, and what it knows of them beside FigureRow, which has them at the
/// begin of the step. q: where a body's own joint is on it; of a floating root its centre of mass. The rows of a wide group lie where as many narrow
/// ones would.
template <unsigned width>
struct NewtonRow {
    // Looked for.
    scalar dr[3][width], theta[3][width];  ///< m, of the centre of mass; 1, Cayley vector of its turn R
    SpatialRows<width> f;                  ///< N m s, N s: what its joint gives to it, taken at the mean of q
    // As the step begins.
    scalar I_0[6][width];                   ///< kg m^2, world
    scalar kick[3][width], spin[3][width];  ///< N s, 2 M v + h F; N m s, L + h tau
    scalar e_0[3][width];                   ///< m, from the parent's centre to its side of the joint; of a slider to q
    // At the end, by this pass.
    scalar turn[9][width];                                ///< R - 1
    scalar s_1[3][width], e_1[3][width];                  ///< m, from its centre to q; from its parent's centre, as e_0
    scalar axis_1[3][width], axis_of_parent_1[3][width];  ///< of its joint, as either side has it
    SpatialRows<width> back;                              ///< rad, m: twist that takes its joint to where it was at the begin; then the body's change
    SpatialRows<width> lack;            ///< N m s, N s: what its balance is off by, at its centre; then at q, with what hangs on it
    scalar load[width], moment[width];  ///< N s, N m s: the sum of the sizes of what all its joints give to it
    scalar N[4][9][width];              ///< A B C D of its Tangent: d lack / d change at the end, with what hangs on it
    // Once its free directions are out. Of a ball they are in N and lack instead: B = A^-1 B, D = D - C A^-1 B, lack.w = A^-1 lack.w.
    SpatialRows<width> rate[2];  ///< the change along free direction i is at[i] - rate[i] . (the change by which its parent takes it along)
    scalar at[2][width];         ///< rad; of a slider m
};
static_assert(sizeof(NewtonRow<lanes>) == lanes * sizeof(NewtonRow<1>));

template <unsigned width>
NewtonRow<width>& newton_row(const FigureRows<width>& figures, NewtonRow<1>* rows, int row_i) {
    return reinterpret_cast<NewtonRow<width>*>(rows + figures.group.first_row)[row_i];
}

/// What a body remembers of the last energy-momentum step of its figure.
struct FigureMemory {
    Vector torque{};     ///< N m, world, that its own joint gave it in the mean of the step, beside the force at its anchor
    uint32_t seen{};     ///< of a root: a hash of the motion of its figure as that step left it; of others, and where there was none, 0
    uint8_t halvings{};  ///< of a root: those that its next step is tried with first
};

struct EnergyMomentumView {
    NewtonRow<1>* rows;        ///< as FigureView::rows
    FigureMemory* of_body;     ///< by slot
    uint16_t* left;            ///< by tile, a bit a lane: bodies that are awake and that the scheme does not move
    uint16_t* moved;           ///< the same: those that it moves
    const uint16_t* touching;  ///< the same: those that have a contact; null: nothing does
    int substeps;              ///< of the scene's effort
    Snap snap;
    int order;
};

} }  // namespace ingot

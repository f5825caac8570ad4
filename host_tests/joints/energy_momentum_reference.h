// SPDX-License-Identifier: MIT
// One energy-momentum step of a figure, solved densely to rounding: what a solver of that step has to come to.
//
// Unknown are, per body, the shift dr of its centre and the Cayley vector theta of its turn R, and per locked row an impulse j. Rows act along mean
// arms and axes. As R s - s = theta x (s + R s)/2, their work over the step is j times the change of the row: none where the row holds at both ends.
//
//     (2m/h) dr - 2 m v_0 - h m g - sum j                                            = 0
//     (2/h) I_0 theta + (1/h) theta x I_0 theta - 2 L_0 - (1 - theta~/2) sum s x j   = 0          s: mean arms
//     g(r_0 + dr, R A_0)                                                             = 0          every row, at the end
//     after:  v = 2 dr/h - v_0,   L = R ((2/h) I_0 theta - L_0)
//
// Newton with derivatives by differences, until nothing changes. Locked rows of ball, hinge, slider, universal, fixed, parallel and rod; no limits,
// drives, wheels or gears.
#pragma once

#include "joints/joint_rows.h"

namespace ingot_figures {

struct EnergyMomentumStep {
    FigureState state;
    std::vector<Vector3d> force;  ///< N, of each joint on body B, world axes: the mean over the step
    bool converged = false;
    int passes = 0;
};

/// h, s. Of redundant rows the impulses are those nearest to none.
EnergyMomentumStep energy_momentum_step(const JointRows& rows, const FigureState& state, double h);

/// Five steps of p h, p h, (1 - 4 p) h, p h, p h with p = 1 / (4 - 4^(1/3)): order 4 (Suzuki, Phys. Lett. A 146, 1990).
EnergyMomentumStep energy_momentum_suzuki_step(const JointRows& rows, const FigureState& state, double h);

/// Velocities brought onto the joints where more than `share` of the kinetic energy does not belong there, and what that takes away given back by
/// scaling; a figure that nothing ties to the world keeps the rigid part of its motion. All bodies of the scene are one figure.
FigureState conditionally_projected(const JointRows& rows, const FigureState& state, double share = 1e-4);

}  // namespace ingot_figures

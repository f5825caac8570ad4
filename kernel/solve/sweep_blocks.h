// SPDX-License-Identifier: MIT
// One visit to each manifold, in lanes. Each sweep goes up or down the order of order_manifolds.
#pragma once

#include "solver_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// At the begin of a substep of h seconds, before its forces: where the points are, how fast they may approach, and which of them bounce
/// within it, at what time and to what place (a parabola, in closed form).
void predict_contacts(const SolverView& solver, scalar h);

/// After the forces: what is taken over of the impulses of the substep before, and given to the bodies.
///
/// An impact is not taken over: impulses of a body that was hit are cut to twice what they were, and what gravity explains. Friction follows
/// a slow mean of itself, which quietens its ringing.
void warm_start(const SolverView& solver, scalar h);

/// What a sweep changed.
struct SweepResult {
    scalar size;      ///< J; sum of (change of impulse)^2 times compliance
    scalar residual;  ///< m/s; the largest speed that an impulse took away
};

/// Makes every contact's velocity right for the moment: normals as one block, then twist, then the friction pair on its cone.
SweepResult velocity_sweep(const SolverView& solver, bool up);

/// Remembers impulses and motions before a sweep, for extrapolate.
void begin_sweep(const SolverView& solver);

/// Goes on by beta in the direction of the sweeps so far (nonlinear conjugate gradients).
void extrapolate(const SolverView& solver, scalar beta);

/// Takes back 0.4 of every overlap, by displacements that no velocity ever sees: no energy comes of it.
void position_sweep(const SolverView& solver, scalar h);

} }  // namespace ingot

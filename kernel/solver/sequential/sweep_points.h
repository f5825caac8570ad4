// SPDX-License-Identifier: MIT
// Sweeps over the manifolds, in the order of pairs or against it: point by point within a manifold.
#pragma once

#include "point_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where friction takes hold, how fast points may approach in the first substep, of h seconds. Impulses on record become `share` times as much.
void begin_contacts(const PointView& solver, scalar share, scalar h);
/// Impulses on record become `share` times as much; and whether nothing accelerated.
void end_contacts(const PointView& solver, scalar share, bool steady);

/// Gives the impulses on record again.
void warm_start(const PointView& solver);

/// What a sweep changes.
struct SweepOfPoints {
    scalar fastest;  ///< m/s, the largest speed that a row corrected
    scalar size;     ///< J, sum of (change of impulse)^2 times compliance
};
/// One sweep: normals until they agree within the manifold, twist, friction. A row that is off by no more than `ignored`, m/s, is left alone.
SweepOfPoints sweep_point_velocities(const PointView& solver, bool forward, scalar ignored);

/// Joins sweeps by nonlinear conjugate gradients: goes on by beta along the direction that the sweep adds to.
/// Source: Silcowitz-Hansen, Niebe, Erleben, "A nonlinear nonsmooth conjugate gradient method for interactive contact force problems", 2010.
void go_on_along(const PointView& solver, scalar beta);

/// One sweep that takes a part of the overlaps back, by displacements that no velocity ever sees. Notes how fast points may approach in the next
/// substep, and cuts what it is to give again of bodies that were hit to what gravity explains.
void sweep_point_positions(const PointView& solver, scalar h);

} }  // namespace ingot

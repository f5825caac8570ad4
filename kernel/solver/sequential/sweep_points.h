// SPDX-License-Identifier: MIT
// Sweeps over the manifolds, in the order of pairs or against it: point by point within a manifold.
#pragma once

#include "point_view.h"

namespace ingot { inline namespace INGOT_ABI {

// View: PointView, or a PointMaterialView.

/// Where friction takes hold, how fast points may approach in the first substep, of h seconds. Impulses on record become `share` times as much.
template <class View>
void begin_contacts(const View& solver, scalar share, scalar h);
/// Impulses on record become `share` times as much; and whether nothing accelerated.
template <class View>
void end_contacts(const View& solver, scalar share, bool steady);

/// At the begin of a substep of h seconds, before its forces, in scenes whose bodies bounce: which points restitution throws back within it, how
/// fast, and to what place. True if there are some. Points that do not meet in this substep are left alone.
template <class View>
bool predict_point_bounces(const View& solver, scalar h);

/// Gives the impulses on record again.
template <class View>
void warm_start(const View& solver);

/// After the warm start: finds contacts whose slip turns round within this substep. True if there are some. h: s, of the substep.
template <class View>
bool begin_point_reversals(const View& solver, scalar h);
/// Once their velocities are solved: displaces bodies by displacement_of_reversal.
template <class View>
void end_point_reversals(const View& solver, scalar h);

/// What a sweep changes.
struct SweepOfPoints {
    scalar fastest;  ///< m/s, the largest speed that a row corrected
    scalar size;     ///< J, sum of (change of impulse)^2 times compliance
};
/// One sweep: normals until they agree within the manifold, torsion, rolling resistance, friction. A row that is off by no more than `ignored`, m/s,
/// is left alone.
template <class View>
SweepOfPoints sweep_point_velocities(const View& solver, bool forward, scalar ignored);

/// Joins sweeps by nonlinear conjugate gradients: goes on by beta along the direction that the sweep adds to.
/// Source: Silcowitz-Hansen, Niebe, Erleben, "A nonlinear nonsmooth conjugate gradient method for interactive contact force problems", 2010.
template <class View>
void go_on_along(const View& solver, scalar beta);

/// One sweep that takes a part of the overlaps back, by displacements that no velocity ever sees. Notes how fast points may approach in the next
/// substep. Cuts the impulses on bodies that were hit to what gravity explains, before the next substep gives them again.
template <class View>
void sweep_point_positions(const View& solver, scalar h);

} }  // namespace ingot

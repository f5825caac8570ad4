// SPDX-License-Identifier: MIT
#pragma once

#include "../../base/report.h"
#include "../../constraint/impact_note.h"
#include "point_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Solves all contacts of a step of h seconds: the scheme of solve_manifolds.h, point by point and without its matrices.
///
/// The step is cut into limits::substeps, or where nothing accelerates and no chain is long, steady_substeps. In each, forces act, the impulses of
/// the substep before are given again, and sweeps over the points, joined by nonlinear conjugate gradients, correct them until no speed changes by
/// more than limits::settled_speed_of_points; then bodies are displaced, and one sweep takes back overlaps by displacements that no velocity ever
/// sees. Friction is a cone at the middle of the points; a twist is resisted as the area resists it. Nothing bounces. All of it is scalar, in the
/// order of pairs and against it in turn: the same bits for every lane count, and towers stand from whichever end they were built.
///
/// Reads v_CM, L, F_T and tau_T of the begin of the step, before integrate_v and integrate_L. Writes nothing to bodies but marks: see
/// write_contact_motion. For scenes with events, `notes` are told who pushed whom.
/// Bound:   substeps * sweeps_of_points visits a manifold, of rounds_of_points rounds over its points each; and rounds_of_pushes a substep.
/// Cost:    on a Cortex-M4F, 5000 to 8000 instructions a manifold and step at rest, and 100000 a substep at the bound.
template <bool notes_impulses>
void solve_points(PointView& solver, const BodyView& bodies, const Vector& gravity, scalar h, ImpactNote* notes, StepReport& report);

} }  // namespace ingot

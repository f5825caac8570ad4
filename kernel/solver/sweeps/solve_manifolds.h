// SPDX-License-Identifier: MIT
#pragma once

#include "../../base/report.h"
#include "../../constraint/impact_note.h"
#include "../../constraint/material_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Solves all contacts of a step of h seconds: the many-body scheme.
///
/// The step is cut into limits::substeps. In each, forces act, the impulses of the substep before are given again, and a few sweeps over the
/// contacts correct them, up and down the levels, joined by nonlinear conjugate gradients; then bodies are displaced, and one sweep
/// takes back overlaps by displacements that no velocity ever sees. No softness, no slop, no leak: loads do not sink, and corrections give
/// no energy. Restitution finds the time of impact within the substep. Where many touch and nothing that does accelerates, fewer substeps do.
///
/// Reads v_CM, L, F_T and tau_T of the begin of the step, before integrate_v and integrate_L. Writes nothing to bodies: see
/// write_contact_motion. For scenes with events, `notes` are told who pushed whom; for those in which nothing bounces, no restitution is looked at.
/// Bound:   steady_substeps * sweeps_of_small and then substeps * sweeps_of_small visits a manifold where few touch; else
///          substeps * sweeps_of_new, or steady_substeps * steady_sweeps and then substeps * sweeps. Where impacts cause impacts,
///          impacts_of_contact of them a contact and substep.
template <bool notes_impulses, bool bounces, class View>
void solve_manifolds(View& solver, const BodyView& bodies, const Vector& gravity, scalar h, ImpactNote* notes, StepReport& report);

} }  // namespace ingot

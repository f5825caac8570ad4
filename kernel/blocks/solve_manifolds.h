// SPDX-License-Identifier: MIT
#pragma once

#include "../base/report.h"
#include "solver_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Solves all contacts of a step of h seconds: the many-body scheme.
///
/// The step is cut into limits::substeps. In each, forces act, the impulses of the substep before are given again, and a few sweeps over the
/// contacts correct them, up and down the levels, joined by nonlinear conjugate gradients; then bodies are displaced, and one sweep
/// takes back overlaps by displacements that no velocity ever sees. No softness, no slop, no leak: loads do not sink, and corrections give
/// no energy. Restitution finds the time of impact within the substep.
///
/// Reads v_CM, L, F_T and tau_T of the begin of the step, before integrate_v and integrate_L. Writes nothing to bodies: see
/// write_contact_motion. Bound: substeps * sweeps_of_young visits a manifold.
void solve_manifolds(SolverView& solver, const BodyView& bodies, const Vector& gravity, scalar h, StepReport& report);

/// Gives the motion that was found to the bodies that touch: v_CM and L of the end of the step, and, in F_T and tau_T, the constant force and
/// torque that lead to the same displacement: integrate_r and the rotation then take them for what they are.
/// Comes after integrate_v and integrate_L.
void write_contact_motion(const SolverView& solver, const BodyView& bodies, const Vector& gravity, scalar h);

/// The small turns by which overlaps were taken back. Comes after the rotation.
void turn_by_corrections(const SolverView& solver, const BodyView& bodies, scalar h);

} }  // namespace ingot

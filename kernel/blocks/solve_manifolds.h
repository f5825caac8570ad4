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

// The stages of a substep that are not files of their own, for those who conduct it differently: see direct/.

/// Bodies that touch and can move get a number among the solver's own.
void take_in_bodies(SolverView& solver, const BodyView& bodies, const Vector& gravity);
/// v_CM += h a, L += h tau_T.
void kick_bodies(const SolverView& solver, scalar h);
/// The most sweeps a substep may take: more while many contacts are young, and where contacts are few: chains are long then, and sweeps cheap.
int sweeps_allowed(const SolverView& solver);
/// Sweeps until nothing changes by more than limits::settled_speed. Returns how many.
int solve_velocities(const SolverView& solver, int sweeps_max, scalar& residual);
/// dp += h v, by the trapezoid where the velocity changed smoothly, so that steady acceleration is exact.
void drift_bodies(SolverView& solver, const BodyView& bodies, scalar h);

/// Gives the motion that was found to the bodies that touch: v_CM and L of the end of the step, and, in F_T and tau_T, the constant force and
/// torque that lead to the same displacement: integrate_r and the rotation then take them for what they are.
/// Comes after integrate_v and integrate_L.
void write_contact_motion(const SolverView& solver, const BodyView& bodies, const Vector& gravity, scalar h);

/// The small turns by which overlaps were taken back. Comes after the rotation.
void turn_by_corrections(const SolverView& solver, const BodyView& bodies, scalar h);

} }  // namespace ingot

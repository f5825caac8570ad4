// SPDX-License-Identifier: MIT
#pragma once

#include "../../constraint/impact_note.h"
#include "../../constraint/solver_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// No manifold of the batch has carried an impulse yet.
void clear_impulse_notes(const SolverView& solver, const StepNotes& notes);

/// Notes which manifolds carry an impulse at the end of a substep, and how much. After each substep, because the impulse of a bounce is gone in the
/// next.
void note_impulses(const SolverView& solver, const StepNotes& notes);

/// The impulses of one manifold, now in its rows, are part of the sums of the step.
void add_to_sum(const SolverView& solver, const ContactBlock& block, int lane_i, ImpulseSum* sums);

} }  // namespace ingot

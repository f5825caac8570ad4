// SPDX-License-Identifier: MIT
// The direct solve of the chosen islands of a batch, around the sweeps of a substep.
#pragma once

#include "../../base/report.h"
#include "direct_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// At the begin of a batch: nothing of another one is loaded.
void begin_direct_batch(const SolverView& solver, DirectView& direct);

/// After the forces of a substep, before its warm start: how bodies of chosen islands move without contacts.
void keep_free_motion(const SolverView& solver, const DirectView& direct);

/// Velocities of the chosen islands: those that are solved are not swept. Each may spend limits::direct_work_max multiplications on factors,
/// whatever others there are.
void solve_before_sweeps(SolverView& solver, DirectView& direct, const BodyView& bodies, scalar h);

/// What the direct solve did not answer, the sweeps did: it is solved from where they ended, and what still is not keeps their result,
/// without the energy that it should not have.
void solve_after_sweeps(SolverView& solver, DirectView& direct, const BodyView& bodies, scalar h, StepReport& report);

/// Positions of the islands that are solved, after which all that are left have their sweeps on; and all are chosen again for the next
/// substep.
void place_islands(SolverView& solver, DirectView& direct, const BodyView& bodies, scalar h);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// The direct solve of the chosen islands of a batch, around the sweeps of a substep.
#pragma once

#include "../../base/report.h"
#include "direct_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// At the begin of a batch: nothing of another one is loaded.
template <class Direct>
void begin_direct_batch(const SolverView& solver, Direct& direct);

/// After the forces of a substep, before its warm start: how bodies of chosen islands move without contacts.
template <class Direct>
void keep_free_motion(const SolverView& solver, const Direct& direct);
/// After the warm start: adds what friction gives before a slip turns round (begin_reversals), which is not solved for.
template <class Direct>
void add_to_free_motion(const SolverView& solver, const Direct& direct);

/// Velocities of the chosen islands: those that are solved are not swept. Each may spend limits::direct_work_max multiplications on factors,
/// whatever others there are.
template <class View, class Direct>
void solve_before_sweeps(View& solver, Direct& direct, const BodyView& bodies, scalar h);

/// Islands that the direct solve did not settle have been swept. They are tried again from where the sweeps ended. An island that still does not
/// settle keeps the result of the sweeps, without the energy that it should not have.
template <class View, class Direct>
void solve_after_sweeps(View& solver, Direct& direct, const BodyView& bodies, scalar h, StepReport& report);

/// Positions of the islands that are solved; the others are left to the position sweep. All are chosen again for the next substep.
template <class View, class Direct>
void place_islands(View& solver, Direct& direct, const BodyView& bodies, scalar h);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "../../constraint/material_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// After the warm start, which takes friction to go on as in the substep before: finds contacts whose slip turns round within this substep. What
/// friction gives before the reversal is no longer solved for, and the circle for the rest is smaller: see reversal_share. True if there are some.
/// For islands that sweeps settle: where few sweeps leave much unsolved, slips turn round for no reason. View: SolverView, or one with belts.
/// Cost: a look at each block; about 150 flops where something slides.
template <class View>
bool begin_reversals(const View& solver, scalar h);

/// Once velocities are solved: where normals carry less than was foreseen, what was given is beyond the cone, and the slip is taken not to turn round
/// after all. True if islands are to be swept again.
bool take_back_reversals(const SolverView& solver);

/// At the end: puts both parts of friction together, and displaces bodies by displacement_of_reversal. h: s, of the substep.
/// View: SolverView, or one with locks.
template <class View>
void end_reversals(const View& solver, scalar h);

} }  // namespace ingot

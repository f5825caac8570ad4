// SPDX-License-Identifier: MIT
#pragma once

#include "../../constraint/material_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// After the warm start, which goes on as the substep before: finds contacts that slide and whose slip turns round within this substep. What friction
/// gives them until then is taken out of what is solved for, and its circle is less wide: see reversal_share. True if there are some. For islands
/// that sweeps settle; what few sweeps leave turns round for no reason. View: SolverView, or one with belts. Cost: a look at each block; about 150
/// flops where something slides.
template <class View>
bool begin_reversals(const View& solver, scalar h);

/// Once velocities are solved: where normals carry less than they were foreseen to, what was given is beyond the cone. There the slip is taken not to
/// turn round after all. True if islands are to be swept again.
bool take_back_reversals(const SolverView& solver);

/// At the end: puts both parts together, and displaces the bodies by what their order makes. h: s, of the substep.
void end_reversals(const SolverView& solver, scalar h);

} }  // namespace ingot

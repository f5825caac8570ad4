// SPDX-License-Identifier: MIT
#pragma once

#include "../../constraint/solver_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Impulses of sweeps that end at their bound are not right yet, and may give energy. Names the islands where they do, by limits::gain_allowed of
/// what they had: they are to be swept again. True where there are some. h: s, of the substep.
bool find_gaining_islands(const SolverView& solver, const BodyView& bodies, scalar h);

} }  // namespace ingot

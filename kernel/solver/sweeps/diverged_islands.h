// SPDX-License-Identifier: MIT
#pragma once

#include "../../constraint/material_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Islands of the batch that carry what sweeps cannot, and do not come near it: with masses of limits::crushing_ratio, at the bound of their sweeps
/// with a residual of limits::crushing_share of the speed of their bodies without contacts. The report counts them among the unfinished. Their
/// impulses are no answer; given again, those between heavy bodies would throw light ones about. So they are dropped, and a body is left no faster
/// than it would be without contacts, or the heavy ones are. What nothing carries then falls in, at the speed of falling.
///
/// Islands with kinematic bodies are left alone: see yield_islands. Cost: a look at each island where all are near.
template <class View>
void hold_diverged_islands(const View& solver, const BodyView& bodies, scalar h);

} }  // namespace ingot

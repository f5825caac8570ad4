// SPDX-License-Identifier: MIT
#pragma once

#include "solver_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// At the begin of a substep of h seconds, before its forces: where the points are, how fast they may approach, and which of them bounce
/// within it, at what time and to what place (a parabola, in closed form).
void predict_contacts(const SolverView& solver, scalar h);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "../../constraint/solver_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// At the begin of a substep of h seconds, before its forces: where the points are, and how fast they may approach.
void predict_contacts(const SolverView& solver, scalar h);

/// After that, which points restitution throws back within the substep, at what time and to what place (a parabola, in closed form).
void predict_bounces(const SolverView& solver, scalar h);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "../../constraint/material_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Makes every contact's velocity right for the moment: normals as one block, then torsion, rolling resistance, and the friction pair on its
/// cone. Visits the live ones. Sweeps of a substep count from 1; those after the first solve only what has an active body: one of whose
/// contacts took away more than limits::active_share of its island's settled speed, in the sweep before or in this one.
template <class View>
void sweep_velocities(const View& solver, int sweep_i, bool up);

/// What the last sweep did to each island that was swept: Island::residual and Island::size. They do not depend on lanes.
void measure_sweep(const SolverView& solver);

} }  // namespace ingot

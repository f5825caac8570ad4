// SPDX-License-Identifier: MIT
#pragma once

#include "../../constraint/material_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Makes every contact's velocity right for the moment: normals as one block, then torsion, rolling resistance, and the friction pair on its cone.
/// Goes along the visits, or back. Sweeps of a substep count from 1. After the first, a contact is solved only if one of its bodies is active: a
/// contact of that body corrected more than limits::active_share of the island's settled speed, in the sweep before or in this one.
template <class View>
void sweep_velocities(const View& solver, const Visit* visits, int visit_count, int sweep_i, bool up);

/// Sets Island::residual and Island::size of each island that was swept, by the last sweep. They do not depend on lanes.
void measure_sweep(const SolverView& solver);

} }  // namespace ingot

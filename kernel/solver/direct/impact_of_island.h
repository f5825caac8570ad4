// SPDX-License-Identifier: MIT
#pragma once

#include "island_rows.h"

namespace ingot { inline namespace INGOT_ABI {

/// True where a body meets another faster than forces drive it within two substeps, and neither is much heavier. Sweeps are better at that: the set
/// of contacts after an impact is far from the set before it, from which the direct solve begins.
template <class Direct>
bool has_impact(const SolverView& solver, const Direct& island, scalar h) {
    if (island.uneven) return false;
    for (int manifold_i = 0; manifold_i < island.manifold_count; ++manifold_i) {  // bound: max_island of HybridIslands: larger islands are swept
        const ManifoldOf<Direct>& manifold = island.manifolds[manifold_i];
        const DirectRow* const rows = island.rows + manifold_i * Direct::row_count;
        wide_scalar smooth = 0;
        for (const Index body : manifold.body)
            if (body != 0) smooth = max(smooth, static_cast<wide_scalar>(2 * h * solver.bodies[island.bodies[body].body_i].dp[3]));
        // bound: 4: block_rows
        for (int row = 0; row < manifold.points; ++row)
            if (has(manifold.rows, row) && row_motion<false>(island, manifold, rows[row]) < rows[row].target - smooth) return true;
    }
    return false;
}

} }  // namespace ingot

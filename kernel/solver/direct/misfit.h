// SPDX-License-Identifier: MIT
#pragma once

#include "normal_set.h"
#include "sliding.h"

namespace ingot { inline namespace INGOT_ABI {

/// By how much the laws of contact are missed.
struct Misfit {
    wide_scalar worst;  ///< m/s
    wide_scalar merit;  ///< J; sum of squares over compliance

    void add(wide_scalar impulse, wide_scalar K) {
        worst = max(worst, abs(impulse) * K);
        merit += impulse * impulse * K;
    }
};

template <class Direct>
Misfit misfit(const Direct& island) {
    Misfit sum = {};
    // bound: max_island of HybridIslands: larger islands are swept
    for (int manifold_i = 0; manifold_i < island.manifold_count; ++manifold_i) {
        const ManifoldOf<Direct>& manifold = island.manifolds[manifold_i];
        const DirectRow* const rows = island.rows + manifold_i * Direct::row_count;
        // bound: 4: block_rows
        for (int row = 0; row < manifold.points; ++row) {
            if (!has(manifold.rows, row)) continue;
            const wide_scalar wanted =
                rows[row].j - (row_motion<false>(island, manifold, rows[row]) - rows[row].target) / rows[row].K;
            sum.add(max(wanted, 0) - rows[row].j, rows[row].K);
        }
        const wide_scalar N = load_of(manifold, rows);
        for (int pair_i = 0; pair_i < Direct::pair_count; ++pair_i) {  // bound: 2: friction and rolling
            const int first = row_of_pair(pair_i);
            if (!has(manifold.rows, first)) continue;
            const PairOfImpulses t = projected_pair(island, manifold, rows + first, manifold.bound_of(pair_i) * N);
            for (int axis = 0; axis < 2; ++axis) sum.add(t.at[axis] - rows[first + axis].j, rows[first + axis].K);
        }
        if (has(manifold.rows, torsion_row))
            sum.add(projected_torsion(island, manifold, rows, manifold.mu * N * manifold.radius) - rows[torsion_row].j, rows[torsion_row].K);
    }
    return sum;
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "normal_set.h"
#include "sliding.h"

namespace ingot { inline namespace INGOT_ABI {

/// What turns the speed of a row into m/s: rows of torsion and of rolling turn, and count at one length_unit.
template <class Direct>
wide_scalar length_of_row(const Direct& island, int row) {
    return row < torsion_row ? wide_scalar(1) : island.unit;
}

/// By how much the laws of contact are missed.
struct Misfit {
    wide_scalar worst;  ///< m/s
    wide_scalar merit;  ///< J; sum of squares over compliance
    wide_scalar grain;  ///< m/s; what the grain of a normal's impulse gives to its row

    /// length: m, what turns the speed of the row into m/s.
    void add(wide_scalar impulse, wide_scalar K, wide_scalar length) {
        worst = max(worst, abs(impulse) * K * length);
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
            // what is to be given and, where that would pull, what there is to take: not as a difference of sums, which have the grain of the load
            const wide_scalar more = (rows[row].target - row_motion<false>(island, manifold, rows[row])) / rows[row].K;
            sum.add(max(more, -rows[row].j), rows[row].K, 1);
            sum.grain = max(sum.grain, limits::direct_grain * rows[row].j * rows[row].K);
        }
        const wide_scalar N = load_of(manifold, rows);
        for (int pair_i = 0; pair_i < Direct::pair_count; ++pair_i) {  // bound: 2: friction and rolling
            const int first = row_of_pair(pair_i);
            if (!has(manifold.rows, first)) continue;
            const PairOfImpulses t = projected_pair(island, manifold, rows + first, manifold.bound_of(pair_i) * N);
            for (int axis = 0; axis < 2; ++axis) sum.add(t.at[axis] - rows[first + axis].j, rows[first + axis].K, length_of_row(island, first));
        }
        if (has(manifold.rows, torsion_row))
            sum.add(projected_torsion(island, manifold, rows, manifold.mu * N * manifold.radius) - rows[torsion_row].j, rows[torsion_row].K,
                    length_of_row(island, torsion_row));
    }
    return sum;
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#include "sliding.h"

#include "../../base/limits.h"
#include "../../math/sqrt.h"
#include "normal_set.h"

namespace ingot { inline namespace INGOT_ABI {

/// sqrt(x) in double without an instruction for it: the scalar's, and two steps of Newton's, which are the same everywhere. What is too small for the
/// scalar is made larger first: 0 below 1e-90.
wide_scalar square_root(wide_scalar x) {
    constexpr double least = 1e-30;
    const bool is_small = x < least;
    if (is_small) x = x * 0x1p200;
    if (!(x > least)) return 0;
    wide_scalar y = static_cast<wide_scalar>(sqrt(static_cast<scalar>(x)));
    for (int step_i = 0; step_i < 2; ++step_i) y = 0.5 * (y + x / y);
    return is_small ? y * 0x1p-100 : y;
}

template <class OfIsland>
wide_scalar load_of(const OfIsland& manifold, const DirectRow* rows) {
    wide_scalar N = 0;
    // bound: 4: block_rows
    for (int row = 0; row < manifold.points; ++row)
        if (has(manifold.rows, row)) N += rows[row].j;
    return max(N, 0);
}

PairOfImpulses cut(const PairOfImpulses& t, wide_scalar limit) {
    const wide_scalar length_sq = t.at[0] * t.at[0] + t.at[1] * t.at[1];
    if (length_sq <= limit * limit) return t;
    const wide_scalar length = square_root(length_sq), share = length > 0 ? limit / length : 0;
    return {{t.at[0] * share, t.at[1] * share}};
}

template <class Direct>
PairOfImpulses tried_pair(const Direct& island, const ManifoldOf<Direct>& manifold, const DirectRow* pair) {
    const wide_scalar inv_K = 1 / pair_compliance(pair);
    PairOfImpulses tried;
    for (int axis = 0; axis < 2; ++axis)
        tried.at[axis] = pair[axis].j - inv_K * (row_motion<false>(island, manifold, pair[axis]) - pair[axis].target);
    return tried;
}
template <class Direct>
PairOfImpulses projected_pair(const Direct& island, const ManifoldOf<Direct>& manifold, const DirectRow* pair, wide_scalar limit) {
    return cut(tried_pair(island, manifold, pair), limit);
}
template <class Direct>
wide_scalar projected_torsion(const Direct& island, const ManifoldOf<Direct>& manifold, const DirectRow* rows, wide_scalar limit) {
    const DirectRow& torsion = rows[torsion_row];
    return clamp(torsion.j - row_motion<false>(island, manifold, torsion) / torsion.K, limit);
}

template <class Direct>
void find_slide(const Direct& island, ManifoldOf<Direct>& manifold, const DirectRow* rows) {
    const wide_scalar N = load_of(manifold, rows);
    for (int pair_i = 0; pair_i < Direct::pair_count; ++pair_i) {  // bound: 2: friction and rolling
        const int first = row_of_pair(pair_i);
        if (!has(manifold.sliding, first)) continue;
        const wide_scalar limit = manifold.bound_of(pair_i) * N;
        const PairOfImpulses x = tried_pair(island, manifold, rows + first);
        const wide_scalar length = square_root(x.at[0] * x.at[0] + x.at[1] * x.at[1]);
        const wide_scalar inv = length > 0 ? 1 / length : 0;
        SlideDirection& slip = manifold.slip[pair_i];
        slip.x[0] = x.at[0] * inv;
        slip.x[1] = x.at[1] * inv;
        slip.share = length > limit ? limit * inv : 1;
    }
    if (has(manifold.sliding, torsion_row)) {
        const DirectRow& torsion = rows[torsion_row];
        manifold.torsion_sign = torsion.j - row_motion<false>(island, manifold, torsion) / torsion.K < 0 ? -1 : 1;
    }
}

// The linker takes those of the scene.
#define INGOT_DIRECT(Direct)                                                                                                \
    template wide_scalar load_of(const ManifoldOf<Direct>&, const DirectRow*);                                              \
    template PairOfImpulses tried_pair(const Direct&, const ManifoldOf<Direct>&, const DirectRow*);                         \
    template PairOfImpulses projected_pair(const Direct&, const ManifoldOf<Direct>&, const DirectRow*, wide_scalar);        \
    template wide_scalar projected_torsion(const Direct&, const ManifoldOf<Direct>&, const DirectRow*, wide_scalar);        \
    template void find_slide(const Direct&, ManifoldOf<Direct>&, const DirectRow*)
INGOT_DIRECT(DirectView);
INGOT_DIRECT(RollingDirectView);
#undef INGOT_DIRECT

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#include "sliding.h"

#include "../../base/limits.h"
#include "../../math/sqrt.h"
#include "normal_set.h"

namespace ingot { inline namespace INGOT_ABI {

/// sqrt(x) in double without an instruction for it: the scalar's, and two steps of Newton's, which are the same everywhere.
wide_scalar square_root(wide_scalar x) {
    if (!(x > 1e-30)) return 0;
    wide_scalar y = static_cast<wide_scalar>(sqrt(static_cast<scalar>(x)));
    for (int step_i = 0; step_i < 2; ++step_i) y = 0.5 * (y + x / y);
    return y;
}

wide_scalar load_of(const DirectManifold& manifold, const DirectRow* rows) {
    wide_scalar N = 0;
    // bound: 4: block_rows
    for (int row = 0; row < manifold.points; ++row)
        if (has(manifold.rows, row)) N += rows[row].j;
    return max(N, 0);
}

FrictionImpulse cut(const FrictionImpulse& t, wide_scalar limit) {
    const wide_scalar length_sq = t.at[0] * t.at[0] + t.at[1] * t.at[1];
    if (length_sq <= limit * limit) return t;
    const wide_scalar length = square_root(length_sq), share = length > 0 ? limit / length : 0;
    return {{t.at[0] * share, t.at[1] * share}};
}

/// t - u / K.
FrictionImpulse tried_friction(const DirectView& island, const DirectManifold& manifold, const DirectRow* rows) {
    const DirectRow* const pair = rows + friction_row;
    const wide_scalar inv_K = 1 / friction_compliance(rows);
    return {{pair[0].j - inv_K * row_motion<false>(island, manifold, pair[0]),
             pair[1].j - inv_K * row_motion<false>(island, manifold, pair[1])}};
}
FrictionImpulse projected_friction(const DirectView& island, const DirectManifold& manifold, const DirectRow* rows,
                                   wide_scalar limit) {
    return cut(tried_friction(island, manifold, rows), limit);
}
wide_scalar projected_torsion(const DirectView& island, const DirectManifold& manifold, const DirectRow* rows, wide_scalar limit) {
    const DirectRow& torsion = rows[torsion_row];
    return clamp(torsion.j - row_motion<false>(island, manifold, torsion) / torsion.K, limit);
}

void find_slide(const DirectView& island, DirectManifold& manifold, const DirectRow* rows) {
    const wide_scalar limit = manifold.mu * load_of(manifold, rows);
    if (has(manifold.sliding, friction_row)) {
        const FrictionImpulse x = tried_friction(island, manifold, rows);
        const wide_scalar length = square_root(x.at[0] * x.at[0] + x.at[1] * x.at[1]);
        const wide_scalar inv = length > 0 ? 1 / length : 0;
        manifold.slip.x[0] = x.at[0] * inv;
        manifold.slip.x[1] = x.at[1] * inv;
        manifold.slip.share = length > limit ? limit * inv : 1;
    }
    if (has(manifold.sliding, torsion_row)) {
        const DirectRow& torsion = rows[torsion_row];
        manifold.slip.torsion = torsion.j - row_motion<false>(island, manifold, torsion) / torsion.K < 0 ? -1 : 1;
    }
}

} }  // namespace ingot

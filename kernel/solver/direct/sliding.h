// SPDX-License-Identifier: MIT
// Friction and torsion by Coulomb's law, in double: what they would be at the slip there is, and how they follow it.
#pragma once

#include "island_rows.h"

namespace ingot { inline namespace INGOT_ABI {

struct FrictionImpulse {
    wide_scalar at[2];
};

wide_scalar square_root(wide_scalar x);
/// Cut to the circle of this radius.
FrictionImpulse cut(const FrictionImpulse& t, wide_scalar limit);
FrictionImpulse tried_friction(const DirectView& island, const DirectManifold& manifold, const DirectRow* rows);
/// What Coulomb's law makes of friction and torsion at the slip there is: the projection of t - u / K to the cone. At the
/// solution it is t.
FrictionImpulse projected_friction(const DirectView& island, const DirectManifold& manifold, const DirectRow* rows,
                                   wide_scalar limit);
wide_scalar projected_torsion(const DirectView& island, const DirectManifold& manifold, const DirectRow* rows, wide_scalar limit);
/// The normal impulse of a manifold.
wide_scalar load_of(const DirectManifold& manifold, const DirectRow* rows);

/// The larger of the pair's compliances.
inline wide_scalar friction_compliance(const DirectRow* rows) {
    const wide_scalar K_1 = rows[friction_row].K, K_2 = rows[friction_row + 1].K;
    return K_1 > K_2 ? K_1 : K_2;
}

/// Where the sliding friction and torsion of a manifold point, for Newton's method.
void find_slide(const DirectView& island, DirectManifold& manifold, const DirectRow* rows);

} }  // namespace ingot

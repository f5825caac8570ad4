// SPDX-License-Identifier: MIT
// Friction and twist by Coulomb's law, in double: what they would be at the slip there is, and how they follow it.
#pragma once

#include "island_rows.h"

namespace ingot { inline namespace INGOT_ABI {

struct FrictionImpulse {
    double at[2];
};

double square_root(double x);
/// Cut to the circle of this radius.
FrictionImpulse cut(const FrictionImpulse& t, double limit);
/// What Coulomb's law makes of friction and twist at the slip there is: the projection of t - u / K to the cone. At the solution it is t.
FrictionImpulse projected_friction(const DirectView& island, const DirectManifold& manifold, const DirectRow* rows, double limit);
double projected_twist(const DirectView& island, const DirectManifold& manifold, const DirectRow* rows, double limit);
/// The normal impulse of a manifold.
double load_of(const DirectManifold& manifold, const DirectRow* rows);

/// One pass of friction that slides, that is, has rows which are not active: it follows the load and the slip. Returns the largest speed that
/// changed.
///
/// Passes alone converge as slowly as the sweeps do; they are mixed so that the change would be least were it linear in what was proposed.
/// Source: Anderson, "Iterative procedures for nonlinear integral equations", J. ACM 12 (1965), with the last slide_memory passes.
double follow_sliding(const DirectView& island, int pass_i);

} }  // namespace ingot

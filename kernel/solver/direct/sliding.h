// SPDX-License-Identifier: MIT
// Friction and torsion by Coulomb's law, in double: their values at a given slip, and their derivatives by it.
#pragma once

#include "island_rows.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of a pair of rows: see row_of_pair.
struct PairOfImpulses {
    wide_scalar at[2];
};

wide_scalar square_root(wide_scalar x);
/// Cut to the circle of this radius.
PairOfImpulses cut(const PairOfImpulses& t, wide_scalar limit);
/// t - u / K, with u the slip: what is left of the speed beyond the target.
template <class Direct>
PairOfImpulses tried_pair(const Direct& island, const ManifoldOf<Direct>& manifold, const DirectRow* pair);
/// Coulomb's law for a pair and for torsion at the present slip: the projection of t - u / K to the cone. At the solution it is t.
template <class Direct>
PairOfImpulses projected_pair(const Direct& island, const ManifoldOf<Direct>& manifold, const DirectRow* pair, wide_scalar limit);
template <class Direct>
wide_scalar projected_torsion(const Direct& island, const ManifoldOf<Direct>& manifold, const DirectRow* rows, wide_scalar limit);
/// The normal impulse of a manifold.
template <class OfIsland>
wide_scalar load_of(const OfIsland& manifold, const DirectRow* rows);

/// The larger of the pair's compliances.
inline wide_scalar pair_compliance(const DirectRow* pair) { return pair[0].K > pair[1].K ? pair[0].K : pair[1].K; }

/// Which way sliding pairs and torsion of a manifold point, for Newton's method.
template <class Direct>
void find_slide(const Direct& island, ManifoldOf<Direct>& manifold, const DirectRow* rows);

} }  // namespace ingot

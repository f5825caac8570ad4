// SPDX-License-Identifier: MIT
#pragma once

#include "direct_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Lists the active rows, and factors their matrix A = J M^-1 J^T as L D L^T. Returns at once when they are those of the last call. False: entries is
/// full, or the work is more than work_left. The first factor of an attempt counts even if it is there already.
///
/// Of each row only the entries from the first that is not zero to the diagonal are stored. Manifolds are ordered by level, so manifolds that share a
/// body are near each other: a tower has about 10 entries a row. Contacts of a body that rests on several others depend on each other, so 1e-12 of
/// the diagonal is added to it; refinement takes out what that changes.
/// Cost: rows times the square of entries per row.
template <class Direct>
bool factor_rows(Direct& island);

/// Solves for active[].x in place.
template <class Direct>
void solve_factored(const Direct& island);

} }  // namespace ingot

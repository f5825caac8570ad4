// SPDX-License-Identifier: MIT
#pragma once

#include "direct_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Lists the active rows, and factors their matrix A = J M^-1 J^T as L D L^T. Returns at once when they are
/// those of the last call. False: entries is full, or the work is more than work_left; that of the first factor of an attempt counts though it is
/// there already.
///
/// Only what lies between the first entry of a row that is not zero and the diagonal is stored and looked at. Manifolds come by
/// level, so that those which share a body are near each other: about 10 entries a row in a tower. 1e-12 of the diagonal is
/// added, because contacts of bodies that rest on several others depend on each other; refinement takes out what that changes.
/// Cost: rows times the square of entries per row.
bool factor_rows(DirectView& island);

/// Solves for active[].x in place.
void solve_factored(const DirectView& island);

} }  // namespace ingot

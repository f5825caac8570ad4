// SPDX-License-Identifier: MIT
#pragma once

#include "../../constraint/material_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// After the forces: gives the bodies the impulses of the substep before again.
///
/// Those of an impact are not given again: impulses on a body that was hit are cut to twice what they were before it, and what gravity explains.
/// Friction follows a slow mean of itself, which quietens its ringing.
template <class View>
void warm_start(const View& solver, const Visit* visits, int visit_count, scalar h);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "../body/body_tiles.h"

namespace ingot { inline namespace INGOT_ABI {

/// L += h tau_T for every body (Hecker 1997, Listing 1). A body whose L would not be finite keeps it and is marked bad.
///
/// Units:   h in s. Cost: 6 flops a body.
void integrate_L(const BodyView& bodies, scalar h);

/// tau_T = 0, and F_T = 0 where the scene translates: the sums of the next step begin.
void clear_forces(const BodyView& bodies);

} }  // namespace ingot

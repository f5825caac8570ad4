// SPDX-License-Identifier: MIT
#pragma once

#include "../body/body_tiles.h"

namespace ingot { inline namespace INGOT_ABI {

/// v_CM += h (F_T / M + gravity) for every body that moves (Hecker 1997, Eq. 14, Listing 1). A body whose v_CM would pass
/// limits::speed_runaway keeps it and is marked bad.
///
/// Units:   h in s, gravity in m s^-2. Cost: 12 flops a body.
void integrate_v(const BodyView& bodies, scalar h, const Vector& gravity);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "../body/body_tiles.h"

namespace ingot { inline namespace INGOT_ABI {

/// r_CM += h (v_CM - h/2 a), a = F_T / M + gravity, with v_CM already of the end of the step: exact for a force that is
/// constant over the step, second order for any other. Contact forces count: they are in F_T.
///
/// A body whose r_CM would pass limits::position_max keeps it and is marked bad.
/// Units:   h in s, gravity in m s^-2. Cost: 18 flops a body.
void integrate_r(const BodyView& bodies, scalar h, const Vector& gravity);

/// r_CM += h v_CM: between two kicks; with the v_CM of the begin of the step, as printed in Hecker 1997, Listing 1. h may be
/// negative. A body whose r_CM would pass limits::position_max keeps it and is marked bad.
void drift_r(const BodyView& bodies, scalar h);

} }  // namespace ingot

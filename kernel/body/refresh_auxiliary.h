// SPDX-License-Identifier: MIT
// Auxiliary state: derived after each step, never integrated.
#pragma once

#include "body_tiles.h"

namespace ingot { inline namespace INGOT_ABI {

/// omega of every body from its A and L: A Ibar^-1 A^T L (Hecker 1997, Eqs. 18 and 20).
/// A body whose omega passes limits::spin_runaway is marked bad. Cost: 38 flops a body.
void refresh_omega(const BodyView& bodies);

/// The same for the body of one slot, with the same bits.
void refresh_omega_of(const BodyView& bodies, int slot);

/// inv_I_world of every body from its A (Eq. 20), for the contacts of a step. Cost: 47 flops a body.
void refresh_inv_I_world(const BodyView& bodies);

} }  // namespace ingot

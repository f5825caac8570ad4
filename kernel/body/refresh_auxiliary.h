// SPDX-License-Identifier: MIT
#pragma once

#include "body_tiles.h"

namespace ingot { inline namespace INGOT_ABI {

/// inv_I_world of every body from its A (Hecker 1997, Eq. 20), then omega from its L (Eq. 18): auxiliary state is
/// never integrated.
/// A body whose omega passes limits::spin_runaway is marked bad.
/// Cost: 65 flops a body.
void refresh_auxiliary(const BodyView& bodies);

/// The same for the body of one slot, with the same bits.
void refresh_auxiliary_of(const BodyView& bodies, int slot);

} }  // namespace ingot

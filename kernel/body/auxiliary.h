// SPDX-License-Identifier: MIT
// Auxiliary state: derived from A and L, never integrated. omega is not kept: what asks for it works it out, so it cannot be
// stale, takes no memory, and a step that nobody asks pays nothing for it.
#pragma once

#include "body_tiles.h"

namespace ingot { inline namespace INGOT_ABI {

/// Angular velocity of the body of a slot, rad/s, world (Hecker 1997, Eqs. 18 and 20). Cost: 36 flops.
Vector omega_of(const BodyView& bodies, int slot);

/// inv_I_world of every body from its A (Eq. 20), for the contacts of a step. Cost: 47 flops a body.
void refresh_inv_I_world(const BodyView& bodies);

/// Marks bodies bad whose spin passes limits::spin_runaway. A method that turns bodies sees that before it turns them; this is
/// for steps that change L after the turn. Cost: 41 flops a body.
void mark_runaway_spins(const BodyView& bodies);

} }  // namespace ingot

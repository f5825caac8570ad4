// SPDX-License-Identifier: MIT
// Sums over bodies, in the order of their slots.
#pragma once

#include "body_tiles.h"

namespace ingot { inline namespace INGOT_ABI {

/// Kinetic energy of the body of one slot: v.p / 2 + L.omega / 2. Units: J. Zero for an immovable body.
scalar kinetic_energy_of(const BodyView& bodies, int slot);
/// p = M v_CM. Units: kg m s^-1. Zero for an immovable body and in scenes that do not translate.
Vector linear_momentum_of(const BodyView& bodies, int slot);
/// r_CM x p + L, about the origin of the world. Units: kg m^2 s^-1.
Vector angular_momentum_of(const BodyView& bodies, int slot);

/// The same summed over all bodies. Cost: one division and about 40 flops a body.
scalar kinetic_energy_of_all(const BodyView& bodies);
Vector linear_momentum_of_all(const BodyView& bodies);
Vector angular_momentum_of_all(const BodyView& bodies);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "direct_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where the impulses of the loaded island give it more kinetic energy than its free motion has, scales them, and what they did
/// to the bodies, by the factor of the least energy; else changes nothing. Friction stays within its cone.
///
/// Contacts that do not bounce only take energy, so impulses that give some are wrong. Impulses of an impact are, when the next step gives them
/// again; with 1000 kg on 1 kg no number of sweeps takes them back: a pile gained 26 kJ of 300 in a step. Belts may give the work that friction does
/// along them, and no more. Islands with points that bounce are left alone.
template <class View, class Direct>
void hold_energy(const View& solver, const Direct& island);

} }  // namespace ingot

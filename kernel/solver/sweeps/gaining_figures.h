// SPDX-License-Identifier: MIT
// What sweeps at their bound do wrong where bodies have joints.
//
// Contacts and ends of joints, by themselves, take energy: with shares s of all their impulses an island has E(s) = E_0 + D s + Q s^2. Sweeps that
// could not settle may end beyond E_0: joints let bodies go a few ways only, and what contacts ask for along others, by the second order of turns, no
// impulse gives, however large. Then the share is taken where E is least, -D / 2 Q, which is what an exact search along these impulses would take.
// Joints hold as they did, for all that a solve does is linear.
//
// Drives do give energy. By their law, j = c - R q of a rate q, the same holds of the energy of the bodies and R q^2 / 2: of what the bodies have,
// that is, without the work that drives do beyond what they do with all of the impulses. To other shares drives answer as they would.
#pragma once

#include "../../constraint/jointed_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of islands with joints whose sweeps have ended at their bound. Whole: a view of bodies with joints, with rows of joints or without. h: s, of the
/// substep. Islands that touch kinematic bodies may gain: see pushed_figures.h; and so may those on belts. Those whose joints are driven are looked
/// at where they settle, too.
/// Cost: three ways through the figures of the batch, where some island has not settled; one through the bodies where some are driven.
template <class Whole>
void hold_gaining_figures(Whole& whole, const BodyView& bodies, scalar h);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// Kinematic bodies give energy, and a figure that one of them presses against its own joint has nowhere to go: as contact and joint come into line,
// what the contact asks for is a speed without end, with a lever of nothing. Impulses grow until something gives way, and then they come out at
// once, in a substep that settles. Such an island may have what it has without contacts, or the energy of its mass at limits::pushed_lever_sq times
// the squared speed of what pushes it, whichever is more, and what its drives give: beyond that a share of all its impulses is given, and joints hold as they did.
#pragma once

#include "../../constraint/jointed_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of islands with joints that touch kinematic bodies, settled or not. Whole: a view of bodies with joints, with rows of joints or without. h: s, of
/// the substep.
/// Cost: one way through the bodies, where such an island is in the batch; three more through its figures where it has more than it may.
template <class Whole>
void hold_pushed_figures(Whole& whole, const BodyView& bodies, scalar h);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// Kinematic bodies give energy, and a figure that one of them presses against its own joint has nowhere to go: as contact and joint come into line,
// what the contact asks for is a speed without end, with a lever of nothing. Impulses grow until something gives way, and then they come out at
// once, in a substep that settles. Such an island may have what it has without contacts, or what a push at v gives in a step of h seconds, whichever
// is more, and what its drives give: beyond that a share of all its impulses is given, and joints hold as they did. A push gives
//
//     2 v to all of the mass, as of a blow with a restitution of 1, and no lever: 2 M v^2; and
//     to each body with joints what a rod of its length w has that stood in line between what pushes it and its joint as the step began: pushed on by
//     h v it has turned to a lever r, with r^2 = 2 w h v, and so has (M w^2 / 3) (v / r)^2 / 2 = M w v / 12 h.
//
// With w^2 = 6 tr I / M, as of a rod, that is v / h sqrt(M tr I / 24). So levers down to sqrt(2 w h v) are followed exactly: doors open.
#pragma once

#include "../../constraint/jointed_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of islands with joints that touch kinematic bodies, settled or not. Whole: a view of bodies with joints, with rows of joints or without. h: s, of
/// the substep.
/// Cost: one way through the bodies, where such an island is in the batch; three more through its figures where it has more than it may, or six.
template <class Whole>
void hold_pushed_figures(Whole& whole, const BodyView& bodies, scalar h);

} }  // namespace ingot

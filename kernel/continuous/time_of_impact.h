// SPDX-License-Identifier: MIT
#pragma once

#include "body_path.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of their magnitudes: what coordinates round by is a share of it.
INGOT_INLINE scalar sum_of_components(const Vector& v) { return abs(v.x) + abs(v.y) + abs(v.z); }

/// When two shapes on the paths of their bodies first meet, before `latest`: a fraction of the step, or `never`. A is no half space.
///
/// Conservative advancement: the nearest points give a plane between the shapes. How fast points of either come towards it is bounded by the speed
/// of the centres along n, by omega x r of the points furthest along omega x n, and by the accelerations omega^2 R and that of the fall; so the time
/// until the plane can be reached is known, and they are moved on by that.
///
/// Met: apart by limits::impact_gap, and the roundings of the positions. Bodies that touch from the begin are left to the contacts until they
/// have parted; meanwhile A without its skin (limits::skin_share) may not reach B. Where that has reached B at the begin, it is A without
/// two skins, and so on; where even limits::skins_max are too few, a ball about the centre of A, half as large as A is thick, may not reach
/// B. Where that is inside too nothing is met.
/// `unsolved`: no contact of this step has seen to them; if they touch from the begin, and their nearest points close by more than that skin
/// in the rest of the step, they meet at once.
/// After limits::approaches_max they are taken for met where they are: too early, never too late.
/// Frames: world. Source: Mirtich, "Impulse-based dynamic simulation", 1996, 2.3; the second order is ours.
scalar time_of_impact(const ShapeOnPath& A, const ShapeOnPath& B, scalar unit, scalar latest, bool unsolved);

/// False where the balls that hold the shapes stay apart.
bool may_meet(const ShapeOnPath& A, const ShapeOnPath& B, scalar unit);

} }  // namespace ingot

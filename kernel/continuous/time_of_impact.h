// SPDX-License-Identifier: MIT
#pragma once

#include "body_path.h"

namespace ingot { inline namespace INGOT_ABI {

/// Of their magnitudes: what coordinates round by is a share of it.
INGOT_INLINE scalar sum_of_components(const Vector& v) { return abs(v.x) + abs(v.y) + abs(v.z); }

/// What is looked for on the paths of two shapes.
struct ImpactSearch {
    scalar unit;    ///< m; of lengths in limits.h
    scalar since;   ///< from then on, or from where the later path begins, if that is later
    scalar latest;  ///< what is later does not count
    scalar touch;   ///< m; so far apart they touch at the begin, if contacts have been solved for what is so near; 0: none have
};

struct TimeOfImpact {
    scalar t;      ///< a fraction of the step, or `never`
    bool touched;  ///< they touched at the begin
    Vector n;      ///< unit, from B to A, when they meet
    Vector P;      ///< m, world, in the middle between their nearest points; of shapes that overlap, anywhere in both
};

/// When two shapes on the paths of their bodies first meet. A is no half space.
///
/// Conservative advancement: the nearest points give a plane between the shapes. How fast points of either come towards it is bounded by the speed
/// of their centres along n, by omega x r of the points furthest along omega x n, and by the accelerations omega^2 R and that of the fall; so the
/// time until the plane can be reached is known, and they are moved on by that. Of what is round, a turn about its axis does not count.
///
/// Met: touching, or apart by less than limits::impact_gap and the roundings of the positions. Shapes that touch from the begin have contacts, or
/// have just had an impact: until they are seen apart they meet when they are deeper in each other than at the begin, and deeper than
/// limits::skin_share of the lesser of their least half extents: see parting_plane.h. Where not even the middle of A was outside of B nothing is met.
/// So no path leads deeper than that, up to the time that is told.
/// After limits::approaches_max they are taken for met where they are: too early, never too late.
/// Frames: world. Source: Mirtich, "Impulse-based dynamic simulation", 1996, 2.3; the second order is ours.
TimeOfImpact time_of_impact(const ShapeOnPath& A, const ShapeOnPath& B, const ImpactSearch& search);

/// False where the balls that hold the shapes stay apart.
bool may_meet(const ShapeOnPath& A, const ShapeOnPath& B, scalar unit);

} }  // namespace ingot

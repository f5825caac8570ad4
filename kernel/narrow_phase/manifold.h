// SPDX-License-Identifier: MIT
#pragma once

#include "../base/limits.h"
#include "../math/vec3.h"

namespace ingot { inline namespace INGOT_ABI {

/// One point where two shapes touch, or nearly do.
struct ManifoldPoint {
    Vector P;           ///< m, world, half-way between the two surfaces
    scalar separation;  ///< m, along n; negative where the shapes overlap
    uint32_t feature;   ///< names the features that made the point; the same from step to step while they do
};

/// Where two shapes touch: up to four points that span the area of contact, and the normal they share.
struct Manifold {
    static constexpr int points_max = 4;
    Vector n;           ///< unit, from B to A, world
    int8_t count;       ///< 0 .. points_max; 0: further apart than the margin
    uint8_t material;   ///< of what is touched of a level; of records with anything else 0, and elsewhere not read
    uint16_t halvings;  ///< of the lengths that its contact is measured by: see base/contact_lengths.h
    ManifoldPoint points[points_max];
};

/// m, of the deepest point; limits::unbounded where there is none.
inline scalar least_separation(const Manifold& manifold) {
    scalar least = limits::unbounded;
    // bound: 4: Manifold::points_max
    for (int i = 0; i < manifold.count; ++i) least = manifold.points[i].separation < least ? manifold.points[i].separation : least;
    return least;
}

} }  // namespace ingot

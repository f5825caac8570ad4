// SPDX-License-Identifier: MIT
// From the points where two shapes touch to the four that stand for them.
#pragma once

#include "../base/limits.h"
#include "../math/sqrt.h"
#include "../math/vec3.h"
#include "manifold.h"

namespace ingot { inline namespace INGOT_ABI {

/// A point that may become one of the manifold, in the frame of the contact.
struct Candidate {
    scalar x, y;        ///< m, in the plane of contact
    scalar z;           ///< m, along n, half-way between the two surfaces
    scalar separation;  ///< m
    uint32_t feature;
};

/// Where the candidates are measured: P = origin + e_x x + e_y y + n z. e_x, e_y and n are orthonormal, of either handedness.
struct ContactFrame {
    Vector origin, e_x, e_y, n;
};

/// What the step before says; kept apart from its manifold so that the new one may be written over it.
struct Before {
    Vector n;
    int count;
    uint32_t features[Manifold::points_max];

    /// True where the point of that place in the manifold was made by the same features.
    INGOT_INLINE bool had(int place, uint32_t feature) const { return place < count && features[place] == feature; }
};

INGOT_INLINE Before remember(const Manifold* manifold) {
    Before before;  // features beyond its count are not looked at: to clear them all would take a call
    before.n = {};
    before.count = 0;
    if (manifold == nullptr) return before;
    before.n = manifold->n;
    before.count = manifold->count < Manifold::points_max ? manifold->count : Manifold::points_max;
    // bound: 4: Manifold::points_max
    for (int i = 0; i < before.count; ++i) before.features[i] = manifold->points[i].feature;
    return before;
}

/// Two unit vectors that make a right-handed frame with the unit vector n.
INGOT_INLINE ContactFrame frame_about(const Vector& n, const Vector& origin) {
    const scalar x = abs(n.x), y = abs(n.y), z = abs(n.z);
    const Vector least = x <= y && x <= z ? Vector{1, 0, 0} : y <= z ? Vector{0, 1, 0} : Vector{0, 0, 1};
    Vector e_x = cross(least, n);
    e_x = e_x * (1 / sqrt(length_sq(e_x)));
    return {origin, e_x, cross(n, e_x), n};
}

INGOT_INLINE void no_points(const Vector& n, Manifold& manifold) {
    manifold.n = n;
    manifold.count = 0;
}

INGOT_INLINE void one_point(const Vector& n, const Vector& P, scalar separation, uint32_t feature, Manifold& manifold) {
    manifold.n = n;
    manifold.count = 1;
    manifold.points[0] = {P, separation, feature};
}

/// Puts into the manifold at most four of the candidates: the deepest, the furthest from it, the one that makes the largest
/// triangle with these, and the one that adds most to its area, in this order. Up to four keep the order they have.
///
/// What the step before chose at each turn is preferred: by `tolerance` (m) in depth, by a tenth in length and area, so that
/// candidates that are alike but for rounding do not take turns.
void keep_points(const Candidate* candidates, int count, const ContactFrame& frame, scalar tolerance, const Before& before, Manifold& manifold);

/// The same where candidates may be anywhere up to the margin, m, as corners of a hull that rocks: near ones go before those that span more. With
/// four that span, and none beside the one that it stands on, a hull sinks into the plane at each corner that it rolls over, and is lifted out again.
void keep_near_points(const Candidate* candidates, int count, const ContactFrame& frame, scalar tolerance, const Before& before, scalar margin,
                      Manifold& manifold);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// Small geometry that several routines of the narrow phase share.
#pragma once

#include "../math/sqrt.h"
#include "manifold_points.h"
#include "../shape/placed_shape.h"

namespace ingot { inline namespace INGOT_ABI {

INGOT_INLINE Vector clamp(const Vector& x, const Vector& limit) {
    return {clamp(x.x, limit.x), clamp(x.y, limit.y), clamp(x.z, limit.z)};
}
inline constexpr scalar Vector::*component_of[3] = {&Vector::x, &Vector::y, &Vector::z};
INGOT_INLINE scalar component(const Vector& v, int i) { return v.*component_of[i]; }
INGOT_INLINE Vector unit_axis(int i, scalar sign) { return {i == 0 ? sign : 0, i == 1 ? sign : 0, i == 2 ? sign : 0}; }
INGOT_INLINE scalar smallest_of(const Vector& v) {
    const scalar least = v.x < v.y ? v.x : v.y;
    return least < v.z ? least : v.z;
}

/// A half space in the world: all points with n . r <= d, seen from a point near what touches it.
struct HeightAbove {
    Vector n;
    scalar height;  ///< of the point above the face
};

INGOT_INLINE HeightAbove face_below(const PlacedShape& half_space, const Vector& point) {
    const Vector n = half_space.A * half_space.shape.size;
    return {n, dot(n, point - half_space.r) - half_space.shape.offset};
}

/// The manifold of a ball around the point c and something whose nearest point is q: n from q to c.
/// reach: the radius of the ball and, where q is on the axis of something round, its radius too.
INGOT_INLINE void round_point(const Vector& n, const Vector& q, scalar distance, scalar reach, scalar radius_B, scalar margin,
                              Manifold& manifold) {
    const scalar s = distance - reach;
    if (s <= margin)
        one_point(n, q + n * (radius_B + s * scalar(0.5)), s, 0, manifold);
    else
        no_points(n, manifold);
}

/// The manifold of two balls. Centres all but together are pushed apart along x.
INGOT_INLINE void ball_on_ball(const Vector& r_A, scalar radius_A, const Vector& r_B, scalar radius_B, scalar margin, Manifold& manifold) {
    const Vector d = r_A - r_B;
    const scalar distance = sqrt(length_sq(d)), reach = radius_A + radius_B;
    const Vector n = distance > epsilon * reach ? d * (1 / distance) : Vector{1, 0, 0};
    round_point(n, r_B, distance, reach, radius_B, margin, manifold);
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#include "cast_shape.h"

#include "../collide/nearest_points.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

scalar extent_of(const Vector& v) { return abs(v.x) + abs(v.y) + abs(v.z); }

/// The gap that is as good as none.
scalar gap_of(const PlacedShape& moving, const Vector& way, const PlacedShape& B) {
    const scalar R = bounding_radius(moving.shape), R_B = B.shape.kind == ShapeKind::half_space ? R : bounding_radius(B.shape);
    return limits::cast_gap * (R < R_B ? R : R_B) + 4 * epsilon * (extent_of(moving.r - B.r) + extent_of(moving.r) + extent_of(way) + R + R_B);
}

/// A plane between two shapes: unit normal from B to A, and how far they are apart along it.
struct PlaneBetween {
    Vector n;
    scalar gap;
};

/// The normal of the face that looks most along n; n itself for what has no faces.
Vector face_towards(const PlacedShape& s, const Vector& n) {
    const Vector u = transpose_times(s.A, n);
    if (s.shape.kind == ShapeKind::box) {
        if (abs(u.x) >= abs(u.y) && abs(u.x) >= abs(u.z)) return s.A.c0;
        return abs(u.y) >= abs(u.z) ? s.A.c1 : s.A.c2;
    }
    if (s.shape.kind == ShapeKind::cylinder && 2 * u.z * u.z > 1) return s.A.c2;
    if (s.shape.kind == ShapeKind::hull) {
        int best = 0;
        for (int face_i = 1; face_i < s.hull->face_count; ++face_i)
            if (dot(s.hull->faces[face_i].n, u) > dot(s.hull->faces[best].n, u)) best = face_i;
        return s.A * s.hull->faces[best].n;
    }
    return n;
}

/// The direction of the edge that lies most across n; zero for what has no straight edges of known direction.
Vector edge_across(const PlacedShape& s, const Vector& n) {
    if (s.shape.kind == ShapeKind::capsule) return s.A.c2;
    if (s.shape.kind != ShapeKind::box) return {};
    const Vector u = transpose_times(s.A, n);
    if (abs(u.x) <= abs(u.y) && abs(u.x) <= abs(u.z)) return s.A.c0;
    return abs(u.y) <= abs(u.z) ? s.A.c1 : s.A.c2;
}

/// Takes the direction m, of either sense and any length, where it parts A and B further than `best`.
void improve(const PlacedShape& A, const PlacedShape& B, const Vector& m, PlaneBetween& best) {
    const scalar length = sqrt(length_sq(m));
    if (!(length > scalar(0.01))) return;
    const Vector n = m * ((dot(m, best.n) < 0 ? scalar(-1) : scalar(1)) / length);
    const scalar gap = dot(n, support_point(A, -n) - support_point(B, n));
    if (gap > best.gap) best = {n, gap};
}

/// The plane of the nearest points. As shapes come near, the rounding of those points turns it by epsilon size / distance; planes of
/// faces and of crossed edges have no such loss, and often are the ones.
PlaneBetween plane_between(const PlacedShape& A, const PlacedShape& B, const Nearest& nearest) {
    PlaneBetween plane = {nearest.n, nearest.at_least};
    if (B.shape.kind == ShapeKind::half_space) return plane;
    const Vector apart = nearest.P_A - nearest.P_B;  // of corners: they are known to the last digit, whatever their distance
    improve(A, B, apart * (1 / (nearest.distance > 0 ? nearest.distance : 1)), plane);
    improve(A, B, face_towards(B, nearest.n), plane);
    improve(A, B, face_towards(A, nearest.n), plane);
    improve(A, B, cross(edge_across(A, nearest.n), edge_across(B, nearest.n)), plane);
    return plane;
}

}  // namespace

ShapeEntry cast_on_shape(const PlacedShape& moving, const Vector& way, const PlacedShape& other, scalar fraction_max) {
    constexpr ShapeEntry missed = {false, 1, {}, {}};
    const scalar gap = gap_of(moving, way, other);
    PlacedShape A = moving, B = other;
    B.r = {};  // all is seen from B: what is far from the origin loses nothing more
    const Vector begin = moving.r - other.r;
    ShapeEntry entry = {true, 0, {}, way * (-1 / sqrt(length_sq(way)))};
    for (int iteration = 0; iteration < limits::cast_iterations_max; ++iteration) {
        A.r = begin + way * entry.fraction;
        const Nearest nearest = closest_points(A, B);
        entry.P = other.r + nearest.P_B;
        if (nearest.overlap) return entry;  // from the begin, or by a rounding: with the plane before it
        const PlaneBetween plane = plane_between(A, B, nearest);
        const scalar closing = -dot(plane.n, way), left = plane.gap - gap / 2;
        if (!(closing > 0)) return missed;  // the plane between them stays between them
        entry.n = plane.n;
        if (plane.gap <= gap) return entry;
        if (left > closing * (fraction_max - entry.fraction)) return missed;
        entry.fraction += left / closing;
    }
    return entry;
}

} }  // namespace ingot

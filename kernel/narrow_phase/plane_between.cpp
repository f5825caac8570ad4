// SPDX-License-Identifier: MIT
#include "plane_between.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

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
        // bound: 2 limits::hull_vertices_max - 4
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
    const scalar gap = gap_along(A, B, n);
    if (gap > best.gap) best = {n, gap};
}

/// All faces of a shape that look to the side of n.
void improve_by_faces(const PlacedShape& s, const PlacedShape& A, const PlacedShape& B, const Vector& n, PlaneBetween& plane) {
    if (s.shape.kind == ShapeKind::box || s.shape.kind == ShapeKind::cylinder) improve(A, B, s.A.c2, plane);
    if (s.shape.kind == ShapeKind::box) {
        improve(A, B, s.A.c0, plane);
        improve(A, B, s.A.c1, plane);
    }
    if (s.shape.kind != ShapeKind::hull) return;
    const Vector u = transpose_times(s.A, n);
    // bound: 2 limits::hull_vertices_max - 4
    for (int face_i = 0; face_i < s.hull->face_count; ++face_i)
        if (dot(s.hull->faces[face_i].n, u) > 0) improve(A, B, s.A * s.hull->faces[face_i].n, plane);
}

}  // namespace

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

scalar gap_along(const PlacedShape& A, const PlacedShape& B, const Vector& n) {
    if (B.shape.kind == ShapeKind::half_space) return dot(n, support_point(A, -n) - B.r) - B.shape.offset;
    return dot(n, support_point(A, -n) - support_point(B, n));
}

PlaneBetween plane_along(const PlacedShape& A, const PlacedShape& B, const Vector& n) {
    PlaneBetween plane = {n, gap_along(A, B, n)};
    if (B.shape.kind == ShapeKind::half_space) return plane;
    improve_by_faces(B, A, B, n, plane);
    improve_by_faces(A, A, B, -n, plane);
    improve(A, B, cross(edge_across(A, n), edge_across(B, n)), plane);
    return plane;
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#include "moved_manifold.h"

#include "../base/limits.h"
#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// The part of `out` across an axis, as a unit vector; 0 where there is none.
Vector out_across(const Vector& axis, const Vector& out) {
    const Vector part = out - axis * dot(axis, out);
    const scalar size_sq = length_sq(part);
    return size_sq > 0 ? part * (1 / sqrt(size_sq)) : Vector{};
}

bool is_along(const Vector& axis, const Vector& n) { return abs(dot(axis, n)) > 1 - limits::along_normal; }

/// Whether n is the normal of a face of a shape. Of a hull it may be: those meet along edges as well, but mostly they do not.
bool has_face(const PlacedShape& of, const Vector& n) {
    switch (of.shape.kind) {
        case ShapeKind::half_space:
        case ShapeKind::level:
        case ShapeKind::hull: return true;
        case ShapeKind::box: return is_along(of.A.c0, n) || is_along(of.A.c1, n) || is_along(of.A.c2, n);
        case ShapeKind::cylinder: return is_along(of.A.c2, n);
        default: return false;
    }
}

enum class NormalOf { A, B, none };

scalar trace(const Matrix& turn) { return turn.c0.x + turn.c1.y + turn.c2.z; }

/// Where both have a face there, a hull's may be none; of others that counts which turns less: a box that tumbles lands on the floor, not the floor
/// on it.
NormalOf owner_of(const Manifold& found, const MovedBody& A, const MovedBody& B) {
    const bool of_A = has_face(A.shape, found.n), of_B = has_face(B.shape, found.n);
    if (!of_A || !of_B) return of_A ? NormalOf::A : of_B ? NormalOf::B : NormalOf::none;
    const bool hull_A = A.shape.shape.kind == ShapeKind::hull, hull_B = B.shape.shape.kind == ShapeKind::hull;
    if (hull_A != hull_B) return hull_A ? NormalOf::B : NormalOf::A;
    return trace(A.turn) > trace(B.turn) ? NormalOf::A : NormalOf::B;
}

/// A point on the surface of a body, from its core.
struct SurfacePoint {
    Vector core;        ///< m, as the manifold was found
    scalar ball, disc;  ///< m, how far the surface is from it along out, and along the part of out across the axis

    /// How far the surface has moved, m, whose outward normal there was out_then. Without coordinates of the world, whose roundings separations would
    /// feel.
    Vector moved(const MovedBody& body, const Vector& out_then, const Vector& out) const {
        const Vector by = body.displaced(core) + (out - out_then) * ball;
        if (!(disc > 0)) return by;
        const Vector axis = body.shape.A.c2;
        return by + (out_across(body.turn * axis, out) - out_across(axis, out_then)) * disc;
    }
};
SurfacePoint surface_point(const MovedBody& body, const Vector& P, const Vector& out) {
    const PlacedShape& of = body.shape;
    const scalar radius = of.shape.size.x;
    if (of.shape.kind == ShapeKind::sphere || of.shape.kind == ShapeKind::capsule) return {P - out * radius, radius, 0};
    if (of.shape.kind == ShapeKind::cylinder) {
        const Vector round = out_across(of.A.c2, out) * radius, from_axis = P - of.r - of.A.c2 * dot(of.A.c2, P - of.r), aside = from_axis - round;
        if (length_sq(aside) < limits::on_rim * limits::on_rim * radius * radius) return {P - round, 0, radius};
    }
    return {P, 0, 0};
}

/// A point of the manifold on both bodies.
struct PairPoint {
    SurfacePoint on_A, on_B;
};
PairPoint pair_point(const Manifold& found, int point_i, const MovedBody& A, const MovedBody& B) {
    const ManifoldPoint& point = found.points[point_i];
    const Vector half_gap = found.n * (point.separation * scalar(0.5));
    return {surface_point(A, point.P + half_gap, -found.n), surface_point(B, point.P - half_gap, found.n)};
}

Vector normal_now(const Manifold& found, const MovedBody& A, const MovedBody& B, NormalOf owner) {
    if (owner == NormalOf::B) return B.turn * found.n;
    if (owner == NormalOf::A) return A.turn * found.n;
    if (found.count != 1) return found.n;
    const auto [on_A, on_B] = pair_point(found, 0, A, B);
    const bool is_between_balls = on_A.ball + on_B.ball > 0 && on_A.disc + on_B.disc == 0;
    const scalar apart = found.points[0].separation + on_A.ball + on_B.ball;
    const Vector between = found.n * apart + (A.displaced(on_A.core) - B.displaced(on_B.core));
    return is_between_balls && dot(between, found.n) > 0 ? between * (1 / sqrt(length_sq(between))) : found.n;
}

}  // namespace

Manifold moved_manifold(const Manifold& found, const MovedBody& A, const MovedBody& B) {
    Manifold now = found;
    const NormalOf owner = owner_of(found, A, B);
    now.n = normal_now(found, A, B, owner);
    for (int i = 0; i < found.count; ++i) {  // bound: 4: Manifold::points_max
        const ManifoldPoint& then = found.points[i];
        const auto [on_A, on_B] = pair_point(found, i, A, B);
        const Vector of_A = on_A.moved(A, -found.n, -now.n), of_B = on_B.moved(B, found.n, now.n);
        const scalar s = then.separation * dot(found.n, now.n) + dot(now.n, of_A - of_B);
        now.points[i].separation = s;
        // A point may move along the face that the normal is of: it is where the other body is.
        const Vector half_then = found.n * (then.separation * scalar(0.5)), half_gap = now.n * (s * scalar(0.5));
        const Vector P_A = then.P + half_then + of_A - half_gap, P_B = then.P - half_then + of_B + half_gap;
        now.points[i].P = owner == NormalOf::B ? P_A : owner == NormalOf::A ? P_B : (P_A + P_B) * scalar(0.5);
    }
    return now;
}

} }  // namespace ingot

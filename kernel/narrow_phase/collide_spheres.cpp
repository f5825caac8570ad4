// SPDX-License-Identifier: MIT
// A ball against what has a nearest point in closed form.
#include "contact_geometry.h"
#include "collide_pairs.h"

namespace ingot { inline namespace INGOT_ABI {

void collide_sphere_sphere(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold*) {
    ball_on_ball(A.r, A.shape.size.x, B.r, B.shape.size.x, margin, manifold);
}

void collide_sphere_capsule(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold*) {
    const scalar radius_B = B.shape.size.x, reach = A.shape.size.x + radius_B, along = dot(A.r - B.r, B.A.c2);
    const Vector q = B.A.c2 * clamp(along, B.shape.size.y), d = (A.r - B.r) - q;
    const scalar distance = sqrt(length_sq(d));
    const Vector n = distance > epsilon * (reach + B.shape.size.y) ? d * (1 / distance) : B.A.c0;
    round_point(n, B.r + q, distance, reach, radius_B, margin, manifold);
}

void collide_sphere_box(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold*) {
    const scalar radius = A.shape.size.x;
    const Vector &h = B.shape.size, c = transpose_times(B.A, A.r - B.r), q = clamp(c, h), d = c - q;
    const scalar distance = sqrt(length_sq(d));
    if (distance > 4 * epsilon * (abs(c.x) + abs(c.y) + abs(c.z))) {
        round_point(B.A * (d * (1 / distance)), B.r + B.A * q, distance, radius, 0, margin, manifold);
        return;
    }
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (component(h, i) - abs(component(c, i)) < component(h, axis) - abs(component(c, axis))) axis = i;
    const scalar depth = component(h, axis) - abs(component(c, axis));
    const Vector n = B.A * unit_axis(axis, component(c, axis) < 0 ? scalar(-1) : scalar(1));
    round_point(n, A.r + n * depth, -depth, radius, 0, margin, manifold);
}

void collide_sphere_cylinder(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold*) {
    const scalar radius = A.shape.size.x, r = B.shape.size.x, h = B.shape.size.y;
    const Vector c = transpose_times(B.A, A.r - B.r);
    const scalar rho = sqrt(c.x * c.x + c.y * c.y);
    const bool has_side = rho > epsilon * r;
    const Vector outward = has_side ? Vector{c.x / rho, c.y / rho, 0} : Vector{1, 0, 0};
    const Vector q = outward * (rho < r ? rho : r) + Vector{0, 0, clamp(c.z, h)}, d = c - q;
    const scalar distance = sqrt(length_sq(d));
    if (distance > 8 * epsilon * (rho + abs(c.z) + r)) {
        round_point(B.A * (d * (1 / distance)), B.r + B.A * q, distance, radius, 0, margin, manifold);
        return;
    }
    const scalar to_side = r - rho, to_end = h - abs(c.z), depth = to_side < to_end ? to_side : to_end;
    const Vector n = B.A * (to_side < to_end ? outward : Vector{0, 0, c.z < 0 ? scalar(-1) : scalar(1)});
    round_point(n, A.r + n * depth, -depth, radius, 0, margin, manifold);
}

void collide_sphere_half_space(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold*) {
    const HeightAbove face = face_below(B, A.r);
    round_point(face.n, A.r - face.n * face.height, face.height, A.shape.size.x, 0, margin, manifold);
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#include "ray_on_shapes.h"

#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

constexpr RayEntry ray_misses = {false, 1, {}};
constexpr RayEntry ray_begins_inside = {true, 0, {}};

/// The stretch of a ray that is inside of everything it was cut by, and the normal of what it entered last.
struct Stretch {
    scalar enter, leave;  ///< fractions
    Vector n;
    bool inside;  ///< the ray begins inside of everything so far

    /// Cuts to the side of a plane: `height` above it at the begin, `rise` over the ray; n is its outward normal.
    /// What rises by less than the rounding of the ray is taken for parallel.
    void cut(scalar height, scalar rise, scalar size, const Vector& normal) {
        if (height > 0) inside = false;
        if (abs(rise) <= epsilon * size * scalar(0.0625)) {
            if (height > 0) leave = -1;
            return;
        }
        const scalar at = -height / rise;
        if (rise < 0) {
            if (at > enter) {
                enter = at;
                n = normal;
            }
        } else if (at < leave) {
            leave = at;
        }
    }
    RayEntry entry() const {
        if (inside) return ray_begins_inside;
        return enter >= 0 && enter <= leave && enter <= 1 ? RayEntry{true, enter, n} : ray_misses;
    }
};

constexpr Stretch whole_line = {-scalar_max, scalar_max, {}, true};

scalar length_of_ray(const Vector& d) { return abs(d.x) + abs(d.y) + abs(d.z); }

/// A ball of the radius about the origin. By way of the point nearest to it: a long ray loses no digits.
RayEntry ray_on_ball(scalar radius, const LocalRay& ray) {
    if (length_sq(ray.o) <= radius * radius) return ray_begins_inside;
    const scalar along = -dot(ray.o, ray.d), d_sq = length_sq(ray.d);
    if (!(along > 0)) return ray_misses;
    const scalar nearest = along / d_sq;
    const Vector p = ray.o + ray.d * nearest;
    const scalar half_chord_sq = radius * radius - length_sq(p);
    if (!(half_chord_sq >= 0)) return ray_misses;
    const scalar back = sqrt(half_chord_sq / d_sq), fraction = nearest - back;
    if (!(fraction <= 1)) return ray_misses;
    const Vector x = p - ray.d * back;
    return {true, fraction > 0 ? fraction : 0, x * (1 / sqrt(length_sq(x)))};
}

/// The ray seen along z, against a circle of the radius about the origin.
struct CircleEntry {
    bool crosses, parallel;
    scalar enter, leave;
};
CircleEntry ray_on_circle(scalar radius, const LocalRay& ray) {
    const scalar d_sq = ray.d.x * ray.d.x + ray.d.y * ray.d.y, o_sq = ray.o.x * ray.o.x + ray.o.y * ray.o.y;
    const scalar least_d = epsilon * length_of_ray(ray.d) * scalar(0.0625);
    if (d_sq <= least_d * least_d) return {o_sq <= radius * radius, true, 0, 0};
    const scalar nearest = -(ray.o.x * ray.d.x + ray.o.y * ray.d.y) / d_sq;
    const scalar x = ray.o.x + ray.d.x * nearest, y = ray.o.y + ray.d.y * nearest;
    const scalar half_chord_sq = radius * radius - (x * x + y * y);
    if (!(half_chord_sq >= 0)) return {false, false, 0, 0};
    const scalar half = sqrt(half_chord_sq / d_sq);
    return {true, false, nearest - half, nearest + half};
}

/// Outward from the z axis at a fraction of the ray.
Vector outward_at(const LocalRay& ray, scalar fraction) {
    const scalar x = ray.o.x + ray.d.x * fraction, y = ray.o.y + ray.d.y * fraction, length = sqrt(x * x + y * y);
    return length > 0 ? Vector{x / length, y / length, 0} : Vector{1, 0, 0};
}

}  // namespace

RayEntry ray_on_sphere(const Shape& sphere, const LocalRay& ray) { return ray_on_ball(sphere.size.x, ray); }

RayEntry ray_on_capsule(const Shape& capsule, const LocalRay& ray) {
    const scalar radius = capsule.size.x, half_length = capsule.size.y;
    const CircleEntry side = ray_on_circle(radius, ray);
    if (!side.crosses) return ray_misses;
    // Where it comes into the endless cylinder, or begins in it: beside the straight part it has met that, beyond it meets an end.
    const scalar enter = side.parallel || side.enter < 0 ? 0 : side.enter, z = ray.o.z + ray.d.z * enter;
    if (abs(z) <= half_length) {
        if (side.parallel || side.enter < 0) return !side.parallel && side.leave < 0 ? ray_misses : ray_begins_inside;
        return side.enter <= 1 ? RayEntry{true, side.enter, outward_at(ray, side.enter)} : ray_misses;
    }
    return ray_on_ball(radius, {{ray.o.x, ray.o.y, z > 0 ? ray.o.z - half_length : ray.o.z + half_length}, ray.d});
}

RayEntry ray_on_box(const Shape& box, const LocalRay& ray) {
    const scalar size = length_of_ray(ray.d);
    const scalar o[3] = {ray.o.x, ray.o.y, ray.o.z}, d[3] = {ray.d.x, ray.d.y, ray.d.z}, h[3] = {box.size.x, box.size.y, box.size.z};
    Stretch stretch = whole_line;
    for (int axis = 0; axis < 3; ++axis) {
        const Vector n = {axis == 0 ? scalar(1) : 0, axis == 1 ? scalar(1) : 0, axis == 2 ? scalar(1) : 0};
        stretch.cut(o[axis] - h[axis], d[axis], size, n);
        stretch.cut(-o[axis] - h[axis], -d[axis], size, -n);
    }
    return stretch.entry();
}

RayEntry ray_on_cylinder(const Shape& cylinder, const LocalRay& ray) {
    const CircleEntry side = ray_on_circle(cylinder.size.x, ray);
    if (!side.crosses) return ray_misses;
    Stretch stretch = whole_line;
    if (!side.parallel) {
        stretch = {side.enter, side.leave, outward_at(ray, side.enter), side.enter <= 0 && side.leave >= 0};
    }
    stretch.cut(ray.o.z - cylinder.size.y, ray.d.z, length_of_ray(ray.d), {0, 0, 1});
    stretch.cut(-ray.o.z - cylinder.size.y, -ray.d.z, length_of_ray(ray.d), {0, 0, -1});
    return stretch.entry();
}

RayEntry ray_on_half_space(const Shape& half_space, const LocalRay& ray) {
    const scalar height = dot(half_space.size, ray.o) - half_space.offset, fall = -dot(half_space.size, ray.d);
    if (height <= 0) return ray_begins_inside;
    return fall >= height ? RayEntry{true, height / fall, half_space.size} : ray_misses;
}

RayEntry ray_on_hull(const ConvexHull& hull, const LocalRay& ray) {
    Stretch stretch = whole_line;
    // bound: 2 limits::hull_vertices_max - 4
    for (int face_i = 0; face_i < hull.face_count; ++face_i) {
        const HullFace& face = hull.faces[face_i];
        stretch.cut(dot(face.n, ray.o) - face.offset, dot(face.n, ray.d), length_of_ray(ray.d), face.n);
    }
    return stretch.entry();
}

} }  // namespace ingot

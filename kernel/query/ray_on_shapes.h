// SPDX-License-Identifier: MIT
// A ray against one shape: a closed form each. A new kind of shape is one more function, and one more line in cast_ray.h.
#pragma once

#include "../shape/placed_shape.h"

namespace ingot { inline namespace INGOT_ABI {

/// A ray in the frame of the shape: from o, by d, which is no shorter than limits::size_min.
struct LocalRay {
    Vector o, d;  ///< m
};

/// Where a ray enters a shape, in the frame of the shape.
struct RayEntry {
    bool meets;
    scalar fraction;  ///< of d, 0 .. 1; 0 where it begins inside or on the surface
    Vector n;         ///< unit, outward; zero where it begins inside
};

// Accuracy: fractions carry a few roundings of 1 and of (|o| + size) / |d|; a ray that grazes may be told to miss by as much.
// Errors:   none; what is not finite meets nothing, or gives what is not finite.

RayEntry ray_on_sphere(const Shape& sphere, const LocalRay& ray);
RayEntry ray_on_capsule(const Shape& capsule, const LocalRay& ray);
RayEntry ray_on_box(const Shape& box, const LocalRay& ray);
RayEntry ray_on_cylinder(const Shape& cylinder, const LocalRay& ray);
RayEntry ray_on_half_space(const Shape& half_space, const LocalRay& ray);
/// Cost: one face after another.
RayEntry ray_on_hull(const ConvexHull& hull, const LocalRay& ray);

} }  // namespace ingot

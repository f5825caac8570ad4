// SPDX-License-Identifier: MIT
#include "shapes.h"

#include "convex_hull.h"

namespace ingot { inline namespace INGOT_ABI {

scalar bounding_radius(const Shape& shape) {
    if (shape.kind == ShapeKind::sphere || shape.kind == ShapeKind::hull) return shape.size.x;
    if (shape.kind == ShapeKind::box || shape.kind == ShapeKind::level) return sqrt(length_sq(shape.size));
    if (shape.kind == ShapeKind::capsule) return shape.size.x + shape.size.y;
    if (shape.kind == ShapeKind::cylinder) return sqrt(shape.size.x * shape.size.x + shape.size.y * shape.size.y);
    return 0;
}

scalar least_half_extent(const Shape& shape, const ConvexHull* hull) {
    const Vector& size = shape.size;
    switch (shape.kind) {
        case ShapeKind::sphere:
        case ShapeKind::capsule: return size.x;
        case ShapeKind::cylinder: return min(size.x, size.y);
        case ShapeKind::box: return min(size.x, min(size.y, size.z));
        case ShapeKind::hull: return hull->inner_radius;
        default: return limits::unbounded;
    }
}

namespace {

bool is_size(scalar length) { return length >= limits::size_min && length <= limits::size_max; }

}  // namespace

Status check_shape(const Shape& shape) {
    if (!is_finite(shape.size) || !is_finite(shape.offset)) return Status::not_finite;
    switch (shape.kind) {
        case ShapeKind::level:  // see World::add_level
        case ShapeKind::none: return Status::ok;
        case ShapeKind::sphere:
        case ShapeKind::hull: return is_size(shape.size.x) ? Status::ok : Status::bad_shape;
        case ShapeKind::box:
            return is_size(shape.size.x) && is_size(shape.size.y) && is_size(shape.size.z) ? Status::ok : Status::bad_shape;
        case ShapeKind::capsule:
        case ShapeKind::cylinder:
            return is_size(shape.size.x) && is_size(shape.size.y) ? Status::ok : Status::bad_shape;
        case ShapeKind::half_space:
            if (abs(length_sq(shape.size) - 1) > limits::unit_length) return Status::bad_direction;
            return abs(shape.offset) <= limits::position_max ? Status::ok : Status::out_of_range;
    }
    return Status::bad_shape;
}

} }  // namespace ingot

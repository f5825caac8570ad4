// SPDX-License-Identifier: MIT
#include "check_query.h"

#include "../body/check_body.h"

namespace ingot { inline namespace INGOT_ABI {

Status check_way(const Vector& from, const Vector& way) {
    Status status = check_vector(from, limits::position_max);
    if (status == Status::ok) status = check_vector(way, 2 * limits::position_max);
    if (status == Status::ok) status = check_vector(from + way, limits::position_max);
    if (status != Status::ok) return status;
    return length_sq(way) >= limits::size_min * limits::size_min ? Status::ok : Status::bad_direction;
}

Status check_query_shape(const PlacedShape& shape) {
    const ShapeKind kind = shape.shape.kind;
    if (kind == ShapeKind::none || is_ground(kind)) return Status::bad_shape;
    if (kind == ShapeKind::hull && shape.hull == nullptr) return Status::bad_shape;
    Status status = check_shape(shape.shape);
    if (status == Status::ok) status = check_vector(shape.r, limits::position_max);
    return status == Status::ok ? check_rotation(shape.A) : status;
}

} }  // namespace ingot

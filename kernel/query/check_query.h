// SPDX-License-Identifier: MIT
// The door of the queries.
#pragma once

#include "../base/status.h"
#include "../shape/placed_shape.h"

namespace ingot { inline namespace INGOT_ABI {

/// Errors: not_finite, out_of_range (begin or end beyond limits::position_max), bad_direction (a way shorter than limits::size_min).
Status check_way(const Vector& from, const Vector& way);

/// Errors: those of check_shape and check_rotation, bad_shape (none, a half space, a hull without its form), out_of_range.
Status check_query_shape(const PlacedShape& shape);

} }  // namespace ingot

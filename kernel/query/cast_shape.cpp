// SPDX-License-Identifier: MIT
#include "cast_shape.h"

#include "../narrow_phase/plane_between.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

scalar extent_of(const Vector& v) { return abs(v.x) + abs(v.y) + abs(v.z); }

/// The gap that is as good as none.
scalar gap_of(const PlacedShape& moving, const Vector& way, const PlacedShape& B) {
    const scalar R = bounding_radius(moving.shape), R_B = B.shape.kind == ShapeKind::half_space ? R : bounding_radius(B.shape);
    return limits::cast_gap * (R < R_B ? R : R_B) + 4 * epsilon * (extent_of(moving.r - B.r) + extent_of(moving.r) + extent_of(way) + R + R_B);
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
        const scalar closing = -dot(plane.n, way);
        if (!(closing > 0)) return missed;  // the plane between them stays between them
        entry.n = plane.n;
        if (plane.gap <= gap) return entry;
        const scalar further = plane.gap - gap / 2;
        if (further > closing) return missed;  // beyond the end; and no quotient is too large for a scalar
        entry.fraction += further / closing;
        // Fractions do not fall: what is met by the last of them is met wherever fraction_max lies beyond it.
        if (entry.fraction > fraction_max) return missed;
    }
    return entry;
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#include "parting_plane.h"

#include "../base/limits.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// The shape without a skin of this part of its least half extent. A hull shrinks about its centre.
PlacedShape without_skin(const PlacedShape& s, scalar least, scalar part) {
    const scalar skin = least * part;
    const Vector& size = s.shape.size;
    switch (s.shape.kind) {
        case ShapeKind::box: return {{s.shape.kind, size - Vector{skin, skin, skin}, 0}, s.r, s.A, nullptr};
        case ShapeKind::cylinder: return {{s.shape.kind, {size.x - skin, size.y - skin, 0}, 0}, s.r, s.A, nullptr};
        case ShapeKind::hull: return {s.shape, s.r + s.A * s.hull->centre * part, s.A * (1 - part), s.hull};
        default: return {{s.shape.kind, {size.x - skin, size.y, 0}, 0}, s.r, s.A, nullptr};  // what has a radius
    }
}

PlacedShape ball_in(const PlacedShape& s, scalar radius) {
    return {Sphere{radius}, s.hull == nullptr ? s.r : s.r + s.A * s.hull->centre, s.A, nullptr};
}

}  // namespace

PartingPlane parting_plane(const PlacedShape& A, const PlacedShape& B, const Nearest& nearest) {
    // Rounding may end the search a little outside of what it is inside of: nothing parts them then.
    if (!nearest.overlap && nearest.at_least > 0) return {plane_between(A, B, nearest), true};
    if (B.shape.kind == ShapeKind::half_space) return {plane_along(A, B, B.A * B.shape.size), true};
    const scalar least = least_half_extent(A.shape, A.hull);
    constexpr scalar skins[] = {scalar(0.25), scalar(0.5), scalar(0.9)};
    for (const scalar part : skins) {
        const Nearest of_core = closest_points(without_skin(A, least, part), B);
        if (!of_core.overlap) return {plane_along(A, B, of_core.n), true};
    }
    const Nearest of_middle = closest_points(ball_in(A, least * scalar(0.25)), B);
    if (of_middle.overlap) return {{}, false};
    return {plane_along(A, B, of_middle.n), true};
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// How a box is put around one shape. Two stages share it: one bounds all shapes, the other those of bodies that are awake.
#pragma once

#include "body_bounds.h"

#include "../base/limits.h"
#include "../body/auxiliary.h"
#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI { namespace bounding {

INGOT_INLINE Vector absolute(const Vector& v) { return {abs(v.x), abs(v.y), abs(v.z)}; }

/// Half extents along the world axes. only_balls: it is the shape of a ball.
template <bool only_balls = false>
INGOT_INLINE Vector reach_of(const Surface& surface, const Matrix& A) {
    const Vector& size = surface.shape.size;
    const scalar R = size.x;  // of a ball, or of the ball around a hull
    if constexpr (only_balls) return {R, R, R};
    switch (surface.shape.kind) {
        case ShapeKind::level:
        case ShapeKind::box: return absolute(A.c0) * size.x + absolute(A.c1) * size.y + absolute(A.c2) * size.z;
        case ShapeKind::capsule: return absolute(A.c2) * size.y + Vector{size.x, size.x, size.x};
        case ShapeKind::cylinder: {
            const auto across = [](scalar c) { return sqrt(c * c < 1 ? 1 - c * c : scalar(0)); };
            return absolute(A.c2) * size.y + Vector{across(A.c2.x), across(A.c2.y), across(A.c2.z)} * size.x;
        }
        default: return {R, R, R};
    }
}

INGOT_INLINE void set_bounds(BoundsTile& bounds, int lane_i, const Vector& low, const Vector& high) {
    set_lane(bounds.low, lane_i, low);
    set_lane(bounds.high, lane_i, high);
}

inline constexpr Vector everywhere = {limits::unbounded, limits::unbounded, limits::unbounded};
inline constexpr Vector nowhere = everywhere * scalar(2);  ///< empty bounds begin there: not even a half space reaches them

/// A half space whose face lies along two of the axes, to the bit, ends there; any other is everywhere. It never moves.
INGOT_INLINE void bound_half_space(const BodyView& bodies, const Surface& surface, Place at, scalar unit, BoundsTile& tile) {
    set_bounds(tile, at.lane, -everywhere, everywhere);
    tile.spin_reach[at.lane] = 0;  // what was in the slot before may have spun
    const Vector n = lane_of(bodies.rotation[at.tile].A, at.lane) * surface.shape.size, r = lane_of(bodies.translation[at.tile].r_CM, at.lane);
    const scalar n_of[3] = {n.x, n.y, n.z}, r_of[3] = {r.x, r.y, r.z}, offset = surface.shape.offset;
    for (int axis = 0; axis < 3; ++axis) {
        const scalar along = n_of[axis], place = r_of[axis];
        if (abs(along) != 1 || n_of[(axis + 1) % 3] != 0 || n_of[(axis + 2) % 3] != 0) continue;
        const scalar slack = limits::contact_margin / 2 * unit + 4 * epsilon * (abs(place) + abs(offset));
        if (along > 0)
            tile.high[axis][at.lane] = place + offset + slack;
        else
            tile.low[axis][at.lane] = place - offset - slack;
    }
}

/// The box of one shape, and what its spin adds. only_balls: besides half spaces, there are no others.
template <bool only_balls = false>
INGOT_INLINE void bound(const BodyView& bodies, const SurfaceView& surfaces, Place at, scalar h, BoundsTile& tile) {
    const Surface& surface = surfaces.surfaces[at.tile * lanes + at.lane];
    if (surface.shape.kind == ShapeKind::none) return set_bounds(tile, at.lane, nowhere, -nowhere);
    if (surface.shape.kind == ShapeKind::half_space) return bound_half_space(bodies, surface, at, surfaces.unit, tile);
    const Vector r = lane_of(bodies.translation[at.tile].r_CM, at.lane), v = lane_of(bodies.translation[at.tile].v_CM, at.lane);
    const scalar turn = sqrt(length_sq(omega_of(bodies, at.tile * lanes + at.lane))) * h;
    const scalar spin_reach = (turn < 2 ? turn : scalar(2)) * surface.bounding_radius;  // no point is further from where it was than the diameter
    tile.spin_reach[at.lane] = spin_reach;
    const scalar more = margin_at(scale_of(surfaces.unit, surface.halvings), surfaces.unit, surfaces.fall) / 2 + spin_reach;
    const Matrix A = lane_of(bodies.rotation[at.tile].A, at.lane);
    const Vector reach = reach_of<only_balls>(surface, A) * (1 + limits::flatness) + Vector{more, more, more};
    const Vector travel = absolute(v) * h;
    set_bounds(tile, at.lane, r - reach - travel, r + reach + travel);
}

/// Bounds of a tile of shapes.
template <bool only_balls = false>
INGOT_INLINE void bound_tile(const BodyView& bodies, const SurfaceView& surfaces, int tile_i, scalar h, BoundsTile& tile) {
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        const int slot = tile_i * lanes + lane_i;
        if (slot < surfaces.slot_count)
            bound<only_balls>(bodies, surfaces, {tile_i, lane_i}, h, tile);
        else
            set_bounds(tile, lane_i, nowhere, -nowhere);
    }
}
/// The lanes that have left their fat AABBs.
INGOT_INLINE mask left_bounds(const BoundsTile& tile) {
    mask left = splat<lane>(1) < lane{};
    for (int axis = 0; axis < 3; ++axis) {
        left = either(left, load(tile.low[axis]) < load(tile.fat_low[axis]));
        left = either(left, load(tile.fat_high[axis]) < load(tile.high[axis]));
    }
    return left;
}

/// Of the box's extent, so it fits bodies of every size. It costs some pairs that do not touch, and saves most searches.
inline constexpr scalar skin_share = scalar(0.1);

} } }  // namespace ingot::bounding

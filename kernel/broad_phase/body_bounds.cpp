// SPDX-License-Identifier: MIT
#include "body_bounds.h"

#include "../base/limits.h"
#include "../body/auxiliary.h"
#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

Vector absolute(const Vector& v) { return {abs(v.x), abs(v.y), abs(v.z)}; }

/// Half extents along the world axes.
Vector reach_of(const Surface& surface, const Matrix& A) {
    const Vector& size = surface.shape.size;
    const scalar R = size.x;  // of a ball, and of that which holds a hull
    switch (surface.shape.kind) {
        case ShapeKind::box: return absolute(A.c0) * size.x + absolute(A.c1) * size.y + absolute(A.c2) * size.z;
        case ShapeKind::capsule: return absolute(A.c2) * size.y + Vector{size.x, size.x, size.x};
        case ShapeKind::cylinder: {
            const auto across = [](scalar c) { return sqrt(c * c < 1 ? 1 - c * c : scalar(0)); };
            return absolute(A.c2) * size.y + Vector{across(A.c2.x), across(A.c2.y), across(A.c2.z)} * size.x;
        }
        default: return {R, R, R};
    }
}

void set_bounds(BoundsTile& bounds, int lane_i, const Vector& low, const Vector& high) {
    set_lane(bounds.low, lane_i, low);
    set_lane(bounds.high, lane_i, high);
}

constexpr Vector everywhere = {limits::unbounded, limits::unbounded, limits::unbounded};
constexpr Vector nowhere = everywhere * scalar(2);  ///< empty bounds begin there; so that not even a half space overlaps them

/// A half space whose face lies along two of the axes ends there; any other is everywhere. It never moves.
void bound_half_space(const BodyView& bodies, const Surface& surface, Place at, BoundsTile& tile) {
    set_bounds(tile, at.lane, -everywhere, everywhere);
    tile.spin_reach[at.lane] = 0;  // what was in the slot before may have spun
    const Vector n = lane_of(bodies.rotation[at.tile].A, at.lane) * surface.shape.size, r = lane_of(bodies.translation[at.tile].r_CM, at.lane);
    const scalar n_of[3] = {n.x, n.y, n.z}, r_of[3] = {r.x, r.y, r.z}, offset = surface.shape.offset;
    for (int axis = 0; axis < 3; ++axis) {
        const scalar along = n_of[axis], place = r_of[axis];
        if (abs(along) != 1 || length_sq(n) != 1) continue;
        const scalar slack = limits::contact_margin / 2 + 4 * epsilon * (abs(place) + abs(offset));
        if (along > 0)
            tile.high[axis][at.lane] = place + offset + slack;
        else
            tile.low[axis][at.lane] = place - offset - slack;
    }
}

void bound(const BodyView& bodies, const Surface& surface, Place at, scalar h, BoundsTile& tile) {
    if (surface.shape.kind == ShapeKind::none) return set_bounds(tile, at.lane, nowhere, -nowhere);
    if (surface.shape.kind == ShapeKind::half_space) return bound_half_space(bodies, surface, at, tile);
    const Vector r = lane_of(bodies.translation[at.tile].r_CM, at.lane), v = lane_of(bodies.translation[at.tile].v_CM, at.lane);
    const scalar turn = sqrt(length_sq(omega_of(bodies, at.tile * lanes + at.lane))) * h;
    const scalar spin_reach = (turn < 2 ? turn : scalar(2)) * surface.bounding_radius;  // no point is further from where it was than the diameter
    tile.spin_reach[at.lane] = spin_reach;
    const scalar more = limits::contact_margin / 2 + spin_reach;
    const Vector reach = reach_of(surface, lane_of(bodies.rotation[at.tile].A, at.lane)) * (1 + limits::flatness) + Vector{more, more, more};
    const Vector travel = absolute(v) * h;
    set_bounds(tile, at.lane, r - reach - travel, r + reach + travel);
}

/// The skin is a tenth of the box, so that it fits bodies of every size; what cannot move needs none. It costs some pairs that do not touch and
/// saves most searches.
INGOT_INLINE void widen(BoundsTile& tile, lane inv_M) {
    const lane tenth = select(inv_M > lane{}, splat<lane>(scalar(0.1)), lane{});
    for (int axis = 0; axis < 3; ++axis) {
        const lane low = load(tile.low[axis]), high = load(tile.high[axis]), skin = max((high - low) * tenth, lane{});
        store(tile.fat_low[axis], low - skin);
        store(tile.fat_high[axis], high + skin);
    }
}

}  // namespace

void invalidate_bounds(BoundsTile* bounds, int slot) {
    const Place at = place_of(slot);
    set_lane(bounds[at.tile].fat_low, at.lane, nowhere);
    set_lane(bounds[at.tile].fat_high, at.lane, -nowhere);
}

bool refresh_bounds(const BodyView& bodies, const SurfaceView& surfaces, scalar h, BoundsTile* bounds) {
    mask left = splat<lane>(1) < lane{};
    // bound: max_bodies max_shapes_of_body / lanes, rounded up: the view of all shapes
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {
        BoundsTile& tile = bounds[tile_i];
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            const int slot = tile_i * lanes + lane_i;
            if (slot < surfaces.slot_count)
                bound(bodies, surfaces.surfaces[slot], {tile_i, lane_i}, h, tile);
            else
                set_bounds(tile, lane_i, nowhere, -nowhere);
        }
        for (int axis = 0; axis < 3; ++axis) {
            left = either(left, load(tile.low[axis]) < load(tile.fat_low[axis]));
            left = either(left, load(tile.fat_high[axis]) < load(tile.high[axis]));
        }
    }
    if (!any(left)) return false;
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) widen(bounds[tile_i], load(bodies.translation[tile_i].inv_M));
    return true;
}

void fatten_bounds(const BodyView& bodies, BoundsTile* bounds) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) widen(bounds[tile_i], load(bodies.translation[tile_i].inv_M));
}

void shrink_bounds(const BodyView& bodies, BoundsTile* bounds) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {
        BoundsTile& tile = bounds[tile_i];
        __builtin_memcpy(tile.fat_low, tile.low, sizeof tile.low);
        __builtin_memcpy(tile.fat_high, tile.high, sizeof tile.high);
    }
}

} }  // namespace ingot

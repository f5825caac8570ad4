// SPDX-License-Identifier: MIT
#include "body_bounds.h"

#include "../base/limits.h"
#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

Vector absolute(const Vector& v) { return {abs(v.x), abs(v.y), abs(v.z)}; }

/// Half extents along the world axes.
Vector reach_of(const Surface& surface, const Matrix& A) {
    const Vector& size = surface.shape.size;
    const scalar R = surface.bounding_radius;
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

}  // namespace

void refresh_bounds(const BodyView& bodies, const SurfaceView& surfaces, scalar h, BoundsTile* bounds) {
    for (int slot = 0; slot < bodies.tile_count * lanes; ++slot) {
        const Place at = place_of(slot);
        BoundsTile& tile = bounds[at.tile];
        const ShapeKind kind = slot < surfaces.slot_count ? surfaces.surfaces[slot].shape.kind : ShapeKind::none;
        if (kind == ShapeKind::none) {
            set_bounds(tile, at.lane, everywhere, -everywhere);
            continue;
        }
        if (kind == ShapeKind::half_space) {
            set_bounds(tile, at.lane, -everywhere, everywhere);
            continue;
        }
        const Surface& surface = surfaces.surfaces[slot];
        const Vector r = lane_of(bodies.translation[at.tile].r_CM, at.lane), v = lane_of(bodies.translation[at.tile].v_CM, at.lane);
        const Vector omega = lane_of(bodies.rotation[at.tile].omega, at.lane);
        const scalar around = sqrt(length_sq(omega)) * surface.bounding_radius * h;
        // A slot's own rounding: the bounds are those of a place with few digits left far from the origin.
        const scalar more = limits::contact_margin / 2 + (around < 2 * surface.bounding_radius ? around : 2 * surface.bounding_radius);
        const Vector reach = reach_of(surface, lane_of(bodies.rotation[at.tile].A, at.lane)) * (1 + limits::flatness) + Vector{more, more, more};
        const Vector travel = absolute(v) * h;
        set_bounds(tile, at.lane, r - reach - travel, r + reach + travel);
    }
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// Which bodies a query has to look at closely: told by the balls that hold them, `lanes` at once.
#pragma once

#include "../base/limits.h"
#include "../body/body_tiles.h"
#include "../shape/placed_body.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// The balls of one tile: whose numbers count, and who is everywhere.
struct BallsOfTile {
    lane radius;
    unsigned there, everywhere;  ///< bit per lane
};

INGOT_INLINE BallsOfTile balls_of_tile(const SurfaceView& surfaces, int tile_i) {
    scalar radius[lanes];
    BallsOfTile balls{};
    for (int lane_i = 0; lane_i < lanes; ++lane_i) {
        const int slot = tile_i * lanes + lane_i;
        radius[lane_i] = 0;
        if (slot >= surfaces.slot_count) continue;
        const Surface& surface = surfaces.surfaces[slot];
        const ShapeKind kind = surface.shape.kind;
        radius[lane_i] = surface.bounding_radius;
        if (kind == ShapeKind::half_space)
            balls.everywhere |= 1u << lane_i;
        else if (kind != ShapeKind::none)
            balls.there |= 1u << lane_i;
    }
    balls.radius = load(radius);
    return balls;
}

/// A ball that moves: from `from` by `way`, and no further than `fraction` of it.
struct MovingBall {
    Vector from, way;
    scalar radius;
    scalar fraction;
    const PlacedShape* shape;  ///< what is in the ball; null: a point
};

/// Where a query looks: all shapes of a world.
struct EveryShape {
    BodyView bodies;
    SurfaceView surfaces;
};

/// The way of a moving ball, against other balls: one, or those of a tile.
struct WayOfBall {
    Vector way;
    scalar inv_way_sq, roundings;

    INGOT_INLINE explicit WayOfBall(const Vector& d)
        : way(d), inv_way_sq(length_sq(d) > 0 ? 1 / length_sq(d) : 0), roundings(8 * epsilon * (abs(d.x) + abs(d.y) + abs(d.z))) {}

    /// True where a ball of the radius about c, seen from the begin of the way, may be touched by the moving one.
    /// Reach is enlarged by limits::flatness and by the roundings of the distance, so that no body that is met is left out.
    template <class T>
    INGOT_INLINE auto may_touch(const Vec3<T>& c, const T& radius, const MovingBall& ball) const {
        const Vec3<T> d = {splat<T>(way.x), splat<T>(way.y), splat<T>(way.z)};
        const T t = min(max(dot(c, d) * splat<T>(inv_way_sq), T{}), splat<T>(ball.fraction));
        const T away_sq = length_sq(c - d * t);
        const T slack = (abs(c.x) + abs(c.y) + abs(c.z)) * splat<T>(8 * epsilon) + splat<T>(roundings);
        const T reach = (radius + splat<T>(ball.radius)) * splat<T>(1 + limits::flatness) + slack;
        return away_sq <= reach * reach;
    }
};

/// The same of a point that waits at the origin of c: which balls come within `distance` of it.
template <class T>
INGOT_INLINE auto may_come_within(const Vec3<T>& c, const T& radius, const scalar& distance) {
    const T slack = (abs(c.x) + abs(c.y) + abs(c.z)) * splat<T>(8 * epsilon);
    const T reach = radius * splat<T>(1 + limits::flatness) + splat<T>(distance) + slack;
    return both(reach >= T{}, length_sq(c) <= reach * reach);
}

INGOT_INLINE Vec3<lane> all_lanes_of(const Vector& v) { return {splat<lane>(v.x), splat<lane>(v.y), splat<lane>(v.z)}; }

/// Calls look(slot), in the order of slots, for every body whose ball the moving ball may touch. `look` may lower the fraction.
/// Cost: about 30 flops a body, `lanes` at once.
template <class Look>
INGOT_INLINE void look_along(const EveryShape& all, const MovingBall& ball, const Look& look) {
    const WayOfBall way(ball.way);
    // bound: max_bodies max_shapes_of_body / lanes, rounded up: the view of all shapes
    for (int tile_i = 0; tile_i < all.bodies.tile_count; ++tile_i) {
        const BallsOfTile balls = balls_of_tile(all.surfaces, tile_i);
        if ((balls.there | balls.everywhere) == 0) continue;
        const Vec3<lane> c = load(all.bodies.translation[tile_i].r_CM) - all_lanes_of(ball.from);
        unsigned found = (bits(way.may_touch(c, balls.radius, ball)) & balls.there) | balls.everywhere;
        // bound: lanes: found has a bit a lane
        for (int slot = tile_i * lanes; found != 0; ++slot, found >>= 1)
            if ((found & 1u) != 0) look(slot);
    }
}

/// Calls look(slot) for every body whose ball may come within `distance` of the point, in the order of slots. `look` may lower the
/// distance, below zero too.
template <class Look>
INGOT_INLINE void look_about(const EveryShape& all, const Vector& point, const scalar& distance, const Look& look) {
    for (int tile_i = 0; tile_i < all.bodies.tile_count; ++tile_i) {
        const BallsOfTile balls = balls_of_tile(all.surfaces, tile_i);
        if ((balls.there | balls.everywhere) == 0) continue;
        const Vec3<lane> c = load(all.bodies.translation[tile_i].r_CM) - all_lanes_of(point);
        unsigned found = (bits(may_come_within(c, balls.radius, distance)) & balls.there) | balls.everywhere;
        // bound: lanes: found has a bit a lane
        for (int slot = tile_i * lanes; found != 0; ++slot, found >>= 1)
            if ((found & 1u) != 0) look(slot);
    }
}

} }  // namespace ingot

#pragma GCC diagnostic pop

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
};

/// Calls look(slot), in the order of slots, for every body whose ball the moving ball may touch. `look` may lower the fraction.
///
/// Reach is enlarged by limits::flatness and by the roundings of the distance, so that no body that is met is left out.
/// Cost: about 30 flops a body, `lanes` at once.
template <class Look>
INGOT_INLINE void look_along(const BodyView& bodies, const SurfaceView& surfaces, const MovingBall& ball, const Look& look) {
    const scalar way_sq = length_sq(ball.way), inv_way_sq = way_sq > 0 ? 1 / way_sq : 0;
    const scalar roundings = 8 * epsilon * (abs(ball.way.x) + abs(ball.way.y) + abs(ball.way.z));
    // bound: max_bodies max_shapes_of_body / lanes, rounded up: the view of all shapes
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {
        const BallsOfTile balls = balls_of_tile(surfaces, tile_i);
        if ((balls.there | balls.everywhere) == 0) continue;
        const auto all = [](const Vector& v) { return Vec3<lane>{splat<lane>(v.x), splat<lane>(v.y), splat<lane>(v.z)}; };
        const Vec3<lane> way = all(ball.way), c = load(bodies.translation[tile_i].r_CM) - all(ball.from);
        const lane t = min(max(dot(c, way) * splat<lane>(inv_way_sq), lane{}), splat<lane>(ball.fraction));
        const lane away_sq = length_sq(c - way * t);
        const lane slack = (abs(c.x) + abs(c.y) + abs(c.z)) * splat<lane>(8 * epsilon) + splat<lane>(roundings);
        const lane reach = (balls.radius + splat<lane>(ball.radius)) * splat<lane>(1 + limits::flatness) + slack;
        unsigned found = (bits(away_sq <= reach * reach) & balls.there) | balls.everywhere;
        // bound: lanes: found has a bit a lane
        for (int slot = tile_i * lanes; found != 0; ++slot, found >>= 1)
            if ((found & 1u) != 0) look(slot);
    }
}

/// Calls look(slot) for every body whose ball may come within `distance` of the point, in the order of slots. `look` may lower the
/// distance, below zero too.
template <class Look>
INGOT_INLINE void look_about(const BodyView& bodies, const SurfaceView& surfaces, const Vector& point, const scalar& distance, const Look& look) {
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {
        const BallsOfTile balls = balls_of_tile(surfaces, tile_i);
        if ((balls.there | balls.everywhere) == 0) continue;
        const Vec3<lane> c = load(bodies.translation[tile_i].r_CM) - Vec3<lane>{splat<lane>(point.x), splat<lane>(point.y), splat<lane>(point.z)};
        const lane slack = (abs(c.x) + abs(c.y) + abs(c.z)) * splat<lane>(8 * epsilon);
        const lane reach = balls.radius * splat<lane>(1 + limits::flatness) + splat<lane>(distance) + slack;
        const mask near = both(reach >= lane{}, length_sq(c) <= reach * reach);
        unsigned found = (bits(near) & balls.there) | balls.everywhere;
        // bound: lanes: found has a bit a lane
        for (int slot = tile_i * lanes; found != 0; ++slot, found >>= 1)
            if ((found & 1u) != 0) look(slot);
    }
}

} }  // namespace ingot

#pragma GCC diagnostic pop

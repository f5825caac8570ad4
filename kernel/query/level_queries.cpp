// SPDX-License-Identifier: MIT
#include "level_queries.h"

namespace ingot { inline namespace INGOT_ABI {

RayEntry ray_on_level(const LevelTable& level, const LocalRay& ray) {
    LevelHit hit;
    if (!cast_ray_on_level(level, ray.o + level.middle(), ray.d, hit)) return {false, 1, {}};
    TriangleFace face;
    if (!face_of_triangle(triangle_of(level, hit.triangle), face)) return {false, 1, {}};
    return {true, hit.fraction, face.n};
}

ShapeEntry cast_on_level(const PlacedShape& moving, const Vector& way, const PlacedShape& level, const LevelTable& table, scalar fraction_max) {
    const LevelFrame frame(level, table);
    const PlacedShape seen = frame.seen(moving);
    const Vector seen_way = frame.seen_direction(way) * fraction_max, none = {};
    ShapeEntry first = {false, 1, {}, {}};
    const LevelReach reach = reach_in_level(seen);
    const Vector low = seen.r - reach.below + min(seen_way, none), high = seen.r + reach.above + max(seen_way, none);
    for_triangles_in(table, low, high, [&](const LevelTriangle& triangle) {
        TriangleFace face;
        if (!face_of_triangle(triangle, face) || !(dot(face.n, seen_way) < 0)) return;
        const TriangleHull sheet(face, 0);
        const ShapeEntry entry = cast_on_shape(seen, frame.seen_direction(way), sheet.placed(), first.meets ? first.fraction : fraction_max);
        if (entry.meets && (!first.meets || entry.fraction < first.fraction)) first = entry;
    });
    if (!first.meets) return first;
    return {true, first.fraction, frame.place(first.P), level.A * first.n};
}

bool overlaps_level(const PlacedShape& shape, const PlacedShape& level, const LevelTable& table) {
    const PlacedShape seen = LevelFrame(level, table).seen(shape);
    bool overlaps = false;
    const LevelReach reach = reach_in_level(seen);
    for_triangles_in(table, seen.r - reach.below, seen.r + reach.above, [&](const LevelTriangle& triangle) {
        TriangleFace face;
        if (overlaps || !face_of_triangle(triangle, face)) return;
        const TriangleHull sheet(face, 0);
        overlaps = closest_points(seen, sheet.placed()).overlap;
    });
    return overlaps;
}

namespace {

/// Of triangles that have one nearest point to p, the one that says on which side of them p is: at an edge the one that faces p most. At a corner it
/// is one of the two at the edge that leads most towards p: others may face it more, and have it behind them though it is outside.
struct FacingTriangle {
    Vector p_on, n;  ///< m; unit, away from the ground
    scalar lead;     ///< m, of the way to p along that edge: none but at a corner, where it is 0 or below
    scalar facing;   ///< m, of p above the triangle or below it
    bool behind;
};

FacingTriangle facing_of(const TriangleFace& face, const TriangleTouch& touch, const Vector& away, scalar distance) {
    const int i = touch.i;
    const scalar along = touch.part == TrianglePart::corner ? max(dot(away, face.along[i]), -dot(away, face.along[i == 0 ? 2 : i - 1])) : scalar(0);
    const scalar height = dot(face.n, away);
    const bool behind = height < 0, rounded = distance > 0 && touch.part != TrianglePart::inside;
    return {touch.p, rounded ? away * ((behind ? scalar(-1) : scalar(1)) / distance) : face.n, min(along, scalar(0)), abs(height), behind};
}

}  // namespace

void point_on_level(const PlacedShape& point, const PlacedShape& level, const LevelTable& table, scalar within, Manifold& manifold) {
    const LevelFrame frame(level, table);
    const Vector p = frame.seen(point).r, half = half_extents_of(table), off = p - table.middle();
    const Vector beyond = {max(abs(off.x) - half.x, scalar(0)), max(abs(off.y) - half.y, scalar(0)), max(abs(off.z) - half.z, scalar(0))};
    const scalar to_box = sqrt(length_sq(beyond)), everything = to_box + 2 * sqrt(length_sq(half)) + table.step;
    const scalar most = min(within, everything);
    FacingTriangle nearest{};
    scalar least = -1;
    // bound: 2 log2 of a table's extent in steps, 16: each turn doubles it
    for (scalar reach = min(to_box + table.step, most);; reach = min(2 * reach, most)) {
        const Vector box = {reach, reach, reach};
        for_triangles_in(table, p - box, p + box, [&](const LevelTriangle& triangle) {
            TriangleFace face;
            if (!face_of_triangle(triangle, face)) return;
            const TriangleTouch touch = nearest_on_triangle(face, p, 0);
            const Vector away = p - touch.p;
            const scalar distance = sqrt(length_sq(away)), rounding = 8 * epsilon * (abs(p.x) + abs(p.y) + abs(p.z) + distance);
            if (least >= 0 && distance > least + rounding) return;
            const FacingTriangle now = facing_of(face, touch, away, distance);
            const bool nearer = least < 0 || distance < least - rounding, leads = now.lead > nearest.lead + rounding;
            least = least < 0 ? distance : min(least, distance);
            if (nearer || leads || (now.lead >= nearest.lead - rounding && now.facing > nearest.facing)) nearest = now;
        });
        if ((least >= 0 && least <= reach) || !(reach < most)) break;
    }
    if (least < 0 || least > within) return no_points({}, manifold);
    const scalar separation = nearest.behind ? -least : least;
    one_point(level.A * nearest.n, frame.place(nearest.p_on + nearest.n * (separation / 2)), separation, 0, manifold);
}

} }  // namespace ingot

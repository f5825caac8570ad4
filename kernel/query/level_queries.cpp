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

void point_on_level(const PlacedShape& point, const PlacedShape& level, const LevelTable& table, scalar within, Manifold& manifold) {
    const LevelFrame frame(level, table);
    const Vector p = frame.seen(point).r, half = half_extents_of(table), off = p - table.middle();
    const Vector beyond = {max(abs(off.x) - half.x, scalar(0)), max(abs(off.y) - half.y, scalar(0)), max(abs(off.z) - half.z, scalar(0))};
    const scalar to_box = sqrt(length_sq(beyond)), everything = to_box + 2 * sqrt(length_sq(half)) + table.step;
    const scalar most = min(within, everything);
    Vector nearest{}, n{};
    scalar least = -1, sine = 0;
    bool behind = false;
    // bound: 2 log2 of a table's extent in steps, 16: each turn doubles it
    for (scalar reach = min(to_box + table.step, most);; reach = min(2 * reach, most)) {
        const Vector box = {reach, reach, reach};
        for_triangles_in(table, p - box, p + box, [&](const LevelTriangle& triangle) {
            TriangleFace face;
            if (!face_of_triangle(triangle, face)) return;
            const TriangleTouch touch = nearest_on_triangle(face, p, 0);
            const Vector away = p - touch.p;
            const scalar distance = sqrt(length_sq(away)), height = dot(face.n, away);
            // Of triangles that share the nearest point the one that faces it most says on which side it is.
            const bool nearer = least < 0 || distance < least;
            const bool as_near = !nearer && distance <= least * (1 + 4 * epsilon);
            if (!nearer && !(as_near && abs(height) > sine)) return;
            if (nearer) least = distance;
            nearest = touch.p;
            sine = abs(height);
            behind = height < 0;
            n = distance > 0 && touch.part != TrianglePart::inside ? away * ((behind ? scalar(-1) : scalar(1)) / distance) : face.n;
        });
        if ((least >= 0 && least <= reach) || !(reach < most)) break;
    }
    if (least < 0 || least > within) return no_points({}, manifold);
    const scalar separation = behind ? -least : least;
    one_point(level.A * n, frame.place(nearest + n * (separation / 2)), separation, 0, manifold);
}

} }  // namespace ingot

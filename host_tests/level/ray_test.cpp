// SPDX-License-Identifier: MIT
// Rays against all triangles one by one, in double (Moller and Trumbore, "Fast, minimum storage ray/triangle intersection", 1997), and rays through
// edges and corners, which have to meet something.
#include <gtest/gtest.h>
#include <ingot/level/level_walk.h>

#include <cmath>
#include <limits>

#include "fields.h"

namespace {

using namespace level_test;
using ingot::LevelHit;
using ingot::LevelTable;
using ingot::LevelTriangle;
using ingot::scalar;
using ingot::Vector;
using Point = ingot::Vec3<double>;

Point in_double(const Vector& v) { return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)}; }
double length_of(const Point& p) { return std::sqrt(dot(p, p)); }

/// How far the place of the triangle's plane where the ray meets it is outside of the triangle, m; below 0 inside. And where that is.
struct Meeting {
    double fraction = -1, outside = 1e300, grazing = 0;
};
Meeting meet(const LevelTriangle& t, const Point& from, const Point& way) {
    const Point a = in_double(t.corners[0]), e1 = in_double(t.corners[1]) - a, e2 = in_double(t.corners[2]) - a;
    const Point p = cross(way, e2);
    const double det = dot(e1, p);  // - way . (e1 x e2): positive from outside
    if (!(det > 0)) return {};
    const Point s = from - a, q = cross(s, e1);
    const double u = dot(s, p) / det, v = dot(way, q) / det;
    Meeting found;
    found.fraction = dot(e2, q) / det;
    const double area = length_of(cross(e1, e2));
    found.grazing = det / (area * length_of(way));
    // Distances to the three edges.
    found.outside = std::max({-u * area / length_of(e2), -v * area / length_of(e1), (u + v - 1) * area / length_of(e2 - e1)});
    return found;
}

std::vector<LevelTriangle> all_of(const LevelTable& level) {
    std::vector<LevelTriangle> all;
    for (const uint32_t number : triangles_of(level)) all.push_back(triangle_of(level, number));
    return all;
}

/// What rounding may do to a ray: corners seen from its start lie within some epsilons of their distance.
double slack_of(const LevelTable& level, const Vector& from) {
    const Vector reach = max(max(level.low - from, from - level.low), max(level.high - from, from - level.high));
    return 16 * static_cast<double>(ingot::epsilon) * static_cast<double>(std::max({reach.x, reach.y, reach.z}));
}

/// True where the ray met something.
bool expect_ray_is_right(const LevelTable& level, const std::vector<LevelTriangle>& all, const Vector& from, const Vector& way) {
    const double slack = slack_of(level, from), length = length_of(in_double(way));
    LevelHit hit{};
    const bool is_met = cast_ray_on_level(level, from, way, hit);
    if (is_met) {
        const Meeting there = meet(triangle_of(level, hit.triangle), in_double(from), in_double(way));
        EXPECT_GT(there.fraction, -1);
        // Along a plane that is nearly the ray's, a little aside is far along.
        EXPECT_LT(there.outside, slack / there.grazing);
        EXPECT_NEAR(there.fraction * length, static_cast<double>(hit.fraction) * length, slack / there.grazing);
    }
    for (const LevelTriangle& t : all) {
        const Meeting other = meet(t, in_double(from), in_double(way));
        if (other.outside > -slack || other.grazing < 1e-3) continue;
        const double room = slack / other.grazing / length;
        if (other.fraction < room || other.fraction > 1 - room) continue;
        EXPECT_TRUE(is_met) << "passes triangle " << t.number;
        if (is_met) {
            EXPECT_LT(static_cast<double>(hit.fraction), other.fraction + 2 * room) << "triangle " << t.number;
        }
    }
    return is_met;
}

Vector draw_in(Random& random, const LevelTable& level, scalar more) {
    const auto share = [&random, more] { return static_cast<scalar>(random() % 4096) / 4096 * (1 + 2 * more) - more; };
    const Vector size = level.high - level.low;
    return {level.low.x + size.x * share(), level.low.y + size.y * share(), level.low.z + (size.z + 1) * share()};
}

int expect_rays_are_right(const LevelTable& level, Random& random, int rays) {
    const std::vector<LevelTriangle> all = all_of(level);
    int met = 0;
    for (int i = 0; i < rays && !testing::Test::HasFailure(); ++i) {
        const Vector from = draw_in(random, level, scalar(0.5));
        Vector way = draw_in(random, level, scalar(0.5)) - from;
        // Along axes too, and to corners.
        if (random() % 4 == 0) way = {way.x, 0, way.z};
        if (random() % 4 == 0) way = {way.x, way.y, 0};
        if (random() % 8 == 0) way = {0, 0, way.z};
        if (random() % 8 == 0) way = all[random() % all.size()].corners[random() % 3] - from;
        met += expect_ray_is_right(level, all, from, way);
    }
    return met;
}

TEST(LevelRay, meets_what_all_triangles_one_by_one_say_first) {
    Random random(21);
    EXPECT_GT(expect_rays_are_right(built(loose_triangles(random, 200, 60000, 20000)).view, random, 3000), 300);
    EXPECT_GT(expect_rays_are_right(built(loose_triangles(random, 300, 4000, 300), scalar(1) / 1024, -800000, 12, 7).view, random, 3000), 50);
    EXPECT_GT(expect_rays_are_right(built(village(random, 5)).view, random, 3000), 300);
    EXPECT_GT(expect_rays_are_right(built(slivers(100, true)).view, random, 2000), 100);
    EXPECT_GT(expect_rays_are_right(built(slivers(100, false)).view, random, 2000), 100);
    const level_tool::MeshData hills = built(terrain(random, 20, 1000, [&](int, int) { return between(random, 0, 4000); }));
    EXPECT_GT(expect_rays_are_right(hills.view, random, 3000), 300);
    for (int round = 0; round < 4; ++round) {
        const Field ground = field(random, 40, 25, round % 2 == 0, round < 2 ? 0 : 5, [&](int, int) { return between(random, 0, 900); });
        EXPECT_GT(expect_rays_are_right(ground.view, random, 3000), 200);
    }
}

/// Corners, points of edges, and points of triangles, as rays see them that come from far enough above.
template <class Through>
void shoot_down(const LevelTable& level, Random& random, const std::vector<LevelTriangle>& all, int shots, const Through& through) {
    const scalar above = level.high.z + 3 * (level.high.z - level.low.z) + 5;
    for (int i = 0; i < shots; ++i) {
        const LevelTriangle& t = all[random() % all.size()];
        const int k = static_cast<int>(random() % 3);
        const auto share = static_cast<scalar>(random() % 1024) / 1024;
        const Vector &a = t.corners[k], &b = t.corners[(k + 1) % 3];
        const Vector target = random() % 2 == 0 ? a : a + (b - a) * share;
        if (!through(target)) continue;
        Vector from{target.x + static_cast<scalar>(between(random, -300, 300)) / 200,
                    target.y + static_cast<scalar>(between(random, -300, 300)) / 200, above};
        if (random() % 4 == 0) from = {target.x, target.y, above};
        LevelHit hit{};
        ASSERT_TRUE(cast_ray_on_level(level, from, (target - from) * 2, hit)) << "shot " << i << " of triangle " << t.number;
        // From below it meets nothing that faces up.
        const Vector below{from.x, from.y, level.low.z - (above - level.high.z)};
        if (!level.is_mesh()) {
            ASSERT_FALSE(cast_ray_on_level(level, below, (target - below) * 2, hit));
        }
    }
}

TEST(LevelRay, finds_no_gap_at_edges_and_corners) {
    Random random(22);
    const level_tool::MeshData hills =
        built(terrain(random, 24, 400, [&](int, int) { return between(random, 0, 700); }), scalar(1) / 1024, 3000, -9000, 5);
    const auto inside = [](const LevelTable& level) {
        return [&level](const Vector& p) { return p.x > level.low.x && p.x < level.high.x && p.y > level.low.y && p.y < level.high.y; };
    };
    shoot_down(hills.view, random, all_of(hills.view), 40000, inside(hills.view));
    const level_tool::MeshData fan = built(slivers(100, true));
    const auto in_fan = [&](const Vector& p) { return p.x > scalar(0.1) && p.x < fan.view.high.x && p.y > scalar(0.05) && p.y < p.x * scalar(0.99); };
    shoot_down(fan.view, random, all_of(fan.view), 20000, in_fan);
    const Field ground = field(random, 60, 60, true, 0, [&](int, int) { return between(random, 0, 500); });
    shoot_down(ground.view, random, all_of(ground.view), 40000, inside(ground.view));
}

/// Straight down on corners and edges of a plane: all that meet there do so at the same fraction, to the bit.
TEST(LevelRay, meets_of_those_at_one_place_the_triangle_of_the_least_number) {
    Random random(25);
    const level_tool::MeshData plane = built(terrain(random, 8, 1024, [](int, int) { return 5; }));
    const std::vector<LevelTriangle> all = all_of(plane.view);
    for (int i = 0; i < 17 * 17; ++i) {
        const Vector from{static_cast<scalar>(i % 17) / 2, static_cast<scalar>(i / 17) / 2, 2};
        uint32_t least = ~0u;
        for (const LevelTriangle& t : all)
            if (meet(t, in_double(from), {0, 0, -4}).outside <= 0) least = std::min(least, t.number);
        LevelHit hit{};
        ASSERT_TRUE(cast_ray_on_level(plane.view, from, {0, 0, -4}, hit));
        ASSERT_EQ(hit.triangle, least) << from.x << ", " << from.y;
    }
}

/// Rooms of triangles that look inwards: a ray from inside meets a wall, wherever it goes.
TEST(LevelRay, leaves_no_closed_room) {
    Random random(23);
    for (int round = 0; round < 20; ++round) {
        Soup room;
        const int size[3] = {between(random, 100, 60000), between(random, 100, 60000), between(random, 100, 60000)};
        add_box(room, {0, 0, 0}, {size[0], size[1], size[2]}, 0);
        for (ingot::LevelFace& face : room.faces) face = {face.a, face.c, face.b, 0};
        const level_tool::MeshData walls = built(room, scalar(1) / 1024, between(random, -900000, 900000), between(random, -50, 50), 0);
        const std::vector<LevelTriangle> all = all_of(walls.view);
        for (int i = 0; i < 3000; ++i) {
            const Vector at = draw_in(random, walls.view, scalar(-0.25));
            const Vector from{at.x, at.y, (walls.view.low.z + walls.view.high.z) / 2};
            const LevelTriangle& t = all[random() % all.size()];
            const auto share = static_cast<scalar>(random() % 64) / 64;
            const Vector target = t.corners[0] + (t.corners[1] - t.corners[0]) * share;
            LevelHit hit{};
            ASSERT_TRUE(cast_ray_on_level(walls.view, from, (target - from) * scalar(1.5), hit));
        }
    }
}

TEST(LevelRay, is_refused_where_it_is_none) {
    Random random(24);
    const level_tool::MeshData mesh = built(village(random, 3));
    const Field hills = field(random, 9, 9, false, 0, [](int column, int row) { return column * row; });
    const scalar bad[] = {std::numeric_limits<scalar>::quiet_NaN(), std::numeric_limits<scalar>::infinity(),
                          -std::numeric_limits<scalar>::infinity()};
    LevelHit hit{};
    for (const LevelTable* level : {&mesh.view, &hills.view}) {
        const Vector middle = (level->low + level->high) * scalar(0.5), above{middle.x, middle.y, level->high.z + 1};
        for (const scalar x : bad) {
            EXPECT_FALSE(cast_ray_on_level(*level, {above.x, x, above.z}, {0, 0, -9}, hit));
            EXPECT_FALSE(cast_ray_on_level(*level, above, {0, 0, x}, hit));
        }
        EXPECT_FALSE(cast_ray_on_level(*level, above, {0, 0, 0}, hit));
        EXPECT_FALSE(cast_ray_on_level(*level, above, {0, 0, std::numeric_limits<scalar>::denorm_min()}, hit));
        EXPECT_FALSE(cast_ray_on_level(*level, above, {0, 0, 1}, hit));
    }
    EXPECT_FALSE(cast_ray_on_level({}, {0, 0, 1}, {0, 0, -9}, hit));
}

}  // namespace

// SPDX-License-Identifier: MIT
// Which part of a triangle a point is over, and which a direction belongs to: against brute force in long double. And the nearest of a level that is
// far from where its numbers begin.
#include <gtest/gtest.h>

#include <ingot/narrow_phase/level_cone.h>

#include <Eigen/Dense>

#include "ground.h"
#include "reference/draws.h"

namespace {

using namespace level_test;
using Real = long double;
using V = Eigen::Matrix<Real, 3, 1>;

V exact(const Vector& v) { return {static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)}; }
Vector rounded(const V& v) { return {static_cast<scalar>(v.x()), static_cast<scalar>(v.y()), static_cast<scalar>(v.z())}; }

V direction(Random& random) {
    for (;;) {
        const V v = {within(random, -1, 1), within(random, -1, 1), within(random, -1, 1)};
        if (v.norm() > 0.1 && v.norm() < 1) return v.normalized();
    }
}

/// A triangle of any size and place; no angle of it is so small that roundings decide what is beside it.
struct Drawn {
    ingot::TriangleFace face;
    V corners[3], n;
    Real size;

    V along(int i) const { return (corners[(i + 1) % 3] - corners[i]).normalized(); }
    V inward(int i) const { return n.cross(along(i)); }
};

Drawn drawn_triangle(Random& random) {
    for (;;) {
        Drawn drawn;
        drawn.size = about(random, 0.05, 20);
        const V middle = direction(random) * about(random, 0.1, 30);
        ingot::LevelTriangle triangle{};
        for (int i = 0; i < 3; ++i) {
            triangle.corners[i] = rounded(middle + direction(random) * drawn.size);
            drawn.corners[i] = exact(triangle.corners[i]);
        }
        if (!ingot::face_of_triangle(triangle, drawn.face)) continue;
        const V across = (drawn.corners[1] - drawn.corners[0]).cross(drawn.corners[2] - drawn.corners[0]);
        if (across.norm() < 0.1 * drawn.size * drawn.size) continue;
        drawn.n = across.normalized();
        return drawn;
    }
}

/// m, in the plane of the triangle.
Real beside(const Drawn& drawn, const V& c) {
    bool inside = true;
    Real least = 1e30L;
    for (int i = 0; i < 3; ++i) {
        const V from = c - drawn.corners[i], along = drawn.along(i);
        inside = inside && drawn.inward(i).dot(from) >= 0;
        const Real length = (drawn.corners[(i + 1) % 3] - drawn.corners[i]).norm();
        const V nearest = drawn.corners[i] + along * std::min(length, std::max(Real(0), along.dot(from)));
        least = std::min(least, (c - nearest).norm());
    }
    return inside ? 0 : least;
}

/// A point in the plane: about a corner, beside an edge, anywhere; `far`: m, off the triangle, about as much.
V point_about(Random& random, const Drawn& drawn, Real far) {
    const int i = between(random, 0, 2);
    const V across = drawn.n.cross(drawn.along(i));
    const Real turn = within(random, 0, 2 * pi);
    const V aside = (drawn.along(i) * std::cos(turn) + across * std::sin(turn)) * far * static_cast<Real>(within(random, 0.2, 2));
    if (random() % 2 == 0) return drawn.corners[i] + aside;
    const V at = drawn.corners[i] + (drawn.corners[(i + 1) % 3] - drawn.corners[i]) * static_cast<Real>(within(random, 0, 1));
    return random() % 4 == 0 ? at + drawn.inward(i) * drawn.size * static_cast<Real>(within(random, -0.5, 1)) : V(at + aside);
}

/// As far beside it as `flush` a point is over a triangle, round its corners too, at any height: and no further.
TEST(TriangleParts, a_point_is_over_what_it_is_beside_by_no_more_than_flush) {
    Random random(9301);
    int over = 0, beside_it = 0, round_corners = 0;
    for (int draw = 0; draw < ingot_reference::draws(40000); ++draw) {
        const Drawn drawn = drawn_triangle(random);
        const Real flush = drawn.size * static_cast<Real>(about(random, 0.01, 0.3));
        const V in_plane = point_about(random, drawn, flush);
        const V c = exact(rounded(in_plane + drawn.n * drawn.size * static_cast<Real>(within(random, -2, 2))));
        const Real off = beside(drawn, c - drawn.n * drawn.n.dot(c - drawn.corners[0]));
        // Of places, and of directions, times how far c is from a corner.
        const Real rounding = 64 * static_cast<Real>(ingot::epsilon) * (c.norm() + 10 * drawn.size);
        if (std::abs(off - flush) < rounding) continue;
        const bool is = ingot::is_over(drawn.face, rounded(c), static_cast<scalar>(flush));
        ASSERT_EQ(is, off < flush) << draw << ": " << static_cast<double>(off) << " m beside it, of " << static_cast<double>(flush);
        (is ? over : beside_it) += 1;
        int outside = 0;
        for (int i = 0; i < 3; ++i) outside += drawn.inward(i).dot(c - drawn.corners[i]) < 0 ? 1 : 0;
        round_corners += outside == 2 ? 1 : 0;
    }
    EXPECT_GT(over, ingot_reference::draws(5000));
    EXPECT_GT(beside_it, ingot_reference::draws(5000));
    EXPECT_GT(round_corners, ingot_reference::draws(1000));
}

/// Of all points of a triangle those that are furthest along a direction are what the direction belongs to: none is further than the one that is
/// told by more than what the tilt makes of an edge. On an edge it is the one that is nearest to where it was asked for.
TEST(TriangleParts, a_direction_belongs_to_what_is_furthest_along_it) {
    Random random(9302);
    constexpr auto tilt = scalar(0.02);
    int on_edges = 0, at_corners[3] = {};
    for (int draw = 0; draw < ingot_reference::draws(40000); ++draw) {
        const Drawn drawn = drawn_triangle(random);
        const int edge = between(random, 0, 2);
        V d = direction(random);
        if (draw % 2 == 0) {  // across an edge, on any side of the plane, and off that by less than the tilt, or more
            d = -drawn.inward(edge) + drawn.n * static_cast<Real>(within(random, -2, 2));
            d += drawn.along(edge) * static_cast<Real>(within(random, -1.5, 1.5)) * static_cast<Real>(tilt) * d.norm();
        }
        d = exact(rounded(d.normalized()));
        if ((d - drawn.n * drawn.n.dot(d)).norm() < 0.2) continue;
        const V p = exact(rounded(point_about(random, drawn, drawn.size * static_cast<Real>(0.2))));
        const ingot::TriangleTouch touch = ingot::put_on_triangle(drawn.face, rounded(p), rounded(d), tilt);
        const Real rounding = 64 * static_cast<Real>(ingot::epsilon) * (p.norm() + 10 * drawn.size);
        ASSERT_NE(touch.part, ingot::TrianglePart::inside);
        Real furthest = -1e30L;
        for (const V& corner : drawn.corners) furthest = std::max(furthest, d.dot(corner));
        ASSERT_GE(d.dot(exact(touch.p)), furthest - static_cast<Real>(tilt) * 2 * drawn.size - rounding) << draw;
        if (touch.part == ingot::TrianglePart::corner) {
            ASSERT_EQ(touch.p.x, drawn.face.corners[touch.i].x) << draw;
            at_corners[touch.i] += 1;
        } else {
            ++on_edges;
            const V along = drawn.along(touch.i);
            ASSERT_LE(std::abs(along.dot(d)), static_cast<Real>(tilt) + rounding / drawn.size) << draw;
            ASSERT_LE(std::abs(along.dot(p - exact(touch.p))), rounding) << draw;
        }
        // What is well across an edge of the furthest corner is of no corner, unless p is beyond its ends; and what is not, of a corner.
        Real flattest = 1;
        int across = 0;
        for (int i = 0; i < 3; ++i) {
            const Real rise = std::abs(drawn.along(i).dot(d));
            if (std::max(d.dot(drawn.corners[i]), d.dot(drawn.corners[(i + 1) % 3])) < furthest || rise >= flattest) continue;
            flattest = rise;
            across = i;
        }
        if (flattest > static_cast<Real>(tilt) + rounding / drawn.size) {
            ASSERT_EQ(touch.part, ingot::TrianglePart::corner) << draw;
            ASSERT_GE(d.dot(exact(touch.p)), furthest - rounding) << draw;
        } else if (flattest < static_cast<Real>(tilt) - rounding / drawn.size) {
            const Real length = (drawn.corners[(across + 1) % 3] - drawn.corners[across]).norm();
            const Real t = drawn.along(across).dot(p - drawn.corners[across]);
            const V nearest = drawn.corners[across] + drawn.along(across) * std::min(length, std::max(Real(0), t));
            ASSERT_LE((exact(touch.p) - nearest).norm(), rounding) << draw;
        }
    }
    EXPECT_GT(on_edges, ingot_reference::draws(3000));
    for (const int count : at_corners) EXPECT_GT(count, ingot_reference::draws(3000));
}

/// Where the numbers of a level begin may be far from all of it: whoever looks for it from afar, from wherever that is, finds what is nearest.
TEST(TriangleParts, the_nearest_of_a_level_is_found_from_afar) {
    int found = 0, on_other_side = 0;
    for (int draw = 0; draw < ingot_reference::draws(400); ++draw) {
        Random random(static_cast<uint64_t>(9400 + draw));
        Ground ground;
        const int extent = between(random, 300, 3000);
        const auto at = [&random] { return static_cast<int64_t>(between(random, -50000, 50000)); };
        ground.mesh = built(loose_triangles(random, between(random, 1, 30), extent, extent / 2), scalar(1) / 256, at(), at(), at());
        if (ground.mesh.triangles.empty()) continue;
        ground.view = ground.mesh.view;
        const V middle = exact(ground.view.middle());
        auto& world = empty_world<OnLevel>();
        OnLevel::levels[0] = ground.view;
        LevelDef def;
        def.A = any_rotation(random);
        def.r = rounded(V(-(exact(def.A.c0) * middle.x() + exact(def.A.c1) * middle.y() + exact(def.A.c2) * middle.z())) + direction(random) * 20);
        ASSERT_TRUE(world.add_level(def).ok());
        const auto seen = [&def](const Vector& p) {
            const V q = exact(p);
            return V(exact(def.r) + exact(def.A.c0) * q.x() + exact(def.A.c1) * q.y() + exact(def.A.c2) * q.z());
        };
        const auto distance_from = [&](const V& p) {
            Real least = 1e30L;
            for (const uint32_t number : triangles_of(ground.view)) {
                const ingot::LevelTriangle triangle = triangle_of(ground.view, number);
                const V c[3] = {seen(triangle.corners[0]), seen(triangle.corners[1]), seen(triangle.corners[2])};
                const V across = (c[1] - c[0]).cross(c[2] - c[0]);
                bool inside = true;
                for (int i = 0; i < 3; ++i) {
                    const V along = c[(i + 1) % 3] - c[i];
                    inside = inside && across.cross(along).dot(p - c[i]) >= 0;
                    const Real t = std::min(Real(1), std::max(Real(0), along.dot(p - c[i]) / along.squaredNorm()));
                    least = std::min(least, (c[i] + along * t - p).norm());
                }
                if (inside && across.norm() > 0) least = std::min(least, std::abs(across.normalized().dot(p - c[0])));
            }
            return least;
        };
        for (int query = 0; query < 8; ++query) {
            // About it, and as far on the other side of where its numbers begin.
            const V about_it = seen(ground.view.middle()), other = exact(def.r) * 2 - about_it;
            const V p = exact(rounded((query % 2 == 0 ? other : about_it) + direction(random) * about(random, 1, 300)));
            const Real distance = distance_from(p);
            const Real rounding = 64 * static_cast<Real>(ingot::epsilon) * (p.norm() + exact(def.r).norm() + middle.norm());
            const auto near = world.find_nearest(rounded(p), 2000);
            ASSERT_TRUE(near.ok() && near.value.found()) << draw << ": " << static_cast<double>(distance) << " m away";
            EXPECT_LE(std::abs(std::abs(static_cast<Real>(near.value.distance)) - distance), rounding) << draw;
            ++found;
            on_other_side += query % 2 == 0 && distance > 4 * static_cast<Real>(length(ingot::half_extents_of(ground.view))) ? 1 : 0;
            const Real less = distance * 0.99L - rounding;
            if (less > 0) {
                EXPECT_FALSE(world.find_nearest(rounded(p), static_cast<scalar>(less)).value.found()) << draw;
            }
        }
    }
    EXPECT_GT(found, 100);
    EXPECT_GT(on_other_side, 30);
}

/// Four corners that make a solid, of blades and needles too, with its faces outward.
struct Solid {
    Ground ground;
    V corners[4];
    static constexpr int faces[4][3] = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};

    V normal(int i) const { return (corners[faces[i][1]] - corners[faces[i][0]]).cross(corners[faces[i][2]] - corners[faces[i][0]]).normalized(); }
    bool has(const V& p) const {
        bool inside = true;
        for (int i = 0; i < 4; ++i) inside = inside && normal(i).dot(p - corners[faces[i][0]]) < 0;
        return inside;
    }
    V nearest_of(int i, const V& p) const {
        const V n = normal(i), c[3] = {corners[faces[i][0]], corners[faces[i][1]], corners[faces[i][2]]};
        bool over = true;
        V best = c[0];
        for (int k = 0; k < 3; ++k) {
            const V along = c[(k + 1) % 3] - c[k];
            over = over && n.cross(along).dot(p - c[k]) >= 0;
            const V q = c[k] + along * std::min(Real(1), std::max(Real(0), along.dot(p - c[k]) / along.squaredNorm()));
            if ((q - p).norm() < (best - p).norm()) best = q;
        }
        return over ? V(p - n * n.dot(p - c[0])) : best;
    }
    V nearest(const V& p) const {
        V best = corners[0];
        for (int i = 0; i < 4; ++i)
            if ((nearest_of(i, p) - p).norm() < (best - p).norm()) best = nearest_of(i, p);
        return best;
    }
    /// Whether another place of it is as near, to a rounding: on the other side of a blade, it may be.
    bool is_as_near_elsewhere(const V& p, Real rounding) const {
        const V q = nearest(p);
        bool is = false;
        for (int i = 0; i < 4; ++i) {
            const V other = nearest_of(i, p);
            is = is || ((other - q).norm() > 1e-12L && (other - p).norm() - (q - p).norm() < rounding);
        }
        return is;
    }
};
Solid drawn_solid(Random& random) {
    for (;;) {
        const int extent[3] = {between(random, 100, 1000), between(random, 100, 1000), between(random, 30, 300)};
        Soup soup;
        Solid solid;
        for (V& corner : solid.corners) {
            soup.points.push_back(lattice_point(between(random, 0, extent[0]), between(random, 0, extent[1]), between(random, 0, extent[2])));
            const auto& p = soup.points.back();
            corner = V(p.x, p.y, p.z) / 256;
        }
        const V across = (solid.corners[1] - solid.corners[0]).cross(solid.corners[2] - solid.corners[0]);
        const Real height = across.norm() > 0 ? across.normalized().dot(solid.corners[3] - solid.corners[0]) : 0;
        if (std::abs(height) < 0.05L || across.norm() < 0.05L) continue;
        if (height > 0) {
            std::swap(solid.corners[0], solid.corners[1]);
            std::swap(soup.points[0], soup.points[1]);
        }
        for (const auto& face : Solid::faces) soup.faces.push_back({face[0], face[1], face[2], 0});
        take_mesh(soup, 1.0 / 256, solid.ground);
        return solid;
    }
}

/// Of a closed level who is outside is before its nearest point, and who is inside is behind it: at ridges and corners however sharp, where faces
/// have one nearest point, and some of them have behind them who is outside.
TEST(ClosedLevels, have_an_inside_and_an_outside) {
    int inside = 0, outside = 0, at_ridges = 0;
    for (int draw = 0; draw < ingot_reference::draws(2000); ++draw) {
        Random random(static_cast<uint64_t>(9500 + draw));
        const Solid solid = drawn_solid(random);
        auto& world = empty_world<OnLevel>();
        OnLevel::levels[0] = solid.ground.view;
        ASSERT_TRUE(world.add_level({}).ok());
        for (int query = 0; query < 12; ++query) {
            const int a = between(random, 0, 3), b = (a + between(random, 1, 3)) % 4;
            const V on_edge = solid.corners[a] + (solid.corners[b] - solid.corners[a]) * static_cast<Real>(within(random, 0, 1));
            const V within_it = (solid.corners[0] + solid.corners[1] + solid.corners[2] + solid.corners[3]) / 4;
            const V p = exact(rounded(query % 4 == 0 ? V(on_edge + (within_it - on_edge) * static_cast<Real>(within(random, 0, 1)))
                                                     : V(on_edge + direction(random) * about(random, 0.02, 2))));
            const V q = solid.nearest(p);
            const Real distance = (p - q).norm(), rounding = 64 * static_cast<Real>(ingot::epsilon) * 8;
            if (distance < 1e-3L || solid.is_as_near_elsewhere(p, rounding)) continue;
            const auto near = world.find_nearest(rounded(p), 100);
            ASSERT_TRUE(near.ok() && near.value.found());
            const Real due = solid.has(p) ? -distance : distance;
            ASSERT_LE(std::abs(static_cast<Real>(near.value.distance) - due), rounding) << draw << ", " << query << ": " << static_cast<double>(due);
            // Its normal leads from the point of the surface that it names to p, or away from it.
            ASSERT_LE((exact(near.value.P) + exact(near.value.n) * static_cast<Real>(near.value.distance) - p).norm(), rounding * 4) << draw;
            ASSERT_LE(std::abs(exact(near.value.n).norm() - 1), 8 * static_cast<Real>(ingot::epsilon));
            int sides = 0;
            for (int i = 0; i < 4; ++i) {
                const V c = solid.corners[Solid::faces[i][0]];
                sides += std::abs(solid.normal(i).dot(q - c)) < rounding ? (solid.normal(i).dot(p - c) > 0 ? 1 : 16) : 0;
            }
            at_ridges += sides > 16 && sides % 16 != 0 && !solid.has(p) ? 1 : 0;
            ++(solid.has(p) ? inside : outside);
        }
    }
    EXPECT_GT(inside, ingot_reference::draws(500));
    EXPECT_GT(outside, ingot_reference::draws(5000));
    EXPECT_GT(at_ridges, ingot_reference::draws(500));
}

/// A shape that is moved out of a level, from deep below it, meets nothing on its way: no triangle is met from behind.
TEST(ClosedLevels, let_out_what_comes_from_behind) {
    int cast = 0;
    for (int draw = 0; draw < ingot_reference::draws(400); ++draw) {
        Random random(static_cast<uint64_t>(9600 + draw));
        Ground ground;
        Soup soup = terrain(random, 12, 256, [&](int, int) { return 2000 + between(random, 0, 60); });
        take_mesh(soup, 1.0 / 256, ground);
        auto& world = empty_world<OnLevel>();
        OnLevel::levels[0] = ground.view;
        ASSERT_TRUE(world.add_level({}).ok());
        for (int query = 0; query < 8; ++query) {
            const double x = within(random, 3, 9), y = within(random, 3, 9);
            const auto size = static_cast<scalar>(within(random, 0.05, 0.5));
            const BodyDef body = goer(random, static_cast<Goer>(between(random, 0, goers_count - 1)), size, 0);
            const ingot::PlacedShape shape = {body.shape, {static_cast<scalar>(x), static_cast<scalar>(y), scalar(1)}, any_rotation(random),
                                              body.shape.kind == ingot::ShapeKind::hull ? Slab::hulls : nullptr};
            // Steeper than any triangle, whose slope is no more than 60 / 256 either way.
            const Vector way = {static_cast<scalar>(within(random, -1, 1)), static_cast<scalar>(within(random, -1, 1)),
                                static_cast<scalar>(within(random, 8, 20))};
            const auto up = world.cast_shape(shape, way);
            ASSERT_TRUE(up.ok());
            EXPECT_FALSE(up.value.found()) << draw << ", " << query;
            // And on the last of its way, from just below a ground of 8 m and less.
            const ingot::PlacedShape pebble = {ingot::Sphere{scalar(0.05)}, {shape.r.x, shape.r.y, scalar(7.4)}, shape.A, nullptr};
            const auto last = world.cast_shape(pebble, {0, 0, static_cast<scalar>(within(random, 0.5, 0.95))});
            ASSERT_TRUE(last.ok());
            EXPECT_FALSE(last.value.found()) << draw << ", " << query;
            ingot::PlacedShape above = shape;
            above.r = shape.r + way;
            if (above.r.z > 11) {
                const auto down = world.cast_shape(above, -way);
                ASSERT_TRUE(down.ok());
                EXPECT_TRUE(down.value.found()) << draw << ", " << query;
                ++cast;
            }
        }
    }
    EXPECT_GT(cast, ingot_reference::draws(400));
}

}  // namespace

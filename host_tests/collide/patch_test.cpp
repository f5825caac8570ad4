// SPDX-License-Identifier: MIT
// What a shape turns towards a contact: the face that faces it, else the flattest edge of the corner that is furthest, else that corner.
#include <gtest/gtest.h>
#include <ingot/narrow_phase/contact_patch.h>

#include "collide/placed.h"

namespace {

using namespace ingot_collide;
using Eigen::Vector3d;
using ingot::Patch;

constexpr double eps = static_cast<double>(ingot::epsilon);

/// Corners of a patch, world, from the origin of the frame.
std::vector<V> corners_of(const Patch& patch, const ingot::ContactFrame& frame) {
    std::vector<V> corners;
    for (int i = 0; i < patch.count; ++i)
        corners.push_back(exact(frame.e_x) * patch.x[i] + exact(frame.e_y) * patch.y[i] + exact(frame.n) * patch.z[i]);
    return corners;
}

/// Straight at a face, at the middle of an edge, at a corner, anywhere.
V direction_towards(const ingot::ConvexHull& hull, RandomInput& random, int case_i) {
    const ingot::HullEdge& edge = hull.edges[random.integer(0, hull.edge_count - 1)];
    const V left = exact(hull.faces[edge.face_left].n), right = exact(hull.faces[edge.face_right].n);
    switch (case_i % 4) {
        case 0: return left;
        case 1: return (left + right).normalized();
        case 2: return exact(hull.vertices[random.integer(0, hull.vertex_count - 1)]).normalized();
        default: return random.direction().cast<long double>();
    }
}

TEST(Patch, of_a_polyhedron_is_its_face_its_flattest_edge_or_its_furthest_corner) {
    RandomInput random(1441);
    int faces = 0, edges = 0, single = 0;
    for (int case_i = 0; case_i < 4000; ++case_i) {
        const ingot::ConvexHull& hull = *hull_of(random);
        PlacedShape s = placed(ingot::Hull{hull.radius}, Vector3d::Zero(), random.rotation());
        s.hull = &hull;
        const auto A = exact(s.A);
        const V n = (A * direction_towards(hull, random, case_i)).normalized(), centre = random.vector(2).cast<long double>();
        const ingot::ContactFrame frame = ingot::frame_about(to_vector(n), {});
        Patch patch{};
        patch.count = 3, patch.face = 5;  // of the contact before
        ingot::patch_of(s, to_vector(centre), to_vector(n), frame, patch);
        const std::vector<V> corners = corners_of(patch, frame);
        const double flat = 4 * static_cast<double>(hull.radius) * eps;  // a face holds its corners to the rounding of its plane
        const double near = 16 * eps * (static_cast<double>(hull.radius) + 4);
        const auto corner = [&](int i) { return V(exact(to_vector(centre)) + A * exact(hull.vertices[i])); };

        long double facing = -1, furthest = -HUGE_VALL;
        for (int i = 0; i < hull.face_count; ++i) facing = std::max<long double>(facing, n.dot(A * exact(hull.faces[i].n)));
        for (int i = 0; i < hull.vertex_count; ++i) furthest = std::max<long double>(furthest, n.dot(corner(i)));
        if (std::abs(static_cast<double>(facing) - static_cast<double>(ingot::limits::facing_cos)) < 16 * eps) continue;
        if (facing > ingot::limits::facing_cos) {
            ++faces;
            ASSERT_GE(patch.face, 0) << case_i;
            const ingot::HullFace& face = hull.faces[patch.face];
            ASSERT_NEAR(static_cast<double>(n.dot(A * exact(face.n))), static_cast<double>(facing), 16 * eps);
            ASSERT_LE(face.loop_count, Patch::corners_max) << "these hulls have no larger faces";
            ASSERT_EQ(patch.count, face.loop_count);
            for (int k = 0; k < patch.count; ++k) {
                const auto i = static_cast<std::size_t>(k);
                ASSERT_LE(static_cast<double>((corners[i] - corner(hull.loops[face.loop_first + k])).norm()), near) << case_i;
                ASSERT_NEAR(static_cast<double>(patch.height(patch.x[k], patch.y[k])), static_cast<double>(patch.z[k]),
                            8 * near + 100 * flat) << case_i;
            }
            continue;
        }
        ASSERT_EQ(patch.face, -1);
        ASSERT_NEAR(static_cast<double>(patch.height(1, 2)), static_cast<double>(patch.z[0]), near) << "level";
        // The corner that is furthest; where two are, within rounding, either.
        const auto is_furthest = [&](int i) { return n.dot(corner(i)) >= furthest - near; };
        long double flattest = HUGE_VALL;
        for (int i = 0; i < hull.edge_count; ++i) {
            if (!is_furthest(hull.edges[i].a) && !is_furthest(hull.edges[i].b)) continue;
            const V along = (corner(hull.edges[i].b) - corner(hull.edges[i].a)).normalized();
            flattest = std::min<long double>(flattest, std::abs(along.dot(n)));
        }
        if (std::abs(static_cast<double>(flattest) - static_cast<double>(ingot::limits::facing_sin)) < 100 * near) continue;
        if (flattest > ingot::limits::facing_sin) {
            ++single;
            ASSERT_EQ(patch.count, 1) << case_i;
            ASSERT_GE(static_cast<double>(n.dot(corners[0])), static_cast<double>(furthest) - near);
            continue;
        }
        ++edges;
        ASSERT_EQ(patch.count, 2) << case_i;
        bool is_edge = false;
        for (int i = 0; i < hull.edge_count; ++i) {
            const V a = corner(hull.edges[i].a), b = corner(hull.edges[i].b);
            if (static_cast<double>((a - corners[0]).norm()) > near || static_cast<double>((b - corners[1]).norm()) > near) continue;
            is_edge = true;
            EXPECT_TRUE(is_furthest(hull.edges[i].a) || is_furthest(hull.edges[i].b)) << case_i;
            EXPECT_NEAR(static_cast<double>(std::abs((b - a).normalized().dot(n))), static_cast<double>(flattest), 100 * near) << case_i;
        }
        ASSERT_TRUE(is_edge) << case_i;
    }
    EXPECT_GT(faces, 1000);
    EXPECT_GT(edges, 300);
    EXPECT_GT(single, 100);
}

struct Point2 {
    long double x, y;
};

/// A level patch with its corners on a circle, in one way round or the other.
Patch level_polygon(RandomInput& random, int corners, double z) {
    Patch patch{};
    patch.count = corners;
    patch.face = 0;
    patch.z_0 = static_cast<scalar>(z);
    const double radius = random.real(0.5, 1.5), begin = random.real(0, 6.28), turn = random.integer(0, 1) == 0 ? 1 : -1;
    const double x = random.real(-0.5, 0.5), y = random.real(-0.5, 0.5);
    for (int i = 0; i < corners; ++i) {
        const double angle = begin + turn * (i + random.real(-0.2, 0.2)) * 6.2831853 / corners;
        patch.x[i] = static_cast<scalar>(x + radius * std::cos(angle));
        patch.y[i] = static_cast<scalar>(y + radius * std::sin(angle));
        patch.z[i] = patch.z_0;
    }
    return patch;
}

Point2 corner_of(const Patch& patch, int i) { return {patch.x[i % patch.count], patch.y[i % patch.count]}; }

/// Twice the area of the triangle of an edge and a point.
long double side_of(const Patch& patch, int edge, Point2 p) {
    const Point2 a = corner_of(patch, edge), b = corner_of(patch, edge + 1);
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// 1 inside, -1 outside, 0 where rounding or the slack may decide.
int where_in(const Patch& polygon, Point2 p) {
    constexpr long double near = 0.05L;
    int left = 0, right = 0;
    for (int edge = 0; edge < polygon.count; ++edge) {
        const long double side = side_of(polygon, edge, p);
        if (std::abs(side) < near) return 0;
        ++(side > 0 ? left : right);
    }
    return left == 0 || right == 0 ? 1 : -1;
}

/// Corners of the intersection of two convex polygons: those inside of the other, and where edges cross. False where one is not clear.
bool intersection(const Patch& A, const Patch& B, std::vector<Point2>& corners) {
    for (const auto& [of, other] : {std::make_pair(&A, &B), std::make_pair(&B, &A)}) {
        for (int i = 0; i < of->count; ++i) {
            const int where = where_in(*other, corner_of(*of, i));
            if (where == 0) return false;
            if (where > 0) corners.push_back(corner_of(*of, i));
        }
    }
    for (int i = 0; i < A.count; ++i) {
        for (int j = 0; j < B.count; ++j) {
            const long double from = side_of(B, j, corner_of(A, i)), to = side_of(B, j, corner_of(A, i + 1));
            const bool cross_A = (from > 0) != (to > 0), cross_B = (side_of(A, i, corner_of(B, j)) > 0) != (side_of(A, i, corner_of(B, j + 1)) > 0);
            if (!cross_A || !cross_B) continue;
            const long double t = from / (from - to);
            const Point2 a = corner_of(A, i), b = corner_of(A, i + 1);
            corners.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
        }
    }
    return true;
}

ingot::Found nothing_found() {
    ingot::Found found{};
    found.margin = 10;
    found.gap = -10;
    found.nearby_sq = scalar(1e-12);
    return found;
}

/// An edge is up to 3 m, and a side a product of two of them: rounded by 36 epsilon. The sides of the ends of an edge that crosses another are 0.1
/// apart and more, so that where it does is known to 2 * 36 epsilon / 0.1 of its length.
TEST(Overlay, of_two_polygons_is_the_corners_of_their_intersection) {
    RandomInput random(1442);
    const long double near = 3 * 720 * eps;
    int compared = 0;
    for (int case_i = 0; case_i < 2000; ++case_i) {
        const Patch A = level_polygon(random, random.integer(3, 6), 0.25), B = level_polygon(random, random.integer(3, 6), -0.5);
        std::vector<Point2> expected;
        if (!intersection(A, B, expected)) continue;
        ingot::Found found = nothing_found();
        ingot::overlay(A, B, 0, 0, found);
        ASSERT_EQ(found.count, static_cast<int>(expected.size())) << case_i;
        for (const Point2& point : expected) {
            bool is_there = false;
            for (int i = 0; i < found.count && !is_there; ++i)
                is_there = std::hypot(found.candidates[i].x - point.x, found.candidates[i].y - point.y) <= near;
            EXPECT_TRUE(is_there) << case_i << ": " << static_cast<double>(point.x) << " " << static_cast<double>(point.y);
        }
        for (int i = 0; i < found.count; ++i) EXPECT_EQ(found.candidates[i].separation, scalar(0.75));
        ++compared;
    }
    EXPECT_GT(compared, 500);
}

Patch level_line(Point2 from, Point2 to) {
    Patch patch{};
    patch.count = 2;
    patch.face = -1;
    patch.x[0] = static_cast<scalar>(from.x), patch.y[0] = static_cast<scalar>(from.y);
    patch.x[1] = static_cast<scalar>(to.x), patch.y[1] = static_cast<scalar>(to.y);
    return patch;
}

/// Edges that are not parallel meet in one point, however short one of them is.
TEST(Overlay, of_two_edges_that_cross_is_one_point) {
    const long double length_A = 2, length_B = 0.0625L;
    for (const long double sin : {1.0L, 0.5L, -0.25L}) {
        const long double cos = std::sqrt(1 - sin * sin), x = 0.25L, y = 0.125L;  // where they cross, a quarter along B
        const Patch A = level_line({x - length_A / 2, y}, {x + length_A / 2, y});
        const Patch B = level_line({x - cos * length_B / 4, y - sin * length_B / 4}, {x + cos * length_B * 3 / 4, y + sin * length_B * 3 / 4});
        for (const bool swapped : {false, true}) {
            ingot::Found found = nothing_found();
            ingot::overlay(swapped ? B : A, swapped ? A : B, 0, scalar(1e-3), found);
            ASSERT_EQ(found.count, 1);
            EXPECT_NEAR(static_cast<double>(found.candidates[0].x), static_cast<double>(x), 16 * eps);
            EXPECT_NEAR(static_cast<double>(found.candidates[0].y), static_cast<double>(y), 16 * eps);
        }
    }
}

}  // namespace

// SPDX-License-Identifier: MIT
// Hulls made from points: Euler's formula, every point inside, volumes in closed form, and what is refused.
#include <gtest/gtest.h>

#include <limits>

#include "collide/placed.h"

namespace {

using namespace ingot_collide;
using Eigen::Vector3d;
using ingot::ConvexHull;
using ingot::Status;
using ingot::Vector;

// At compile time, from the constants of a user.
constexpr auto octahedron = ingot::convex_hull({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
static_assert(octahedron.ok() && octahedron.value.vertex_count == 6 && octahedron.value.face_count == 8 &&
              octahedron.value.edge_count == 12);
constexpr auto flat = ingot::convex_hull({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}});
static_assert(flat.status == Status::bad_shape);
constexpr auto three = ingot::convex_hull({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}});
static_assert(three.status == Status::bad_shape);

double volume_of(const ConvexHull& hull) {
    double six_volumes = 0;
    const auto at = [&](int i) { return Eigen::Vector3d(exact(hull.vertices[i]).cast<double>()); };
    for (int f = 0; f < hull.face_count; ++f) {
        const std::uint8_t* loop = hull.loops + hull.faces[f].loop_first;
        for (int k = 1; k + 1 < hull.faces[f].loop_count; ++k)
            six_volumes += at(loop[0]).dot(at(loop[k]).cross(at(loop[k + 1])));
    }
    return six_volumes / 6;
}

/// Outward faces over all points, edges with a face on either side, each edge once, loops counter-clockwise.
void expect_sound(const ConvexHull& hull, const std::vector<Vector>& points) {
    EXPECT_EQ(hull.vertex_count - hull.edge_count + hull.face_count, 2);
    double size = 0;
    for (const Vector& p : points) size = std::max(size, static_cast<double>((exact(p) - exact(points[0])).norm()));
    // The builder's own tolerance, four times for a face of points that are each that far off, and the rounding of the plane.
    const double tolerance =
        4 * static_cast<double>(ingot::limits::hull_flatness) * size + 8 * ingot::epsilon * static_cast<double>(hull.radius);
    for (int f = 0; f < hull.face_count; ++f) {
        const ingot::HullFace& face = hull.faces[f];
        EXPECT_NEAR(static_cast<double>(exact(face.n).norm()), 1, 4 * ingot::epsilon);
        for (const Vector& p : points) EXPECT_LE(static_cast<double>(exact(face.n).dot(exact(p)) - face.offset), tolerance);
        EXPECT_LE(static_cast<double>(exact(face.n).dot(exact(hull.centre)) - face.offset),
                  -0.999 * static_cast<double>(hull.inner_radius));
        EXPECT_GE(face.loop_count, 3);
    }
    std::vector<int> uses(static_cast<std::size_t>(hull.face_count));
    for (int e = 0; e < hull.edge_count; ++e) {
        const ingot::HullEdge& edge = hull.edges[e];
        for (const bool left : {true, false}) {
            const std::size_t f = left ? edge.face_left : edge.face_right;
            const int from = left ? edge.a : edge.b, to = left ? edge.b : edge.a;
            const std::uint8_t* loop = hull.loops + hull.faces[f].loop_first;
            const int count = hull.faces[f].loop_count;
            bool has = false;
            for (int k = 0; k < count; ++k) has |= loop[k] == from && loop[(k + 1) % count] == to;
            EXPECT_TRUE(has) << "edge " << e;
            ++uses[f];
        }
    }
    for (std::size_t f = 0; f < uses.size(); ++f) EXPECT_EQ(uses[f], hull.faces[f].loop_count);
    for (const Vector& p : points) EXPECT_LE(exact(p).norm(), hull.radius);
    EXPECT_GT(hull.inner_radius, 0);
}

TEST(Hull, faces_hold_all_points) {
    RandomInput random(1431);
    int made = 0;
    for (int i = 0; i < 600; ++i) {
        Vector points[24];
        const int few = random.integer(4, 24);
        for (int k = 0; k < 24; ++k) {
            Vector3d p = i % 2 == 0 ? random.direction() : Vector3d(random.vector(1));
            if (i % 5 == 0) p(2) *= 0.01;
            if (i % 7 == 0) p = (p * 3).array().round() / 3;  // many on one plane
            points[k] = k < few ? to_vector(Vector3d(p + Vector3d(0.5, -2, 1))) : points[k % few];
        }
        const auto hull = ingot::convex_hull(points);
        if (!hull.ok()) continue;  // the rounded ones may be flat
        ++made;
        expect_sound(hull.value.view(), {points, points + 24});
    }
    EXPECT_GT(made, 570);
}

/// Boxes turned at random keep six faces of four corners, prisms their two large faces; volumes in closed form.
TEST(Hull, solids_keep_their_faces) {
    RandomInput random(1432);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Matrix3d T = random.rotation();
        const Vector3d half(random.real(0.1, 3), random.real(0.1, 3), random.real(0.1, 3));
        Vector box[9], prism[24];
        for (int k = 0; k < 8; ++k)
            box[k] = to_vector(Vector3d(
                T * Vector3d((k & 1) ? half(0) : -half(0), (k & 2) ? half(1) : -half(1), (k & 4) ? half(2) : -half(2))));
        box[8] = {0, 0, 0};
        const auto hull = ingot::convex_hull(box);
        ASSERT_TRUE(hull.ok()) << i;
        EXPECT_EQ(hull.value.face_count, 6);
        EXPECT_EQ(hull.value.vertex_count, 8);
        EXPECT_EQ(hull.value.edge_count, 12);
        expect_sound(hull.value.view(), {box, box + 9});
        EXPECT_NEAR(volume_of(hull.value.view()) / (8 * half.prod()), 1, 100 * ingot::epsilon);
        const double angle = 3.14159265358979 / 6;
        for (int k = 0; k < 24; ++k)
            prism[k] =
                to_vector(Vector3d(T * Vector3d(std::cos(angle * (k % 12)), std::sin(angle * (k % 12)), k < 12 ? -0.5 : 0.5)));
        const auto round = ingot::convex_hull(prism);
        ASSERT_TRUE(round.ok()) << i;
        EXPECT_EQ(round.value.face_count, 14);
        expect_sound(round.value.view(), {prism, prism + 24});
        EXPECT_NEAR(volume_of(round.value.view()), 12 * 0.5 * std::sin(angle), 100 * ingot::epsilon);
    }
}

TEST(Hull, degenerate_points_are_refused) {
    RandomInput random(1433);
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN(), inf = std::numeric_limits<scalar>::infinity();
    for (int i = 0; i < 200; ++i) {
        const Eigen::Matrix3d T = random.rotation();
        Vector plane[12], line[12], spot[12], bad[12];
        for (int k = 0; k < 12; ++k) {
            plane[k] = to_vector(Vector3d(T * Vector3d(random.real(-1, 1), random.real(-1, 1), 0)));
            line[k] = to_vector(Vector3d(T.col(0) * random.real(-1, 1)));
            spot[k] = to_vector(Vector3d(T.col(0) * 3));
            bad[k] = to_vector(Vector3d(random.direction()));
        }
        EXPECT_EQ(ingot::convex_hull(plane).status, Status::bad_shape) << i;
        EXPECT_EQ(ingot::convex_hull(line).status, Status::bad_shape) << i;
        EXPECT_EQ(ingot::convex_hull(spot).status, Status::bad_shape) << i;
        ASSERT_TRUE(ingot::convex_hull(bad).ok());
        bad[random.integer(0, 11)].y = i % 2 == 0 ? nan : -inf;
        EXPECT_EQ(ingot::convex_hull(bad).status, Status::not_finite) << i;
    }
    Vector many[33];
    for (Vector& p : many) p = to_vector(Vector3d(random.direction()));
    EXPECT_EQ(ingot::convex_hull(many).status, Status::no_room);
    Vector far[4] = {{0, 0, 0}, {scalar(2e9), 0, 0}, {0, 1, 0}, {0, 0, 1}};
    EXPECT_EQ(ingot::convex_hull(far).status, Status::out_of_range);
}

/// The mass of a hull is that of the box it is.
/// Found by fuzz_hull: a needle, but for limits::hull_flatness, whose faces met three at an edge and yet added up by Euler's formula.
TEST(Hull, of_a_needle_is_refused) {
    const ingot::scalar length = static_cast<ingot::scalar>(4 / static_cast<double>(ingot::limits::hull_flatness));
    const ingot::Vector points[] = {{ingot::scalar(2.85205078), 0, 0},
                                    {ingot::scalar(-0.84375), 1, -length},
                                    {ingot::scalar(0.0814208984), ingot::scalar(-3.1373291), ingot::scalar(0.00207519531)},
                                    {ingot::scalar(-0.84375), ingot::scalar(2.85205078), 0},
                                    {0, 0, 0}};
    // In double such a needle is longer than a shape may be.
    EXPECT_EQ(ingot::convex_hull(points).status, length > ingot::limits::size_max ? Status::out_of_range : Status::bad_shape);
}

TEST(Hull, has_the_mass_of_its_solid) {
    constexpr auto box = ingot::convex_hull(
        {{1, 2, 3}, {-1, 2, 3}, {1, -2, 3}, {-1, -2, 3}, {1, 2, -3}, {-1, 2, -3}, {1, -2, -3}, {-1, -2, -3}});
    static_assert(box.ok());
    constexpr auto mass = ingot::solid_hull(10, box.value.view());
    static_assert(mass.ok());
    EXPECT_NEAR(static_cast<double>(mass.value.M), 480, 480 * 8 * ingot::epsilon);
}

}  // namespace

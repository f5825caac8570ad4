// SPDX-License-Identifier: MIT
// What a shape turns towards a contact: the face that faces it, else the flattest edge of the corner that is furthest, else that corner.
#include <gtest/gtest.h>
#include <ingot/collide/contact_patch.h>

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

}  // namespace

// SPDX-License-Identifier: MIT
// Normal cones of fixed hulls: against their definition, in long double, for hulls of every sort, wherever they are. And which points are below the
// axis of a cylinder.
#include <gtest/gtest.h>

#include <ingot/narrow_phase/normal_cone.h>

#include <vector>

#include "collide/placed.h"

namespace {

using namespace ingot_collide;
using Eigen::Vector3d;

/// How far d is from the cone of all sums of the normals with weights of no sign but plus: some such sum of three of them at most is the nearest
/// (Caratheodory), so all sets of up to three are tried.
long double distance_from_cone(const std::vector<V>& normals, const V& d) {
    long double least = d.norm();
    const auto consider = [&](const V& nearest) { least = std::min(least, (d - nearest).norm()); };
    for (std::size_t i = 0; i < normals.size(); ++i) {
        if (d.dot(normals[i]) > 0) consider(normals[i] * d.dot(normals[i]));
        for (std::size_t k = 0; k < i; ++k) {
            Eigen::Matrix<long double, 3, 2> two;
            two << normals[i], normals[k];
            const Eigen::Matrix<long double, 2, 1> weights = (two.transpose() * two).ldlt().solve(two.transpose() * d);
            if (weights.minCoeff() > 0) consider(two * weights);
            for (std::size_t m = 0; m < k; ++m) {
                Eigen::Matrix<long double, 3, 3> three;
                three << normals[i], normals[k], normals[m];
                if (std::abs(three.determinant()) < 1e-6L) continue;  // one of them is a sum of the others, or all but
                if ((three.inverse() * d).minCoeff() > 0) consider(d);
            }
        }
    }
    return least;
}

/// A hull somewhere, and a point of it: a corner, or on an edge, or in a face, with the normals of the faces that meet there.
struct PointOfHull {
    PlacedShape T;
    V p;
    std::vector<V> normals;
};

PointOfHull point_of_hull(RandomInput& random) {
    PointOfHull point;
    const ingot::ConvexHull& hull = *hull_of(random);
    point.T = {{ShapeKind::hull, {}}, to_vector(random.vector(3)), to_matrix(random.rotation()), &hull};
    const ingot::HullEdge& edge = hull.edges[random.integer(0, hull.edge_count - 1)];
    const V a = exact(hull.vertices[edge.a]), b = exact(hull.vertices[edge.b]);
    const int kind = random.integer(0, 2);
    V q = kind == 0 ? a : V(a + (b - a) * static_cast<long double>(random.real(0.1, 0.9)));
    if (kind == 2) {
        const ingot::HullFace& face = hull.faces[edge.face_left];
        V middle = V::Zero();
        for (int k = 0; k < face.loop_count; ++k) middle += exact(hull.vertices[hull.loops[face.loop_first + k]]) / face.loop_count;
        q += (middle - q) * 0.5L;
    }
    for (int i = 0; i < hull.face_count; ++i) {
        const ingot::HullFace& face = hull.faces[i];
        const std::uint8_t* loop = hull.loops + face.loop_first;
        bool meets = kind == 2 ? i == edge.face_left : kind == 1 && (i == edge.face_left || i == edge.face_right);
        for (int k = 0; kind == 0 && k < face.loop_count; ++k) meets = meets || loop[k] == edge.a;
        if (meets) point.normals.push_back(exact(point.T.A) * exact(face.n));
    }
    point.p = exact(point.T.r) + exact(point.T.A) * q;
    return point;
}

/// What is outside of the normal cone by more than the tilt is hidden, and what is in it is not.
TEST(NormalCone, of_a_hull_is_of_the_faces_that_meet) {
    RandomInput random(1441);
    const long double tilt = ingot::limits::edge_tilt;
    int hidden = 0, seen = 0;
    for (int i = 0; i < 20000; ++i) {
        const PointOfHull at = point_of_hull(random);
        if (at.normals.size() > 8) continue;  // Wedge::faces_max
        // Of 6 m, a turn and a product each; the faces around are as flat as a hull of 2 m has them.
        const scalar flush = 64 * ingot::epsilon + 8 * ingot::limits::hull_flatness;
        bool others = false;  // sharp corners have faces nearby that do not meet in them
        for (int f = 0; f < at.T.hull->face_count; ++f) {
            const ingot::HullFace& face = at.T.hull->faces[f];
            const V n = exact(at.T.A) * exact(face.n);
            bool meets = false;
            for (const V& of : at.normals) meets = meets || (of - n).norm() < 1e-12L;
            others = others || (!meets && n.dot(at.p - exact(at.T.r)) - static_cast<long double>(face.offset) > -2 * static_cast<long double>(flush));
        }
        if (others) continue;
        V d = exact(to_vector(random.direction())).normalized();
        long double weights = 0;
        if (i % 2 == 0) {
            d = V::Zero();
            for (const V& n : at.normals) {
                const long double weight = random.real(0, 1);
                d += n * weight;
                weights += weight;
            }
            if (d.norm() < 0.01L) continue;
            weights /= d.norm();
            d.normalize();
        }
        const ingot::Touch touch = {to_vector(at.p.cast<double>()), to_vector(d.cast<double>()), ingot::limits::edge_tilt, false, {}};
        const bool answer = ingot::hidden_by_hull(at.T, touch, touch.p, flush);
        const long double off = distance_from_cone(at.normals, exact(touch.d));
        if (off > tilt + 64 * static_cast<long double>(ingot::epsilon)) {
            ++hidden;
            ASSERT_TRUE(answer) << i << ": off by " << off << ", of " << at.normals.size() << " faces";
        }
        // A way that counts as along the hull may lead out of each face by half the tilt, and out of d by the sum of the weights as much.
        if (i % 2 == 0 && weights < 1.9L) {
            ++seen;
            ASSERT_FALSE(answer) << i << ": a sum of normals, of " << at.normals.size() << " faces";
        }
    }
    EXPECT_GT(hidden, 4000);
    EXPECT_GT(seen, 3000);
}

/// A direction that was searched for is off by thousandths. So little leads from the inside of a face to no edge, from the middle of an edge to no
/// corner; what is off by more, or leads over an edge that is near, belongs to the edge.
TEST(PutOnHull, does_not_go_to_what_is_far_away) {
    RandomInput random(1443);
    const double far = static_cast<double>(ingot::limits::far_side);
    const double off_least = 2 * static_cast<double>(ingot::limits::edge_tilt), off_most = static_cast<double>(ingot::limits::face_tilt) / 2;
    int faces = 0, edges = 0, near_edges = 0;
    for (int i = 0; i < 20000; ++i) {
        const ingot::ConvexHull& hull = *hull_of(random);
        const PlacedShape T = {{ShapeKind::hull, {}}, to_vector(random.vector(3)), to_matrix(random.rotation()), &hull};
        const ingot::HullEdge& edge = hull.edges[random.integer(0, hull.edge_count - 1)];
        const V a = exact(hull.vertices[edge.a]), b = exact(hull.vertices[edge.b]), along = (b - a).normalized();
        const V n = exact(hull.faces[edge.face_left].n), m = exact(hull.faces[edge.face_right].n);
        if (n.dot(m) > 0.9L || hull.inner_radius < hull.radius / 20) continue;  // a face of its own each, and no sliver
        const ingot::HullFace& face = hull.faces[edge.face_left];
        const V on_edge = a + (b - a) * static_cast<long double>(random.real(0.2, 0.8));
        const double off = random.real(off_least, off_most);
        const auto put = [&](const V& q, const V& d) {
            const ingot::Vector p = T.r + T.A * to_vector(q.cast<double>()), d_world = T.A * to_vector(d.normalized().cast<double>());
            ingot::Touch touch = {p, d_world, ingot::limits::edge_tilt, false, {}};
            ingot::put_on_hull(T, touch);
            return touch;
        };
        const auto moved = [&](const ingot::Touch& touch, const V& q) { return (exact(touch.p) - exact(T.r) - exact(T.A) * q).norm(); };
        // Of places of 4 m, and a turn; faces are as flat as a hull of 2 m has them.
        const long double slack = 64 * static_cast<long double>(ingot::epsilon) + 8 * static_cast<long double>(ingot::limits::hull_flatness);
        V middle = V::Zero();
        for (int k = 0; k < face.loop_count; ++k) middle += exact(hull.vertices[hull.loops[face.loop_first + k]]) / face.loop_count;
        // How far a point of the face is inside of its edges, but for one; 0 beside a face so much in its plane that either may be meant.
        const auto inside_of = [&](const V& q, int but_for) {
            double inside = 1e9;
            for (int f = 0; f < hull.face_count; ++f) {
                const V of = exact(hull.faces[f].n), across = of - n * n.dot(of);
                if (f == edge.face_left || f == but_for) continue;
                const auto far_in = static_cast<double>((static_cast<long double>(hull.faces[f].offset) - of.dot(q)) / across.norm());
                inside = across.norm() < 2 * static_cast<long double>(ingot::limits::face_tilt) ? 0 : std::min(inside, far_in);
            }
            return inside;
        };
        const double near = far * static_cast<double>(hull.inner_radius);
        const V aside = V(n.cross(exact(to_vector(random.direction())))).normalized();
        if (inside_of(middle, -1) > 2 * near) {
            const ingot::Touch touch = put(middle, n + aside * static_cast<long double>(off));
            EXPECT_TRUE(touch.face) << i;
            EXPECT_LE(moved(touch, middle), slack) << i;
            ++faces;
        }
        const V between = (n + m).normalized() + along * static_cast<long double>(random.integer(0, 1) == 0 ? off : -off);
        long double furthest = 0;
        for (int k = 0; k < hull.vertex_count; ++k) furthest = std::max(furthest, between.dot(exact(hull.vertices[k])));
        if (furthest <= std::max(between.dot(a), between.dot(b))) {  // else an edge goes on from its end, all but straight
            const ingot::Touch touch = put(on_edge, between);
            EXPECT_FALSE(touch.face) << i;
            EXPECT_LE(moved(touch, on_edge), slack) << i << " along an edge";
            ++edges;
        }
        // Just inside of that edge, and off towards it.
        const V out = along.cross(n), q = on_edge - out * static_cast<long double>(near / 2);
        if (!(inside_of(q, edge.face_right) > 2 * near)) continue;
        const ingot::Touch over = put(q, n + out * static_cast<long double>(off));
        EXPECT_FALSE(over.face) << i;
        EXPECT_LE(moved(over, on_edge), slack) << i << " at an edge";
        ++near_edges;
    }
    EXPECT_GT(faces, 2000);
    EXPECT_GT(edges, 5000);
    EXPECT_GT(near_edges, 1000);
}

/// Below the axis of a cylinder is what is in the plane of the axis and of what is up: wherever the cylinder is and however far along.
TEST(NormalCone, a_point_is_below_the_axis_wherever_the_cylinder_is) {
    RandomInput random(1442);
    for (int i = 0; i < 20000; ++i) {
        // No longer and no deeper than the radius: of such a way, eight roundings are less than what it is let be off.
        const double r = random.real(0.05, 2), h = random.real(0.05, 1) * r;
        const PlacedShape s = placed(ingot::Cylinder{scalar(r), scalar(h)}, random.vector(i % 3 == 0 ? 0.5 : 30), random.rotation());
        const V axis = exact(s.A.c2), d = exact(to_vector(random.direction())), aside = axis.cross(d);
        if (aside.norm() < 0.5L) continue;
        const double sign = random.integer(0, 1) == 0 ? -1 : 1;
        const V below = exact(s.r) + axis * static_cast<long double>(random.real(-h, h)) - d * static_cast<long double>(random.real(0, 1) * r);
        const auto point_at = [&](long double off) { return to_vector((below + aside.normalized() * (sign * off)).cast<double>()); };
        // As much as it is let be off, and what the two places and the product lose.
        const long double slack = static_cast<long double>(ingot::limits::off_round) * static_cast<long double>(r);
        const long double lost = 8 * static_cast<long double>(ingot::epsilon) * (below.norm() + exact(s.r).norm()) / aside.norm();
        EXPECT_TRUE(ingot::is_below_axis(s, point_at(0), to_vector(d.cast<double>()))) << i;
        EXPECT_FALSE(ingot::is_below_axis(s, point_at(2 * (slack + lost)), to_vector(d.cast<double>()))) << i;
    }
}

}  // namespace

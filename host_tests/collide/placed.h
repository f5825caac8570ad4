// SPDX-License-Identifier: MIT
// Shapes at random places, for the kernel and for the oracle.
#pragma once

#include <ingot/shape/hull_of_points.h>
#include <ingot/narrow_phase/find_manifolds.h>

#include <array>
#include <deque>
#include <string>

#include "collide/convex_oracle.h"
#include "reference/kernel_types.h"
#include "reference/random_input.h"

namespace ingot_collide {

using ingot::Manifold;
using ingot::PlacedShape;
using ingot::scalar;
using ingot::Shape;
using ingot::ShapeKind;
using ingot_reference::RandomInput;
using ingot_reference::to_matrix;
using ingot_reference::to_vector;
using V = ingot_oracle::V;

inline V exact(const ingot::Vector& v) { return {v.x, v.y, v.z}; }
inline Eigen::Matrix<long double, 3, 3> exact(const ingot::Matrix& A) {
    Eigen::Matrix<long double, 3, 3> m;
    m << exact(A.c0), exact(A.c1), exact(A.c2);
    return m;
}

/// Of the numbers the kernel is given, exactly. `prism_sides`: for cylinders.
inline ingot_oracle::Convex oracle_of(const PlacedShape& s, int prism_sides = 48) {
    const V r = exact(s.r);
    const auto A = exact(s.A);
    const long double x = s.shape.size.x, y = s.shape.size.y;
    switch (s.shape.kind) {
        case ShapeKind::sphere: return ingot_oracle::point(r, x);
        case ShapeKind::capsule: return ingot_oracle::segment(r - A.col(2) * y, r + A.col(2) * y, x);
        case ShapeKind::box: return ingot_oracle::box(r, A, exact(s.shape.size));
        case ShapeKind::cylinder: return ingot_oracle::prism(r, A, x, y, prism_sides);
        case ShapeKind::hull: {
            std::vector<V> corners;
            for (int i = 0; i < s.hull->vertex_count; ++i) corners.push_back(r + A * exact(s.hull->vertices[i]));
            std::vector<std::vector<int>> loops;
            for (int i = 0; i < s.hull->face_count; ++i) {
                const ingot::HullFace& face = s.hull->faces[i];
                const std::uint8_t* loop = s.hull->loops + face.loop_first;
                loops.emplace_back(loop, loop + face.loop_count);
            }
            return ingot_oracle::polyhedron(corners, loops);
        }
        default: return {};
    }
}

inline PlacedShape placed(const Shape& shape, const Eigen::Vector3d& r = Eigen::Vector3d::Zero(),
                          const Eigen::Matrix3d& A = Eigen::Matrix3d::Identity()) {
    return {shape, to_vector(r), to_matrix(A), nullptr};
}

/// Hulls of every sort, made once: rocks of 4 to 30 corners, prisms, a cube, slivers.
inline const ingot::ConvexHull* hull_of(RandomInput& random) {
    struct Kept {
        ingot::HullOf<30> hull;
        ingot::ConvexHull view;
    };
    static std::deque<Kept> all;
    if (all.empty()) {
        RandomInput own(77);
        while (all.size() < 40) {
            const std::size_t kind = all.size() % 4;
            ingot::Vector points[30];
            const int count = own.integer(4, 30);
            for (int i = 0; i < 30; ++i) {
                const int k = i % count, side = i % 6;
                Eigen::Vector3d p = own.direction() * own.real(0.7, 1);
                if (kind == 1) p = {std::cos(1.0471975512 * side), std::sin(1.0471975512 * side), i % 12 < 6 ? -0.4 : 0.4};
                if (kind == 2) p = {(i & 1) ? 1.0 : -1.0, (i & 2) ? 0.7 : -0.7, (i & 4) ? 0.5 : -0.5};
                if (kind == 3) p = {p(0), p(1) * 0.05, p(2) * 0.05};
                points[i] = k == i || kind == 1 || kind == 2 ? to_vector(p) : points[k];
            }
            const auto made = ingot::convex_hull(points);
            if (!made.ok()) continue;
            all.push_back({made.value, {}});
            all.back().view = all.back().hull.view();
        }
    }
    return &all[static_cast<std::size_t>(random.integer(0, 39))].view;
}

inline double size_of(const PlacedShape& s) { return static_cast<double>(ingot::bounding_radius(s.shape)); }

inline Eigen::Matrix3d turned(const Eigen::Vector3d& axis, double angle) {
    return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// The routine of two kinds, by the kernel's own list.
inline bool collide(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                    const Manifold* before = nullptr) {
    using All = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::Hull, ingot::HalfSpace>;
    return ingot::collide_pair<All>(A, B, margin, manifold, before);
}

inline long double least(const Manifold& m) {
    long double s = HUGE_VALL;
    for (int i = 0; i < m.count; ++i) s = std::min<long double>(s, m.points[i].separation);
    return s;
}

}  // namespace ingot_collide

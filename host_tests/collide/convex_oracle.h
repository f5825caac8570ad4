// SPDX-License-Identifier: MIT
// Distance and depth of convex polyhedra with a radius, by going through all their features. Knows no kernel.
//
// Apart: the least distance of any vertex to any triangle and of any two edges. Overlapping: the largest separation along any
// face normal or product of two edges, which is minus the depth. Both in long double; nothing is skipped, nothing iterates.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ingot_oracle {

using Real = long double;
using V = Eigen::Matrix<Real, 3, 1>;

struct Convex {
    std::vector<V> vertices;
    std::vector<V> normals;                   ///< of its faces
    std::vector<std::array<V, 3>> triangles;  ///< that cover its surface
    std::vector<std::array<V, 2>> edges;
    Real radius = 0;
    Real size = 0;  ///< of the ball about its middle
    V middle = V::Zero();

    Real support(const V& n) const {
        Real most = -HUGE_VALL;
        for (const V& v : vertices) most = std::max(most, n.dot(v));
        return most;
    }
    Convex moved(const V& by) const {
        Convex m = *this;
        for (V& v : m.vertices) v += by;
        for (auto& t : m.triangles)
            for (V& v : t) v += by;
        for (auto& e : m.edges)
            for (V& v : e) v += by;
        m.middle += by;
        return m;
    }
};

inline V nearest_on_triangle(const V& p, const std::array<V, 3>& t) {
    const V n = (t[1] - t[0]).cross(t[2] - t[0]);
    bool inside = n.squaredNorm() > 0;
    for (std::size_t i = 0; i < 3 && inside; ++i) inside = n.dot((t[(i + 1) % 3] - t[i]).cross(p - t[i])) >= 0;
    if (inside) return p - n * (n.dot(p - t[0]) / n.squaredNorm());
    V best = t[0];
    for (std::size_t i = 0; i < 3; ++i) {
        const V a = t[i], e = t[(i + 1) % 3] - a;
        const Real s = e.squaredNorm() > 0 ? std::clamp<Real>(e.dot(p - a) / e.squaredNorm(), 0, 1) : 0;
        const V q = a + s * e;
        if ((q - p).squaredNorm() < (best - p).squaredNorm()) best = q;
    }
    return best;
}

inline Real edge_distance(const std::array<V, 2>& a, const std::array<V, 2>& b) {
    const V u = a[1] - a[0], v = b[1] - b[0], w = a[0] - b[0];
    Real best = HUGE_VALL;
    const auto from_a = [&](Real s) {
        const V p = a[0] + s * u;
        const Real t = v.squaredNorm() > 0 ? std::clamp<Real>(v.dot(p - b[0]) / v.squaredNorm(), 0, 1) : 0;
        best = std::min(best, (p - b[0] - t * v).norm());
    };
    const auto from_b = [&](Real t) {
        const V q = b[0] + t * v;
        const Real s = u.squaredNorm() > 0 ? std::clamp<Real>(u.dot(q - a[0]) / u.squaredNorm(), 0, 1) : 0;
        best = std::min(best, (a[0] + s * u - q).norm());
    };
    from_a(0), from_a(1), from_b(0), from_b(1);
    const Real uu = u.dot(u), vv = v.dot(v), uv = u.dot(v), det = uu * vv - uv * uv;
    if (det > 1e-16L * uu * vv) from_a(std::clamp<Real>((uv * v.dot(w) - vv * u.dot(w)) / det, 0, 1));
    return best;
}

/// n from B to A.
struct Separation {
    Real s;
    V n;
};

/// The largest gap between the shadows on any of the axes; radii left out.
inline Separation best_axis(const Convex& a, const Convex& b) {
    Separation best{-HUGE_VALL, V::UnitX()};
    const auto look = [&](V n) {
        const Real length = n.norm();
        if (!(length > 1e-9L)) return;
        n /= length;
        for (const Real sign : {Real(1), Real(-1)}) {
            const V m = sign * n;
            const Real s = -a.support(-m) - b.support(m);
            if (s > best.s) best = {s, m};
        }
    };
    for (const V& n : a.normals) look(n);
    for (const V& n : b.normals) look(n);
    for (const auto& e : a.edges)
        for (const auto& f : b.edges) {
            const V u = (e[1] - e[0]).normalized(), v = (f[1] - f[0]).normalized();
            look(u.cross(v));
        }
    // Points and lines have few axes of their own.
    if (a.normals.empty() || b.normals.empty()) look(a.middle - b.middle);
    return best;
}

/// Distance of the surfaces, negative where they overlap.
inline Real signed_distance(const Convex& a, const Convex& b) {
    if (!a.normals.empty() || !b.normals.empty()) {
        const Separation axis = best_axis(a, b);
        if (axis.s <= 0) return axis.s - a.radius - b.radius;
    }
    Real best = HUGE_VALL;
    for (const V& p : a.vertices)
        for (const auto& t : b.triangles) best = std::min(best, (p - nearest_on_triangle(p, t)).norm());
    for (const V& p : b.vertices)
        for (const auto& t : a.triangles) best = std::min(best, (p - nearest_on_triangle(p, t)).norm());
    for (const auto& e : a.edges)
        for (const auto& f : b.edges) best = std::min(best, edge_distance(e, f));
    for (const V& p : a.vertices)
        for (const V& q : b.vertices) best = std::min(best, (p - q).norm());
    for (const V& p : a.vertices)
        for (const auto& f : b.edges) best = std::min(best, edge_distance({p, p}, f));
    for (const V& q : b.vertices)
        for (const auto& e : a.edges) best = std::min(best, edge_distance(e, {q, q}));
    return best - a.radius - b.radius;
}

inline Convex point(const V& p, Real radius) {
    Convex c;
    c.vertices = {p};
    c.radius = radius, c.size = radius, c.middle = p;
    return c;
}

inline Convex segment(const V& p, const V& q, Real radius) {
    Convex c;
    c.vertices = {p, q};
    c.edges = {{p, q}};
    c.radius = radius, c.size = radius + (p - q).norm() / 2, c.middle = (p + q) / 2;
    return c;
}

/// From its faces as loops of corners, counter-clockwise from outside.
inline Convex polyhedron(const std::vector<V>& corners, const std::vector<std::vector<int>>& loops) {
    Convex c;
    c.vertices = corners;
    for (const V& v : corners) c.middle += v / static_cast<Real>(corners.size());
    for (const V& v : corners) c.size = std::max(c.size, (v - c.middle).norm());
    for (const auto& loop : loops) {
        const auto at = [&](std::size_t i) { return corners[static_cast<std::size_t>(loop[i % loop.size()])]; };
        V n = V::Zero();
        for (std::size_t i = 0; i < loop.size(); ++i) {
            n += (at(i) - c.middle).cross(at(i + 1) - c.middle);
            if (loop[i] < loop[(i + 1) % loop.size()]) c.edges.push_back({at(i), at(i + 1)});
            if (i >= 2) c.triangles.push_back({at(0), at(i - 1), at(i)});
        }
        c.normals.push_back(n.normalized());
    }
    return c;
}

inline Convex box(const V& r, const Eigen::Matrix<Real, 3, 3>& A, const V& half) {
    std::vector<V> corners;
    for (int i = 0; i < 8; ++i) {
        const V local((i & 1) ? half(0) : -half(0), (i & 2) ? half(1) : -half(1), (i & 4) ? half(2) : -half(2));
        corners.push_back(r + A * local);
    }
    return polyhedron(corners, {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}});
}

/// A prism of `sides` sides inside the cylinder.
inline Convex prism(const V& r, const Eigen::Matrix<Real, 3, 3>& A, Real radius, Real half, int sides) {
    std::vector<V> corners;
    for (const Real z : {-half, half})
        for (int i = 0; i < sides; ++i) {
            const Real angle = 2 * 3.14159265358979323846L * i / sides;
            corners.push_back(r + A * V(radius * std::cos(angle), radius * std::sin(angle), z));
        }
    std::vector<std::vector<int>> loops(2);
    for (int i = 0; i < sides; ++i) {
        loops[0].push_back(sides - 1 - i);
        loops[1].push_back(sides + i);
        const int j = (i + 1) % sides;
        loops.push_back({i, j, sides + j, sides + i});
    }
    return polyhedron(corners, loops);
}

}  // namespace ingot_oracle

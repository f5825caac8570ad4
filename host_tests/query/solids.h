// SPDX-License-Identifier: MIT
// Distances of points from solids, supports of solids, and where a way enters one: in long double, and knowing no kernel but the
// numbers it was given.
#pragma once

#include <ingot/ingot.h>

#include <cmath>
#include <functional>
#include <vector>

#include "collide/placed.h"

namespace query_oracle {

using Real = long double;
using V = ingot_oracle::V;
using ingot::PlacedShape;
using ingot::ShapeKind;
using ingot_collide::exact;

/// Signed distance of a point: exact outside; inside, what is nearest to the surface of a sphere, capsule, box, cylinder or half
/// space. For a hull it is the largest height above its faces.
inline Real distance_of(const PlacedShape& s, const V& point) {
    const V p = exact(s.A).transpose() * (point - exact(s.r)), size = exact(s.shape.size);
    switch (s.shape.kind) {
        case ShapeKind::sphere: return p.norm() - size.x();
        case ShapeKind::capsule: return (p - V(0, 0, std::clamp(p.z(), -size.y(), size.y()))).norm() - size.x();
        case ShapeKind::box: {
            const V q = p.cwiseAbs() - size;
            return q.cwiseMax(Real(0)).norm() + std::min<Real>(q.maxCoeff(), 0);
        }
        case ShapeKind::cylinder: {
            const Real side = std::hypot(p.x(), p.y()) - size.x(), end = std::abs(p.z()) - size.y();
            return std::hypot(std::max<Real>(side, 0), std::max<Real>(end, 0)) + std::min<Real>(std::max(side, end), 0);
        }
        case ShapeKind::half_space: return size.dot(p) - s.shape.offset;
        case ShapeKind::hull: {
            Real most = -HUGE_VALL;
            for (int i = 0; i < s.hull->face_count; ++i) most = std::max<Real>(most, exact(s.hull->faces[i].n).dot(p) - s.hull->faces[i].offset);
            return most;
        }
        default: return HUGE_VALL;
    }
}

/// How far the solid reaches along a direction of length 1, from the origin of the world.
inline Real support_of(const PlacedShape& s, const V& n_world) {
    const V n = exact(s.A).transpose() * n_world, size = exact(s.shape.size);
    const Real r = n_world.dot(exact(s.r));
    switch (s.shape.kind) {
        case ShapeKind::sphere: return r + size.x();
        case ShapeKind::capsule: return r + size.x() + size.y() * std::abs(n.z());
        case ShapeKind::box: return r + n.cwiseAbs().dot(size);
        case ShapeKind::cylinder: return r + size.x() * std::hypot(n.x(), n.y()) + size.y() * std::abs(n.z());
        case ShapeKind::half_space: return (n - size).norm() < 1e-5L ? r + s.shape.offset : HUGE_VALL;
        case ShapeKind::hull: {
            Real most = -HUGE_VALL;
            for (int i = 0; i < s.hull->vertex_count; ++i) most = std::max<Real>(most, n.dot(exact(s.hull->vertices[i])));
            return r + most;
        }
        default: return -HUGE_VALL;
    }
}

/// A convex function on 0 .. 1: its least value, and where it first falls to zero.
struct Way {
    Real least, at_least;  ///< value, and where
    Real enters;           ///< 0: from the begin; 2: never
};

inline Way walk(const std::function<Real(Real)>& f, int turns = 120) {
    Real low = 0, high = 1;
    for (int i = 0; i < turns; ++i) {
        const Real a = low + (high - low) * 0.45L, b = low + (high - low) * 0.55L;
        if (f(a) <= f(b))
            high = b;
        else
            low = a;
    }
    Way way{f(low), low, 2};
    for (const Real t : {Real(0), Real(1), high})
        if (f(t) < way.least) way = {f(t), t, 2};
    if (way.least > 0) return way;
    if (f(0) <= 0) return {way.least, way.at_least, 0};
    low = 0, high = way.at_least;
    for (int i = 0; i < turns / 2; ++i) {
        const Real t = (low + high) / 2;
        (f(t) > 0 ? low : high) = t;
    }
    way.enters = high;
    return way;
}

}  // namespace query_oracle

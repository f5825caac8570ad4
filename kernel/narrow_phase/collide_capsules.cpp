// SPDX-License-Identifier: MIT
// A capsule is a ball swept along a stretch of a line: the nearest points of that stretch, and what lies along it.
#include "contact_geometry.h"
#include "collide_pairs.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

// Features of capsules: the two ends of the stretch along which shapes lie, or the nearest point.
constexpr uint32_t nearest_feature = 2;

/// Two points on the axes and how far they are apart.
struct Span {
    Vector p, q;
    scalar distance;
};

Span span(const Vector& p, const Vector& q) { return {p, q, sqrt(length_sq(p - q))}; }

void add_point(const Vector& P, scalar separation, uint32_t feature, scalar margin, Manifold& manifold) {
    if (separation <= margin && manifold.count < Manifold::points_max) manifold.points[manifold.count++] = {P, separation, feature};
}

}  // namespace

void collide_capsule_capsule(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold*) {
    const scalar radius_A = A.shape.size.x, radius_B = B.shape.size.x, reach = radius_A + radius_B;
    const scalar a = A.shape.size.y, b = B.shape.size.y;
    const Vector &u = A.A.c2, &v = B.A.c2, d = A.r - B.r, u_x_v = cross(u, v);
    const scalar c = dot(u, v), sin_sq = length_sq(u_x_v), u_d = dot(u, d), v_d = dot(v, d);
    // The point of B nearest to the point s of A, all seen from the centre of B.
    const auto at = [&](scalar s) { return span(d + u * s, v * clamp(c * s + v_d, b)); };

    const Span low = at(clamp(-abs(c) * b - u_d, a)), high = at(clamp(abs(c) * b - u_d, a));
    Span nearest = low.distance < high.distance ? low : high;
    if (sin_sq > limits::parallel_sin_sq) {
        const scalar on_A = clamp((c * v_d - u_d) / sin_sq, a), on_B = clamp(c * on_A + v_d, b);
        const Span crossing = at(clamp(c * on_B - u_d, a));
        if (crossing.distance < nearest.distance) nearest = crossing;
    }

    Vector n = A.A.c0;
    if (nearest.distance > 4 * epsilon * (reach + a + b)) {
        n = (nearest.p - nearest.q) * (1 / nearest.distance);
    } else if (sin_sq > limits::parallel_sin_sq) {
        n = u_x_v * ((dot(u_x_v, d) < 0 ? scalar(-1) : scalar(1)) / sqrt(sin_sq));
    }
    no_points(n, manifold);
    if (nearest.distance - reach > margin) return;

    const Vector towards_surface = B.r + n * ((radius_B - radius_A) * scalar(0.5));
    const auto add = [&](const Span& of, uint32_t feature) {
        add_point(towards_surface + (of.p + of.q) * scalar(0.5), of.distance - reach, feature, margin, manifold);
    };
    const bool lies = sin_sq <= limits::lying_sin_sq && length_sq(high.p - low.p) > limits::lying_sin_sq * reach * reach;
    if (lies) {
        // The manifold has one normal: an end that looks another way is left to the nearest point.
        scalar least = scalar_max;
        for (uint32_t end_i = 0; end_i < 2; ++end_i) {
            const Span& end = end_i == 0 ? low : high;
            if (dot(n, end.p - end.q) < limits::lying_cos * end.distance) continue;
            add(end, end_i);
            least = end.distance < least ? end.distance : least;
        }
        if (nearest.distance >= least - limits::flatness * reach) return;
    }
    add(nearest, nearest_feature);
}

namespace {

/// The stretch of a line inside a slab: lowers `high` and raises `low` to where |c + u t| <= h.
INGOT_INLINE void cut_to_slab(scalar c, scalar u, scalar h, scalar& low, scalar& high) {
    if (abs(u) <= epsilon) {
        if (abs(c) > h) high = low - 1;
        return;
    }
    const scalar inv = 1 / u, one = (-h - c) * inv, other = (h - c) * inv;
    const scalar first = one < other ? one : other, second = one < other ? other : one;
    low = first > low ? first : low;
    high = second < high ? second : high;
}

/// Where the line c + u t, |t| <= half_length, is nearest to the box |x| <= h.
///
/// Half the derivative of the squared distance, u . (p - clamp(p)), grows with t and is a straight line between the six
/// planes of the box: bisect among these, then once by the secant.
scalar nearest_to_box(const Vector& c, const Vector& u, scalar half_length, const Vector& h) {
    const auto slope = [&](scalar t) {
        const Vector p = c + u * t;
        return dot(u, p - clamp(p, h));
    };
    scalar low = -half_length, high = half_length, slope_low = slope(low), slope_high = slope(high);
    if (slope_low >= 0) return low;
    if (slope_high <= 0) return high;
    for (int plane = 0; plane < 6; ++plane) {
        const scalar along = component(u, plane >> 1), face = component(h, plane >> 1), from = component(c, plane >> 1);
        if (abs(along) <= epsilon) continue;
        const scalar t = ((plane & 1) != 0 ? face - from : -face - from) / along;
        if (!(t > low && t < high)) continue;
        const scalar s = slope(t);
        if (s < 0)
            low = t, slope_low = s;
        else
            high = t, slope_high = s;
    }
    const scalar range = slope_high - slope_low;
    return range > 0 ? low - (high - low) * (slope_low / range) : low;
}

/// A capsule beside a box, in the frame of the box, from its centre.
struct CapsuleAtBox {
    const PlacedShape& box;
    Vector c, u;                 ///< m, its centre; unit, along its axis
    scalar radius, half_length;  ///< m
    scalar margin;               ///< m

    INGOT_INLINE const Vector& h() const { return box.shape.size; }
    INGOT_INLINE Vector world(const Vector& point) const { return box.r + box.A * point; }
};

/// How the axis of the capsule and the box are apart; where they are not, the shortest way out. In the frame of the box.
struct AxisFromBox {
    Vector n;           ///< unit, from the box to the axis
    scalar distance;    ///< m, along n; negative inside
    Vector along_edge;  ///< unit, the edge of the box that crosses the axis and makes n; zero where a face does
    bool crosses;       ///< there is such an edge
};

/// Where the axis of the capsule enters the box: faces, and edges crossed with the axis where clearly better.
AxisFromBox shortest_way_out(const CapsuleAtBox& capsule) {
    const Vector &c = capsule.c, &u = capsule.u, &h = capsule.h();
    AxisFromBox way{{}, -scalar_max, {}, false};
    for (int i = 0; i < 3; ++i) {
        const scalar gap = abs(component(c, i)) - (component(h, i) + capsule.half_length * abs(component(u, i)));
        if (!(gap > way.distance)) continue;
        way.distance = gap;
        way.n = unit_axis(i, component(c, i) < 0 ? scalar(-1) : scalar(1));
    }
    const scalar preference = limits::edge_preference * smallest_of(h);
    for (int i = 0; i < 3; ++i) {
        Vector axis = cross(unit_axis(i, 1), u);
        const scalar sin_sq = length_sq(axis);
        if (!(sin_sq > limits::parallel_sin_sq)) continue;
        axis = axis * ((dot(axis, c) < 0 ? scalar(-1) : scalar(1)) / sqrt(sin_sq));
        const scalar gap = dot(axis, c) - (h.x * abs(axis.x) + h.y * abs(axis.y) + h.z * abs(axis.z));
        if (!(gap > way.distance + preference)) continue;
        way = {axis, gap, unit_axis(i, 1), true};
    }
    return way;
}

/// Both ends of the stretch over a face on which the capsule lies. False where it lies on none, or none is within the margin.
bool lie_on_face(const CapsuleAtBox& capsule, const Vector& n, Manifold& manifold) {
    const Vector &c = capsule.c, &u = capsule.u, &h = capsule.h();
    int face = 0;
    for (int i = 1; i < 3; ++i)
        if (abs(component(n, i)) > abs(component(n, face))) face = i;
    const scalar n_face = component(n, face), rise = component(u, face);
    // Beyond `flatness` the height above the face and the distance to its rim differ by more than that.
    if (!(1 - n_face * n_face <= limits::flatness && rise * rise <= limits::lying_sin_sq)) return false;

    scalar low = -capsule.half_length, high = capsule.half_length;
    for (int i = 0; i < 3; ++i)
        if (i != face) cut_to_slab(component(c, i), component(u, i), component(h, i) * (1 + limits::corner_slack), low, high);
    if (!(low <= high)) return false;

    const scalar sign = n_face < 0 ? scalar(-1) : scalar(1);
    const Vector up = unit_axis(face, sign);
    const uint32_t feature = 4u * static_cast<uint32_t>(2 * face + (sign < 0 ? 1 : 0) + 1);
    const Vector n_before = manifold.n;
    manifold.n = capsule.box.A * up;
    for (uint32_t end_i = 0; end_i < 2; ++end_i) {
        const Vector end = c + u * (end_i == 0 ? low : high);
        const scalar s = sign * component(end, face) - component(h, face) - capsule.radius;
        add_point(capsule.world(end - up * (capsule.radius + s * scalar(0.5))), s, feature + end_i, capsule.margin, manifold);
    }
    if (manifold.count > 0) return true;
    manifold.n = n_before;
    return false;
}

/// Both ends of the stretch that the capsule shares with an edge, each with its own distance. True where one of them is as near as anything.
bool lie_along_edge(const CapsuleAtBox& capsule, const Vector& n, scalar distance, Manifold& manifold) {
    const Vector &c = capsule.c, &u = capsule.u, &h = capsule.h();
    for (int i = 0; i < 3; ++i) {
        const scalar along = component(u, i);
        if (1 - along * along > limits::lying_sin_sq || component(n, i) * component(n, i) > limits::lying_sin_sq) continue;
        scalar low = -capsule.half_length, high = capsule.half_length, least = scalar_max;
        cut_to_slab(component(c, i), along, component(h, i), low, high);
        if (!(high - low > scalar(0.1) * capsule.radius)) continue;
        for (uint32_t end_i = 0; end_i < 2; ++end_i) {
            const Vector end = c + u * (end_i == 0 ? low : high), foot = clamp(end, h);
            const scalar away = sqrt(length_sq(end - foot)), s = away - capsule.radius;
            if (dot(n, end - foot) < limits::lying_cos * away) continue;
            least = away < least ? away : least;
            add_point(capsule.world(foot + n * (s * scalar(0.5))), s, 28u + 4u * static_cast<uint32_t>(i) + end_i, capsule.margin, manifold);
        }
        if (distance >= least - limits::flatness * capsule.radius) return true;
    }
    return false;
}

/// Where the axis is deepest in the box: its lower end, or where it passes the edge, nearest to it as seen along the edge.
Vector deepest_of_axis(const CapsuleAtBox& capsule, const AxisFromBox& way) {
    const Vector &c = capsule.c, &u = capsule.u, &h = capsule.h(), &n = way.n;
    if (!way.crosses) return c - u * (dot(u, n) < 0 ? -capsule.half_length : capsule.half_length);
    const Vector corner{n.x > 0 ? h.x : -h.x, n.y > 0 ? h.y : -h.y, n.z > 0 ? h.z : -h.z};
    const Vector across = u - way.along_edge * dot(way.along_edge, u);
    return c - u * (dot(across, c - corner) / length_sq(across));
}

}  // namespace

void collide_capsule_box(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold*) {
    const scalar radius = A.shape.size.x, half_length = A.shape.size.y;
    const Vector &h = B.shape.size, c = transpose_times(B.A, A.r - B.r), u = transpose_times(B.A, A.A.c2);
    const CapsuleAtBox capsule{B, c, u, radius, half_length, margin};
    const scalar t = nearest_to_box(c, u, half_length, h);
    const Vector p = c + u * t, q = clamp(p, h), d = p - q;
    const scalar distance = sqrt(length_sq(d));
    const bool apart = distance > 4 * epsilon * (abs(c.x) + abs(c.y) + abs(c.z) + half_length);
    const AxisFromBox way = apart ? AxisFromBox{d * (1 / distance), distance, {}, false} : shortest_way_out(capsule);

    const Vector n = B.A * way.n;
    no_points(n, manifold);
    const scalar s = way.distance - radius;
    if (s > margin || lie_on_face(capsule, way.n, manifold)) return;
    if (apart) {
        if (lie_along_edge(capsule, way.n, distance, manifold)) return;
        add_point(B.r + B.A * q + n * (s * scalar(0.5)), s, nearest_feature, margin, manifold);
    } else {
        const Vector core = deepest_of_axis(capsule, way);
        add_point(capsule.world(core - way.n * (radius + s * scalar(0.5))), s, nearest_feature, margin, manifold);
    }
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#include "nearest_points.h"

#include "contact_geometry.h"

namespace ingot { inline namespace INGOT_ABI {

Vector core_support(const PlacedShape& s, const Vector& d) {
    const Vector& size = s.shape.size;
    switch (s.shape.kind) {
        case ShapeKind::capsule: return {0, 0, d.z < 0 ? -size.y : size.y};
        case ShapeKind::box: return {d.x < 0 ? -size.x : size.x, d.y < 0 ? -size.y : size.y, d.z < 0 ? -size.z : size.z};
        case ShapeKind::cylinder: {
            const scalar across = sqrt(d.x * d.x + d.y * d.y), k = across > 0 ? size.x / across : 0;
            return {across > 0 ? d.x * k : size.x, d.y * k, d.z < 0 ? -size.y : size.y};
        }
        case ShapeKind::hull: {
            const ConvexHull& hull = *s.hull;
            int best = 0;
            scalar furthest = dot(hull.vertices[0], d);
            // bound: limits::hull_vertices_max
            for (int i = 1; i < hull.vertex_count; ++i) {
                const scalar along = dot(hull.vertices[i], d);
                if (!(along > furthest)) continue;
                furthest = along;
                best = i;
            }
            return hull.vertices[best];
        }
        default: return {};
    }
}

Vector support_point(const PlacedShape& s, const Vector& n) {
    return s.r + (s.A * core_support(s, transpose_times(s.A, n)) + n * core_radius(s));
}

namespace {

/// A corner of the difference A - B: the point of A, and the two it comes from, all seen from the centre of B.
struct Corner {
    Vector w, a, b;
};

struct Simplex {
    Corner corners[4];
    scalar weight[4];
    int count;

    void keep(int i, int j, int k, scalar u, scalar v, scalar t, int n) {
        const Corner old[3] = {corners[i], corners[j], corners[k]};
        corners[0] = old[0], corners[1] = old[1], corners[2] = old[2];
        weight[0] = u, weight[1] = v, weight[2] = t;
        count = n;
    }
};

/// The point of a triangle nearest to the origin, as weights; 0 for what is not part of it (Ericson, "Real-time collision
/// detection", 2005, 5.1.5, by the regions of Voronoi).
void weigh_triangle(const Vector& a, const Vector& b, const Vector& c, scalar (&weight)[3]) {
    const Vector ab = b - a, ac = c - a;
    weight[0] = weight[1] = weight[2] = 0;
    const scalar d1 = -dot(ab, a), d2 = -dot(ac, a);
    if (d1 <= 0 && d2 <= 0) return void(weight[0] = 1);
    const scalar d3 = -dot(ab, b), d4 = -dot(ac, b);
    if (d3 >= 0 && d4 <= d3) return void(weight[1] = 1);
    const scalar d5 = -dot(ab, c), d6 = -dot(ac, c);
    if (d6 >= 0 && d5 <= d6) return void(weight[2] = 1);
    const scalar vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 - d3 > 0) {
        weight[1] = d1 / (d1 - d3);
        return void(weight[0] = 1 - weight[1]);
    }
    const scalar vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0 && d2 - d6 > 0) {
        weight[2] = d2 / (d2 - d6);
        return void(weight[0] = 1 - weight[2]);
    }
    const scalar va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0 && (d4 - d3) + (d5 - d6) > 0) {
        weight[2] = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return void(weight[1] = 1 - weight[2]);
    }
    const scalar sum = va + vb + vc;
    if (!(sum > 0)) return void(weight[0] = 1);  // no area left
    weight[1] = vb / sum;
    weight[2] = vc / sum;
    weight[0] = 1 - weight[1] - weight[2];
}

void reduce_triangle(Simplex& s, int i, int j, int k) {
    scalar weight[3];
    weigh_triangle(s.corners[i].w, s.corners[j].w, s.corners[k].w, weight);
    const int from[3] = {i, j, k};
    int kept[3] = {i, i, i}, count = 0;
    scalar weights[3] = {0, 0, 0};
    for (int m = 0; m < 3; ++m) {
        if (!(weight[m] > 0)) continue;
        kept[count] = from[m];
        weights[count++] = weight[m];
    }
    s.keep(kept[0], kept[1], kept[2], weights[0], weights[1], weights[2], count > 0 ? count : 1);
}

Vector point_of(const Simplex& s, Vector Corner::*part) {
    Vector p{};
    for (int i = 0; i < s.count; ++i) p += s.corners[i].*part * s.weight[i];  // bound: 4
    return p;
}

/// The part of the simplex nearest to the origin. False where the origin is inside.
bool reduce(Simplex& s) {
    if (s.count == 1) {
        s.weight[0] = 1;
        return true;
    }
    if (s.count == 2) {
        const Vector &a = s.corners[0].w, ab = s.corners[1].w - a;
        const scalar along = -dot(a, ab), all = length_sq(ab);
        if (along >= all)
            s.keep(1, 1, 1, 1, 0, 0, 1);
        else if (!(along > 0))
            s.keep(0, 0, 0, 1, 0, 0, 1);
        else
            s.keep(0, 1, 1, 1 - along / all, along / all, 0, 2);
        return true;
    }
    if (s.count == 3) {
        reduce_triangle(s, 0, 1, 2);
        return true;
    }
    // Of the faces that have the origin on their outer side, the nearest.
    constexpr uint8_t faces[4][4] = {
        {0, 1, 2, 3}, {0, 3, 1, 2}, {0, 2, 3, 1}, {1, 3, 2, 0}};  // the last is the corner opposite
    Simplex best{};
    scalar nearest = scalar_max;
    bool outside = false;
    for (const auto& face : faces) {
        const Vector &a = s.corners[face[0]].w, &b = s.corners[face[1]].w, &c = s.corners[face[2]].w;
        const Vector n = cross(b - a, c - a);
        const scalar origin_side = -dot(n, a), inner_side = dot(n, s.corners[face[3]].w - a);
        if (origin_side * inner_side > 0) continue;  // a flat simplex has no inner side: all faces count
        outside = true;
        Simplex part = s;
        reduce_triangle(part, face[0], face[1], face[2]);
        const scalar distance = length_sq(point_of(part, &Corner::w));
        if (!(distance < nearest)) continue;
        nearest = distance;
        best = part;
    }
    if (outside) s = best;
    return outside;
}

INGOT_INLINE bool has_corner(const Simplex& s, const Vector& w) {
    bool known = false;
    for (int i = 0; i < s.count; ++i) known |= length_sq(s.corners[i].w - w) <= 0;  // bound: 4
    return known;
}

/// What a search for nearest points ends with.
struct NearestSearch {
    Simplex simplex;  ///< its point nearest to the origin is the difference of the nearest points
    bool overlapping;
    scalar at_least;  ///< m; proven along n, where it exceeds what was known before
    Vector n;
};

/// Walks to the point of the difference nearest to the origin, v: the furthest corner against v joins the simplex, and its nearest part stays.
NearestSearch search_nearest(const PlacedShape& A, const PlacedShape& B, const Vector& d, scalar enough, scalar known_gap) {
    NearestSearch found{{}, false, known_gap, {}};
    Simplex& simplex = found.simplex;
    Vector v = length_sq(d) > 0 ? d : Vector{1, 0, 0};
    scalar v_sq = scalar_max, size = 0;
    for (int iteration = 0; iteration < limits::nearest_iterations_max; ++iteration) {
        const Vector a = d + A.A * core_support(A, transpose_times(A.A, -v)), b = B.A * core_support(B, transpose_times(B.A, v));
        const Vector w = a - b;
        const scalar length_v = sqrt(length_sq(v)), gap = dot(v, w) / length_v;
        if (gap > found.at_least) {
            found.at_least = gap;
            found.n = v * (1 / length_v);
            if (gap > enough) {
                if (simplex.count == 0) {  // whoever stops here still wants two points
                    simplex.corners[simplex.count++] = {w, a, b};
                    (void)reduce(simplex);
                }
                break;
            }
        }
        // The first v is a direction, not a point of the difference.
        if (simplex.count > 0 && (!(length_v - gap > limits::nearest_accuracy * length_v) || has_corner(simplex, w))) break;
        const scalar w_size = abs(a.x) + abs(a.y) + abs(a.z) + abs(b.x) + abs(b.y) + abs(b.z);
        size = w_size > size ? w_size : size;

        const Simplex last = simplex;
        simplex.corners[simplex.count++] = {w, a, b};
        if (!reduce(simplex)) {
            found.overlapping = !(found.at_least > 0);  // what is proven apart only looks enclosed
            if (!found.overlapping) simplex = last;
            break;
        }
        const Vector next = point_of(simplex, &Corner::w);
        const scalar next_sq = length_sq(next);
        if (!(next_sq < v_sq)) {  // rounding has the last word
            simplex = last;
            break;
        }
        v = next;
        v_sq = next_sq;
        const scalar touching = 2 * epsilon * size;
        if (v_sq <= touching * touching) {
            found.overlapping = true;
            break;
        }
    }
    return found;
}

}  // namespace

Nearest nearest_cores(const PlacedShape& A, const PlacedShape& B, scalar enough, scalar known_gap) {
    NearestSearch found = search_nearest(A, B, A.r - B.r, enough, known_gap);
    Nearest nearest{};
    if (found.overlapping && found.simplex.count == 4)
        for (scalar& weight : found.simplex.weight) weight = scalar(0.25);
    const Vector a = point_of(found.simplex, &Corner::a), b = point_of(found.simplex, &Corner::b);
    nearest.P_A = B.r + a;
    nearest.P_B = B.r + b;
    nearest.overlap = found.overlapping;
    if (found.overlapping) return nearest;
    const Vector apart = a - b;
    nearest.distance = sqrt(length_sq(apart));
    // The direction that is proven: where what is round is all but touched, the last point may be nearer but no longer has one.
    nearest.n = found.at_least > known_gap || !(nearest.distance > 0) ? found.n : apart * (1 / nearest.distance);
    nearest.at_least = found.at_least;
    return nearest;
}

namespace {

/// B is a half space.
Nearest above_half_space(const PlacedShape& A, const PlacedShape& B) {
    const Vector n = B.A * B.shape.size, P = support_point(A, -n);
    const scalar height = face_below(B, P).height;
    const bool below = height <= 0;
    return {below ? 0 : height, n, P, below ? P : P - n * height, below, below ? 0 : height};
}

}  // namespace

Nearest closest_points(const PlacedShape& A, const PlacedShape& B, scalar enough) {
    if (B.shape.kind == ShapeKind::half_space) return above_half_space(A, B);
    if (A.shape.kind == ShapeKind::half_space) {
        Nearest swapped = above_half_space(B, A);
        const Vector P = swapped.P_A;
        swapped.P_A = swapped.P_B;
        swapped.P_B = P;
        swapped.n = -swapped.n;
        return swapped;
    }
    const scalar radius_A = core_radius(A), radius_B = core_radius(B), reach = radius_A + radius_B;
    Nearest nearest = nearest_cores(A, B, enough < scalar_max - reach ? enough + reach : scalar_max);
    if (nearest.overlap) return nearest;
    nearest.P_A -= nearest.n * radius_A;
    nearest.P_B += nearest.n * radius_B;
    nearest.overlap = nearest.distance <= reach;
    nearest.distance = nearest.overlap ? 0 : nearest.distance - reach;
    nearest.at_least = nearest.at_least > reach ? nearest.at_least - reach : 0;
    return nearest;
}

bool overlap(const PlacedShape& A, const PlacedShape& B) { return closest_points(A, B, 0).overlap; }

} }  // namespace ingot

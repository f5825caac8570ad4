// SPDX-License-Identifier: MIT
// Two boxes by their 15 separating axes; see Gottschalk, Lin, Manocha, "OBBTree", 1996, for the axes, and Sutherland, Hodgman,
// "Reentrant polygon clipping", 1974, for the points.
#include "manifold_points.h"
#include "narrow_phase.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

constexpr int next[5] = {0, 1, 2, 0, 1};  // next[i + 1] and next[i + 2] are the other two axes

// Axes by number: 0 .. 2 the faces of A, 3 .. 5 those of B, 6 + 3 i + j the edges i of A and j of B.
constexpr int first_edge_axis = 6;
constexpr int no_axis = -1;

constexpr uint32_t feature_of(int axis, bool negative, uint32_t rest) {
    return static_cast<uint32_t>(axis) << 24 | (negative ? 1u << 23 : 0u) | rest;
}

struct Axes {
    scalar a[3], b[3];    ///< half extents
    Vector A[3], B[3];    ///< axes of the boxes in the world
    Vector d;             ///< from the centre of B to that of A
    scalar R[3][3];       ///< A_i . B_j
    scalar abs_R[3][3];
    scalar d_A[3], d_B[3];  ///< d along the axes
};

INGOT_INLINE void set_axes(const PlacedShape& A, const PlacedShape& B, Axes& axes) {
    axes.a[0] = A.shape.size.x, axes.a[1] = A.shape.size.y, axes.a[2] = A.shape.size.z;
    axes.b[0] = B.shape.size.x, axes.b[1] = B.shape.size.y, axes.b[2] = B.shape.size.z;
    axes.A[0] = A.A.c0, axes.A[1] = A.A.c1, axes.A[2] = A.A.c2;
    axes.B[0] = B.A.c0, axes.B[1] = B.A.c1, axes.B[2] = B.A.c2;
    axes.d = A.r - B.r;
    for (int i = 0; i < 3; ++i) {
        axes.d_A[i] = dot(axes.d, axes.A[i]);
        axes.d_B[i] = dot(axes.d, axes.B[i]);
        for (int j = 0; j < 3; ++j) {
            axes.R[i][j] = dot(axes.A[i], axes.B[j]);
            axes.abs_R[i][j] = abs(axes.R[i][j]);
        }
    }
}

/// The gap between the shadows of the boxes on a unit vector n that points from B to A.
INGOT_INLINE scalar gap_along(const PlacedShape& A, const PlacedShape& B, const Vector& n) {
    const Vector &a = A.shape.size, &b = B.shape.size;
    const scalar reach_A = a.x * abs(dot(n, A.A.c0)) + a.y * abs(dot(n, A.A.c1)) + a.z * abs(dot(n, A.A.c2));
    const scalar reach_B = b.x * abs(dot(n, B.A.c0)) + b.y * abs(dot(n, B.A.c1)) + b.z * abs(dot(n, B.A.c2));
    return dot(n, A.r - B.r) - (reach_A + reach_B);
}

/// The polygon while it is clipped: its corners, and the edges before and after each, 0 .. 3 of the incident face and 4 .. 7
/// the sides of the reference face.
struct Polygon {
    scalar x[8], y[8], z[8];
    uint8_t in[8], out[8];
    int count;
};

/// Keeps the part of `from` with sign * (y or x) <= limit. A convex polygon gains at most one corner.
INGOT_INLINE void clip(const Polygon& from, bool along_y, scalar sign, scalar limit, uint8_t side, Polygon& to) {
    const scalar* along = along_y ? from.y : from.x;
    to.count = 0;
    int last = from.count - 1;
    scalar last_over = last >= 0 ? sign * along[last] - limit : 0;
    for (int i = 0; i < from.count; ++i) {
        const scalar over = sign * along[i] - limit;
        const bool inside = over <= 0, last_inside = last_over <= 0;
        if (inside != last_inside && to.count < 8) {
            const scalar t = last_over / (last_over - over);
            const int k = to.count++;
            to.x[k] = from.x[last] + t * (from.x[i] - from.x[last]);
            to.y[k] = from.y[last] + t * (from.y[i] - from.y[last]);
            to.z[k] = from.z[last] + t * (from.z[i] - from.z[last]);
            to.in[k] = inside ? side : from.in[i];
            to.out[k] = inside ? from.in[i] : side;
        }
        if (inside && to.count < 8) {
            const int k = to.count++;
            to.x[k] = from.x[i], to.y[k] = from.y[i], to.z[k] = from.z[i];
            to.in[k] = from.in[i], to.out[k] = from.out[i];
        }
        last = i;
        last_over = over;
    }
}

/// One box by its half extents h and axes X; a face of it is the reference, or meets the reference.
struct BoxView {
    const scalar* h;
    const Vector* X;
};

/// The points of face `axis` of the reference box against the other box, whose nearest face is clipped.
///
/// centre: from the reference box to the other; outward: the sign of the face, on the side of the other box; n_sign: n of the
/// manifold is n_sign times the outward normal.
void face_points(const BoxView& reference, const BoxView& other, const Vector& origin, const Vector& centre, int axis,
                 scalar outward, scalar n_sign, scalar margin, scalar tolerance, uint32_t face_feature, const Before& before,
                 Manifold& manifold) {
    const Vector e_x = reference.X[next[axis + 1]], e_y = reference.X[next[axis + 2]], up = reference.X[axis] * outward;
    const scalar h_x = reference.h[next[axis + 1]], h_y = reference.h[next[axis + 2]], h_z = reference.h[axis];

    int facing = 0;
    scalar along = dot(other.X[0], up);
    for (int j = 1; j < 3; ++j) {
        const scalar c = dot(other.X[j], up);
        if (abs(c) > abs(along)) {
            facing = j;
            along = c;
        }
    }
    const bool flipped = along > 0;  // the face that looks against `up`
    const Vector u = other.X[next[facing + 1]] * other.h[next[facing + 1]], v = other.X[next[facing + 2]] * other.h[next[facing + 2]];
    const Vector c = centre + other.X[facing] * (flipped ? -other.h[facing] : other.h[facing]);

    const scalar c_x = dot(c, e_x), c_y = dot(c, e_y), c_z = dot(c, up) - h_z;
    const scalar u_x = dot(u, e_x), u_y = dot(u, e_y), u_z = dot(u, up);
    const scalar v_x = dot(v, e_x), v_y = dot(v, e_y), v_z = dot(v, up);

    Polygon polygons[2];
    Polygon* polygon = &polygons[0];
    for (int i = 0; i < 4; ++i) {
        const scalar p = i == 1 || i == 2 ? scalar(-1) : scalar(1), q = i >= 2 ? scalar(-1) : scalar(1);
        polygon->x[i] = c_x + p * u_x + q * v_x;
        polygon->y[i] = c_y + p * u_y + q * v_y;
        polygon->z[i] = c_z + p * u_z + q * v_z;
        polygon->in[i] = static_cast<uint8_t>((i + 3) & 3);
        polygon->out[i] = static_cast<uint8_t>(i);
    }
    polygon->count = 4;

    const scalar limit_x = h_x * (1 + limits::corner_slack), limit_y = h_y * (1 + limits::corner_slack);
    const scalar spread_x = abs(u_x) + abs(v_x), spread_y = abs(u_y) + abs(v_y);
    int other_i = 1;
    const auto cut = [&](bool along_y, scalar sign, scalar limit, uint8_t side) {
        Polygon* to = &polygons[other_i];
        clip(*polygon, along_y, sign, limit, side, *to);
        polygon = to;
        other_i ^= 1;
    };
    if (c_x + spread_x > limit_x) cut(false, 1, limit_x, 4);
    if (spread_x - c_x > limit_x) cut(false, -1, limit_x, 5);
    if (c_y + spread_y > limit_y) cut(true, 1, limit_y, 6);
    if (spread_y - c_y > limit_y) cut(true, -1, limit_y, 7);

    const uint32_t incident = (static_cast<uint32_t>(facing) << 1 | (flipped ? 1u : 0u)) << 16;
    Candidate candidates[8];
    int count = 0;
    for (int i = 0; i < polygon->count; ++i) {
        const scalar s = polygon->z[i];
        if (!(s <= margin)) continue;
        const scalar x = polygon->x[i], y = polygon->y[i];
        const uint32_t corner = static_cast<uint32_t>(polygon->in[i]) << 4 | polygon->out[i];
        candidates[count++] = {x > h_x ? h_x : x < -h_x ? -h_x : x, y > h_y ? h_y : y < -h_y ? -h_y : y,
                               n_sign * s * scalar(0.5), s, face_feature | incident | corner};
    }
    const Vector n = up * n_sign;
    keep_points(candidates, count, {origin + up * h_z, e_x, e_y, n}, tolerance, before, manifold);
}

/// The point of edges i of A and j of B; false where the nearest points of their lines lie outside the edges.
INGOT_INLINE bool edge_point(const PlacedShape& B, const Axes& axes, int i, int j, scalar margin, uint32_t& corner,
                             Manifold& manifold, bool forced) {
    Vector n = cross(axes.A[i], axes.B[j]);
    n = n * (1 / sqrt(length_sq(n)));
    if (dot(n, axes.d) < 0) n = -n;

    Vector p_A = axes.d, p_B{};  // middles of the edges, seen from the centre of B
    uint32_t signs = 0;
    for (int k = 0; k < 3; ++k) {
        if (k != i) {
            const bool ahead = dot(n, axes.A[k]) > 0;
            p_A += axes.A[k] * (ahead ? -axes.a[k] : axes.a[k]);
            signs |= ahead ? 1u << k : 0u;
        }
        if (k != j) {
            const bool ahead = dot(n, axes.B[k]) > 0;
            p_B += axes.B[k] * (ahead ? axes.b[k] : -axes.b[k]);
            signs |= ahead ? 8u << k : 0u;
        }
    }
    const Vector w = p_A - p_B;
    const scalar c = axes.R[i][j], inv = 1 / (1 - c * c), along_A = dot(w, axes.A[i]), along_B = dot(w, axes.B[j]);
    const scalar t_A = (c * along_B - along_A) * inv, t_B = (along_B - c * along_A) * inv;
    const scalar a = axes.a[i] * (1 + limits::corner_slack), b = axes.b[j] * (1 + limits::corner_slack);
    if (!forced && !(abs(t_A) <= a && abs(t_B) <= b)) return false;
    const scalar s = dot(n, w);
    const Vector middle = (p_A + axes.A[i] * t_A + p_B + axes.B[j] * t_B) * scalar(0.5);
    if (s <= margin)
        one_point(n, B.r + middle, s, corner | signs, manifold);
    else
        no_points(n, manifold);
    return true;
}

}  // namespace

void collide_box_box(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold* before_it) {
    const Before before = remember(before_it);
    if (before_it != nullptr && before.count == 0 && gap_along(A, B, before.n) > margin) return no_points(before.n, manifold);

    Axes axes;
    set_axes(A, B, axes);
    scalar smallest = axes.a[0];
    for (int i = 0; i < 3; ++i) {
        smallest = axes.a[i] < smallest ? axes.a[i] : smallest;
        smallest = axes.b[i] < smallest ? axes.b[i] : smallest;
    }
    const int axis_before = before.count > 0 ? static_cast<int>(before.features[0] >> 24) : no_axis;
    const scalar hysteresis = limits::axis_hysteresis * smallest;

    scalar separations[first_edge_axis];
    for (int i = 0; i < 3; ++i) {
        const scalar s = abs(axes.d_A[i]) - (axes.a[i] + axes.b[0] * axes.abs_R[i][0] + axes.b[1] * axes.abs_R[i][1] +
                                             axes.b[2] * axes.abs_R[i][2]);
        if (s > margin) return no_points(axes.d_A[i] < 0 ? -axes.A[i] : axes.A[i], manifold);
        separations[i] = s;
    }
    for (int j = 0; j < 3; ++j) {
        const scalar s = abs(axes.d_B[j]) - (axes.b[j] + axes.a[0] * axes.abs_R[0][j] + axes.a[1] * axes.abs_R[1][j] +
                                             axes.a[2] * axes.abs_R[2][j]);
        if (s > margin) return no_points(axes.d_B[j] < 0 ? -axes.B[j] : axes.B[j], manifold);
        separations[3 + j] = s;
    }
    int face = 0;
    for (int axis = 1; axis < first_edge_axis; ++axis)
        if (separations[axis] > separations[face]) face = axis;
    if (axis_before >= 0 && axis_before < first_edge_axis && separations[axis_before] + hysteresis >= separations[face])
        face = axis_before;

    // Edges: what is compared is less by the rounding of a product that nearly cancels.
    int edge = no_axis;
    scalar best = separations[face] + limits::edge_preference * smallest;
    for (int i = 0; i < 3; ++i) {
        const int i1 = next[i + 1], i2 = next[i + 2];
        for (int j = 0; j < 3; ++j) {
            const int j1 = next[j + 1], j2 = next[j + 2];
            const scalar length_sq_of_axis = axes.R[i1][j] * axes.R[i1][j] + axes.R[i2][j] * axes.R[i2][j];
            if (!(length_sq_of_axis > limits::parallel_sin_sq)) continue;
            const scalar along = abs(axes.d_A[i2] * axes.R[i1][j] - axes.d_A[i1] * axes.R[i2][j]);
            const scalar reach = (axes.a[i1] * axes.abs_R[i2][j] + axes.a[i2] * axes.abs_R[i1][j]) +
                                 (axes.b[j1] * axes.abs_R[i][j2] + axes.b[j2] * axes.abs_R[i][j1]);
            const scalar inv_length = 1 / sqrt(length_sq_of_axis);
            scalar s = (along - reach - 8 * epsilon * (along + reach)) * inv_length;
            const int axis = first_edge_axis + 3 * i + j;
            if (s > margin) {
                Vector n = cross(axes.A[i], axes.B[j]) * inv_length;
                if (dot(n, axes.d) < 0) n = -n;
                return no_points(n, manifold);
            }
            if (axis == axis_before) s += hysteresis;
            if (s > best) {
                best = s;
                edge = axis;
            }
        }
    }
    if (edge != no_axis) {
        uint32_t feature = feature_of(edge, false, 0);
        if (edge_point(B, axes, (edge - first_edge_axis) / 3, (edge - first_edge_axis) % 3, margin, feature, manifold, false))
            return;
    }

    const bool of_A = face < 3;
    const int axis = of_A ? face : face - 3;
    const BoxView box_A{axes.a, axes.A}, box_B{axes.b, axes.B};
    const bool negative = of_A ? !(axes.d_A[axis] < 0) : axes.d_B[axis] < 0;  // the face looks against its axis
    const uint32_t feature = feature_of(face, negative, 0);
    const scalar tolerance = limits::flatness * smallest;
    if (of_A)
        face_points(box_A, box_B, A.r, -axes.d, axis, negative ? scalar(-1) : scalar(1), -1, margin, tolerance, feature, before,
                    manifold);
    else
        face_points(box_B, box_A, B.r, axes.d, axis, negative ? scalar(-1) : scalar(1), 1, margin, tolerance, feature, before,
                    manifold);
    if (manifold.count == 0 && edge != no_axis) {
        uint32_t corner = feature_of(edge, false, 0);
        edge_point(B, axes, (edge - first_edge_axis) / 3, (edge - first_edge_axis) % 3, best < 0 ? margin : -scalar_max, corner,
                   manifold, true);
    }
}

} }  // namespace ingot

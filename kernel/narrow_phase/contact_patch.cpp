// SPDX-License-Identifier: MIT
#include "contact_patch.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

// Boxes are the cube of half extent 1, stretched.
constexpr Vector unit_box_vertices[8] = {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                                         {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};
constexpr HullFace unit_box_faces[6] = {{{-1, 0, 0}, 1, 0, 4}, {{1, 0, 0}, 1, 4, 4},   {{0, -1, 0}, 1, 8, 4},
                                        {{0, 1, 0}, 1, 12, 4}, {{0, 0, -1}, 1, 16, 4}, {{0, 0, 1}, 1, 20, 4}};
constexpr uint8_t unit_box_loops[24] = {0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6};
constexpr HullEdge unit_box_edges[12] = {{0, 4, 0, 2}, {4, 6, 0, 5}, {6, 2, 0, 3}, {2, 0, 0, 4}, {1, 3, 1, 4}, {3, 7, 1, 3},
                                         {7, 5, 1, 5}, {5, 1, 1, 2}, {0, 1, 2, 4}, {5, 4, 2, 5}, {6, 7, 3, 5}, {3, 2, 3, 4}};
constexpr ConvexHull unit_box{unit_box_vertices, unit_box_faces, unit_box_edges, unit_box_loops, 8, 6, 12, {}, 2, 1};

}  // namespace

Polyhedron polyhedron_of(const PlacedShape& s) {
    if (s.shape.kind == ShapeKind::hull) return {s.hull, {1, 1, 1}};
    if (s.shape.kind == ShapeKind::box) return {&unit_box, s.shape.size};
    return {nullptr, {}};
}

namespace {

/// Adds the corner p, in the world and seen from the origin of the frame.
INGOT_INLINE void add_corner(const Vector& p, const ContactFrame& frame, Patch& patch) {
    if (patch.count >= Patch::corners_max) return;
    const int k = patch.count++;
    patch.x[k] = dot(p, frame.e_x);
    patch.y[k] = dot(p, frame.e_y);
    patch.z[k] = dot(p, frame.n);
}

INGOT_INLINE void set_plane(const Vector& normal, const ContactFrame& frame, Patch& patch) {
    const scalar along = dot(normal, frame.n), x = dot(normal, frame.e_x), y = dot(normal, frame.e_y);
    patch.slope_x = -x / along;
    patch.slope_y = -y / along;
    patch.z_0 = patch.z[0] - patch.slope_x * patch.x[0] - patch.slope_y * patch.y[0];
}

// cos(2 pi k / 16), k = 0 .. 4.
constexpr scalar cap_cos[5] = {1, scalar(0.92387953251128675613), scalar(0.70710678118654752440),
                               scalar(0.38268343236508977173), 0};
INGOT_INLINE scalar cap_cosine(int k) {
    const int quarter = (k & 15) <= 8 ? k & 15 : 16 - (k & 15);
    return quarter <= 4 ? cap_cos[quarter] : -cap_cos[8 - quarter];
}

void cylinder_patch(const PlacedShape& s, const Vector& centre, const Vector& towards, const ContactFrame& frame,
                    Patch& patch) {
    const scalar r = s.shape.size.x, h = s.shape.size.y;
    const Vector t = transpose_times(s.A, towards);
    const scalar across = sqrt(t.x * t.x + t.y * t.y);
    const bool upper = t.z >= 0;
    const Vector radial = across > 0 ? Vector{t.x / across, t.y / across, 0} : Vector{1, 0, 0};
    if (abs(t.z) >= limits::facing_cos) {
        // Corners fixed to the body where it lies flat; else one of them is the lowest point of the rim.
        const bool flat = across <= 50 * limits::flatness;
        const Vector first = flat ? Vector{1, 0, 0} : radial, second{-first.y, first.x, 0}, middle{0, 0, upper ? h : -h};
        for (int k = 0; k < limits::cap_corners; ++k)
            add_corner(centre + s.A * (middle + first * (r * cap_cosine(k)) + second * (r * cap_cosine(k - 4))), frame, patch);
        patch.face = upper ? 1 : 0;
        set_plane(s.A.c2, frame, patch);
        return;
    }
    const Vector side = s.A * (radial * r), axis = s.A.c2 * h;
    if (abs(t.z) <= limits::facing_sin) {
        add_corner(centre + side - axis, frame, patch);
        add_corner(centre + side + axis, frame, patch);
        return;
    }
    add_corner(upper ? centre + side + axis : centre + side - axis, frame, patch);
}

void polyhedron_patch(const PlacedShape& s, const Vector& centre, const Vector& towards, const ContactFrame& frame,
                      Patch& patch) {
    const Polyhedron p = polyhedron_of(s);
    const Vector t = transpose_times(s.A, towards);
    int face = 0;
    scalar facing = -scalar_max;
    // bound: 2 limits::hull_vertices_max - 4
    for (int i = 0; i < p.hull->face_count; ++i) {
        const scalar c = dot(p.hull->faces[i].n, t);
        if (!(c > facing)) continue;
        face = i;
        facing = c;
    }
    if (facing >= limits::facing_cos) {
        const HullFace& f = p.hull->faces[face];
        const int step = (f.loop_count + Patch::corners_max - 1) / Patch::corners_max;  // of faces of more corners, every other
        // bound: limits::hull_vertices_max
        for (int k = 0; k < f.loop_count; k += step)
            add_corner(centre + s.A * p.vertex(p.hull->loops[f.loop_first + k]), frame, patch);
        patch.face = face;
        set_plane(s.A * f.n, frame, patch);
        return;
    }
    int corner = 0;
    scalar furthest = -scalar_max;
    // bound: limits::hull_vertices_max
    for (int i = 0; i < p.hull->vertex_count; ++i) {
        const scalar along = dot(p.vertex(i), t);
        if (!(along > furthest)) continue;
        corner = i;
        furthest = along;
    }
    int edge = -1;
    scalar flattest = limits::facing_sin * limits::facing_sin;
    // bound: 3 limits::hull_vertices_max - 6
    for (int i = 0; i < p.hull->edge_count; ++i) {
        const HullEdge& e = p.hull->edges[i];
        if (e.a != corner && e.b != corner) continue;
        const Vector along = p.vertex(e.b) - p.vertex(e.a);
        const scalar rise = dot(along, t), ratio = rise * rise / length_sq(along);
        if (!(ratio < flattest)) continue;
        edge = i;
        flattest = ratio;
    }
    if (edge < 0) return add_corner(centre + s.A * p.vertex(corner), frame, patch);
    add_corner(centre + s.A * p.vertex(p.hull->edges[edge].a), frame, patch);
    add_corner(centre + s.A * p.vertex(p.hull->edges[edge].b), frame, patch);
}

}  // namespace

void patch_of(const PlacedShape& s, const Vector& centre, const Vector& towards, const ContactFrame& frame, Patch& patch) {
    patch.count = 0;
    patch.face = -1;
    patch.slope_x = patch.slope_y = 0;
    if (s.shape.kind == ShapeKind::cylinder) {
        cylinder_patch(s, centre, towards, frame, patch);
    } else if (s.shape.kind == ShapeKind::capsule) {
        const scalar rise = dot(s.A.c2, towards);
        const Vector axis = s.A.c2 * s.shape.size.y;
        if (abs(rise) <= limits::facing_sin) {
            add_corner(centre - axis, frame, patch);
            add_corner(centre + axis, frame, patch);
        } else {
            add_corner(rise > 0 ? centre + axis : centre - axis, frame, patch);
        }
    } else if (s.shape.kind == ShapeKind::sphere) {
        add_corner(centre, frame, patch);
    } else {
        polyhedron_patch(s, centre, towards, frame, patch);
    }
    if (patch.face < 0) patch.z_0 = patch.z[0];
}

namespace {

/// True where (x, y) is inside the polygon, or outside by no more than the slack.
bool inside(const Patch& polygon, scalar turn, scalar slack, scalar x, scalar y) {
    int last = polygon.count - 1;
    // bound: Patch::corners_max
    for (int i = 0; i < polygon.count; ++i) {
        const scalar e_x = polygon.x[i] - polygon.x[last], e_y = polygon.y[i] - polygon.y[last];
        const scalar off = turn * (e_x * (y - polygon.y[last]) - e_y * (x - polygon.x[last]));
        if (off < 0 && off * off > slack * slack * (e_x * e_x + e_y * e_y)) return false;
        last = i;
    }
    return true;
}

/// +1 or -1: which way round the corners go.
scalar turn_of(const Patch& polygon) {
    scalar area = 0;
    for (int i = 2; i < polygon.count; ++i)
        area += (polygon.x[i - 1] - polygon.x[0]) * (polygon.y[i] - polygon.y[0]) -
                (polygon.y[i - 1] - polygon.y[0]) * (polygon.x[i] - polygon.x[0]);
    return area < 0 ? scalar(-1) : scalar(1);
}

/// The stretch low .. high of the line from corner a to corner b of `of` that is inside the polygon (Cyrus, Beck).
bool stretch_inside(const Patch& of, int a, int b, const Patch& polygon, scalar turn, scalar slack, scalar& low, scalar& high,
                    int& side_low, int& side_high) {
    const scalar d_x = of.x[b] - of.x[a], d_y = of.y[b] - of.y[a];
    low = 0, high = 1;
    side_low = side_high = -1;
    int last = polygon.count - 1;
    for (int i = 0; i < polygon.count; ++i) {
        const scalar e_x = polygon.x[i] - polygon.x[last], e_y = polygon.y[i] - polygon.y[last];
        const scalar from = turn * (e_x * (of.y[a] - polygon.y[last]) - e_y * (of.x[a] - polygon.x[last])) +
                            slack * sqrt(e_x * e_x + e_y * e_y);
        const scalar by = turn * (e_x * d_y - e_y * d_x), to = from + by;
        if (from < 0 && to < 0) return false;
        if (from < 0 && to > from) {
            const scalar t = -from / by;
            if (t > low) low = t, side_low = last;
        } else if (to < 0 && to < from) {
            const scalar t = -from / by;
            if (t < high) high = t, side_high = last;
        }
        last = i;
    }
    return low <= high;
}

uint32_t pair(int a, int b) { return static_cast<uint32_t>(a & 31) << 6 | static_cast<uint32_t>(b & 31); }

/// The polygons, or a line and a polygon, on top of each other.
void overlay_polygons(const Patch& A, const Patch& B, scalar slack, Found& found) {
    const scalar turn_A = turn_of(A), turn_B = turn_of(B);
    const bool polygon_A = A.count >= 3, polygon_B = B.count >= 3;
    if (polygon_B)
        // bound: Patch::corners_max
        for (int i = 0; i < A.count; ++i)
            if (inside(B, turn_B, slack, A.x[i], A.y[i]))
                found.add(A.x[i], A.y[i], A.z[i], B.height(A.x[i], A.y[i]), corner_of_A | pair(i, 0));
    if (polygon_A)
        // bound: Patch::corners_max
        for (int i = 0; i < B.count; ++i)
            if (inside(A, turn_A, slack, B.x[i], B.y[i]))
                found.add(B.x[i], B.y[i], A.height(B.x[i], B.y[i]), B.z[i], corner_of_B | pair(0, i));
    // Edges of the one that enter and leave the other.
    const bool walk_A = polygon_B;
    const Patch &line = walk_A ? A : B, &polygon = walk_A ? B : A;
    const scalar turn = walk_A ? turn_B : turn_A;
    const int lines = line.count >= 3 ? line.count : 1;
    // bound: Patch::corners_max
    for (int i = 0; i < lines; ++i) {
        const int next = i + 1 < line.count ? i + 1 : 0;
        scalar low, high;
        int side_low, side_high;
        if (!stretch_inside(line, i, next, polygon, turn, slack, low, high, side_low, side_high)) continue;
        for (int end = 0; end < 2; ++end) {
            const scalar t = end == 0 ? low : high;
            const int side = end == 0 ? side_low : side_high;
            if (side < 0) continue;
            const scalar x = line.x[i] + (line.x[next] - line.x[i]) * t, y = line.y[i] + (line.y[next] - line.y[i]) * t;
            const scalar z = line.z[i] + (line.z[next] - line.z[i]) * t, other = polygon.height(x, y);
            found.add(x, y, walk_A ? z : other, walk_A ? other : z,
                      crossing | (walk_A ? pair(i, side) : pair(side, i)) | (end == 0 ? 0u : 1u << 12));
        }
    }
}

/// Two lines: where they cross, or the ends of the stretch along which they lie, no further apart than `aside`.
void cross_lines(const Patch& A, const Patch& B, scalar aside, Found& found) {
    const scalar u_x = A.x[1] - A.x[0], u_y = A.y[1] - A.y[0], v_x = B.x[1] - B.x[0], v_y = B.y[1] - B.y[0];
    const scalar u_sq = u_x * u_x + u_y * u_y, v_sq = v_x * v_x + v_y * v_y, w_x = B.x[0] - A.x[0], w_y = B.y[0] - A.y[0];
    const scalar area = u_x * v_y - u_y * v_x;
    const auto within = [](scalar t) { return t < 0 ? scalar(0) : t > 1 ? scalar(1) : t; };
    const auto add = [&](scalar s, scalar t, uint32_t feature) {
        const scalar x_A = A.x[0] + u_x * s, y_A = A.y[0] + u_y * s, x_B = B.x[0] + v_x * t, y_B = B.y[0] + v_y * t;
        if ((x_B - x_A) * (x_B - x_A) + (y_B - y_A) * (y_B - y_A) > aside * aside) return;
        found.add((x_A + x_B) * scalar(0.5), (y_A + y_B) * scalar(0.5), A.z[0] + (A.z[1] - A.z[0]) * s,
                  B.z[0] + (B.z[1] - B.z[0]) * t, feature);
    };
    if (area * area > limits::parallel_sin_sq * u_sq * v_sq)
        add(within((w_x * v_y - w_y * v_x) / area), within((w_x * u_y - w_y * u_x) / area), crossing);
    if (area * area > limits::lying_sin_sq * u_sq * v_sq || !(u_sq > 0 && v_sq > 0)) return;
    // Ends of B as seen along A.
    const scalar first = (w_x * u_x + w_y * u_y) / u_sq, second = ((w_x + v_x) * u_x + (w_y + v_y) * u_y) / u_sq;
    for (uint32_t end = 0; end < 2; ++end) {
        const scalar s = within(end == 0 ? first : second);
        const scalar at_x = u_x * s - w_x, at_y = u_y * s - w_y;
        add(s, within((at_x * v_x + at_y * v_y) / v_sq), crossing | (1 + end));
    }
}

}  // namespace

void overlay(const Patch& A, const Patch& B, scalar slack, scalar aside, Found& found) {
    // A corner is where the other surface is nearest: it has the gap of the whole, whatever the slope under it.
    if (A.count == 1 || B.count == 1) {
        const bool of_A = A.count == 1;
        const Patch &corner = of_A ? A : B, &face = of_A ? B : A;
        if (face.count < 3 || !inside(face, turn_of(face), slack, corner.x[0], corner.y[0])) return;
        const scalar reach = found.gap + found.radius_A + found.radius_B, z = corner.z[0];
        found.add(corner.x[0], corner.y[0], of_A ? z : z + reach, of_A ? z - reach : z, of_A ? corner_of_A : corner_of_B);
    } else if (A.count >= 3 || B.count >= 3)
        overlay_polygons(A, B, slack, found);
    else
        cross_lines(A, B, aside, found);
}

} }  // namespace ingot

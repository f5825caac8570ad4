// SPDX-License-Identifier: MIT
// Hulls and cylinders against everything that has a core: the direction that separates best, then the features on both sides
// clipped against each other in the plane across it.
//
// Directions tried: faces of hulls, boxes and ends of cylinders; edges of two polyhedra whose arcs cross on the Gauss map; edges
// across the side of a cylinder; and that of the nearest points, which is exact where cores are apart and good where cylinders
// only just overlap. Every direction is judged by the supports of the whole shapes, so a manifold never lies about its gap.
// Source: Gregorius, "The separating axis test between convex polyhedra", GDC 2013, for the test on the Gauss map.
#include "contact_geometry.h"
#include "narrow_phase.h"
#include "nearest_points.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

// Boxes are the cube of half extent 1, stretched.
constexpr Vector cube_vertices[8] = {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}};
constexpr HullFace cube_faces[6] = {{{-1, 0, 0}, 1, 0, 4}, {{1, 0, 0}, 1, 4, 4},  {{0, -1, 0}, 1, 8, 4},
                                    {{0, 1, 0}, 1, 12, 4}, {{0, 0, -1}, 1, 16, 4}, {{0, 0, 1}, 1, 20, 4}};
constexpr uint8_t cube_loops[24] = {0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6};
constexpr HullEdge cube_edges[12] = {{0, 4, 0, 2}, {4, 6, 0, 5}, {6, 2, 0, 3}, {2, 0, 0, 4}, {1, 3, 1, 4}, {3, 7, 1, 3},
                                     {7, 5, 1, 5}, {5, 1, 1, 2}, {0, 1, 2, 4}, {5, 4, 2, 5}, {6, 7, 3, 5}, {3, 2, 3, 4}};
constexpr ConvexHull cube{cube_vertices, cube_faces, cube_edges, cube_loops, 8, 6, 12, {}, 2};

/// A polyhedron: a hull as it is, or the cube stretched to a box; its faces are those of the hull, stretched along.
struct Polyhedron {
    const ConvexHull* hull;  ///< null for what is round
    Vector stretch;

    Vector vertex(int i) const { return scaled(stretch, hull->vertices[i]); }
};

Polyhedron polyhedron_of(const PlacedShape& s) {
    if (s.shape.kind == ShapeKind::hull) return {s.hull, {1, 1, 1}};
    if (s.shape.kind == ShapeKind::box) return {&cube, s.shape.size};
    return {nullptr, {}};
}

/// The gap between the shadows of two cores on n, which points from B to A.
scalar gap_along(const PlacedShape& A, const PlacedShape& B, const Vector& n) {
    const Vector n_A = transpose_times(A.A, n), n_B = transpose_times(B.A, n);
    return dot(n, A.r - B.r) + (dot(n_A, core_support(A, -n_A)) - dot(n_B, core_support(B, n_B)));
}

// Axes, as features name them: what kind, and which face.
enum : uint32_t { face_of_A = 0, face_of_B = 1, edges = 2, nearest = 3 };
constexpr uint32_t axis_code(uint32_t kind, int i) { return kind << 30 | static_cast<uint32_t>(i & 63) << 24; }
constexpr uint32_t axis_mask = 0xff000000u;
constexpr uint32_t no_axis = ~0u;

/// The search for the direction: the best of all, and the one that the step before had.
struct Search {
    uint32_t before;
    scalar hysteresis;
    Vector n;
    scalar gap;
    uint32_t code;
    Vector n_before;
    scalar gap_before;

    void look(const Vector& direction, scalar separation, uint32_t axis) {
        if (axis == before) {
            n_before = direction;
            gap_before = separation;
        }
        if (!(separation > gap)) return;
        n = direction;
        gap = separation;
        code = axis;
    }
    /// The faces are done: the one of before is kept while it is nearly as good.
    void settle() {
        if (before == no_axis || !(gap_before + hysteresis >= gap)) return;
        n = n_before;
        gap = gap_before;
        code = before;
    }
};

void look_at_faces(const PlacedShape& of, const PlacedShape& other, bool of_A, Search& search) {
    const uint32_t kind = of_A ? face_of_A : face_of_B;
    const auto look = [&](const Vector& n_body, int i) {
        const Vector outward = of.A * n_body, n = of_A ? -outward : outward;
        search.look(n, of_A ? gap_along(of, other, n) : gap_along(other, of, n), axis_code(kind, i));
    };
    if (of.shape.kind == ShapeKind::cylinder) {
        look({0, 0, -1}, 0);
        look({0, 0, 1}, 1);
    }
    const Polyhedron p = polyhedron_of(of);
    if (p.hull == nullptr) return;
    for (int i = 0; i < p.hull->face_count; ++i) look(p.hull->faces[i].n, i);
}

/// Edge pairs whose arcs cross on the Gauss map; all others are no candidates for touching (Gregorius 2013).
void look_at_edge_pairs(const PlacedShape& A, const PlacedShape& B, Search& search) {
    const Polyhedron a = polyhedron_of(A), b = polyhedron_of(B);
    const Vector d = A.r - B.r;
    scalar side[2 * limits::hull_vertices_max];  // of the faces of B seen along an edge of A
    const int faces_B = b.hull->face_count < 2 * limits::hull_vertices_max ? b.hull->face_count : 2 * limits::hull_vertices_max;
    for (int i = 0; i < a.hull->edge_count; ++i) {
        const HullEdge& edge_A = a.hull->edges[i];
        const Vector p = A.A * a.vertex(edge_A.a), u = A.A * (a.vertex(edge_A.b) - a.vertex(edge_A.a));
        const Vector left_A = A.A * a.hull->faces[edge_A.face_left].n, right_A = A.A * a.hull->faces[edge_A.face_right].n;
        const Vector u_B = transpose_times(B.A, u);
        const scalar u_sq = length_sq(u);
        for (int k = 0; k < faces_B; ++k) side[k] = dot(b.hull->faces[k].n, u_B);
        for (int j = 0; j < b.hull->edge_count; ++j) {
            const HullEdge& edge_B = b.hull->edges[j];
            const scalar c = side[edge_B.face_left], e = side[edge_B.face_right];
            if (!(c * e < 0)) continue;
            const Vector v = B.A * (b.vertex(edge_B.b) - b.vertex(edge_B.a));
            const scalar left = dot(left_A, v), right = dot(right_A, v);
            // Arcs cross when the ends of each lie on both sides of the other, on the same half of the sphere: with the normals of
            // B turned round and u along n_left x n_right of A, that is this sign.
            if (!(left * right < 0)) continue;
            Vector n = cross(u, v);
            const scalar n_sq = length_sq(n);
            if (!(n_sq > limits::parallel_sin_sq * u_sq * length_sq(v))) continue;
            n = n * (1 / sqrt(n_sq));
            if (dot(n, left_A + right_A) > 0) n = -n;
            const Vector left_B = B.A * b.hull->faces[edge_B.face_left].n, right_B = B.A * b.hull->faces[edge_B.face_right].n;
            if (!(dot(n, left_B + right_B) > 0)) continue;
            search.look(n, dot(n, d + p - B.A * b.vertex(edge_B.a)), axis_code(edges, 0));
        }
    }
}

/// Edges of a polyhedron across the side of a cylinder or along a capsule, whose axis is u in the world.
void look_at_edges_across(const PlacedShape& s, const Vector& u, const PlacedShape& A, const PlacedShape& B, Search& search) {
    const Polyhedron p = polyhedron_of(s);
    if (p.hull == nullptr) return;
    const Vector u_body = transpose_times(s.A, u);
    const bool is_A = &s == &A;
    for (int i = 0; i < p.hull->edge_count; ++i) {
        const HullEdge& edge = p.hull->edges[i];
        const Vector e = p.vertex(edge.b) - p.vertex(edge.a);
        Vector n = cross(e, u_body);
        const scalar n_sq = length_sq(n);
        if (!(n_sq > limits::parallel_sin_sq * length_sq(e))) continue;
        const Vector &left = p.hull->faces[edge.face_left].n, &right = p.hull->faces[edge.face_right].n;
        n = n * ((dot(n, left + right) < 0 ? scalar(-1) : scalar(1)) / sqrt(n_sq));
        // Outward along n only if n lies between the normals of both faces.
        if (dot(cross(left, n), e) * dot(cross(n, right), e) < 0) continue;
        const Vector outward = s.A * n, towards_A = is_A ? -outward : outward;
        search.look(towards_A, gap_along(A, B, towards_A), axis_code(edges, 0));
    }
}

PlacedShape shrunk(const PlacedShape& s, scalar by) {
    PlacedShape smaller = s;
    if (s.shape.kind != ShapeKind::cylinder) return smaller;
    smaller.shape.size.x -= by;
    smaller.shape.size.y -= by;
    return smaller;
}

scalar smallest_extent(const PlacedShape& s) {
    switch (s.shape.kind) {
        case ShapeKind::box: return smallest_of(s.shape.size);
        case ShapeKind::capsule:
        case ShapeKind::cylinder: return s.shape.size.x < s.shape.size.y ? s.shape.size.x : s.shape.size.y;
        default: return s.shape.size.x;
    }
}

/// What a shape turns towards a contact: a face, an edge or a corner, seen in the plane of contact.
struct Patch {
    static constexpr int corners_max = limits::cap_corners;
    scalar x[corners_max], y[corners_max], z[corners_max];
    int count;
    int face;                    ///< its number, or -1
    scalar z_0, slope_x, slope_y;  ///< of its plane: z = z_0 + slope_x x + slope_y y

    scalar height(scalar at_x, scalar at_y) const { return z_0 + slope_x * at_x + slope_y * at_y; }
};

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
constexpr scalar cap_cos[5] = {1, scalar(0.92387953251128675613), scalar(0.70710678118654752440), scalar(0.38268343236508977173), 0};
INGOT_INLINE scalar cap_cosine(int k) {
    const int quarter = (k & 15) <= 8 ? k & 15 : 16 - (k & 15);
    return quarter <= 4 ? cap_cos[quarter] : -cap_cos[8 - quarter];
}

void cylinder_patch(const PlacedShape& s, const Vector& centre, const Vector& towards, const ContactFrame& frame, Patch& patch) {
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

void polyhedron_patch(const PlacedShape& s, const Vector& centre, const Vector& towards, const ContactFrame& frame, Patch& patch) {
    const Polyhedron p = polyhedron_of(s);
    const Vector t = transpose_times(s.A, towards);
    int face = 0;
    scalar facing = -scalar_max;
    for (int i = 0; i < p.hull->face_count; ++i) {
        const scalar c = dot(p.hull->faces[i].n, t);
        if (!(c > facing)) continue;
        face = i;
        facing = c;
    }
    if (facing >= limits::facing_cos) {
        const HullFace& f = p.hull->faces[face];
        const int step = (f.loop_count + Patch::corners_max - 1) / Patch::corners_max;  // of faces of more corners, every other
        for (int k = 0; k < f.loop_count; k += step) add_corner(centre + s.A * p.vertex(p.hull->loops[f.loop_first + k]), frame, patch);
        patch.face = face;
        set_plane(s.A * f.n, frame, patch);
        return;
    }
    int corner = 0;
    scalar furthest = -scalar_max;
    for (int i = 0; i < p.hull->vertex_count; ++i) {
        const scalar along = dot(p.vertex(i), t);
        if (!(along > furthest)) continue;
        corner = i;
        furthest = along;
    }
    int edge = -1;
    scalar flattest = limits::facing_sin * limits::facing_sin;
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

/// What s turns towards `towards`; centre: its origin, seen from that of the frame.
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

/// Points that touch, in the plane of contact; near ones are one.
struct Found {
    static constexpr int room = 2 * Patch::corners_max;
    Candidate candidates[room];
    int count;
    scalar margin, nearby_sq;
    uint32_t axis;
    scalar radius_A, radius_B;

    void add(scalar x, scalar y, scalar z_A, scalar z_B, uint32_t feature) {
        const scalar bottom = z_A - radius_A, top = z_B + radius_B, s = bottom - top;
        if (!(s <= margin) || count >= room) return;
        for (int i = 0; i < count; ++i) {
            const scalar d_x = candidates[i].x - x, d_y = candidates[i].y - y;
            if (d_x * d_x + d_y * d_y <= nearby_sq) return;
        }
        candidates[count++] = {x, y, (bottom + top) * scalar(0.5), s, axis | feature};
    }
};

enum : uint32_t { corner_of_A = 1u << 16, corner_of_B = 2u << 16, crossing = 3u << 16 };

/// True where (x, y) is inside the polygon, or outside by no more than the slack.
bool inside(const Patch& polygon, scalar turn, scalar slack, scalar x, scalar y) {
    int last = polygon.count - 1;
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

/// The stretch low .. high of the line from corner a to corner b of `of` that is inside the polygon (Cyrus and Beck, 1978).
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
void overlay(const Patch& A, const Patch& B, scalar slack, Found& found) {
    const scalar turn_A = turn_of(A), turn_B = turn_of(B);
    const bool polygon_A = A.count >= 3, polygon_B = B.count >= 3;
    if (polygon_B)
        for (int i = 0; i < A.count; ++i)
            if (inside(B, turn_B, slack, A.x[i], A.y[i]))
                found.add(A.x[i], A.y[i], A.z[i], B.height(A.x[i], A.y[i]), corner_of_A | pair(i, 0));
    if (polygon_A)
        for (int i = 0; i < B.count; ++i)
            if (inside(A, turn_A, slack, B.x[i], B.y[i]))
                found.add(B.x[i], B.y[i], A.height(B.x[i], B.y[i]), B.z[i], corner_of_B | pair(0, i));
    // Edges of the one that enter and leave the other.
    const bool walk_A = polygon_B;
    const Patch &line = walk_A ? A : B, &polygon = walk_A ? B : A;
    const scalar turn = walk_A ? turn_B : turn_A;
    const int lines = line.count >= 3 ? line.count : 1;
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

/// Two lines: where they cross, or along which stretch they lie.
void cross_lines(const Patch& A, const Patch& B, Found& found) {
    const scalar u_x = A.x[1] - A.x[0], u_y = A.y[1] - A.y[0], v_x = B.x[1] - B.x[0], v_y = B.y[1] - B.y[0];
    const scalar u_sq = u_x * u_x + u_y * u_y, v_sq = v_x * v_x + v_y * v_y, w_x = B.x[0] - A.x[0], w_y = B.y[0] - A.y[0];
    const scalar area = u_x * v_y - u_y * v_x;
    const auto on = [](const Patch& p, scalar t) { return p.z[0] + (p.z[1] - p.z[0]) * t; };
    const auto within = [](scalar t) { return t < 0 ? scalar(0) : t > 1 ? scalar(1) : t; };
    const auto add = [&](scalar s, scalar t, uint32_t feature) {
        const scalar x = (A.x[0] + u_x * s + B.x[0] + v_x * t) * scalar(0.5), y = (A.y[0] + u_y * s + B.y[0] + v_y * t) * scalar(0.5);
        found.add(x, y, on(A, s), on(B, t), feature);
    };
    if (area * area > limits::lying_sin_sq * u_sq * v_sq) {
        add(within((w_x * v_y - w_y * v_x) / area), within((w_x * u_y - w_y * u_x) / area), crossing);
        return;
    }
    // Ends of B as seen along A.
    const scalar first = (w_x * u_x + w_y * u_y) / u_sq, second = ((w_x + v_x) * u_x + (w_y + v_y) * u_y) / u_sq;
    for (uint32_t end = 0; end < 2; ++end) {
        const scalar s = within(end == 0 ? first : second);
        const scalar at_x = u_x * s - w_x, at_y = u_y * s - w_y;
        add(s, within((at_x * v_x + at_y * v_y) / v_sq), crossing | (1 + end));
    }
}

/// The manifold across n, of shapes whose nearest points, or deepest, are known.
void touch(const PlacedShape& A, const PlacedShape& B, const Search& search, const Vector& P, scalar margin, const Before& before,
           scalar smallest, Manifold& manifold) {
    const ContactFrame frame = frame_about(search.n, B.r);
    Patch patch_A, patch_B;
    patch_of(A, A.r - B.r, -search.n, frame, patch_A);
    patch_of(B, {}, search.n, frame, patch_B);

    const scalar slack = limits::corner_slack * smallest;
    Found found;
    found.count = 0;
    found.margin = margin;
    found.nearby_sq = 4 * slack * slack;
    const int other_face = (search.code >> 30) == face_of_A ? patch_B.face : patch_A.face;  // the axis names its own
    found.axis = search.code | static_cast<uint32_t>(other_face & 63) << 18;
    found.radius_A = core_radius(A), found.radius_B = core_radius(B);
    if (patch_A.count >= 3 || patch_B.count >= 3) {
        if (patch_A.count == 1)
            found.add(patch_A.x[0], patch_A.y[0], patch_A.z[0], patch_B.height(patch_A.x[0], patch_A.y[0]), corner_of_A);
        else if (patch_B.count == 1)
            found.add(patch_B.x[0], patch_B.y[0], patch_A.height(patch_B.x[0], patch_B.y[0]), patch_B.z[0], corner_of_B);
        else
            overlay(patch_A, patch_B, slack, found);
    } else if (patch_A.count == 2 && patch_B.count == 2) {
        cross_lines(patch_A, patch_B, found);
    }
    scalar least = scalar_max;
    for (int i = 0; i < found.count; ++i) least = found.candidates[i].separation < least ? found.candidates[i].separation : least;
    const scalar gap = search.gap - (found.radius_A + found.radius_B);
    // Nothing on top of each other, or not the deepest: the nearest points, which are known.
    if (found.count == 0 || least > gap + limits::edge_preference * smallest) {
        if (gap > margin) return no_points(search.n, manifold);
        return one_point(search.n, P, gap, search.code | corner_of_A | corner_of_B | 1u, manifold);
    }
    keep_points(found.candidates, found.count, frame, limits::flatness * smallest, before, manifold);
}

void collide_convex(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold* before_it) {
    const Before before = remember(before_it);
    const scalar reach = core_radius(A) + core_radius(B);
    if (before_it != nullptr && before.count == 0 && length_sq(before.n) > 0 && gap_along(A, B, before.n) - reach > margin)
        return no_points(before.n, manifold);

    const scalar smallest_A = smallest_extent(A), smallest_B = smallest_extent(B);
    const scalar smallest = smallest_A < smallest_B ? smallest_A : smallest_B;
    const bool polyhedra = polyhedron_of(A).hull != nullptr && polyhedron_of(B).hull != nullptr;
    Search search{before.count > 0 ? before.features[0] & axis_mask : no_axis, limits::axis_hysteresis * smallest, {1, 0, 0},
                  -scalar_max, no_axis, {1, 0, 0}, -scalar_max};

    // What is round has no direction of its own that could be tried: nearest points first.
    Vector P{};
    bool have_P = false;
    if (!polyhedra) {
        const scalar by = limits::cylinder_shrink * smallest;
        const Nearest apart = nearest_cores(shrunk(A, by), shrunk(B, by), margin + reach + 4 * by);
        if (!apart.overlap) {
            const scalar gap = gap_along(A, B, apart.n);
            search.look(apart.n, gap, axis_code(nearest, 0));
            if (gap - reach > margin) return no_points(apart.n, manifold);
            const bool round = reach > 0 && A.shape.kind != ShapeKind::cylinder && B.shape.kind != ShapeKind::cylinder;
            P = (apart.P_A + apart.P_B + apart.n * (core_radius(B) - core_radius(A))) * scalar(0.5);
            have_P = true;
            if (round) {
                // Balls and capsules whose cores are apart: that is the direction.
                touch(A, B, search, P, margin, before, smallest, manifold);
                return;
            }
        }
    }
    const scalar gap_of_nearest = search.gap;
    Search faces = search;
    faces.gap = -scalar_max;
    look_at_faces(A, B, true, faces);
    look_at_faces(B, A, false, faces);
    faces.settle();
    if (faces.gap - reach > margin) return no_points(faces.n, manifold);

    Search rest = faces;
    rest.gap = -scalar_max;
    if (gap_of_nearest > -scalar_max) rest.look(search.n, gap_of_nearest, axis_code(nearest, 0));
    if (polyhedra) {
        look_at_edge_pairs(A, B, rest);
    } else {
        const bool long_A = A.shape.kind == ShapeKind::cylinder || A.shape.kind == ShapeKind::capsule;
        const bool long_B = B.shape.kind == ShapeKind::cylinder || B.shape.kind == ShapeKind::capsule;
        if (long_A) look_at_edges_across(B, A.A.c2, A, B, rest);
        if (long_B) look_at_edges_across(A, B.A.c2, A, B, rest);
        if (long_A && long_B) {
            Vector n = cross(A.A.c2, B.A.c2);
            const scalar sin_sq = length_sq(n);
            if (sin_sq > limits::parallel_sin_sq) {
                n = n * ((dot(n, A.r - B.r) < 0 ? scalar(-1) : scalar(1)) / sqrt(sin_sq));
                rest.look(n, gap_along(A, B, n), axis_code(edges, 0));
            }
            // Side by side, or one inside the other: across the axis of either.
            for (int of = 0; of < 2; ++of) {
                const Vector& axis = of == 0 ? A.A.c2 : B.A.c2;
                const Vector d = A.r - B.r, across = d - axis * dot(axis, d);
                const scalar across_sq = length_sq(across);
                if (!(across_sq > limits::parallel_sin_sq * smallest * smallest)) continue;
                const Vector m = across * (1 / sqrt(across_sq));
                rest.look(m, gap_along(A, B, m), axis_code(edges, 1));
            }
        }
    }
    const bool edge_wins = rest.gap > faces.gap + limits::edge_preference * smallest || !(faces.gap > -scalar_max);
    const Search& best = edge_wins ? rest : faces;
    if (best.gap - reach > margin) return no_points(best.n, manifold);
    if (!have_P || best.code != axis_code(nearest, 0)) {
        // Half-way between the deepest corner and the plane it is deepest under.
        const Vector deepest = support_point(A, -best.n);
        P = deepest - best.n * ((best.gap - reach) * scalar(0.5));
    }
    touch(A, B, best, P, margin, before, smallest, manifold);
}

}  // namespace

void collide_sphere_hull(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold* before) {
    collide_convex(A, B, margin, manifold, before);
}
void collide_capsule_cylinder(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold* before) {
    collide_convex(A, B, margin, manifold, before);
}
void collide_capsule_hull(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold* before) {
    collide_convex(A, B, margin, manifold, before);
}
void collide_box_cylinder(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold* before) {
    collide_convex(A, B, margin, manifold, before);
}
void collide_box_hull(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold* before) {
    collide_convex(A, B, margin, manifold, before);
}
void collide_cylinder_cylinder(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold* before) {
    collide_convex(A, B, margin, manifold, before);
}
void collide_cylinder_hull(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold* before) {
    collide_convex(A, B, margin, manifold, before);
}
void collide_hull_hull(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold* before) {
    collide_convex(A, B, margin, manifold, before);
}

} }  // namespace ingot

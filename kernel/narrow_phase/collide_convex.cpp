// SPDX-License-Identifier: MIT
// Hulls and cylinders against everything that has a core: the direction that separates best, then the features on both sides
// clipped against each other in the plane across it.
//
// Cores that are apart: the direction of the nearest points. Cores that overlap: faces of hulls and boxes, ends of cylinders,
// edges of two polyhedra whose arcs cross on the Gauss map, edges across the side of what is round; for cylinders, the best of
// these turned until no turn helps. Every direction is judged by the supports of the whole shapes, so no manifold claims a gap
// that is not there.
// Source: Gregorius, "The separating axis test between convex polyhedra", GDC 2013, for the test on the Gauss map.
#include "contact_patch.h"
#include "collide_pairs.h"
#include "nearest_points.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// The gap between the shadows of two cores on n, which points from B to A.
scalar gap_seen_along(const PlacedShape& A, const PlacedShape& B, const Vector& n) {
    const Vector n_A = transpose_times(A.A, n), n_B = transpose_times(B.A, n);
    return dot(n, A.r - B.r) + (dot(n_A, core_support(A, -n_A)) - dot(n_B, core_support(B, n_B)));
}

// Axes, as features name them: what kind, and which face.
enum : uint32_t { face_of_A = 0, face_of_B = 1, between = 2 };
constexpr uint32_t axis_code(uint32_t kind, int i) { return kind << 30 | static_cast<uint32_t>(i & 63) << 24; }
constexpr uint32_t axis_mask = 0xff000000u;
constexpr uint32_t no_face = ~0u;

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
    void join(const Search& other) {
        if (other.gap_before > -scalar_max) {
            n_before = other.n_before;
            gap_before = other.gap_before;
        }
        if (!(other.gap > gap)) return;
        n = other.n;
        gap = other.gap;
        code = other.code;
    }
    /// The faces are done: the one of before is kept while it is nearly as good.
    void settle() {
        if (before == no_face || !(gap_before + hysteresis >= gap)) return;
        n = n_before;
        gap = gap_before;
        code = before;
    }
};

void look_at_faces(const PlacedShape& of, const PlacedShape& other, bool of_A, Search& search) {
    const uint32_t kind = of_A ? face_of_A : face_of_B;
    const auto look = [&](const Vector& n_body, int i) {
        const Vector outward = of.A * n_body, n = of_A ? -outward : outward;
        search.look(n, of_A ? gap_seen_along(of, other, n) : gap_seen_along(other, of, n), axis_code(kind, i));
    };
    if (of.shape.kind == ShapeKind::cylinder) {
        look({0, 0, -1}, 0);
        look({0, 0, 1}, 1);
    }
    const Polyhedron p = polyhedron_of(of);
    if (p.hull == nullptr) return;
    // bound: 2 limits::hull_vertices_max - 4
    for (int i = 0; i < p.hull->face_count; ++i) look(p.hull->faces[i].n, i);
}

/// Edge pairs whose arcs cross on the Gauss map; all others are no candidates for touching (Gregorius 2013).
void look_at_edge_pairs(const PlacedShape& A, const PlacedShape& B, Search& search) {
    const Polyhedron a = polyhedron_of(A), b = polyhedron_of(B);
    const Vector d = A.r - B.r;
    scalar side[2 * limits::hull_vertices_max];  // of the faces of B seen along an edge of A
    const int faces_B = b.hull->face_count < 2 * limits::hull_vertices_max ? b.hull->face_count : 2 * limits::hull_vertices_max;
    // bound: 3 limits::hull_vertices_max - 6
    for (int i = 0; i < a.hull->edge_count; ++i) {
        const HullEdge& edge_A = a.hull->edges[i];
        const Vector p = A.A * a.vertex(edge_A.a), u = A.A * (a.vertex(edge_A.b) - a.vertex(edge_A.a));
        const Vector left_A = A.A * a.hull->faces[edge_A.face_left].n, right_A = A.A * a.hull->faces[edge_A.face_right].n;
        const Vector u_B = transpose_times(B.A, u);
        const scalar u_sq = length_sq(u);
        // bound: 2 limits::hull_vertices_max
        for (int k = 0; k < faces_B; ++k) side[k] = dot(b.hull->faces[k].n, u_B);
        // bound: 3 limits::hull_vertices_max - 6
        for (int j = 0; j < b.hull->edge_count; ++j) {
            const HullEdge& edge_B = b.hull->edges[j];
            const scalar c = side[edge_B.face_left], e = side[edge_B.face_right];
            if (!(c * e < 0)) continue;
            const Vector v = B.A * (b.vertex(edge_B.b) - b.vertex(edge_B.a));
            const scalar left = dot(left_A, v), right = dot(right_A, v);
            // Arcs cross when the ends of each lie on both sides of the other, on the same half of the sphere: with the normals
            // of B turned round and u along n_left x n_right of A, that is this sign.
            if (!(left * right < 0)) continue;
            Vector n = cross(u, v);
            const scalar n_sq = length_sq(n);
            if (!(n_sq > limits::parallel_sin_sq * u_sq * length_sq(v))) continue;
            n = n * (1 / sqrt(n_sq));
            if (dot(n, left_A + right_A) > 0) n = -n;
            const Vector left_B = B.A * b.hull->faces[edge_B.face_left].n, right_B = B.A * b.hull->faces[edge_B.face_right].n;
            if (!(dot(n, left_B + right_B) > 0)) continue;
            search.look(n, dot(n, d + p - B.A * b.vertex(edge_B.a)), axis_code(between, 0));
        }
    }
}

/// Edges of a polyhedron across the side of a cylinder or along a capsule, whose axis is u in the world.
void look_at_edges_across(const PlacedShape& s, const Vector& u, const PlacedShape& A, const PlacedShape& B, Search& search) {
    const Polyhedron p = polyhedron_of(s);
    if (p.hull == nullptr) return;
    const Vector u_body = transpose_times(s.A, u);
    const bool is_A = &s == &A;
    // bound: 3 limits::hull_vertices_max - 6
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
        search.look(towards_A, gap_seen_along(A, B, towards_A), axis_code(between, 0));
    }
}

scalar smallest_extent(const PlacedShape& s) {
    switch (s.shape.kind) {
        case ShapeKind::box: return smallest_of(s.shape.size);
        case ShapeKind::capsule:
        case ShapeKind::cylinder: return s.shape.size.x < s.shape.size.y ? s.shape.size.x : s.shape.size.y;
        case ShapeKind::hull: return s.hull->inner_radius;
        default: return s.shape.size.x;
    }
}

/// The axis of what is long and round; null for the rest.
const Vector* axis_of(const PlacedShape& s) {
    return s.shape.kind == ShapeKind::cylinder || s.shape.kind == ShapeKind::capsule ? &s.A.c2 : nullptr;
}

/// Half-way between the points where the shapes touch once A has been moved along n. by: m, so that they are just apart.
Vector meeting_point(const PlacedShape& A, const PlacedShape& B, const Vector& n, scalar gap, scalar by) {
    PlacedShape moved = A;
    moved.r += n * (by - gap);
    const Nearest near = nearest_cores(moved, B, scalar_max, by);
    const Vector on_A = near.P_A - n * (by - gap + core_radius(A)), on_B = near.P_B + n * core_radius(B);
    return (on_A + on_B) * scalar(0.5);
}

/// The manifold across the direction that was found. False where nothing is on top of each other across a face and another
/// direction is known: then the face only seemed as good.
bool touch(const PlacedShape& A, const PlacedShape& B, const Search& search, scalar margin, const Before& before,
           scalar smallest, bool has_other, Manifold& manifold) {
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
    found.gap = search.gap - (found.radius_A + found.radius_B);
    // What is round is lower by aside^2 / 2 r beside its line: by less than the slack.
    const bool round = axis_of(A) != nullptr || axis_of(B) != nullptr;
    overlay(patch_A, patch_B, slack, round ? limits::round_aside * smallest : slack, found);

    scalar least = scalar_max;
    // bound: Found::room, twice limits::cap_corners
    for (int i = 0; i < found.count; ++i)
        least = found.candidates[i].separation < least ? found.candidates[i].separation : least;
    // Nothing on top of each other, or not the deepest: one point.
    if (found.count == 0 || least > found.gap + limits::edge_preference * smallest) {
        if (has_other) return false;
        const Vector P = A.shape.kind == ShapeKind::sphere
                             ? A.r - search.n * (found.radius_A + found.gap * scalar(0.5))
                             : meeting_point(A, B, search.n, search.gap, limits::refinement_lift * smallest);
        one_point(search.n, P, found.gap, found.axis | corner_of_A | corner_of_B, manifold);
        return true;
    }
    keep_points(found.candidates, found.count, frame, limits::flatness * smallest, before, manifold);
    return true;
}

/// Directions across the axes of what is round: edges, the other axis, and from one axis to the centre of the other shape.
void look_across_axes(const PlacedShape& A, const PlacedShape& B, Search& search) {
    const Vector *axis_A = axis_of(A), *axis_B = axis_of(B), d = A.r - B.r;
    const auto look = [&](const Vector& direction) {
        const scalar size_sq = length_sq(direction);
        if (!(size_sq > limits::parallel_sin_sq)) return;
        const Vector n = direction * ((dot(direction, d) < 0 ? scalar(-1) : scalar(1)) / sqrt(size_sq));
        search.look(n, gap_seen_along(A, B, n), axis_code(between, 0));
    };
    if (axis_A != nullptr) look_at_edges_across(B, *axis_A, A, B, search);
    if (axis_B != nullptr) look_at_edges_across(A, *axis_B, A, B, search);
    if (axis_A != nullptr && axis_B != nullptr) look(cross(*axis_A, *axis_B));
    const scalar far = sqrt(length_sq(d));
    if (!(far > 0)) return;
    const Vector from_B = d * (1 / far);
    if (axis_A != nullptr) look(from_B - *axis_A * dot(*axis_A, from_B));
    if (axis_B != nullptr) look(from_B - *axis_B * dot(*axis_B, from_B));
    look(from_B);
}

/// Turns the direction towards one that separates better, until none does by limits::round_accuracy of the smallest extent.
///
/// Moves A out along n and takes the direction of the nearest points. With D = A - B, h its support function in the direction
/// m = -n and q = (h + lift) m the origin moved out: the nearest point of D is at the distance q . m' - h(m') >= |q| - h(m), so
/// h(m') <= h(m), for every D. It stands still only where the point of D furthest along m is h m: there no turn helps.
void refine(const PlacedShape& A, const PlacedShape& B, scalar smallest, Search& search) {
    if (!(search.gap > -scalar_max)) return;
    for (int i = 0; i < limits::refinements_max; ++i) {
        PlacedShape moved = A;
        moved.r += search.n * (limits::refinement_lift * smallest - search.gap);
        const Nearest near = nearest_cores(moved, B, scalar_max);
        if (near.overlap) return;
        const scalar gap = gap_seen_along(A, B, near.n);
        if (!(gap > search.gap + limits::round_accuracy * smallest)) return;
        search.n = near.n;
        search.gap = gap;
        search.code = axis_code(between, 0);
    }
}

/// A search that rounding ended may be off by ten-thousandths, and along that a corner metres away seems to overlap: a face may part them further.
void look_at_all_faces(const PlacedShape& A, const PlacedShape& B, const Search& nothing, Search& rest) {
    Search face = nothing;
    look_at_faces(A, B, true, face);
    look_at_faces(B, A, false, face);
    rest.look(face.n, face.gap, axis_code(between, 0));
}

void collide_convex(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold* before_it) {
    const Before before = remember(before_it);
    const scalar reach = core_radius(A) + core_radius(B);
    if (before_it != nullptr && before.count == 0 && length_sq(before.n) > 0 && gap_seen_along(A, B, before.n) - reach > margin)
        return no_points(before.n, manifold);

    const scalar smallest_A = smallest_extent(A), smallest_B = smallest_extent(B);
    const scalar smallest = smallest_A < smallest_B ? smallest_A : smallest_B;
    const uint32_t axis_before = before.count > 0 ? before.features[0] & axis_mask : no_face;
    const Search nothing{axis_before, limits::axis_hysteresis * smallest, {1, 0, 0}, -scalar_max, no_face, {1, 0, 0},
                         -scalar_max};
    const bool cylinder = A.shape.kind == ShapeKind::cylinder || B.shape.kind == ShapeKind::cylinder;

    // Cores that are apart: the direction of their nearest points separates best.
    Search rest = nothing;
    const Nearest near = nearest_cores(A, B, margin + reach);
    bool apart = false;
    if (!near.overlap) {
        rest.look(near.n, gap_seen_along(A, B, near.n), axis_code(between, 0));
        if (rest.gap - reach > margin) return no_points(rest.n, manifold);
        apart = rest.gap > 0 && rest.gap >= near.distance - limits::nearest_direction * smallest;
        if (apart && reach > 0 && rest.gap < near.distance * (1 - limits::nearest_accuracy)) look_at_all_faces(A, B, nothing, rest);
        if (apart && reach > 0 && !cylinder) return void(touch(A, B, rest, margin, before, smallest, false, manifold));
    }
    Search faces = nothing, faces_A = nothing, faces_B = nothing;
    look_at_faces(A, B, true, faces_A);
    look_at_faces(B, A, false, faces_B);
    faces.join(faces_A);
    faces.join(faces_B);
    faces.settle();
    if (faces.gap - reach > margin) return no_points(faces.n, manifold);

    if (!apart) {
        if (polyhedron_of(A).hull != nullptr && polyhedron_of(B).hull != nullptr)
            look_at_edge_pairs(A, B, rest);
        else
            look_across_axes(A, B, rest);
        if (cylinder) {
            // From each of them: what a turn ends at is the least way only nearby. Shallow ones have no other.
            const scalar best = faces.gap > rest.gap ? faces.gap : rest.gap;
            const bool shallow = best > -(limits::shallow * smallest);
            if (!shallow || faces_A.gap >= best) refine(A, B, smallest, faces_A);
            if (!shallow || faces_B.gap >= best) refine(A, B, smallest, faces_B);
            if (!shallow || rest.gap >= best) refine(A, B, smallest, rest);
            rest.join(faces_A);
            rest.join(faces_B);
        }
    }
    const bool face_wins = faces.gap > -scalar_max && rest.gap <= faces.gap + limits::edge_preference * smallest;
    const bool has_rest = rest.gap >= faces.gap - limits::edge_preference * smallest;
    if (face_wins && touch(A, B, faces, margin, before, smallest, has_rest, manifold)) return;
    if (rest.gap - reach > margin) return no_points(rest.n, manifold);
    touch(A, B, rest, margin, before, smallest, false, manifold);
}

}  // namespace

void collide_sphere_hull(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                         const Manifold* before) {
    collide_convex(A, B, margin, manifold, before);
}
void collide_capsule_cylinder(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                              const Manifold* before) {
    collide_convex(A, B, margin, manifold, before);
}
void collide_capsule_hull(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                          const Manifold* before) {
    collide_convex(A, B, margin, manifold, before);
}
void collide_box_cylinder(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                          const Manifold* before) {
    collide_convex(A, B, margin, manifold, before);
}
void collide_box_hull(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold* before) {
    collide_convex(A, B, margin, manifold, before);
}
void collide_cylinder_cylinder(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                               const Manifold* before) {
    collide_convex(A, B, margin, manifold, before);
}
void collide_cylinder_hull(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                           const Manifold* before) {
    collide_convex(A, B, margin, manifold, before);
}
void collide_hull_hull(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold* before) {
    collide_convex(A, B, margin, manifold, before);
}

} }  // namespace ingot

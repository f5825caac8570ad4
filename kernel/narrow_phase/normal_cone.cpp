// SPDX-License-Identifier: MIT
#include "normal_cone.h"

namespace ingot { inline namespace INGOT_ABI {

void put_on_box(const PlacedShape& box, Touch& touch) {
    const Vector &h = box.shape.size, q = transpose_times(box.A, touch.p - box.r), e = transpose_times(box.A, touch.d);
    int across = 0;
    // A direction that was searched for may be off by thousandths: so little does not lead to a side that is far from the point.
    const auto put = [&](scalar q_i, scalar e_i, scalar h_i) {
        const scalar side = e_i < 0 ? -h_i : h_i;
        const scalar tilt = abs(side - q_i) > limits::far_side * h_i ? max(touch.tilt, limits::face_tilt) : touch.tilt;
        if (abs(e_i) <= tilt) return ++across, clamp(q_i, h_i);
        return side;
    };
    touch.p = box.r + box.A * Vector{put(q.x, e.x, h.x), put(q.y, e.y, h.y), put(q.z, e.z, h.z)};
    touch.face = across == 2;
}

bool hidden_by_box(const PlacedShape& T, const Touch& touch, const Vector& p, scalar flush) {
    const Vector &h = T.shape.size, q = transpose_times(T.A, p - T.r), e = transpose_times(T.A, touch.d);
    if (abs(q.x) > h.x + flush || abs(q.y) > h.y + flush || abs(q.z) > h.z + flush) return false;
    const auto leads_in = [&](scalar q_i, scalar e_i, scalar h_i) {
        return e_i > touch.tilt ? q_i <= h_i - flush : e_i < -touch.tilt && q_i >= -h_i + flush;
    };
    return leads_in(q.x, e.x, h.x) || leads_in(q.y, e.y, h.y) || leads_in(q.z, e.z, h.z);
}

bool hidden_by_half_space(const PlacedShape& T, const Touch& touch, const Vector& p, scalar flush) {
    const HeightAbove face = face_below(T, p);
    if (face.height > flush) return false;
    const scalar along = dot(touch.d, face.n);
    const Vector aside = touch.d - face.n * along;
    return face.height < -flush || along < 0 || length_sq(aside) > touch.tilt * touch.tilt;
}

namespace {

/// True where d, which is off the normal of a face by `aside`, leads over an edge of it that is near q, a point in its plane. As for put_on_box, d
/// may be off by thousandths, and so little does not lead to an edge that is far from the point.
bool leads_over_edge(const ConvexHull& hull, int face_i, const Vector& q, const Vector& aside, scalar tilt) {
    const Vector& n = hull.faces[face_i].n;
    bool leads = false;
    // bound: 3 limits::hull_vertices_max - 6
    for (int i = 0; i < hull.edge_count; ++i) {
        const HullEdge& edge = hull.edges[i];
        if (edge.face_left != face_i && edge.face_right != face_i) continue;
        const HullFace& other = hull.faces[edge.face_left == face_i ? edge.face_right : edge.face_left];
        const Vector across = other.n - n * dot(n, other.n);
        const scalar size = sqrt(length_sq(across)), inside = other.offset - dot(other.n, q);
        leads = leads || (dot(across, aside) > tilt * size && inside < limits::far_side * hull.inner_radius * size);
    }
    return leads;
}

}  // namespace

void put_on_hull(const PlacedShape& s, Touch& touch) {
    const ConvexHull& hull = *s.hull;
    const Vector d = transpose_times(s.A, touch.d);
    Vector q = transpose_times(s.A, touch.p - s.r);
    const auto put = [&](const Vector& on_hull) { touch.p = s.r + s.A * on_hull; };
    int face_i = 0;
    // bound: 2 limits::hull_vertices_max - 4
    for (int i = 1; i < hull.face_count; ++i)
        if (dot(hull.faces[i].n, d) > dot(hull.faces[face_i].n, d)) face_i = i;
    const HullFace& face = hull.faces[face_i];
    const Vector aside = d - face.n * dot(face.n, d), below = q - face.n * (dot(face.n, q) - face.offset);
    const scalar aside_sq = length_sq(aside), most = max(touch.tilt, limits::face_tilt);
    touch.face = dot(face.n, d) > 0 && (aside_sq <= touch.tilt * touch.tilt ||
                                        (aside_sq <= most * most && !leads_over_edge(hull, face_i, below, aside, touch.tilt)));
    if (touch.face) {
        q = below;
        // bound: 2 limits::hull_vertices_max - 4
        for (int k = 0; k < hull.face_count; ++k) {  // back over the edges of the face: exact for one of them
            const scalar beyond = dot(hull.faces[k].n, q) - hull.faces[k].offset;
            const Vector across = hull.faces[k].n - face.n * dot(face.n, hull.faces[k].n);
            if (k != face_i && beyond > 0 && length_sq(across) > touch.tilt * touch.tilt) q = q - across * (beyond / length_sq(across));
        }
        return put(q);
    }
    int corner = 0;
    // bound: limits::hull_vertices_max
    for (int i = 1; i < hull.vertex_count; ++i)
        if (dot(hull.vertices[i], d) > dot(hull.vertices[corner], d)) corner = i;
    Vector nearest = hull.vertices[corner];
    scalar least = scalar_max;
    // bound: 3 limits::hull_vertices_max - 6
    for (int i = 0; i < hull.edge_count; ++i) {
        const HullEdge& edge = hull.edges[i];
        if (edge.a != corner && edge.b != corner) continue;
        const Vector &from = hull.vertices[edge.a], along = hull.vertices[edge.b] - from;
        const scalar rise = dot(along, d), size_sq = length_sq(along), t = dot(q - from, along) / size_sq;
        const scalar from_corner = edge.a == corner ? t : 1 - t, tilt = from_corner > limits::far_side / 2 ? most : touch.tilt;
        const Vector on = from + along * (t < 0 ? scalar(0) : t > 1 ? scalar(1) : t);
        if (rise * rise > tilt * tilt * size_sq || !(length_sq(q - on) < least)) continue;
        least = length_sq(q - on);
        nearest = on;
    }
    put(nearest);
}

namespace {

/// The faces of a hull that meet in a point.
struct Wedge {
    static constexpr int faces_max = 8;
    Vector n[faces_max];
    int count;

    /// True where d leads into the hull, by more than the tilt: some direction of the tangent cone is that much along d. The one most along d is
    /// d itself, d in a face, or an edge.
    bool takes(const Vector& d, scalar tilt) const {
        if (leads_in(d, tilt, d)) return true;
        // bound: Wedge::faces_max
        for (int i = 0; i < count; ++i)
            if (leads_in(d - n[i] * dot(d, n[i]), tilt, d)) return true;
        // bound: Wedge::faces_max
        for (int i = 0; i < count; ++i)
            for (int k = i + 1; k < count; ++k) {
                const Vector edge = cross(n[i], n[k]);
                if (leads_in(edge * dot(edge, d), tilt, d)) return true;
            }
        return false;
    }

private:
    /// x: of any length. Inside all faces but for rounding, which for d in a face is some epsilon.
    bool leads_in(const Vector& x, scalar tilt, const Vector& d) const {
        const scalar size = sqrt(length_sq(x));
        if (!(dot(x, d) > tilt * size)) return false;
        // bound: Wedge::faces_max
        for (int i = 0; i < count; ++i)
            if (dot(n[i], x) > tilt / 2 * size) return false;
        return true;
    }
};

}  // namespace

bool hidden_by_hull(const PlacedShape& T, const Touch& touch, const Vector& p, scalar flush) {
    const Vector q = transpose_times(T.A, p - T.r);
    Wedge wedge;
    wedge.count = 0;
    // bound: 2 limits::hull_vertices_max - 4
    for (int i = 0; i < T.hull->face_count; ++i) {
        const HullFace& face = T.hull->faces[i];
        const scalar height = dot(face.n, q) - face.offset;
        if (height > flush) return false;
        if (height > -flush && wedge.count < Wedge::faces_max) wedge.n[wedge.count++] = face.n;
    }
    return wedge.takes(transpose_times(T.A, touch.d), touch.tilt);
}

bool is_side_of_body(const PlacedShape& body, const Vector& d) {
    const Vector e = transpose_times(body.A, d);
    const scalar near = 1 - limits::edge_tilt * limits::edge_tilt;
    if (body.shape.kind == ShapeKind::box) return abs(e.x) > near || abs(e.y) > near || abs(e.z) > near;
    if (body.shape.kind == ShapeKind::cylinder) return abs(e.z) > near;
    if (body.shape.kind != ShapeKind::hull) return false;
    // bound: 2 limits::hull_vertices_max - 4
    for (int i = 0; i < body.hull->face_count; ++i)
        if (dot(body.hull->faces[i].n, e) < -near) return true;
    return false;
}

bool is_below_axis(const PlacedShape& cylinder, const Vector& P, const Vector& d) {
    const scalar slack = limits::off_round * cylinder.shape.size.x + 2 * epsilon * sqrt(length_sq(P));
    const Vector aside = cross(cylinder.A.c2, d);
    const scalar off = dot(P - cylinder.r, aside);
    return off * off <= slack * slack * length_sq(aside);
}

int face_count(const PlacedShape& S) {
    return S.shape.kind == ShapeKind::box ? 6 : S.shape.kind == ShapeKind::hull ? S.hull->face_count : 0;
}

FaceOfFixed face_of(const PlacedShape& S, int face_i) {
    if (S.shape.kind == ShapeKind::hull) return {S.A * S.hull->faces[face_i].n, S.hull->faces[face_i].offset};
    const int axis = face_i >> 1;
    return {S.A * unit_axis(axis, (face_i & 1) != 0 ? scalar(-1) : scalar(1)), component(S.shape.size, axis)};
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// Two boxes by their separating axes (box_axes.h); see Sutherland, Hodgman, "Reentrant polygon clipping", 1974, for the points.
#include "box_axes.h"
#include "collide_pairs.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

constexpr uint32_t feature_of(int axis, bool negative, uint32_t rest) {
    return static_cast<uint32_t>(axis) << 24 | (negative ? 1u << 23 : 0u) | rest;
}

/// The gap between the shadows of the boxes on a unit vector n that points from B to A.
INGOT_INLINE scalar gap_of_boxes(const PlacedShape& A, const PlacedShape& B, const Vector& n) {
    scalar reach_A = 0, reach_B = 0;
    for (int k = 0; k < 3; ++k) {
        reach_A += component(A.shape.size, k) * abs(dot(n, column(A.A, k)));
        reach_B += component(B.shape.size, k) * abs(dot(n, column(B.A, k)));
    }
    return dot(n, A.r - B.r) - (reach_A + reach_B);
}

/// A corner of the polygon that is clipped; the edges before and after it, 0 .. 3 of the incident face and 4 .. 7 the sides of the reference face.
struct ClippedCorner {
    scalar at[3];  ///< m, along e_x, e_y, and above the reference face
    uint8_t in, out;
};
struct Polygon {
    ClippedCorner corner[8];
    int count;
};

/// Keeps the part of `from` with sign * (y or x) <= limit. A convex polygon gains at most one corner.
void clip(const Polygon& from, bool along_y, scalar sign, scalar limit, uint8_t side, Polygon& to) {
    const int axis = along_y ? 1 : 0;
    to.count = 0;
    const ClippedCorner* last = from.count > 0 ? &from.corner[from.count - 1] : nullptr;
    scalar last_over = last != nullptr ? sign * last->at[axis] - limit : 0;
    // bound: 8: corners of a rectangle that is clipped four times
    for (int i = 0; i < from.count; ++i) {
        const ClippedCorner& next = from.corner[i];
        const scalar over = sign * next.at[axis] - limit;
        const bool inside = over <= 0, last_inside = last_over <= 0;
        if (inside != last_inside && to.count < 8) {
            const scalar t = last_over / (last_over - over);
            ClippedCorner& cut = to.corner[to.count++];
            for (int k = 0; k < 3; ++k) cut.at[k] = last->at[k] + t * (next.at[k] - last->at[k]);
            cut.in = inside ? side : next.in;
            cut.out = inside ? next.in : side;
        }
        if (inside && to.count < 8) to.corner[to.count++] = next;
        last = &next;
        last_over = over;
    }
}

/// A box seen along one of its edges: the edge nearest to the other box, and the sum of the outward normals of the two faces that make it.
struct EdgeOfBox {
    Vector middle, out;
    uint32_t signs;
};

/// `towards` is normal to one of the faces, or the box turns this edge towards it; where it is level with `towards` a face looks for the point.
EdgeOfBox edge_of(const PlacedShape& box, int along, const Vector& towards, const Vector& point) {
    EdgeOfBox edge{box.r, {}, 0};
    for (int k = 0; k < 3; ++k) {
        if (k == along) continue;
        const Vector& A_k = column(box.A, k);
        const scalar rise = dot(A_k, towards);
        const bool ahead = (abs(rise) > limits::facing_sin ? rise : dot(point - box.r, A_k)) > 0;
        edge.middle += A_k * (ahead ? component(box.shape.size, k) : -component(box.shape.size, k));
        edge.out += ahead ? A_k : -A_k;
        edge.signs |= ahead ? 1u << k : 0u;
    }
    return edge;
}

/// Where two parallel edges meet, as of cards that lean on each other, any direction between the faces of both separates the boxes equally well:
/// the normals that either edge allows span a quarter turn, and they share an angle of 2 phi. Edges are taken for round, with a radius of
/// ridge / 2: the normal is the middle of what they share while they lie on each other, turns as they shift, and is that of a face, which has points
/// of its own, from tan(phi) of the radius on. Edges that are apart have the direction between them.
///
/// n: from B to A, of the face that separates best. False where no two edges meet so.
bool ridge_points(const PlacedShape& A, const PlacedShape& B, const Vector& n, scalar ridge, scalar margin, Manifold& manifold) {
    int i = 0, j = 0;
    scalar most = 0;
    for (int k = 0; k < 3; ++k) {
        if (abs(dot(column(A.A, k), n)) > limits::facing_sin) continue;  // that edge does not lie in the face
        for (int m = 0; m < 3; ++m) {
            const scalar c = abs(dot(column(A.A, k), column(B.A, m)));
            if (c > most) most = c, i = k, j = m;
        }
    }
    if (!(most * most >= 1 - limits::parallel_sin_sq)) return false;

    // The box whose edge points towards the face first: the face then knows at which end it is.
    const Vector &u = column(A.A, i), v = column(B.A, j) * (dot(column(A.A, i), column(B.A, j)) < 0 ? scalar(-1) : scalar(1));
    const EdgeOfBox first_A = edge_of(A, i, -n, B.r), first_B = edge_of(B, j, n, A.r);
    const EdgeOfBox of_A = edge_of(A, i, -n, first_B.middle), of_B = edge_of(B, j, n, first_A.middle);
    // Middle of the shared angle, and tan(phi) = tan(45 degrees - psi) with psi half the angle between what the edges allow.
    const Vector sum = of_B.out - of_A.out, difference = of_B.out + of_A.out;
    const scalar length = sqrt(length_sq(sum)), spread = sqrt(length_sq(difference));
    if (!(length > spread * (1 + limits::facing_sin))) return false;
    const Vector middle = sum * (1 / length);
    const scalar tan_phi = (length - spread) / (length + spread);

    const scalar a = component(A.shape.size, i), b = component(B.shape.size, j), offset = dot(of_B.middle - of_A.middle, u);
    const scalar low = offset - b > -a ? offset - b : -a, high = offset + b < a ? offset + b : a;
    if (!(low <= high)) return false;
    const auto on_A = [&](scalar x) { return of_A.middle + u * x; };
    const auto on_B = [&](scalar x) { return of_B.middle + v * (x - offset); };
    Vector w = on_A((low + high) / 2) - on_B((low + high) / 2);
    w = w - u * dot(w, u);
    const scalar ahead = ridge + dot(w, middle);
    const Vector aside = w - middle * dot(w, middle);
    if (!(ahead > 0 && length_sq(aside) < tan_phi * tan_phi * ahead * ahead)) return false;
    const Vector turned = middle * ahead + aside, normal = turned * (1 / sqrt(length_sq(turned)));

    no_points(normal, manifold);
    for (uint32_t end = 0; end < 2; ++end) {
        const Vector p = on_A(end == 0 ? low : high), q = on_B(end == 0 ? low : high);
        const scalar s = dot(normal, p - q);
        const uint32_t feature = feature_of(first_edge_axis + 3 * i + j, true, of_A.signs | of_B.signs << 3 | end << 6);
        if (s <= margin) manifold.points[manifold.count++] = {(p + q) * scalar(0.5), s, feature};
    }
    return true;
}

/// The face that separates best, and the other box above it.
struct ReferenceFace {
    const PlacedShape &box, &other;
    int axis;                 ///< of its box, along its normal
    scalar h_x, h_y;          ///< m, half extents
    const Vector &e_x, &e_y;  ///< unit, along them
    Vector up;                ///< unit, its outward normal
    Vector centre;            ///< m, of the other box, from that of this one
    bool of_A;                ///< of A: n, from B to A, is then against `up`
    bool negative;            ///< up is against that axis of its box
};

/// The face of the other box that looks most against `up`: its axis, and the cosine of that with `up`.
struct IncidentFace {
    int axis;
    scalar along;
    INGOT_INLINE bool flipped() const { return along > 0; }  ///< against its axis, to look against `up`
};

INGOT_INLINE IncidentFace incident_face(const ReferenceFace& face) {
    int facing = 0;
    scalar along = dot(face.other.A.c0, face.up);
    for (int j = 1; j < 3; ++j) {
        const scalar c = dot(column(face.other.A, j), face.up);
        if (abs(c) > abs(along)) {
            facing = j;
            along = c;
        }
    }
    return {facing, along};
}

/// The corners of the incident face along e_x, e_y, and above the reference face, m; reach: how far they get to +x, -x, +y, -y.
INGOT_INLINE void place_polygon(const ReferenceFace& face, const IncidentFace& incident, Polygon& polygon, scalar (&reach)[4]) {
    const PlacedShape& other = face.other;
    const int facing = incident.axis;
    const scalar h_facing = component(other.shape.size, facing);
    const Vector u = column(other.A, axis_after[facing + 1]) * component(other.shape.size, axis_after[facing + 1]);
    const Vector v = column(other.A, axis_after[facing + 2]) * component(other.shape.size, axis_after[facing + 2]);
    const Vector c = face.centre + column(other.A, facing) * (incident.flipped() ? -h_facing : h_facing);
    const scalar c_x = dot(c, face.e_x), c_y = dot(c, face.e_y), c_z = dot(c, face.up) - component(face.box.shape.size, face.axis);
    const scalar u_x = dot(u, face.e_x), u_y = dot(u, face.e_y), u_z = dot(u, face.up);
    const scalar v_x = dot(v, face.e_x), v_y = dot(v, face.e_y), v_z = dot(v, face.up);
    for (int i = 0; i < 4; ++i) {
        const scalar p = i == 1 || i == 2 ? scalar(-1) : scalar(1), q = i >= 2 ? scalar(-1) : scalar(1);
        polygon.corner[i] = {
            {c_x + p * u_x + q * v_x, c_y + p * u_y + q * v_y, c_z + p * u_z + q * v_z}, static_cast<uint8_t>((i + 3) & 3), static_cast<uint8_t>(i)};
    }
    polygon.count = 4;
    const scalar spread_x = abs(u_x) + abs(v_x), spread_y = abs(u_y) + abs(v_y);
    reach[0] = c_x + spread_x, reach[1] = spread_x - c_x, reach[2] = c_y + spread_y, reach[3] = spread_y - c_y;
}

/// Cuts polygons[0] to the reference face, by those of its sides that it reaches over. What is left is one of the two.
INGOT_INLINE const Polygon& clip_to_face(const ReferenceFace& face, const scalar (&reach)[4], Polygon (&polygons)[2]) {
    Polygon* polygon = &polygons[0];
    const scalar limit_x = face.h_x * (1 + limits::corner_slack), limit_y = face.h_y * (1 + limits::corner_slack);
    const bool over[4] = {reach[0] > limit_x, reach[1] > limit_x, reach[2] > limit_y, reach[3] > limit_y};
    for (int side = 0; side < 4; ++side) {
        if (!over[side]) continue;
        Polygon* to = polygon == &polygons[0] ? &polygons[1] : &polygons[0];
        clip(*polygon, side >= 2, (side & 1) != 0 ? scalar(-1) : scalar(1), side >= 2 ? limit_y : limit_x,
             static_cast<uint8_t>(4 + side), *to);
        polygon = to;
    }
    return *polygon;
}

/// The points of a face against the other box, whose nearest face is clipped.
void face_points(const PlacedShape& A, const PlacedShape& B, const BestAxis& best, scalar margin, const Before& before,
                 Manifold& manifold) {
    const bool of_A = best.face < 3;
    const int axis = of_A ? best.face : best.face - 3;
    const PlacedShape &reference = of_A ? A : B, &other = of_A ? B : A;
    const Vector centre = other.r - reference.r;
    const scalar h_x = component(reference.shape.size, axis_after[axis + 1]), h_y = component(reference.shape.size, axis_after[axis + 2]);
    const Vector &e_x = column(reference.A, axis_after[axis + 1]), &e_y = column(reference.A, axis_after[axis + 2]);
    Vector up = column(reference.A, axis);
    const scalar above = dot(centre, up);
    const bool negative = of_A ? above > 0 ? false : true : above < 0;  // n is that axis or its opposite when all is level
    if (negative) up = -up;
    const ReferenceFace face{reference, other, axis, h_x, h_y, e_x, e_y, up, centre, of_A, negative};
    const IncidentFace incident = incident_face(face);
    if (abs(incident.along) < limits::facing_cos &&
        ridge_points(A, B, face.of_A ? -face.up : face.up, limits::ridge * best.smallest, margin, manifold))
        return;

    Polygon polygons[2];
    scalar reach[4];
    place_polygon(face, incident, polygons[0], reach);
    const Polygon& polygon = clip_to_face(face, reach, polygons);

    const uint32_t faces =
        feature_of(best.face, face.negative, (static_cast<uint32_t>(incident.axis) << 1 | (incident.flipped() ? 1u : 0u)) << 16);
    const scalar to_n = face.of_A ? scalar(-1) : scalar(1);  // n is this times `up`
    Candidate candidates[8];
    int count = 0;
    // bound: Patch::corners_max
    for (int i = 0; i < polygon.count; ++i) {
        const ClippedCorner& corner = polygon.corner[i];
        const scalar s = corner.at[2];
        if (!(s <= margin)) continue;
        candidates[count++] = {clamp(corner.at[0], face.h_x), clamp(corner.at[1], face.h_y), to_n * s * scalar(0.5), s,
                               faces | static_cast<uint32_t>(corner.in) << 4 | corner.out};
    }
    const ContactFrame frame{face.box.r + face.up * component(face.box.shape.size, face.axis), face.e_x, face.e_y, face.up * to_n};
    keep_points(candidates, count, frame, limits::flatness * best.smallest, before, manifold);
}

/// True where two edges cross all but across a face: the normal of their crossing is that of the face but for facing_cos.
INGOT_INLINE bool lies_flat(const PlacedShape& A, const PlacedShape& B, const BestAxis& best) {
    const Vector n = cross(column(A.A, (best.edge - first_edge_axis) / 3), column(B.A, (best.edge - first_edge_axis) % 3));
    const scalar along = dot(n, best.face < 3 ? column(A.A, best.face) : column(B.A, best.face - 3));
    return along * along > limits::facing_cos * limits::facing_cos * length_sq(n);
}

/// True where no point of a face is deeper than the edges allow. A point that is s deep in both boxes is at least s cos theta below the planes across
/// the normal of the edges, which is theta off that of the face: a deeper one has left a thin box at its other side, and is no overlap to be undone.
INGOT_INLINE bool inside_both(const PlacedShape& A, const PlacedShape& B, const BestAxis& best, const Manifold& manifold) {
    const Vector n = cross(column(A.A, (best.edge - first_edge_axis) / 3), column(B.A, (best.edge - first_edge_axis) % 3));
    const scalar cos = abs(dot(n, manifold.n)) / sqrt(length_sq(n)), least = best.separation - limits::edge_preference * best.smallest;
    // bound: 4: Manifold::points_max
    for (int i = 0; i < manifold.count; ++i)
        if (manifold.points[i].separation < 0 && manifold.points[i].separation * cos < least) return false;
    return true;
}

/// The point of two edges; false where the nearest points of their lines lie outside the edges.
bool edge_point(const PlacedShape& A, const PlacedShape& B, const BestAxis& best, scalar margin, Manifold& manifold) {
    const int i = (best.edge - first_edge_axis) / 3, j = (best.edge - first_edge_axis) % 3;
    const Vector &u = column(A.A, i), &v = column(B.A, j), d = A.r - B.r;
    Vector n = cross(u, v);
    const scalar sin_sq = length_sq(n);
    n = n * ((dot(n, d) < 0 ? scalar(-1) : scalar(1)) / sqrt(sin_sq));

    Vector p = d, q{};  // middles of the edges of A and B, seen from the centre of B
    uint32_t signs = 0;
    for (int k = 0; k < 3; ++k) {
        const Vector &A_k = column(A.A, k), &B_k = column(B.A, k);
        if (k != i) {
            const bool ahead = dot(n, A_k) > 0;
            p += A_k * (ahead ? -component(A.shape.size, k) : component(A.shape.size, k));
            signs |= ahead ? 1u << k : 0u;
        }
        if (k != j) {
            const bool ahead = dot(n, B_k) > 0;
            q += B_k * (ahead ? component(B.shape.size, k) : -component(B.shape.size, k));
            signs |= ahead ? 8u << k : 0u;
        }
    }
    const Vector w = p - q;
    const scalar c = dot(u, v), along_u = dot(w, u), along_v = dot(w, v);
    const scalar on_u = (c * along_v - along_u) / sin_sq, on_v = (along_v - c * along_u) / sin_sq;
    const scalar slack = 1 + limits::corner_slack;
    if (!(abs(on_u) <= component(A.shape.size, i) * slack && abs(on_v) <= component(B.shape.size, j) * slack)) return false;
    const scalar s = dot(n, w);
    if (s <= margin)
        one_point(n, B.r + (p + u * on_u + q + v * on_v) * scalar(0.5), s, feature_of(best.edge, false, signs), manifold);
    else
        no_points(n, manifold);
    return true;
}

}  // namespace

void collide_box_box(const PlacedShape& A, const PlacedShape& B, const Margin& margin, Manifold& manifold, const Manifold* before_it) {
    const Before before = remember(before_it);
    if (before_it != nullptr && before.count == 0 && gap_of_boxes(A, B, before.n) > margin) return no_points(before.n, manifold);

    BestAxis best;
    const int axis_before = before.count > 0 ? static_cast<int>(before.features[0] >> 24) : no_axis;
    if (!find_axis(A, B, margin, axis_before, best, manifold)) return;
    // Where two edges cross they have one point. Boxes that lie all but flat on each other, or meet fast, may turn about it onto other corners within
    // the step: those of the face have the crossing among them, and look further. The normal is the face's then.
    if (best.edge != no_axis && (margin.most > margin.fast || lies_flat(A, B, best))) {
        face_points(A, B, best, margin, before, manifold);
        if (manifold.count > 1 && inside_both(A, B, best, manifold)) return;
    }
    if (best.edge != no_axis && edge_point(A, B, best, margin, manifold)) return;
    face_points(A, B, best, margin, before, manifold);
}

} }  // namespace ingot

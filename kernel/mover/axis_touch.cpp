// SPDX-License-Identifier: MIT
#include "axis_touch.h"

#include "../narrow_phase/plane_between.h"

namespace ingot { inline namespace INGOT_ABI {

PlacedShape placed_mover(const Mover& mover) {
    // Two directions across `up`, by the one of its components that is least.
    const Vector &z = mover.up, size = {abs(z.x), abs(z.y), abs(z.z)};
    const Vector away = size.x <= size.y && size.x <= size.z ? Vector{1, 0, 0} : size.y <= size.z ? Vector{0, 1, 0} : Vector{0, 0, 1};
    const Vector across = cross(away, z), x = across * (1 / sqrt(length_sq(across)));
    return {mover.capsule, mover.r, {x, cross(z, x), z}, nullptr};
}

AxisTouch touch_of_shape(const PlacedShape& capsule, const PlacedShape& other, scalar reach) {
    const scalar radius = capsule.shape.size.x;
    PlacedShape axis = capsule;
    axis.shape.size.x = 0;
    if (other.shape.kind == ShapeKind::half_space) {
        const Vector n = other.A * other.shape.size, lowest = support_point(axis, -n);
        const scalar height = face_below(other, lowest).height;
        return {height - radius <= reach, false, true, n, lowest - n * height, height - radius};
    }
    PlacedShape B = other;  // all is seen from it: what is far from the origin loses nothing more
    B.r = {};
    axis.r = capsule.r - other.r;
    const Nearest nearest = closest_points(axis, B, reach + radius);
    if (nearest.overlap) {
        const scalar far = sqrt(length_sq(axis.r));
        const PlaneBetween out = plane_along(axis, B, far > 0 ? axis.r * (1 / far) : capsule.A.c2);
        return {true, true, false, out.n, other.r + (support_point(axis, -out.n) - out.n * out.gap), out.gap - radius};
    }
    const PlaneBetween plane = plane_between(axis, B, nearest);
    return {plane.gap - radius <= reach, false, false, plane.n, other.r + nearest.P_B, plane.gap - radius};
}

bool passes_box(const PlacedShape& capsule, const Vector& way, const PlacedShape& box, scalar reach) {
    const Vector from = capsule.r - box.r, u = transpose_times(box.A, capsule.A.c2) * capsule.shape.size.y, &h = box.shape.size;
    const Vector begin = transpose_times(box.A, from), end = begin + transpose_times(box.A, way);
    // The roundings of the places, and of a rotation: more than there are.
    const scalar size = abs(from.x) + abs(from.y) + abs(from.z) + abs(way.x) + abs(way.y) + abs(way.z);
    const scalar far = (capsule.shape.size.x + reach) * (1 + limits::flatness) + 16 * epsilon * size;
    const auto passes = [far](scalar a, scalar b, scalar u_i, scalar h_i) {
        const scalar extent = h_i * (1 + limits::flatness) + abs(u_i) + far;
        return min(a, b) > extent || max(a, b) < -extent;
    };
    return passes(begin.x, end.x, u.x, h.x) || passes(begin.y, end.y, u.y, h.y) || passes(begin.z, end.z, u.z, h.z);
}

namespace {

/// A point of the axis and one of a triangle.
struct AxisNearest {
    scalar distance_sq;
    Vector on_axis, p;
    bool inside;  ///< of the triangle
};

/// Where the axis from a, along the unit vector u, is nearest to an edge.
/// Source: Ericson, "Real-Time Collision Detection", 2005, 5.1.9.
AxisNearest nearest_to_edge(const Vector& a, const Vector& u, scalar length, const TriangleFace& face, int i) {
    const Vector &e = face.corners[i], &v = face.along[i], w = a - e;
    const scalar edge = dot(v, face.corners[i == 2 ? 0 : i + 1] - e);
    const scalar b = dot(u, v), c = dot(u, w), f = dot(v, w), sine_sq = 1 - b * b;
    const auto within = [](scalar t, scalar most) { return t < 0 ? scalar(0) : t > most ? most : t; };
    scalar s = sine_sq > limits::parallel_sin_sq ? within((b * f - c) / sine_sq, length) : length / 2;
    const scalar t = within(b * s + f, edge);
    s = within(b * t - c, length);
    const Vector on_axis = a + u * s, p = e + v * within(b * s + f, edge);
    return {length_sq(on_axis - p), on_axis, p, false};
}
AxisNearest nearest_to_end(const Vector& end, const TriangleFace& face) {
    const TriangleTouch on = nearest_on_triangle(face, end, 0);
    return {length_sq(end - on.p), end, on.p, on.part == TrianglePart::inside};
}
bool is_over(const TriangleFace& face, const Vector& x) {
    bool over = true;
    for (int i = 0; i < 3; ++i) over = over && dot(face.inward[i], x - face.corners[i]) >= 0;
    return over;
}

}  // namespace

AxisTouch touch_of_triangle(const PlacedShape& capsule, const TriangleFace& face) {
    constexpr AxisTouch none = {false, false, false, {}, {}, 0};
    const scalar radius = capsule.shape.size.x, half = capsule.shape.size.y;
    const Vector &u = capsule.A.c2, a = capsule.r - u * half, b = capsule.r + u * half;
    const scalar at_a = dot(face.n, a - face.corners[0]), at_b = dot(face.n, b - face.corners[0]);
    const scalar low = min(at_a, at_b), high = max(at_a, at_b);
    if (!(high > 0)) return none;  // behind it
    if (!(low > 0)) {
        const Vector x = a + (b - a) * (at_a / (at_a - at_b));
        if (is_over(face, x)) return {true, true, true, face.n, x, low - radius};  // the axis goes through it
    }
    AxisNearest nearest = nearest_to_end(a, face);
    const auto take = [&nearest](const AxisNearest& other) {
        const bool as_near = other.distance_sq <= nearest.distance_sq * (1 + 4 * epsilon);
        if (other.distance_sq < nearest.distance_sq * (1 - 4 * epsilon) || (as_near && other.inside && !nearest.inside)) nearest = other;
    };
    take(nearest_to_end(b, face));
    for (int i = 0; i < 3; ++i) take(nearest_to_edge(a, u, 2 * half, face, i));
    const Vector away = nearest.on_axis - nearest.p;
    const scalar distance = sqrt(nearest.distance_sq), rise = dot(away, face.n);
    if (nearest.inside && rise > 0) return {true, false, true, face.n, nearest.p, rise - radius};
    if (!(distance > epsilon * radius)) return {true, true, true, face.n, nearest.p, low - radius};  // through an edge of it
    if (rise < -limits::edge_tilt * distance) return none;
    const Vector n = away * (1 / distance);
    const bool along = length_sq(n - face.n * dot(n, face.n)) <= limits::edge_tilt * limits::edge_tilt;
    return {true, false, along, n, nearest.p, distance - radius};
}

void put_on_shape(const PlacedShape& S, const PlacedShape& capsule, scalar flush, MoverTouch& touch) {
    Touch on = {touch.P, touch.n, limits::edge_tilt, touch.face, {}};
    Vector inside = touch.P;
    if (S.shape.kind == ShapeKind::half_space) inside = capsule.r;
    if (S.shape.kind == ShapeKind::box) {
        put_on_box(S, on);
        inside = S.r + S.A * clamp(transpose_times(S.A, capsule.r - S.r), S.shape.size);
        const Vector to_middle = S.r - on.p;  // where the capsule is all beside the face
        if (length_sq(inside - on.p) <= flush * flush) inside = on.p + to_middle;
    }
    if (S.shape.kind == ShapeKind::hull) {
        put_on_hull(S, on);
        inside = S.r + S.A * S.hull->centre;
    }
    touch.P = on.p;
    touch.face = on.face;
    Vector inwards = inside - on.p;
    inwards = inwards - touch.n * dot(touch.n, inwards);
    const scalar way = sqrt(length_sq(inwards)), most = 4 * flush;
    touch.inner = on.p + inwards * (way > most ? most / way : scalar(1));
}

namespace {

/// Which of two touches counts more: the nearer, and of those as near the one whose direction comes first, so that it is no matter who was found
/// first.
bool counts_more(const MoverTouch& a, const MoverTouch& b) {
    if (a.gap != b.gap) return a.gap < b.gap;
    if (a.n.x != b.n.x) return a.n.x < b.n.x;
    if (a.n.y != b.n.y) return a.n.y < b.n.y;
    if (a.n.z != b.n.z) return a.n.z < b.n.z;
    if (a.P.x != b.P.x) return a.P.x < b.P.x;
    if (a.P.y != b.P.y) return a.P.y < b.P.y;
    return a.P.z < b.P.z;
}

}  // namespace

void MoverTouches::add(const MoverTouch& touch) {
    if (count == movers::touches_max) {
        if (!counts_more(touch, touches[count - 1])) return;
        --count;
    }
    int place = count++;
    for (; place > 0 && counts_more(touch, touches[place - 1]); --place) touches[place] = touches[place - 1];  // bound: movers::touches_max
    touches[place] = touch;
}

void MoverTouches::merge(const Vector& up) {
    int kept = 0;
    for (int i = 0; i < count; ++i) {  // bound: movers::touches_max
        bool said = false;
        for (int k = 0; k < kept && !said; ++k) {  // bound: movers::planes_max
            if (!(dot(touches[i].n, touches[k].n) >= movers::merge_cos)) continue;
            said = true;
            if (dot(touches[i].upright, up) > dot(touches[k].upright, up)) touches[k].upright = touches[i].upright;
        }
        if (!said && kept < movers::planes_max) touches[kept++] = touches[i];
    }
    count = kept;
}

bool hidden_by_shape(const PlacedShape& T, const Vector& p, const Vector& d, scalar flush) {
    const Touch touch = {p, d, limits::edge_tilt, false, {}};
    if (T.shape.kind == ShapeKind::box) return hidden_by_box(T, touch, p, flush);
    if (T.shape.kind == ShapeKind::hull) return hidden_by_hull(T, touch, p, flush);
    return T.shape.kind == ShapeKind::half_space && hidden_by_half_space(T, touch, p, flush);
}

bool hidden_by_level_at(const PlacedShape& T, const LevelTable& table, const Vector& p, const Vector& d, scalar flush) {
    const LevelFrame frame(T, table);
    return hidden_by_level(table, frame.seen_point(p), frame.seen_direction(d), limits::edge_tilt, flush);
}

namespace {

/// The way out of a level for a capsule whose axis is in it: there is one. Each triangle would push its own way, with the others in that.
class WayOut {
public:
    WayOut(const PlacedShape& capsule, bool is_mesh, scalar flush)
        : a_(capsule.r - capsule.A.c2 * capsule.shape.size.y), b_(capsule.r + capsule.A.c2 * capsule.shape.size.y), radius_(capsule.shape.size.x),
          flush_(flush), is_mesh_(is_mesh) {}

    /// Of a triangle that the axis goes through.
    void see_crossed(const AxisTouch& touch) { consider(touch, 0); }
    /// Of a triangle that the axis is before.
    void see_before(scalar distance) { before_ = some_before_ ? min(before_, distance) : distance, some_before_ = true; }
    /// Of a triangle that an end of the axis is behind: out by where it is nearest, so that below a valley there is a way, too.
    void see_behind(const TriangleFace& face) {
        const scalar at_a = dot(face.n, a_ - face.corners[0]), at_b = dot(face.n, b_ - face.corners[0]);
        a_is_below_ = a_is_below_ || (!(at_a > 0) && is_below(face, a_));
        b_is_below_ = b_is_below_ || (!(at_b > 0) && is_below(face, b_));
        if (is_mesh_ && (at_a > 0 || at_b > 0)) return;
        if (!(at_a > 0)) see_end_behind(face, a_);
        if (!(at_b > 0)) see_end_behind(face, b_);
    }

    /// A field is solid, at any depth: in it is what has ground above both ends. A mesh has an inside as deep as the radius, behind what is nearest.
    bool is_in() const {
        if (!best_.there || behind_ == 0) return best_.there;
        return is_mesh_ ? !some_before_ || behind_ < before_ : a_is_below_ && b_is_below_;
    }
    const AxisTouch& touch() const { return best_; }

private:
    void see_end_behind(const TriangleFace& face, const Vector& end) {
        const TriangleTouch on = nearest_on_triangle(face, end, 0);
        const Vector away = on.p - end;
        const scalar distance = sqrt(length_sq(away));
        if (is_mesh_ && !(distance < radius_)) return;
        const Vector n = on.part != TrianglePart::inside && distance > epsilon * radius_ ? away * (1 / distance) : face.n;
        const scalar low = min(dot(n, a_ - on.p), dot(n, b_ - on.p));
        consider({true, true, false, n, on.p, low - radius_}, distance);
    }
    /// The nearest; of those that the axis goes through, the one that it is out of by the least.
    void consider(const AxisTouch& touch, scalar behind) {
        if (best_.there && (behind > behind_ || (behind == behind_ && !comes_first(touch)))) return;
        best_ = touch;
        behind_ = behind;
    }
    bool comes_first(const AxisTouch& touch) const {
        const Vector &n = touch.n, &m = best_.n;
        if (touch.gap != best_.gap) return touch.gap > best_.gap;
        return n.x != m.x ? n.x < m.x : n.y != m.y ? n.y < m.y : n.z < m.z;
    }
    bool is_below(const TriangleFace& face, const Vector& p) const {
        bool is = true;
        for (int i = 0; i < 3; ++i) {
            const Vector q = p - face.corners[i];
            is = is && face.along[i].x * q.y - face.along[i].y * q.x >= -flush_;
        }
        return is;
    }

    const Vector a_, b_;
    const scalar radius_, flush_;
    const bool is_mesh_;
    AxisTouch best_ = {};
    scalar behind_ = 0, before_ = 0;  ///< m, from the axis to what is nearest
    bool some_before_ = false, a_is_below_ = false, b_is_below_ = false;
};

}  // namespace

void add_touches_of_level(const PlacedShape& capsule, const PlacedShape& level, const LevelTable& table, const MoverReach& asked, int slot,
                          MoverTouches& touches) {
    const LevelFrame frame(level, table);
    const PlacedShape seen = frame.seen(capsule);
    const Vector more = {asked.reach, asked.reach, asked.reach};
    const LevelReach reach = reach_in_level(seen);
    WayOut out(seen, table.is_mesh(), asked.flush);
    const auto add = [&](const AxisTouch& found, const Vector& inner) {
        touches.add({level.A * found.n, frame.place(found.P), frame.place(inner), level.A * found.n, found.gap - asked.skin, slot, found.face});
    };
    for_triangles_in(table, seen.r - reach.below - more, seen.r + reach.above + more, [&](const LevelTriangle& triangle) {
        TriangleFace face;
        if (!face_of_triangle(triangle, face)) return;
        out.see_behind(face);
        const AxisTouch found = touch_of_triangle(seen, face);
        if (!found.there || !(found.gap <= asked.reach)) return;
        if (found.crosses) return out.see_crossed(found);
        out.see_before(found.gap + seen.shape.size.x);
        Vector inwards = (face.corners[0] + face.corners[1] + face.corners[2]) * (scalar(1) / 3) - found.P;
        const scalar way = sqrt(length_sq(inwards)), most = 4 * asked.flush;
        if (way > most) inwards = inwards * (most / way);
        const Vector inner = found.face ? found.P + inwards : found.P;
        const auto hidden = [&](const Vector& p) { return hidden_by_level(table, p, found.n, limits::edge_tilt, asked.flush); };
        if (hidden(found.P) && (!found.face || hidden(inner))) return;
        add(found, inner);
    });
    if (out.is_in()) add(out.touch(), out.touch().P);
}

ShapeEntry cast_axis_on_level(const PlacedShape& capsule, const Vector& way, scalar fraction_max, const AxisCast& cast, const PlacedShape& level,
                              const LevelTable& table) {
    const LevelFrame frame(level, table);
    const PlacedShape seen = frame.seen(capsule);
    const Vector seen_way = frame.seen_direction(way), reached = seen_way * fraction_max, none = {}, more = Vector{1, 1, 1} * (cast.stop + cast.near);
    const LevelReach reach = reach_in_level(seen);
    const Vector low = seen.r - reach.below + min(reached, none) - more;
    const Vector high = seen.r + reach.above + max(reached, none) + more;
    ShapeEntry first = {false, 1, {}, {}};
    for_triangles_in(table, low, high, [&](const LevelTriangle& triangle) {
        TriangleFace face;
        if (!face_of_triangle(triangle, face)) return;
        const ShapeEntry entry = cast_axis(seen, seen_way, first.meets ? first.fraction : fraction_max, cast, [&](const PlacedShape& now) {
            const AxisTouch touch = touch_of_triangle(now, face);
            const bool from_begin = cast.flush > 0 && touch.there && !touch.crosses && touch.gap <= cast.stop + cast.near;
            if (!from_begin || length_sq(now.r - seen.r) > 0) return touch;
            return hidden_by_level(table, touch.P, touch.n, limits::edge_tilt, cast.flush) ? AxisTouch{} : touch;
        });
        if (entry.meets && (!first.meets || entry.fraction < first.fraction)) first = entry;
    });
    if (!first.meets) return first;
    return {true, first.fraction, frame.place(first.P), level.A * first.n};
}

} }  // namespace ingot

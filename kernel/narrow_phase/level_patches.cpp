// SPDX-License-Identifier: MIT
#include "level_patches.h"

namespace ingot { inline namespace INGOT_ABI {

/// False for what is further above than the margin, and for what is behind. A field is solid, at any depth.
bool LevelPatches::reaches(const TriangleFace& face) const {
    if (!(dot(face.n, support_point(on_.body, -face.n) - face.corners[0]) <= on_.margin)) return false;
    if (is_solid() || dot(face.n, on_.body.r - face.corners[0]) >= 0) return true;
    return dot(face.n, support_point(on_.body, face.n) - face.corners[0]) >= 0;
}

/// The plane of the last triangle, but for roundings.
bool LevelPatches::is_in_plane(const TriangleFace& face) const {
    const Vector turned = face.n - plane_.shape.size, away = face.corners[0] - plane_.r;
    const scalar grain = 2 * epsilon, size = abs(away.x) + abs(away.y) + abs(away.z);
    if (abs(turned.x) > grain || abs(turned.y) > grain || abs(turned.z) > grain) return false;
    return abs(dot(face.n, away)) <= grain * size;
}

/// What is no deeper than its least half extent may be pushed out through a face; deeper, it stands beside it, or behind a sheet. A field is solid:
/// whose centre is in the ground, or beside it at a rim, is pushed out from any depth; but not who has the back of a spike beside it and ground
/// below.
bool LevelPatches::is_above(const TriangleFace& face) const {
    const scalar height = dot(face.n, on_.body.r - face.corners[0]);
    if (is_solid()) return height > -on_.half_extent || !is_in_the_air();
    return height > -on_.half_extent && (height >= 0 || !has_back(level_, face));
}

/// A place on the body so deep below a face that the centre of the body is behind, too: it is in the ground together with the centre, or else on the
/// far side of a spike, which is not to be pushed out through this side.
bool LevelPatches::is_behind(const TriangleFace& face, scalar separation) const {
    return separation < -on_.half_extent && dot(face.n, on_.body.r - face.corners[0]) < 0 && is_in_the_air();
}

/// The centre of the body is before what of a mesh is nearest to it; of a field, above the ground.
bool LevelPatches::is_in_the_air() const {
    return is_solid() ? is_above_field() : is_before_mesh();
}

/// Of triangles that are equally near, by an edge that they share, the one counts that looks most to the centre or away from it.
/// Source: Baerentzen and Aanaes, "Signed Distance Computation Using the Angle Weighted Pseudonormal", 2005: why not any of them.
bool LevelPatches::is_before_mesh() const {
    const Vector& r = on_.body.r;
    const Vector reach = {on_.half_extent, on_.half_extent, on_.half_extent};
    scalar least = on_.half_extent, most = 0;
    bool is = true;
    for_triangles_in(level_, r - reach, r + reach, [&](const LevelTriangle& triangle) {
        TriangleFace face;
        if (!face_of_triangle(triangle, face)) return;
        const Vector away = r - nearest_on_triangle(face, r, 0).p;
        const scalar distance = sqrt(length_sq(away)), height = dot(face.n, away), turned = abs(height);
        if (distance > least + on_.flush || (distance > least - on_.flush && !(turned > most))) return;
        least = min(least, distance);
        most = turned;
        is = height >= 0;
    });
    return is;
}

/// A triangle of the field is straight below the centre of the body. Within `flush` of its edges it counts: none is missed by a rounding.
bool LevelPatches::is_above_field() const {
    const Vector& r = on_.body.r;
    bool is = false;
    for_triangles_in(level_, {r.x, r.y, level_.low.z}, r, [&](const LevelTriangle& triangle) {
        TriangleFace face;
        if (is || !face_of_triangle(triangle, face) || !(dot(face.n, r - face.corners[0]) >= 0)) return;
        is = true;
        for (int i = 0; i < 3; ++i) {
            const Vector q = r - face.corners[i];
            is = is && face.along[i].x * q.y - face.along[i].y * q.x >= -on_.flush;
        }
    });
    return is;
}

namespace {

/// What is round, on its side: it touches along a line, and of it a direction says where.
bool lies(const PlacedShape& body, const Vector& n) {
    const bool is_round = body.shape.kind == ShapeKind::capsule || body.shape.kind == ShapeKind::cylinder;
    return is_round && abs(dot(body.A.c2, n)) < scalar(0.5);
}

/// False for a point that a direction, searched for, puts beside the line below the axis along which it would touch: nothing is there.
bool is_below_line(const PlacedShape& round, const Vector& P, const Vector& d) {
    const Vector aside = cross(round.A.c2, d);
    const scalar off = dot(P - round.r, aside), slack = 2 * limits::nearest_direction * round.shape.size.x;
    return off * off <= slack * slack;
}

}  // namespace

/// Its lowest point is above the inside of the face, or hardly in it: then nothing is nearer than the face.
bool LevelPatches::stands_inside(const TriangleFace& face, const Manifold& above) const {
    int lowest = 0;
    for (int i = 1; i < above.count; ++i)  // bound: 4: Manifold::points_max
        if (above.points[i].separation < above.points[lowest].separation) lowest = i;
    return above.count > 0 && above.points[lowest].separation > -on_.flush &&
           is_over(face, above.points[lowest].P, 0);
}

/// What is round and lies on its side touches along a line: of it what is above the face. True where there is some, and hardly in it.
bool LevelPatches::lies_across(const LevelTriangle& triangle, const TriangleFace& face, const Manifold& above) {
    if (!lies(on_.body, face.n) || above.count != 2) return false;
    const Vector a = above.points[0].P + face.n * (above.points[0].separation / 2);
    const Vector way = above.points[1].P + face.n * (above.points[1].separation / 2) - a;
    scalar low = 0, high = 1;
    for (int i = 0; i < 3; ++i) {
        const scalar inside = dot(face.inward[i], a - face.corners[i]), by = dot(face.inward[i], way);
        if (inside < 0 && inside + by < 0) return false;
        if (inside < 0) low = max(low, -inside / by);
        if (inside + by < 0) high = min(high, -inside / by);
    }
    if (low > high) return false;
    add_above(triangle, face, a + way * low);
    add_above(triangle, face, a + way * high);
    return min(above.points[0].separation, above.points[1].separation) > -on_.flush;
}

namespace {

/// Where a stretch of a line, about r along the unit vector u, half as long as h, is nearest to that from a, of `length` along the unit vector v: s
/// and t along them.
/// Source: Ericson, "Real-Time Collision Detection", 2005, 5.1.9.
struct NearestOnLines {
    scalar s, t;
};
NearestOnLines nearest_on_lines(const Vector& r, const Vector& u, scalar h, const Vector& a, const Vector& v, scalar length) {
    const Vector w = r - a;
    const scalar b = dot(u, v), c = dot(u, w), f = dot(v, w), sine_sq = 1 - b * b;
    const auto within = [length](scalar t) { return t < 0 ? scalar(0) : t > length ? length : t; };
    scalar s = sine_sq > limits::parallel_sin_sq ? clamp((b * f - c) / sine_sq, h) : scalar(0);
    const scalar t = within(b * s + f);
    s = clamp(b * t - c, h);
    return {s, within(b * s + f)};
}

}  // namespace

/// What is round against ridges and rims, from its axis: as for a ball, and as exact. True where it touches one of them. of_side: all are nearest to
/// its side, and none to a flat end of a cylinder, of which this knows nothing.
bool LevelPatches::add_round(const LevelTriangle& triangle, const TriangleFace& face, bool& of_side) {
    const PlacedShape& body = on_.body;
    const bool capsule = body.shape.kind == ShapeKind::capsule;
    if (!capsule && body.shape.kind != ShapeKind::cylinder) return false;
    const scalar radius = body.shape.size.x, h = body.shape.size.y;
    bool some = false;
    of_side = true;
    for (int i = 0; i < 3; ++i) {
        if (!ends(triangle, i)) continue;
        const Vector& a = face.corners[i];
        const scalar length = dot(face.along[i], face.corners[i == 2 ? 0 : i + 1] - a);
        const NearestOnLines near = nearest_on_lines(body.r, body.A.c2, h, a, face.along[i], length);
        const bool on_side = capsule || abs(near.s) < h - on_.flush;
        of_side = of_side && on_side;
        const Vector on_edge = a + face.along[i] * near.t, away = body.r + body.A.c2 * near.s - on_edge;
        const scalar distance = sqrt(length_sq(away)), separation = distance - radius;
        if (!on_side || !(separation <= on_.margin && separation > -on_.half_extent)) continue;
        const Vector d = away * (1 / distance);
        const TriangleTouch touch = nearest_on_triangle(face, on_edge, 0);
        if (dot(d, face.n) < -limits::edge_tilt || !is_open(triangle, touch, d, limits::edge_tilt)) continue;
        add_point(d, on_edge + d * (separation / 2), separation);
        some = true;
    }
    return some;
}

/// A ridge or a rim passes below the body, which may touch the triangle beside its face. Where ground goes on flat, or rises, corners of the body say
/// all there is to say.
bool LevelPatches::ends_below(const LevelTriangle& triangle, const TriangleFace& face) const {
    for (int i = 0; i < 3; ++i) {
        if (!ends(triangle, i)) continue;
        const Vector furthest = support_point(on_.body, -face.inward[i]);
        if (dot(face.inward[i], furthest - face.corners[i]) <= on_.margin) return true;
    }
    return false;
}

/// Flat seams and valleys have no directions of their own; of ridges, rims and corners the neighbours are asked.
bool LevelPatches::is_open(const LevelTriangle& triangle, const TriangleTouch& touch, const Vector& d, scalar tilt) const {
    if (touch.part == TrianglePart::edge) {
        const EdgeKind kind = triangle.edge(touch.i);
        if (kind == EdgeKind::flat || kind == EdgeKind::concave) return false;
    }
    return !hidden_by_level(level_, touch.p, d, tilt, on_.flush);
}

/// A point inside a face is real; near a rim, which may lie along other triangles, these are asked of it and of a place a little further inside: a
/// face that ends at the foot of a wall is open beside the wall. So they are where it is overlapped: what has sunk into a floor of boxes reaches
/// walls between them.
bool LevelPatches::is_bare(const LevelTriangle& triangle, const TriangleFace& face, const Vector& p, scalar separation) const {
    bool near_rim = separation < -on_.flush;
    for (int i = 0; i < 3; ++i)
        near_rim = near_rim || (ends(triangle, i) && dot(face.inward[i], p - face.corners[i]) <= on_.flush);
    const Sheets sheets = separation > on_.half_extent / -4 ? Sheets::hide_nothing : Sheets::hide;
    if (!near_rim || !hidden_by_level(level_, p, face.n, limits::face_tilt, on_.flush, sheets)) return true;
    const Vector inwards = nearest_on_triangle(face, on_.body.r, 0).p - p;
    const scalar way = sqrt(length_sq(inwards)), most = 4 * on_.flush;
    const Vector inner = p + inwards * (way > most ? most / way : scalar(1));
    return !hidden_by_level(level_, inner, face.n, limits::face_tilt, on_.flush, sheets);
}

/// A place on the body, above a triangle or in it.
void LevelPatches::add_above(const LevelTriangle& triangle, const TriangleFace& face, const Vector& on_body) {
    const scalar separation = dot(face.n, on_body - face.corners[0]);
    const Vector on_level = on_body - face.n * separation;
    if (!(separation <= on_.margin) || is_behind(face, separation) || !is_bare(triangle, face, on_level, separation)) return;
    add_point(face.n, on_level + face.n * (separation / 2), separation);
}

void LevelPatches::add_ball(const LevelTriangle& triangle, const TriangleFace& face) {
    const Vector& c = on_.body.r;
    const scalar radius = on_.body.shape.size.x, height = dot(face.n, c - face.corners[0]);
    if (!(height <= on_.margin + radius && is_above(face))) return;
    const TriangleTouch touch = nearest_on_triangle(face, c, on_.flush);
    if (touch.part == TrianglePart::inside) {
        const scalar separation = height - radius;
        if (!is_behind(face, separation) && is_bare(triangle, face, touch.p, separation))
            add_point(face.n, touch.p + face.n * (separation / 2), separation);
        return;
    }
    const Vector away = c - touch.p;
    const scalar distance = sqrt(length_sq(away)), separation = distance - radius;
    if (!(separation <= on_.margin && height > 0)) return;
    const Vector d = away * (1 / distance);
    if (is_open(triangle, touch, d, limits::edge_tilt)) add_point(d, touch.p + d * (separation / 2), separation);
}

/// What a body touches of a triangle that ends: over its face up to its edges, or beside it, where no neighbour hides that. False where the plane of
/// the face says the rest.
bool LevelPatches::add_beside(const LevelTriangle& triangle, const TriangleFace& face, const Manifold& found, bool stands) {
    if (found.count == 0) return !stands;
    const Vector& d = found.n;
    const scalar rise = dot(d, face.n);
    if (rise > 0 && length_sq(d - face.n * rise) <= limits::face_tilt * limits::face_tilt) {
        for (int i = 0; i < found.count && !lies(on_.body, face.n); ++i) {  // bound: 4: Manifold::points_max
            const ManifoldPoint& point = found.points[i];
            if (is_over(face, point.P, on_.flush))
                add_above(triangle, face, point.P + d * (point.separation / 2));
        }
        return false;
    }
    if (stands) return false;
    if (lies(on_.body, d) && !is_below_line(on_.body, found.points[0].P, d)) return true;
    bool some = false;
    for (int i = 0; i < found.count && rise >= -limits::edge_tilt; ++i) {  // bound: 4: Manifold::points_max
        const ManifoldPoint& point = found.points[i];
        const TriangleTouch touch = put_on_triangle(face, point.P - d * (point.separation / 2), d, limits::edge_tilt);
        if (!is_open(triangle, touch, d, limits::edge_tilt)) continue;
        add_point(d, point.P, point.separation);
        some = true;
    }
    return some || least_separation(found) > -on_.flush;  // what is apart is nearest along d, and along nothing else
}

/// Of points above the plane of a triangle, those above the triangle.
void LevelPatches::add_inside(const LevelTriangle& triangle, const TriangleFace& face, const Manifold& found) {
    for (int i = 0; i < found.count; ++i) {  // bound: 4: Manifold::points_max
        const ManifoldPoint& point = found.points[i];
        if (is_over(face, point.P, on_.flush))
            add_above(triangle, face, point.P + face.n * (point.separation / 2));
    }
}

/// The patch whose plane it is in, and whose material it has; a new one; or, where there is no room, the shallowest in exchange. Null: it is
/// shallower than all.
LevelPatch* LevelPatches::patch_for(const Vector& n, const Vector& surface, scalar separation) {
    for (int i = 0; i < count_; ++i) {  // bound: level_patches
        const ContactFrame& frame = patches_[i].frame;
        if (level_.material_count > 0 && patches_[i].material != material_) continue;
        const Vector aside = n - frame.n * dot(n, frame.n);
        const bool turned = !(dot(n, frame.n) > 0) || length_sq(aside) > limits::face_tilt * limits::face_tilt;
        if (!turned && abs(dot(frame.n, surface - frame.origin)) <= on_.flush) return patches_ + i;
    }
    int place = count_;
    if (count_ == level_patches) {
        place = 0;
        for (int i = 1; i < count_; ++i)  // bound: level_patches
            if (patches_[i].least > patches_[place].least) place = i;
        if (!(separation < patches_[place].least)) return nullptr;
    } else {
        ++count_;
    }
    patches_[place].frame = frame_about(n, surface);
    patches_[place].count = 0;
    patches_[place].material = material_;
    patches_[place].least = separation;
    return patches_ + place;
}

namespace {

/// On the way from a to b, no further aside of it than `aside`, m, and no deeper than they say that it is there, but for `deeper`.
bool is_between(const Candidate& point, const Candidate& a, const Candidate& b, scalar aside, scalar deeper) {
    const scalar x = b.x - a.x, y = b.y - a.y, p_x = point.x - a.x, p_y = point.y - a.y;
    const scalar size_sq = x * x + y * y, along = p_x * x + p_y * y, across = x * p_y - y * p_x;
    if (!(along > 0 && along < size_sq && across * across <= aside * aside * size_sq)) return false;
    return point.separation >= a.separation + (b.separation - a.separation) * (along / size_sq) - deeper;
}

/// Of several points in one part of the body the one that is furthest out keeps the name: it is the one that stays.
void name_apart(Candidate* points, int count, const ContactFrame& frame, const Vector& centre) {
    const Vector c = centre - frame.origin;
    const scalar x = dot(c, frame.e_x), y = dot(c, frame.e_y);
    scalar out[LevelPatch::room];
    uint32_t again[LevelPatch::room];
    for (int i = 0; i < count; ++i)  // bound: LevelPatch::room
        out[i] = (points[i].x - x) * (points[i].x - x) + (points[i].y - y) * (points[i].y - y);
    for (int i = 0; i < count; ++i) {
        again[i] = 0;
        for (int k = 0; k < count; ++k)  // bound: LevelPatch::room
            if (points[k].feature == points[i].feature && (out[k] > out[i] || (out[k] == out[i] && k < i))) again[i] += 8;
    }
    for (int i = 0; i < count; ++i) points[i].feature += again[i];
}

/// Points between two others carry nothing that these cannot: a line that crosses many triangles has two points. Returns how many are left.
int drop_between(Candidate* points, int count, scalar aside, scalar deeper) {
    for (int i = 0; i < count;) {  // bound: LevelPatch::room: each turn goes on, or there is one less
        bool between = false;
        for (int a = 0; a < count; ++a)  // bound: LevelPatch::room
            for (int b = a + 1; b < count && !between; ++b) between = a != i && b != i && is_between(points[i], points[a], points[b], aside, deeper);
        if (between)
            points[i] = points[--count];
        else
            ++i;
    }
    return count;
}

/// A patch is full: points within its outline make way, the innermost first, and the deepest never.
void make_room(scalar aside, scalar deeper, const Vector& centre, LevelPatch& patch) {
    patch.count = drop_between(patch.points, patch.count, aside, deeper);
    const Vector c = centre - patch.frame.origin;
    const scalar x = dot(c, patch.frame.e_x), y = dot(c, patch.frame.e_y);
    // bound: LevelPatch::room
    while (patch.count > LevelPatch::room * 3 / 4) {
        int deepest = 0;
        for (int i = 1; i < patch.count; ++i)  // bound: LevelPatch::room
            if (patch.points[i].separation < patch.points[deepest].separation) deepest = i;
        int innermost = deepest == 0 ? 1 : 0;
        scalar least = scalar_max;
        for (int i = 0; i < patch.count; ++i) {  // bound: LevelPatch::room
            const Candidate& point = patch.points[i];
            const scalar out = (point.x - x) * (point.x - x) + (point.y - y) * (point.y - y);
            if (i == deepest || !(out < least)) continue;
            innermost = i;
            least = out;
        }
        patch.points[innermost] = patch.points[--patch.count];
    }
}

}  // namespace

void LevelPatches::add_point(const Vector& n, const Vector& P, scalar separation) {
    added_ = true;
    LevelPatch* patch = patch_for(n, P - n * (separation / 2), separation);
    if (patch == nullptr) return;
    patch->least = min(patch->least, separation);
    const Vector q = P - patch->frame.origin;
    const Candidate point = {dot(q, patch->frame.e_x), dot(q, patch->frame.e_y), dot(q, patch->frame.n), separation, feature_of(P)};
    const scalar near = on_.flush;
    for (int i = 0; i < patch->count; ++i) {  // bound: LevelPatch::room
        Candidate& other = patch->points[i];
        if (abs(other.x - point.x) > near || abs(other.y - point.y) > near) continue;
        if (point.separation < other.separation) other = point;
        return;
    }
    if (patch->count == LevelPatch::room) make_room(on_.flush, limits::flatness * on_.half_extent, on_.body.r, *patch);
    patch->points[patch->count++] = point;
}

/// Which part of the body a point is on: an octant about its centre; of what rolls, which half of its axis.
uint32_t LevelPatches::feature_of(const Vector& P) const {
    const PlacedShape& body = on_.body;
    if (body.shape.kind == ShapeKind::sphere) return 0;
    const Vector q = transpose_times(body.A, P - body.r);
    const uint32_t half = q.z < 0 ? 4u : 0u;
    const bool rolls = body.shape.kind == ShapeKind::capsule ||
                       (body.shape.kind == ShapeKind::cylinder && abs(q.z) < body.shape.size.y * (1 - limits::flatness));
    return rolls ? half : half | (q.y < 0 ? 2u : 0u) | (q.x < 0 ? 1u : 0u);
}

void LevelPatches::write(int patch_i, const Manifold& before, Manifold& manifold) const {
    const LevelPatch& patch = patches_[patch_i];
    Candidate points[LevelPatch::room];
    for (int i = 0; i < patch.count; ++i) points[i] = patch.points[i];  // bound: LevelPatch::room
    const int count = drop_between(points, patch.count, on_.flush, limits::flatness * on_.half_extent);
    name_apart(points, count, patch.frame, on_.body.r);
    keep_points(points, count, patch.frame, limits::flatness * on_.half_extent, remember(&before), manifold);
}

} }  // namespace ingot

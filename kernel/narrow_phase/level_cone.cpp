// SPDX-License-Identifier: MIT
#include "level_cone.h"

#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

int next(int i) { return i == 2 ? 0 : i + 1; }
int before(int i) { return i == 0 ? 2 : i - 1; }

/// The point of edge i that is nearest to c.
TriangleTouch nearest_on_edge(const TriangleFace& face, int i, const Vector& c) {
    const Vector &a = face.corners[i], &b = face.corners[next(i)];
    const scalar t = dot(face.along[i], c - a), length = dot(face.along[i], b - a);
    if (t <= 0) return {a, TrianglePart::corner, i};
    if (t >= length) return {b, TrianglePart::corner, next(i)};
    return {a + face.along[i] * t, TrianglePart::edge, i};
}

}  // namespace

bool face_of_triangle(const LevelTriangle& triangle, TriangleFace& face) {
    scalar longest = 0;
    Vector edges[3];
    for (int i = 0; i < 3; ++i) {
        face.corners[i] = triangle.corners[i];
        edges[i] = triangle.corners[next(i)] - triangle.corners[i];
        const scalar length = sqrt(length_sq(edges[i]));
        if (!(length > 0)) return false;
        face.along[i] = edges[i] * (1 / length);
        longest = max(longest, length);
    }
    const Vector across = cross(edges[0], edges[1]);
    const scalar area = sqrt(length_sq(across));
    if (!(area > 0)) return false;
    face.n = across * (1 / area);
    for (int i = 0; i < 3; ++i) face.inward[i] = cross(face.n, face.along[i]);
    face.altitude = area / longest;
    return true;
}

TriangleTouch nearest_on_triangle(const TriangleFace& face, const Vector& c, scalar flush) {
    bool outside = false;
    TriangleTouch nearest{};
    scalar least = 0;
    for (int i = 0; i < 3; ++i) {
        if (dot(face.inward[i], c - face.corners[i]) >= 0) continue;
        const TriangleTouch on_edge = nearest_on_edge(face, i, c);
        const scalar away = length_sq(c - on_edge.p);
        if (outside && !(away < least)) continue;
        outside = true;
        least = away;
        nearest = on_edge;
    }
    const scalar height = dot(face.n, c - face.corners[0]);
    if (outside && least - height * height > flush * flush) return nearest;
    return {c - face.n * height, TrianglePart::inside, 0};
}

bool is_over(const TriangleFace& face, const Vector& c, scalar flush) {
    bool outside = false, near = false;
    for (int i = 0; i < 3; ++i) {
        const Vector from_corner = c - face.corners[i];
        const scalar inside = dot(face.inward[i], from_corner);
        if (inside >= 0) continue;
        if (inside < -flush) return false;
        const scalar t = dot(face.along[i], from_corner), beyond = t - dot(face.along[i], face.corners[next(i)] - face.corners[i]);
        const scalar past = max(-t, beyond);
        outside = true;
        near = near || past <= 0 || inside * inside + past * past <= flush * flush;
    }
    return !outside || near;
}

TriangleTouch put_on_triangle(const TriangleFace& face, const Vector& p, const Vector& d, scalar tilt) {
    int corner = 0;
    for (int i = 1; i < 3; ++i)
        if (dot(d, face.corners[i] - face.corners[corner]) > 0) corner = i;
    const int edges[2] = {corner, before(corner)};
    int edge = -1;
    scalar flattest = tilt;
    for (const int i : edges) {
        const scalar rise = abs(dot(d, face.along[i]));
        if (!(rise <= flattest)) continue;
        edge = i;
        flattest = rise;
    }
    if (edge < 0) return {face.corners[corner], TrianglePart::corner, corner};
    return nearest_on_edge(face, edge, p);
}

bool hidden_by_triangle(const LevelTriangle& triangle, const TriangleFace& face, const Vector& p, const Vector& d, scalar tilt, scalar flush) {
    if (abs(dot(face.n, p - face.corners[0])) > flush) return false;
    if (!is_over(face, p, flush)) return false;
    int edges = 0, first = 0, last = 0;
    bool on_ridge = false, on_others = false;
    for (int i = 0; i < 3; ++i) {
        const scalar inside = dot(face.inward[i], p - face.corners[i]);
        if (inside > flush) continue;
        if (edges++ == 0) first = i;
        last = i;
        const EdgeKind kind = triangle.edge(i);
        on_ridge = on_ridge || kind == EdgeKind::convex;
        on_others = on_others || kind == EdgeKind::border || kind == EdgeKind::concave;
    }
    const scalar rise = dot(d, face.n);
    const bool along_normal = length_sq(d - face.n * rise) <= tilt * tilt;
    // What is below this face may be before the other one, where a ridge is sharper than a right angle.
    if (rise < -tilt && !(on_ridge && !on_others)) return true;
    if (edges == 0) return !along_normal;
    if (edges == 1) return dot(d, face.inward[first]) > tilt;
    if (edges == 3) return false;  // all of it is within the tolerance: it has no directions
    // In a corner: along the edge that leaves it, and back along the one that ends in it.
    const int leaving = next(first) == last ? last : first, ending = leaving == last ? first : last;
    return dot(d, face.along[leaving]) > tilt || dot(d, face.along[ending]) < -tilt;
}

namespace {

bool is_corner_of(const TriangleFace& face, const Vector& p) {
    bool is = false;
    for (const Vector& corner : face.corners) is = is || (corner.x == p.x && corner.y == p.y && corner.z == p.z);
    return is;
}
/// The same triangle, seen from the other side: a sheet without thickness.
bool is_back_of(const TriangleFace& face, const TriangleFace& other) {
    return dot(face.n, other.n) < 0 && is_corner_of(face, other.corners[0]) && is_corner_of(face, other.corners[1]) &&
           is_corner_of(face, other.corners[2]);
}

}  // namespace

bool has_back(const LevelTable& level, const TriangleFace& face) {
    bool has = false;
    const Vector& p = face.corners[0];
    for_triangles_in(level, p, p, [&](const LevelTriangle& triangle) {
        TriangleFace other;
        has = has || (face_of_triangle(triangle, other) && is_back_of(face, other));
    });
    return has;
}

bool hidden_by_level(const LevelTable& level, const Vector& p, const Vector& d, scalar tilt, scalar flush, Sheets sheets) {
    bool hidden = false;
    const Vector reach = {flush, flush, flush};
    for_triangles_in(level, p - reach, p + reach, [&](const LevelTriangle& triangle) {
        TriangleFace face;
        if (hidden || !face_of_triangle(triangle, face) || !hidden_by_triangle(triangle, face, p, d, tilt, flush)) return;
        const bool from_behind = sheets == Sheets::hide_nothing && dot(d, face.n) < -tilt;
        hidden = !from_behind || !has_back(level, face);
    });
    return hidden;
}

} }  // namespace ingot

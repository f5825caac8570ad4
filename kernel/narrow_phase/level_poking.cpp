// SPDX-License-Identifier: MIT
#include "../base/limits.h"
#include "../math/sqrt.h"
#include "level_patches.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Calls each(n, depth) for the flat faces of a body: n world and outward, depth (m) of P below it, negative outside.
template <class Each>
void for_flat_faces(const PlacedShape& body, const Vector& P, const Each& each) {
    const Vector from = P - body.r;
    if (body.shape.kind == ShapeKind::hull) {
        for (int i = 0; i < body.hull->face_count; ++i) {  // bound: 255: faces of a hull
            const Vector n = body.A * body.hull->faces[i].n;
            each(n, body.hull->faces[i].offset - dot(n, from));
        }
        return;
    }
    const Vector axes[3] = {body.A.c0, body.A.c1, body.A.c2};
    const bool is_box = body.shape.kind == ShapeKind::box;
    const scalar half[3] = {body.shape.size.x, body.shape.size.y, is_box ? body.shape.size.z : body.shape.size.y};
    for (int i = is_box ? 0 : 2; i < 3; ++i) {
        const scalar along = dot(axes[i], from);
        each(axes[i], half[i] - along);
        each(-axes[i], half[i] + along);
    }
}

/// Calls each(u) for the directions of its edges, world.
template <class Each>
void for_edges(const PlacedShape& body, const Each& each) {
    if (body.shape.kind == ShapeKind::box) {
        each(body.A.c0);
        each(body.A.c1);
        each(body.A.c2);
        return;
    }
    for (int i = 0; i < body.hull->edge_count; ++i) {  // bound: 255: edges of a hull
        const HullEdge& edge = body.hull->edges[i];
        each(body.A * (body.hull->vertices[edge.b] - body.hull->vertices[edge.a]));
    }
}

bool is_inside(const PlacedShape& body, const Vector& P) {
    bool inside = true;
    for_flat_faces(body, P, [&inside](const Vector&, scalar depth) { inside = inside && depth > 0; });
    if (body.shape.kind != ShapeKind::cylinder) return inside;
    const Vector q = transpose_times(body.A, P - body.r);
    return inside && q.x * q.x + q.y * q.y < body.shape.size.x * body.shape.size.x;
}

/// Where a stretch of a line is within a body of flat faces, m along it from a. False: nowhere.
struct StretchInside {
    scalar begin, end;
};
bool stretch_within(const PlacedShape& body, const Vector& a, const Vector& along, StretchInside& stretch) {
    for_flat_faces(body, a, [&](const Vector& n, scalar depth) {
        const scalar by = dot(n, along);
        if (by > 0) stretch.end = min(stretch.end, depth / by);
        if (by < 0) stretch.begin = max(stretch.begin, depth / by);
        if (by == 0 && !(depth > 0)) stretch.end = -1;
    });
    return stretch.begin < stretch.end;
}

}  // namespace

/// A corner of the triangle is inside the body: it leaves it through the nearest face of the body whose direction is open there.
void LevelPatches::see_poking_corner(const LevelTriangle& triangle, const TriangleFace& face, int corner, Poking& least) const {
    const Vector& P = face.corners[corner];
    if (!is_inside(on_.body, P)) return;
    const TriangleTouch touch = {P, TrianglePart::corner, corner};
    for_flat_faces(on_.body, P, [&](const Vector& n, scalar depth) {
        if (depth < least.depth && dot(n, face.n) <= limits::edge_tilt && is_open(triangle, touch, -n, limits::edge_tilt)) least = {P, -n, depth};
    });
}

/// An edge of the triangle passes through the body: the least way out across both that is open there.
void LevelPatches::see_poking_edge(const LevelTriangle& triangle, const TriangleFace& face, int edge, Poking& least) const {
    const Vector &a = face.corners[edge], &along = face.along[edge];
    const scalar length = dot(along, face.corners[edge == 2 ? 0 : edge + 1] - a);
    StretchInside stretch = {0, length};
    if (!stretch_within(on_.body, a, along, stretch)) return;
    const Vector middle = a + along * ((stretch.begin + stretch.end) / 2);
    const TriangleTouch touch = {middle, TrianglePart::edge, edge};
    for_edges(on_.body, [&](const Vector& of_body) {
        const Vector across = cross(along, of_body);
        const scalar size_sq = length_sq(across);
        if (!(size_sq > limits::parallel_sin_sq * length_sq(of_body))) return;
        const Vector ways[2] = {across * (1 / sqrt(size_sq)), across * (-1 / sqrt(size_sq))};
        for (const Vector& d : ways) {
            const scalar depth = dot(d, middle - support_point(on_.body, -d));
            if (depth < least.depth && dot(d, face.n) >= -limits::edge_tilt && is_open(triangle, touch, d, limits::edge_tilt))
                least = {middle, d, depth};
        }
    });
}

/// Where the nearest direction between the body and the triangle leads into other ground, which is `overlap` deep (m): of its corners and ridges that
/// poke into the body, the one that is out again by the least. None that is out by much more: then the nearest direction is open for a neighbour, and
/// the contact is its.
void LevelPatches::add_poking(const LevelTriangle& triangle, const TriangleFace& face, scalar overlap) {
    const ShapeKind kind = on_.body.shape.kind;
    if (kind == ShapeKind::capsule) return;
    const scalar most = min(limits::poking_share * overlap, on_.half_extent);
    Poking least = {{}, {}, most};
    for (int i = 0; i < 3; ++i) {
        see_poking_corner(triangle, face, i, least);
        if (kind != ShapeKind::cylinder && ends(triangle, i)) see_poking_edge(triangle, face, i, least);
    }
    if (least.depth < most) add_point(least.d, least.P - least.d * (least.depth / 2), -least.depth);
}

} }  // namespace ingot

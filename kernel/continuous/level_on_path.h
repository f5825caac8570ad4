// SPDX-License-Identifier: MIT
// A level as bodies meet it on their paths: triangle by triangle.
#pragma once

#include "../narrow_phase/collide_level.h"
#include "time_of_impact.h"

namespace ingot { inline namespace INGOT_ABI {

/// Whether the bodies of a collision may meet levels.
template <class Collision>
inline constexpr bool sees_levels = Collision::SceneTraits::Shapes::has(ShapeKind::level);

/// A shape is one of those that a level takes beside its first, which stands for all of them.
template <class Collision>
bool is_companion([[maybe_unused]] const Collision& collision, [[maybe_unused]] ShapeSlot shape) {
    if constexpr (sees_levels<Collision>) {
        const Shape& of = collision.shapes.surface(shape).shape;
        return of.kind == ShapeKind::level && patch_number(of) != 0;
    }
    return false;
}

/// All that a shape reaches on its path, as a level sees it.
struct PathInLevel {
    Vector begin, end;  ///< m, of the body's centre of mass
    scalar reach;       ///< m, about the chord between them

    PathInLevel(const ShapeOnPath& A, const LevelFrame& frame, scalar unit) {
        const BodyPath& path = A.path;
        const scalar time = path.until - path.from;
        const Vector there = path.r_CM + (path.way + path.fall * time) * time;
        begin = frame.seen_point(path.r_CM);
        end = frame.seen_point(there);
        // A parabola leaves its chord by a quarter of the fall.
        reach = A.radius * (1 + limits::flatness) + sum_of_components(path.fall) * scalar(0.25) + limits::impact_gap_max * unit +
                8 * epsilon * (sum_of_components(path.r_CM) + sum_of_components(there) + sum_of_components(begin) + sum_of_components(end));
    }
    /// In so many pieces, which are hardly longer than what goes along is wide: the box of a long way across a level would hold most of it.
    int pieces() const {
        const scalar most = limits::path_boxes_max, wanted = sqrt(length_sq(end - begin)) / (4 * reach);
        return wanted < most - 1 ? 1 + static_cast<int>(wanted) : limits::path_boxes_max;
    }
    /// The i-th of n, by its ends.
    Vector place(int i, int n) const { return begin + (end - begin) * (static_cast<scalar>(i) / static_cast<scalar>(n)); }
    bool stays_above(const TriangleFace& face) const {
        return min(dot(face.n, begin - face.corners[0]), dot(face.n, end - face.corners[0])) > reach;
    }
    /// While what goes along is near the plane of a face, all of it is above the inside. Needs: it does not stay above.
    bool comes_down_inside(const TriangleFace& face) const {
        const scalar from = dot(face.n, begin - face.corners[0]), fall = from - dot(face.n, end - face.corners[0]);
        const auto fraction_at = [&](scalar height) {
            const scalar way = from - height;
            return way > 0 ? (way < fall ? way / fall : scalar(1)) : scalar(0);
        };
        const Vector way = end - begin, first = begin + way * fraction_at(reach), last = begin + way * fraction_at(-reach);
        bool inside = true;
        for (int i = 0; i < 3; ++i) {
            const Vector& corner = face.corners[i];
            inside = inside && min(dot(face.inward[i], first - corner), dot(face.inward[i], last - corner)) > reach;
        }
        return inside;
    }
};

/// Calls each(triangle, n) for the triangles of a level that a shape may meet on its path: a thin hull that stands, or, where the shape comes down
/// well inside, the half space below it, which costs a small thing above a large triangle no digits; and its normal, world.
///
/// Triangles are met from outside. What begins with its middle behind one has others before it, or is in the ground already, and contacts push it
/// out.
/// Cost: walks to the triangles in the boxes of the pieces of the path; those in two of them are told twice.
template <class Shapes, class Each>
void for_triangles_on_path(const ShapeOnPath& A, const ShapeOnPath& level, scalar unit, const Each& each) {
    const PlacedShape placed = place_on_body(level.shape, level.place, nullptr, level.path.r_CM, level.path.A);
    const PlacedShape body = place_on_body(A.shape, A.place, A.hull, A.path.r_CM, A.path.A);
    const LevelTable& table = *Shapes::level_of(level.shape);
    const LevelFrame frame(placed, table);
    const Vector middle = frame.seen_point(A.hull == nullptr ? body.r : body.r + body.A * A.hull->centre);
    const scalar half_extent = least_half_extent(A.shape, A.hull);
    const PathInLevel on(A, frame, unit);
    BodyPath stands = level.path;
    const auto tell = [&](const LevelTriangle& triangle) {
        TriangleFace face;
        if (!face_of_triangle(triangle, face) || dot(face.n, middle - face.corners[0]) < 0 || on.stays_above(face)) return;
        const Vector n = placed.A * face.n;
        if (on.comes_down_inside(face)) {
            stands.r_CM = frame.place(face.corners[0]);
            stands.A = identity_matrix<scalar>();
            return each(ShapeOnPath{stands, HalfSpace{n, 0}, nullptr, nullptr, 0}, n);
        }
        const TriangleHull hull(face, half_extent);
        const PlacedShape thin = hull.placed();
        stands.r_CM = frame.place(thin.r);
        stands.A = placed.A;
        const ShapeOnPath met = {stands, thin.shape, nullptr, thin.hull, thin.hull->radius};
        if (may_meet(A, met, unit)) each(met, n);
    };
    const Vector more = {on.reach, on.reach, on.reach};
    const int pieces = on.pieces();
    for (int i = 0; i < pieces; ++i) {  // bound: limits::path_boxes_max
        const Vector from = on.place(i, pieces), to = on.place(i + 1, pieces);
        for_triangles_in(table, min(from, to) - more, max(from, to) + more, tell);
    }
}

} }  // namespace ingot

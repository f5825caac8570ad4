// SPDX-License-Identifier: MIT
// Normal cones of levels: which directions a contact with a triangle may have, among its neighbours.
//
// The law is that of normal_cone.h. A triangle is a sheet with one outside: at a point inside it only its normal is real, at a rim what leads
// neither into it nor behind it, and at a ridge what does not lead into it, as the other face says what is behind. Whoever shares the point says the
// same of his own: so a ridge leaves the directions between its two normals, however sharp it is, a valley and a seam in a plane none but those of
// the faces, and it is no matter how triangles meet, or of which level they are.
#pragma once

#include "../level/level_walk.h"
#include "../math/vec3.h"

namespace ingot { inline namespace INGOT_ABI {

/// A triangle as contacts see it, in the level's frame.
struct TriangleFace {
    Vector corners[3];  ///< m
    Vector n;           ///< unit, outward
    Vector along[3];    ///< unit, of the edge from a corner to the next
    Vector inward[3];   ///< unit, in the plane, across that edge
    scalar altitude;    ///< m, the least of the three
};

/// False for a triangle without an area.
bool face_of_triangle(const LevelTriangle& triangle, TriangleFace& face);

/// Where a triangle is touched: inside, on an edge or on a corner.
enum class TrianglePart : uint8_t { inside, edge, corner };
struct TriangleTouch {
    Vector p;  ///< m, on it
    TrianglePart part;
    int i;     ///< which edge, or which corner
};

/// The point of a triangle that is nearest to c. Within `flush` (m) of its inside it is inside.
/// Source: Ericson, "Real-Time Collision Detection", 2005, 5.1.5: the regions; here they are told by the edges.
TriangleTouch nearest_on_triangle(const TriangleFace& face, const Vector& c, scalar flush);

/// Whether c is above the inside of a triangle, or below it, at any height: what nearest_on_triangle calls inside. flush: m, beside it.
bool is_over(const TriangleFace& face, const Vector& c, scalar flush);

/// Puts p on the edge or corner that the direction d, which is not that of the normal, belongs to.
/// tilt: sine of the angle by which d may be wrong.
TriangleTouch put_on_triangle(const TriangleFace& face, const Vector& p, const Vector& d, scalar tilt);

/// Whether a ridge or a rim is there: what ends at this edge.
inline bool ends(const LevelTriangle& triangle, int i) { return triangle.edge(i) == EdgeKind::border || triangle.edge(i) == EdgeKind::convex; }

/// The same triangle is there seen from the other side too: a sheet without thickness, and what is behind the one side is before the other.
bool has_back(const LevelTable& level, const TriangleFace& face);

/// True where the triangle reaches p (within `flush`, m) and d is not in its normal cone there.
bool hidden_by_triangle(const LevelTriangle& triangle, const TriangleFace& face, const Vector& p, const Vector& d, scalar tilt, scalar flush);

/// Whether sheets without thickness, triangles that are there from both sides, hide what is behind them. What overlaps by little has them before it;
/// to what is deep in the ground they are walls between solids.
enum class Sheets : bool { hide_nothing, hide };

/// The same for all triangles of a level.
/// Cost: a walk to the triangles whose boxes reach p.
bool hidden_by_level(const LevelTable& level, const Vector& p, const Vector& d, scalar tilt, scalar flush, Sheets sheets = Sheets::hide_nothing);

} }  // namespace ingot

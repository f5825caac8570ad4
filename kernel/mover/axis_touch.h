// SPDX-License-Identifier: MIT
// A mover's capsule against one shape: its axis is a stretch of a line, and all it touches is as far from that as its radius.
//
// Nearest points to the axis are a radius away, so their direction is known to some epsilon of the sizes over the radius, also where capsules and
// shapes all but touch.
#pragma once

#include "../narrow_phase/collide_level.h"
#include "../narrow_phase/normal_cone.h"
#include "../query/cast_shape.h"
#include "mover.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where a capsule and a shape are nearest.
struct AxisTouch {
    bool there;    ///< false: it is further away than was asked for, or on the side of a triangle that has none
    bool crosses;  ///< the axis is in the shape: the plane is one of the shortest ways out
    bool face;     ///< n is the normal of a face at P
    Vector n;      ///< unit, from the shape to the axis
    Vector P;      ///< m, on the shape
    scalar gap;    ///< m, from the surface of the capsule along n; below 0 inside
};

/// Of a convex shape or a half space. reach: m; of what is further away nothing has to be known.
/// Cost: that of closest_points, and of plane_between.
AxisTouch touch_of_shape(const PlacedShape& capsule, const PlacedShape& other, scalar reach);

/// True for a box that the capsule, on all of its way, is further from than `reach`, m, along one of its axes: so most whose balls are met are left
/// out.
bool passes_box(const PlacedShape& capsule, const Vector& way, const PlacedShape& box, scalar reach);

/// Of a triangle that the axis goes through, or is before; in the frame of its level; exact.
AxisTouch touch_of_triangle(const PlacedShape& capsule, const TriangleFace& face);

/// How far a capsule gets.
struct AxisCast {
    scalar stop;   ///< m, the gap at which it ends
    scalar slack;  ///< m; what is nearer than `stop` from the begin is met when it comes nearer by so much; 0: at once
    scalar near;   ///< m, a gap this much larger is as good
    /// m; above 0: it is in something. Then what it touches of a level from the begin, along a direction that neighbours within `flush` hide, is not
    /// met: no plane is asked of it either.
    scalar flush = 0;
};

/// Where on its way a capsule comes near to a shape: a gap of AxisCast::stop, or a little more, never less. As cast_on_shape: Newton's method from
/// the one side on a gap that is a convex function of the way. What its axis is in from the begin is not met.
/// touch(capsule): where it touches the shape.
/// Source: Mirtich, "Impulse-based dynamic simulation", 1996, 2.3.
template <class Touch>
ShapeEntry cast_axis(const PlacedShape& capsule, const Vector& way, scalar fraction_max, const AxisCast& cast, const Touch& touch_at) {
    constexpr ShapeEntry missed = {false, 1, {}, {}};
    PlacedShape now = capsule;
    ShapeEntry entry = {true, 0, {}, {}};
    scalar stop = cast.stop;
    const scalar least_closing = sqrt(length_sq(way)) * limits::edge_tilt;  // along a wall, whose plane is known to less
    for (int iteration = 0; iteration < limits::cast_iterations_max; ++iteration) {
        now.r = capsule.r + way * entry.fraction;
        const AxisTouch touch = touch_at(now);
        if (!touch.there || touch.crosses) return missed;
        const scalar closing = -dot(touch.n, way);
        if (!(closing > 0)) return missed;
        entry.P = touch.P;
        entry.n = touch.n;
        if (iteration == 0 && touch.gap <= stop + cast.near) {
            if (closing < least_closing) return missed;
            if (!(cast.slack > 0)) return entry;
            stop = touch.gap - cast.slack;
        }
        if (touch.gap - stop <= cast.near) return entry;
        const scalar further = touch.gap - stop;
        if (further > closing) return missed;  // beyond the end; and no quotient is too large for a scalar
        entry.fraction += further / closing;
        if (entry.fraction > fraction_max) return missed;
    }
    return entry;
}

/// A touch among others, before planes are made of it.
struct MoverTouch {
    Vector n, P;     ///< as in AxisTouch
    Vector inner;    ///< m, of a face: P, and a little further inside
    Vector upright;  ///< unit: as MoverGround::n
    scalar gap;      ///< m, from the skin
    int slot;        ///< of the shape
    bool face;       ///< n is the normal of a face
};

/// The nearest of what is touched, whatever comes first.
struct MoverTouches {
    MoverTouch touches[movers::touches_max];
    int count = 0;

    void add(const MoverTouch& touch);
    /// Those that say the same, within 2 degrees, become one: the nearest, with the most upright face of all. No more than planes_max are left.
    void merge(const Vector& up);
};

/// What is asked for around a mover.
struct MoverReach {
    Vector up;
    scalar skin;   ///< m
    scalar reach;  ///< m, beyond the capsule
    scalar flush;  ///< m, how far apart surfaces are one
};

/// Where a touch is on its own shape: a point of a search becomes one of a corner, an edge or a face. And of a face, a place a little further inside.
void put_on_shape(const PlacedShape& S, const PlacedShape& capsule, scalar flush, MoverTouch& touch);

/// Of the faces of a box or hull S that meet in touch.P calls each(n), unit, world.
template <class Each>
void for_faces_at(const PlacedShape& S, const Vector& P, scalar flush, const Each& each) {
    // bound: 2 limits::hull_vertices_max - 4
    for (int face_i = 0; face_i < face_count(S); ++face_i) {
        const FaceOfFixed face = face_of(S, face_i);
        if (abs(dot(face.n, P - S.r) - face.offset) <= flush) each(face.n);
    }
}
/// The same of a level; n as the world sees it.
template <class Each>
void for_faces_of_level(const PlacedShape& level, const LevelTable& table, const Vector& P, scalar flush, const Each& each) {
    const LevelFrame frame(level, table);
    const Vector p = frame.seen_point(P), more = {flush, flush, flush};
    for_triangles_in(table, p - more, p + more, [&](const LevelTriangle& triangle) {
        TriangleFace face;
        if (!face_of_triangle(triangle, face) || length_sq(p - nearest_on_triangle(face, p, 0).p) > flush * flush) return;
        each(level.A * face.n);
    });
}

/// All that a capsule touches of a level, but for what the level's own triangles hide.
void add_touches_of_level(const PlacedShape& capsule, const PlacedShape& level, const LevelTable& table, const MoverReach& asked, int slot,
                          MoverTouches& touches);
/// Where it meets a level.
ShapeEntry cast_axis_on_level(const PlacedShape& capsule, const Vector& way, scalar fraction_max, const AxisCast& cast, const PlacedShape& level,
                              const LevelTable& table);

/// True where T, a fixed shape, hides a contact with direction d at p: see normal_cone.h. Of a level, hidden_by_level_at.
bool hidden_by_shape(const PlacedShape& T, const Vector& p, const Vector& d, scalar flush);
bool hidden_by_level_at(const PlacedShape& T, const LevelTable& table, const Vector& p, const Vector& d, scalar flush);

/// The capsule as queries take it: its axis is `up`.
PlacedShape placed_mover(const Mover& mover);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// Normal cones of fixed shapes: which directions a contact may have.
#pragma once

#include "contact_geometry.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where a fixed shape is touched, and from where.
struct Touch {
    Vector p;     ///< m, world, on the fixed shape
    Vector d;     ///< unit, from the fixed shape to the body
    scalar tilt;  ///< sine of the angle by which d may be wrong
    bool face;     ///< d is the normal of a face, which holds in the limit: p stands for the points of that face nearby as well
    Vector inner;  ///< m, world; of a face: p, and a little further inside
};

/// Puts p on the corner, edge or face of a fixed box that d belongs to: a direction that was searched for has points that are off by millimetres.
void put_on_box(const PlacedShape& box, Touch& touch);
void put_on_hull(const PlacedShape& hull, Touch& touch);

/// True where the shape reaches p (m, world; within `flush`, m) and d is not in its normal cone there: no body can touch p from that side.
///
/// By Moreau, the part of d in the tangent cone of T at p is how far d is away from the normal cone. Of a box it is taken axis by axis.
/// Cost: 30 flops; of a hull up to 8 faces that meet in p, and the cube of their number, mostly one.
/// Source: Rockafellar, Wets, "Variational Analysis", 1998, 6.9 and 6.42: the normal cone of a union, where its parts meet, lies in the
///         intersection of theirs.
bool hidden_by_box(const PlacedShape& T, const Touch& touch, const Vector& p, scalar flush);
bool hidden_by_hull(const PlacedShape& T, const Touch& touch, const Vector& p, scalar flush);
bool hidden_by_half_space(const PlacedShape& T, const Touch& touch, const Vector& p, scalar flush);

/// True where d is the normal of a flat side of the body: while the body tilts, so does d.
bool is_side_of_body(const PlacedShape& body, const Vector& d);
/// True where a point is below the lowest line of a cylinder, as d says what is up, but for rounding.
bool is_below_axis(const PlacedShape& cylinder, const Vector& P, const Vector& d);

/// A face of a fixed box or hull: all of its points have dot(n, P - S.r) <= offset.
struct FaceOfFixed {
    Vector n;       ///< unit, outward, world
    scalar offset;  ///< m
};
/// 0 for shapes that have no flat faces, and for half spaces.
int face_count(const PlacedShape& S);
FaceOfFixed face_of(const PlacedShape& S, int face_i);

} }  // namespace ingot

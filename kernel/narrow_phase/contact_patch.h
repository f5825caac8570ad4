// SPDX-License-Identifier: MIT
// What two shapes turn towards each other, seen in the plane of contact, and where it is on top of each other.
#pragma once

#include "contact_geometry.h"

namespace ingot { inline namespace INGOT_ABI {

/// A polyhedron: a hull as it is, or the cube stretched to a box; its faces are those of the hull, stretched along.
struct Polyhedron {
    const ConvexHull* hull;  ///< null for what is round
    Vector stretch;

    Vector vertex(int i) const { return scaled(stretch, hull->vertices[i]); }
};

Polyhedron polyhedron_of(const PlacedShape& s);

/// What a shape turns towards a contact: a face, an edge or a corner, seen in the plane of contact.
struct Patch {
    static constexpr int corners_max = limits::cap_corners;
    scalar x[corners_max], y[corners_max], z[corners_max];
    int count;
    int face;                      ///< its number, or -1
    scalar z_0, slope_x, slope_y;  ///< of its plane: z = z_0 + slope_x x + slope_y y

    scalar height(scalar at_x, scalar at_y) const { return z_0 + slope_x * at_x + slope_y * at_y; }
};

/// What s turns towards the unit vector `towards`; centre: its origin, seen from that of the frame.
void patch_of(const PlacedShape& s, const Vector& centre, const Vector& towards, const ContactFrame& frame, Patch& patch);

/// Points that touch, in the plane of contact; near ones are one.
struct Found {
    static constexpr int room = 2 * Patch::corners_max;
    Candidate candidates[room];
    int count;
    scalar margin, nearby_sq;
    scalar gap;     ///< along n; no two points on top of each other are nearer
    uint32_t axis;  ///< bits of all features
    scalar radius_A, radius_B;

    void add(scalar x, scalar y, scalar z_A, scalar z_B, uint32_t feature) {
        const scalar bottom = z_A - radius_A, top = z_B + radius_B;
        const scalar s = bottom - top < gap ? gap : bottom - top;  // beyond the rim of a face its plane goes on
        if (!(s <= margin) || count >= room) return;
        // bound: Found::room, twice limits::cap_corners
        for (int i = 0; i < count; ++i) {
            const scalar d_x = candidates[i].x - x, d_y = candidates[i].y - y;
            if (d_x * d_x + d_y * d_y <= nearby_sq) return;
        }
        candidates[count++] = {x, y, (bottom + top) * scalar(0.5), s, axis | feature};
    }
};

enum : uint32_t { corner_of_A = 1u << 16, corner_of_B = 2u << 16, crossing = 3u << 16 };

/// True for the one point of shapes of which nothing is on top of each other across their normal: it may be beside either.
constexpr bool is_beside_face(uint32_t feature) { return (feature & 0x3ffffu) == (corner_of_A | corner_of_B); }

/// Adds where two patches, of which neither is a corner, are on top of each other: corners within `slack` (m) of the other
/// patch, and where edges cross. Two edges that lie along each other do so no further apart than `aside` (m). Source: Cyrus and
/// Beck, "Generalized two- and three-dimensional clipping", 1978.
void overlay(const Patch& A, const Patch& B, scalar slack, scalar aside, Found& found);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// A convex polyhedron as the narrow phase reads it, from arrays in flash.
#pragma once

#include "../math/vec3.h"

namespace ingot { inline namespace INGOT_ABI {

/// A face: all points of the hull have n . r <= offset.
struct HullFace {
    Vector n{};           ///< unit, outward
    scalar offset{};      ///< m
    uint8_t loop_first{};  ///< its corners in ConvexHull::loops, counter-clockwise as seen from outside
    uint8_t loop_count{};  ///< corners of the face
};

/// An edge from vertex a to vertex b, with face_left on the left as seen from outside.
struct HullEdge {
    uint8_t a{}, b{}, face_left{}, face_right{};  ///< index of a corner, or of the face beside
};

/// Views of constant arrays; the frame is the hull's own. Made by HullOf::view(), see hull_of_points.h.
struct ConvexHull {
    const Vector* vertices{};  ///< m, from the origin of the body
    const HullFace* faces{};  ///< of them face_count
    const HullEdge* edges{};  ///< of them edge_count
    const uint8_t* loops{};  ///< corners of all faces, one face behind the other
    uint8_t vertex_count{}, face_count{}, edge_count{};  ///< how many there are
    Vector centre{};  ///< m, a point well inside
    scalar radius{};  ///< m, of the ball about the origin that holds the hull
    scalar inner_radius{};  ///< m, of the ball about the centre that the hull holds
};

/// The hulls of a scene, in flash. A body has the number of its hull, no pointer: so a world can be copied, and read by another machine.
struct HullTable {
    const ConvexHull* hulls{};
    int count{};
};

/// The hulls of a scene that names none.
struct NoHulls {};

constexpr HullTable table_of(const NoHulls&) { return {nullptr, 0}; }
template <unsigned N>
constexpr HullTable table_of(const ConvexHull (&hulls)[N]) {
    return {hulls, static_cast<int>(N)};
}

} }  // namespace ingot

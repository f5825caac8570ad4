// SPDX-License-Identifier: MIT
#include "triangle_hull.h"

#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

constexpr uint8_t loops_of_triangle[12] = {0, 1, 2, 1, 0, 3, 2, 1, 3, 0, 2, 3};
constexpr HullEdge edges_of_triangle[6] = {{0, 1, 0, 1}, {1, 2, 0, 2}, {2, 0, 0, 3}, {0, 3, 1, 3}, {1, 3, 2, 1}, {2, 3, 3, 2}};

}  // namespace

/// Its tip hangs below the middle, so little that what stands before a wall does not meet the hull of its other side.
TriangleHull::TriangleHull(const TriangleFace& face, scalar half_extent) {
    const Vector middle = (face.corners[0] + face.corners[1] + face.corners[2]) * (scalar(1) / 3);
    const scalar depth = min(half_extent, face.altitude) / 8;
    origin_ = middle;
    scalar radius_sq = 0;
    for (int i = 0; i < 3; ++i) {
        vertices_[i] = face.corners[i] - middle;
        radius_sq = max(radius_sq, length_sq(vertices_[i]));
    }
    vertices_[3] = face.n * -depth;
    for (int i = 0; i < 4; ++i) {
        const uint8_t* loop = loops_of_triangle + 3 * i;
        const Vector& a = vertices_[loop[0]];
        const Vector across = cross(vertices_[loop[1]] - a, vertices_[loop[2]] - a);
        const Vector n = i == 0 ? face.n : across * (1 / sqrt(length_sq(across)));
        faces_[i] = {n, dot(n, a), static_cast<uint8_t>(3 * i), 3};
    }
    hull_ = {vertices_, faces_, edges_of_triangle, loops_of_triangle, 4, 4, 6, face.n * (depth / -4), sqrt(radius_sq), half_extent};
}

} }  // namespace ingot

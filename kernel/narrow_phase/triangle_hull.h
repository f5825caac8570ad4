// SPDX-License-Identifier: MIT
#pragma once

#include "../shape/placed_shape.h"
#include "level_cone.h"

namespace ingot { inline namespace INGOT_ABI {

/// A triangle as the narrow phase and queries take it: a thin hull that hangs below it, in the level's frame.
class TriangleHull {
public:
    TriangleHull(const TriangleFace& face, scalar half_extent);
    PlacedShape placed() const { return {Hull{hull_.radius, 0}, origin_, identity_matrix<scalar>(), &hull_}; }
    TriangleHull(const TriangleHull&) = delete;
    TriangleHull& operator=(const TriangleHull&) = delete;

private:
    Vector vertices_[4], origin_;
    HullFace faces_[4];
    ConvexHull hull_;
};

} }  // namespace ingot

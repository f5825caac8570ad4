// SPDX-License-Identifier: MIT
#pragma once

#include "../math/mat3.h"
#include "manifold.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where a body is.
struct BodyFrame {
    Vector r;  ///< m, world
    Matrix A;  ///< body to world
};

/// A manifold in the frames of its two bodies, as it was when it was found.
struct ManifoldAnchors {
    scalar on_A[3][Manifold::points_max], on_B[3][Manifold::points_max];  ///< m, in the frame of A and of B
    scalar separation[Manifold::points_max];  ///< m
    Vector n_A, n_B;  ///< the normal, in the frame of A and of B
    scalar margin;    ///< m, of the search; 0: nothing is known
};

/// Keeps where the points of a manifold lie on its two bodies.
void anchor(const BodyFrame& A, const BodyFrame& B, const Manifold& manifold, scalar margin, ManifoldAnchors& anchors);

/// What a manifold may differ in from what its anchors know, and be renewed from them.
struct RenewLimits {
    scalar slip;    ///< m, that points may have moved against each other
    scalar margin;  ///< m, of this step
    scalar spare;   ///< m, by which that may be larger than the margin of the search
};

/// Renews a manifold from its anchors: true if the bodies have moved so little against each other that a search would find the same features.
///
/// No point of A has moved by more than `slip` (m) against its fellow of B, along the normal or across, and the normal of A has not turned against
/// that of B by more than limits::recycled_slip. With slip = recycled_slip R, R the lesser bounding radius, a point of A that was further
/// away than the margin is so still, but for 2 slip: well within limits::contact_margin for bodies up to some metres. Separations are exact
/// but for slip^2 / R.
/// False: the manifold is as it was; search. So it is for anchors that know nothing, or that were found with less margin.
/// Cost: about 40 flops a point.
bool renew_from_anchors(const BodyFrame& A, const BodyFrame& B, const RenewLimits& within, const ManifoldAnchors& anchors, Manifold& manifold);

} }  // namespace ingot

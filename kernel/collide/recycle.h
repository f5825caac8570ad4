// SPDX-License-Identifier: MIT
#pragma once

#include "manifold.h"
#include "placed_shape.h"

namespace ingot { inline namespace INGOT_ABI {

/// A manifold in the frames of its two bodies, as it was when it was found.
struct ManifoldAnchors {
    Vector on_A[Manifold::points_max], on_B[Manifold::points_max];  ///< m, in the frame of A and of B
    Vector n_A, n_B;                                                ///< the normal, in the frame of A and of B
    scalar margin;                                                  ///< m, of the search; 0: nothing is known
};

/// Keeps where the points of a manifold lie on its two bodies.
void anchor(const PlacedShape& A, const PlacedShape& B, const Manifold& manifold, scalar margin, ManifoldAnchors& anchors);

/// Renews a manifold from its anchors: true if the bodies have moved so little against each other that a search would find the same features.
///
/// No point has slipped, and the normal of A has not turned against that of B at the length R, by more than slip = limits::recycled_slip R, R the
/// lesser bounding radius (the greater counts where the other is a half space). A point of A that was further away than the margin is so still,
/// but for 2 slip, which is well within limits::contact_margin for bodies up to some metres; separations are exact to slip^2 / R.
/// False: the manifold is as it was; search. So it is for anchors that know nothing, or that were found with less margin.
/// Cost: about 40 flops a point.
bool renew_from_anchors(const PlacedShape& A, const PlacedShape& B, scalar slip, scalar margin, const ManifoldAnchors& anchors, Manifold& manifold);

} }  // namespace ingot

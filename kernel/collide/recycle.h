// SPDX-License-Identifier: MIT
// The manifold of a step before, carried along with the two shapes instead of a new test.
//
//     if (!recycle_manifold(A, B, kept, allowed, margin, manifold)) {
//         collide_box_box(A, B, margin, manifold, &manifold);
//         keep_manifold(A, B, manifold, kept);
//     }
#pragma once

#include "manifold.h"
#include "placed_shape.h"

namespace ingot { inline namespace INGOT_ABI {

/// A manifold as the shapes carry it, and how they were to each other when it was made.
struct KeptManifold {
    Matrix A_in_B;  ///< A to B
    Vector r_in_B;  ///< m, origin of A in the frame of B
    Vector n_B;     ///< from B to A, in the frame of B
    int count;
    Vector on_A[Manifold::points_max];  ///< m, points of the surface of A in its own frame
    Vector on_B[Manifold::points_max];  ///< m, and of B in its own
    uint32_t features[Manifold::points_max];
};

/// manifold: of these two shapes where they are.
void keep_manifold(const PlacedShape& A, const PlacedShape& B, const Manifold& manifold, KeptManifold& kept);

/// How far any point of the shapes can have moved, as seen from the other shape, since the manifold was kept.
///
/// A point p of A, |p| <= R from its origin, is at r + Q p in the frame of B. It has moved by dr + dQ p, and a turn by theta
/// moves p by no more than the chord 2 sin(theta / 2) R <= theta R; the chord is |dQ| / sqrt(2) in the norm of Frobenius, so no
/// angle is needed. The same holds for B as seen from A: the smaller shape is taken, which never is a half space.
///
/// Units:   m. Accuracy: a few roundings of |A.r - B.r| and of R.
scalar moved_since(const PlacedShape& A, const PlacedShape& B, const KeptManifold& kept);

/// The kept manifold where the shapes are now; false, and the manifold as it was, where moved_since exceeds `allowed`: a new
/// test is due. Both measure from the pose of the last test, so that a slow drift cannot add up.
///
/// Accuracy: with m = moved_since, the distance of the shapes has changed by no more than m, and so has each separation: n is
/// fixed
///           to B, and the point of A has moved by no more than m. They differ from what a new test gives by 2 m at most, and
///           by the square of the turn where a face lies on a face. Surfaces that were apart by more than the margin are so by
///           more than margin - m; nothing that overlaps is missed while allowed <= margin.
/// Units:   allowed, margin: m.
/// Errors:  none; what is not finite is never recycled.
/// Cost:    about 250 flops and one square root for four points.
bool recycle_manifold(const PlacedShape& A, const PlacedShape& B, const KeptManifold& kept, scalar allowed, scalar margin,
                      Manifold& manifold);

} }  // namespace ingot

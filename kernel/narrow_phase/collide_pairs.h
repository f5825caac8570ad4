// SPDX-License-Identifier: MIT
// Where two shapes touch: one routine a pair of kinds, pure functions of the two shapes.
//
//     Manifold manifold{};                                          // zero: nothing is known of a step before
//     collide_box_box(A, B, margin, manifold, &manifold);           // `before` may be the manifold that is written
//
// n points from B to A. A point is left out when its separation exceeds the margin; so is, as yet, a pair of edges or corners
// that are apart and not above each other. Overlap always gives a point. No points: n is a direction along which the shapes
// are apart by more than the margin, or zero; with it in `before` the next call is done after one projection.
// `before` also keeps the face, the edges and the corners of the step before until others are clearly better.
//
// Needs:   sizes that check_shape accepts, A and B orthonormal, margin >= 0.
// Errors:  none; what is not finite gives points that are not finite, or none, in bounded time.
// Accuracy: separations carry the rounding of |A.r - B.r| and of the sizes, a few units in the last place of their sum,
//          however far both are from the origin. Faces are preferred to edges by limits::edge_preference. Directions of hulls and
//          cylinders that are apart are searched for, to limits::nearest_direction of the smallest extent. Overlapping cylinders
//          are parted along the best of up to three directions that no turn improves by limits::round_accuracy.
// Cost:    a few hundred flops for balls, capsules and half spaces; boxes about 2000 to 3400 instructions; hulls every face of both
//          and every pair of edges that may touch; cylinders up to 26 searches for nearest points, a dozen as a rule.
#pragma once

#include "../base/limits.h"
#include "manifold.h"
#include "../shape/placed_shape.h"

namespace ingot { inline namespace INGOT_ABI {

/// How far apart two shapes may be and still have points, m. A plain length is one of ordinary things, see base/contact_lengths.h.
struct Margin {
    scalar most;  ///< 0 .. limits::unbounded
    scalar fast;  ///< a larger margin is that of a fast pair, which looks for more points
    Margin(scalar length, scalar length_of_fast = limits::fast_margin) : most(length), fast(length_of_fast) {}
    operator scalar() const { return most; }
};

// Balls have one point, its feature 0. Centres at one place, to the rounding of the radii, have no normal: an axis is taken.

void collide_sphere_sphere(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                           const Manifold* before = nullptr);
void collide_sphere_capsule(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                            const Manifold* before = nullptr);
/// A centre inside the box is pushed to the nearest face.
void collide_sphere_box(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                        const Manifold* before = nullptr);
/// A centre inside the cylinder is pushed to the nearest of side and ends.
void collide_sphere_cylinder(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                             const Manifold* before = nullptr);
void collide_sphere_hull(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                         const Manifold* before = nullptr);
void collide_sphere_half_space(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                               const Manifold* before = nullptr);

// Capsules that lie along each other, along a face or an edge have two points, else one.

void collide_capsule_capsule(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                             const Manifold* before = nullptr);
void collide_capsule_box(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                         const Manifold* before = nullptr);
void collide_capsule_cylinder(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                              const Manifold* before = nullptr);
void collide_capsule_hull(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                          const Manifold* before = nullptr);
void collide_capsule_half_space(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                                const Manifold* before = nullptr);

/// Separating axes; the face that meets the reference face is clipped against its rectangle.
void collide_box_box(const PlacedShape& A, const PlacedShape& B, const Margin& margin, Manifold& manifold,
                     const Manifold* before = nullptr);
void collide_box_cylinder(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                          const Manifold* before = nullptr);
void collide_box_hull(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                      const Manifold* before = nullptr);
void collide_box_half_space(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                            const Manifold* before = nullptr);

void collide_cylinder_cylinder(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                               const Manifold* before = nullptr);
void collide_cylinder_hull(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                           const Manifold* before = nullptr);
void collide_cylinder_half_space(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                                 const Manifold* before = nullptr);

void collide_hull_hull(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                       const Manifold* before = nullptr);
void collide_hull_half_space(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold,
                             const Manifold* before = nullptr);

} }  // namespace ingot

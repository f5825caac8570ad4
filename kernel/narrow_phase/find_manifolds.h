// SPDX-License-Identifier: MIT
// From pairs that may touch to manifolds.
#pragma once

#include "../base/limits.h"
#include "../base/report.h"
#include "../math/sqrt.h"
#include "manifold_record.h"
#include "contact_geometry.h"
#include "collide_level.h"
#include "../shape/placed_body.h"
#include "manifold_anchors.h"

namespace ingot { inline namespace INGOT_ABI {

INGOT_INLINE BodyFrame frame_of(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    return {lane_of(bodies.translation[at.tile].r_CM, at.lane), lane_of(bodies.rotation[at.tile].A, at.lane)};
}

/// How far apart two bodies may be and still have a manifold: what they can travel towards each other in the step, and a little.
INGOT_INLINE scalar margin_of(const BodyView& bodies, const SurfaceView& surfaces, const BoundsTile* bounds, const BodyPair& pair, scalar h) {
    const Place A = place_of(pair.body_A), B = place_of(pair.body_B);
    const Vector v = lane_of(bodies.translation[A.tile].v_CM, A.lane) - lane_of(bodies.translation[B.tile].v_CM, B.lane);
    const scalar scale = scale_of(surfaces.unit, surfaces.halvings(pair.body_A, pair.body_B));
    return margin_at(scale, surfaces.unit, surfaces.fall) + sqrt(length_sq(v)) * h + bounds[A.tile].spin_reach[A.lane] +
           bounds[B.tile].spin_reach[B.lane];
}

/// For scenes without fast bodies: see continuous/fast_pairs.h.
struct NoFastPairs {
    static constexpr bool leads_figures = false;
    static constexpr bool has(const BodyPair&) { return false; }
    static constexpr bool meets_hard(const BodyPair&, const Manifold&) { return false; }
};

/// Whether a pair has a fast body with joints: see continuous/figure_pairs.h.
template <class FastPairs>
INGOT_INLINE bool is_led([[maybe_unused]] const FastPairs& fast_pairs, [[maybe_unused]] const BodyPair& pair) {
    if constexpr (FastPairs::leads_figures)
        return fast_pairs.leads(pair);
    else
        return false;
}

/// Of a pair with a fast body: it has a manifold if it touches. What is further is no plane yet: a fast body may pass by.
INGOT_INLINE scalar margin_of_fast(const BodyView& bodies, const SurfaceView& surfaces, const BodyPair& pair) {
    const Place A = place_of(pair.body_A), B = place_of(pair.body_B);
    const Vector r_A = lane_of(bodies.translation[A.tile].r_CM, A.lane), r_B = lane_of(bodies.translation[B.tile].r_CM, B.lane);
    const scalar gap = limits::touching_gap * scale_of(surfaces.unit, surfaces.halvings(pair.body_A, pair.body_B));
    return gap + 8 * epsilon * sqrt(length_sq(r_A) + length_sq(r_B));
}

/// Balls are found as quickly as they would be renewed.
INGOT_INLINE bool worth_renewing(const Surface& A, const Surface& B) {
    return A.shape.kind != ShapeKind::sphere && B.shape.kind != ShapeKind::sphere;
}

/// The manifold of the step before, moved along with the bodies; false if it has to be found anew.
template <class Shapes>
INGOT_INLINE bool renew_manifold(const BodyView& bodies, const SurfaceView& surfaces, const BodyPair& pair, scalar margin,
                                 const ManifoldAnchors& anchors, Manifold& manifold) {
    const Surface &A = surfaces.surfaces[pair.body_A], &B = surfaces.surfaces[pair.body_B];
    if (!worth_renewing(A, B)) return false;
    const scalar R_A = Shapes::radius_of(A), R_B = Shapes::radius_of(B);  // 0: a half space
    const scalar R = R_A == 0 ? R_B : R_B == 0 || R_A < R_B ? R_A : R_B;
    const scalar spare = limits::contact_margin / 2 * scale_of(surfaces.unit, manifold.halvings);
    return renew_from_anchors(frame_of(bodies, pair.body_A), frame_of(bodies, pair.body_B), {limits::recycled_slip * R, margin, spare}, anchors,
                              manifold);
}

/// The same for shapes in any order. `before` and the manifold have their normals from B to A.
template <class Shapes, bool knows_balls = true>
bool collide_placed(const PlacedShape& A, const PlacedShape& B, const Margin& margin, const Manifold& before, Manifold& manifold) {
    if constexpr (Shapes::has(ShapeKind::level)) {
        if (B.shape.kind == ShapeKind::level) return collide_level<Shapes>(A, B, margin, manifold), true;
        if (A.shape.kind == ShapeKind::level) {
            collide_level<Shapes>(B, A, margin, manifold);
            manifold.n = -manifold.n;
            return true;
        }
    }
    if (!(B.shape.kind < A.shape.kind)) return collide_shapes<Shapes, knows_balls>(A, B, margin, manifold, before);
    Manifold seen = before;
    seen.n = -seen.n;
    const bool tested = collide_shapes<Shapes, knows_balls>(B, A, margin, manifold, seen);
    manifold.n = -manifold.n;
    return tested;
}

/// The manifold of a pair, found by the routine for its shapes; false if there is none.
template <class Shapes>
bool find_manifold(const BodyView& bodies, const SurfaceView& surfaces, const BodyPair& pair, const Margin& margin, const Manifold& before,
                   Manifold& manifold) {
    if constexpr (Shapes::has(ShapeKind::sphere)) {  // without the frames and the choice, which for balls are most of the way
        const Shape &shape_A = surfaces.surfaces[pair.body_A].shape, &shape_B = surfaces.surfaces[pair.body_B].shape;
        if (shape_A.kind == ShapeKind::sphere && shape_B.kind == ShapeKind::sphere) {
            ball_on_ball(r_CM_of(bodies, pair.body_A), shape_A.size.x, r_CM_of(bodies, pair.body_B), shape_B.size.x, margin, manifold);
            return true;
        }
    }
    return collide_placed<Shapes, false>(placed_body<Shapes>(bodies, surfaces, pair.body_A), placed_body<Shapes>(bodies, surfaces, pair.body_B),
                                         margin, before, manifold);
}

inline constexpr Manifold no_manifold_before = {};

/// True where the shapes of a pair overlap or touch.
template <class Shapes>
bool shapes_overlap(const BodyView& bodies, const SurfaceView& surfaces, const BodyPair& pair) {
    Manifold found_now;
    return find_manifold<Shapes>(bodies, surfaces, pair, 0, no_manifold_before, found_now) && found_now.count != 0;
}

/// The same contacts as the solver knows them: by bodies, where pairs are of shape slots.
template <int shapes_of_body>
void name_bodies(const ManifoldView& manifolds, BodyPair* body_pairs) {
    for (int pair_i = 0; pair_i < *manifolds.count; ++pair_i) {  // bound: max_manifolds
        const BodyPair& pair = manifolds.pairs[pair_i];
        body_pairs[pair_i] = {static_cast<Index>(pair.body_A / shapes_of_body), static_cast<Index>(pair.body_B / shapes_of_body), pair.record};
    }
}

/// A pair that begins to touch has its record, all zero, filled.
template <bool renews>
INGOT_INLINE void begin_record(const BodyView& bodies, const SurfaceView& surfaces, const BodyPair& pair, const Manifold& found, scalar margin,
                               const ManifoldView& manifolds) {
    ManifoldRecord& record = manifolds.records[pair.record];
    mix_materials(surfaces, pair, record);
    keep_manifold(found, record.manifold);
    if (renews && worth_renewing(surfaces.surfaces[pair.body_A], surfaces.surfaces[pair.body_B]))
        anchor(frame_of(bodies, pair.body_A), frame_of(bodies, pair.body_B), found, margin, manifolds.anchors[pair.record]);
}

} }  // namespace ingot

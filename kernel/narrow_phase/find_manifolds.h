// SPDX-License-Identifier: MIT
// From pairs that may touch to manifolds. The only file that names the routines of the narrow phase.
#pragma once

#include "../base/limits.h"
#include "../base/report.h"
#include "../math/sqrt.h"
#include "manifold_record.h"
#include "contact_geometry.h"
#include "collide_pairs.h"
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

/// The routine for the two shapes; A has the kind that comes first. Only the routines of shapes that the scene names are linked.
/// False for a pair that has none. before: of the last step, or null.
template <class Shapes>
bool collide_pair(const PlacedShape& A, const PlacedShape& B, const Margin& margin, Manifold& manifold, const Manifold* before) {
#define INGOT_PAIR(a, b)                                                             \
    if constexpr (Shapes::has(ShapeKind::a) && Shapes::has(ShapeKind::b))            \
        if (A.shape.kind == ShapeKind::a && B.shape.kind == ShapeKind::b) return collide_##a##_##b(A, B, margin, manifold, before), true
    INGOT_PAIR(sphere, sphere);
    INGOT_PAIR(sphere, capsule);
    INGOT_PAIR(sphere, box);
    INGOT_PAIR(sphere, cylinder);
    INGOT_PAIR(sphere, hull);
    INGOT_PAIR(sphere, half_space);
    INGOT_PAIR(capsule, capsule);
    INGOT_PAIR(capsule, box);
    INGOT_PAIR(capsule, cylinder);
    INGOT_PAIR(capsule, hull);
    INGOT_PAIR(capsule, half_space);
    INGOT_PAIR(box, box);
    INGOT_PAIR(box, cylinder);
    INGOT_PAIR(box, hull);
    INGOT_PAIR(box, half_space);
    INGOT_PAIR(cylinder, cylinder);
    INGOT_PAIR(cylinder, hull);
    INGOT_PAIR(cylinder, half_space);
    INGOT_PAIR(hull, hull);
    INGOT_PAIR(hull, half_space);
#undef INGOT_PAIR
    return false;
}

/// The same, and no points for a pair that has no routine.
template <class Shapes>
bool collide_shapes(const PlacedShape& A, const PlacedShape& B, const Margin& margin, Manifold& manifold, const Manifold& before) {
    manifold.n = {};
    manifold.count = 0;
    return collide_pair<Shapes>(A, B, margin, manifold, &before);
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
template <class Shapes>
bool collide_placed(const PlacedShape& A, const PlacedShape& B, const Margin& margin, const Manifold& before, Manifold& manifold) {
    if (!(B.shape.kind < A.shape.kind)) return collide_shapes<Shapes>(A, B, margin, manifold, before);
    Manifold seen = before;
    seen.n = -seen.n;
    const bool tested = collide_shapes<Shapes>(B, A, margin, manifold, seen);
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
    return collide_placed<Shapes>(placed_body<Shapes>(bodies, surfaces, pair.body_A), placed_body<Shapes>(bodies, surfaces, pair.body_B), margin,
                                  before, manifold);
}

inline constexpr Manifold no_manifold_before = {};

/// True where the shapes of a pair overlap or touch.
template <class Shapes>
bool shapes_overlap(const BodyView& bodies, const SurfaceView& surfaces, const BodyPair& pair) {
    Manifold found_now;
    return find_manifold<Shapes>(bodies, surfaces, pair, 0, no_manifold_before, found_now) && found_now.count != 0;
}

/// What was found, and zero where it has no point: equal worlds are equal bytes, and a snapshot holds nothing of the stack.
INGOT_INLINE void keep_manifold(const Manifold& found, Manifold& kept) {
    kept.n = found.n;
    kept.count = found.count;
    kept.halvings = found.halvings;
    for (int point_i = 0; point_i < Manifold::points_max; ++point_i) {
        const ManifoldPoint point = point_i < found.count ? found.points[point_i] : ManifoldPoint{};
        kept.points[point_i].P = point.P;  // by members: with doubles a point has a gap, which would take bytes of the stack along
        kept.points[point_i].separation = point.separation;
        kept.points[point_i].feature = point.feature;
    }
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

/// Manifolds of all pairs of the last search, those of the step before renewed; manifolds.pairs are those that touch.
///
/// Pairs that the rules of the scene keep apart have none: see pair_rules.h.
/// Pairs with a fast body touch or have none.
/// Full: what finds no record is refused_record, and counted in contacts_lost; who it is to be is then chosen anew: see crowded_manifolds.h.
template <class Shapes, bool renews, class Rules, class FastPairs = NoFastPairs>
void update_manifolds(const BodyView& bodies, const SurfaceView& surfaces, const BoundsTile* bounds, scalar h, const Rules& rules,
                      const PairList& found, const ManifoldView& manifolds, StepReport& report, const FastPairs& fast_pairs = {}) {
    *manifolds.count = 0;
    // bound: max_pairs and the pairs of shapes of one body: pairs_with_own of scene.h
    for (int pair_i = 0; pair_i < *found.count; ++pair_i) {
        BodyPair& pair = found.pairs[pair_i];
        const bool has_record = pair.record != no_record;
        const auto overlap = [&] { return shapes_overlap<Shapes>(bodies, surfaces, pair); };
        if (rules.keeps(pair)) {
            if (has_record)
                manifolds.pairs[(*manifolds.count)++] = pair;
            else if (bounds_overlap(bounds, pair.body_A, pair.body_B))
                (void)rules.may_touch(pair, overlap);  // a sensor notes who is in it
            continue;
        }
        if (!bounds_overlap(bounds, pair.body_A, pair.body_B) || !rules.may_touch(pair, overlap)) {
            if (has_record) give_back(manifolds, pair.record);
            continue;
        }
        const bool fast = fast_pairs.has(pair);
        const scalar margin = fast ? margin_of_fast(bodies, surfaces, pair) : margin_of(bodies, surfaces, bounds, pair, h);
        if constexpr (renews) {
            if (has_record && !fast && !is_led(fast_pairs, pair) &&
                renew_manifold<Shapes>(bodies, surfaces, pair, margin, manifolds.anchors[pair.record], manifolds.records[pair.record].manifold)) {
                manifolds.pairs[(*manifolds.count)++] = pair;
                continue;
            }
        }
        Manifold found_now;
        found_now.halvings = static_cast<uint16_t>(surfaces.halvings(pair.body_A, pair.body_B));
        const Manifold& before = has_record ? manifolds.records[pair.record].manifold : no_manifold_before;
        const Margin search = {margin, limits::fast_margin * scale_of(surfaces.unit, found_now.halvings)};
        if (!find_manifold<Shapes>(bodies, surfaces, pair, search, before, found_now)) count(report.pairs_untested);
        if constexpr (FastPairs::leads_figures)
            if (!fast && fast_pairs.leads(pair)) fast_pairs.template find_on_way<Shapes>(pair, surfaces, found_now);
        if (found_now.count == 0) {
            if (has_record) give_back(manifolds, pair.record);
            continue;
        }
        if (!has_record) pair.record = take_record(manifolds);
        if (pair.record == no_record) {
            count(report.contacts_lost);
            pair.record = refused_record;
            continue;
        }
        ManifoldRecord& record = manifolds.records[pair.record];
        if (has_record)
            carry_impulses(record, found_now);
        else
            mix_materials(surfaces, pair, record);
        keep_manifold(found_now, record.manifold);
        if (renews && worth_renewing(surfaces.surfaces[pair.body_A], surfaces.surfaces[pair.body_B]))
            anchor(frame_of(bodies, pair.body_A), frame_of(bodies, pair.body_B), found_now, margin, manifolds.anchors[pair.record]);
        manifolds.pairs[(*manifolds.count)++] = pair;
    }
    count(report.contacts_lost, *found.lost);
}

} }  // namespace ingot

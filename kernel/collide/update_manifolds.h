// SPDX-License-Identifier: MIT
// From pairs that may touch to manifolds. The only file that names the routines of the narrow phase.
#pragma once

#include "../base/limits.h"
#include "../base/report.h"
#include "../math/sqrt.h"
#include "manifold_record.h"
#include "narrow_phase.h"
#include "recycle.h"

namespace ingot { inline namespace INGOT_ABI {

INGOT_INLINE PlacedShape placed_shape(const BodyView& bodies, const SurfaceView& surfaces, int slot) {
    const Place at = place_of(slot);
    return {surfaces.surfaces[slot].shape, lane_of(bodies.translation[at.tile].r_CM, at.lane),
            lane_of(bodies.rotation[at.tile].A, at.lane), nullptr};
}

/// How far apart two bodies may be and still have a manifold: what they can travel towards each other in the step, and a little.
INGOT_INLINE scalar margin_of(const BodyView& bodies, const SurfaceView& surfaces, const BodyPair& pair, scalar h) {
    const Place A = place_of(pair.body_A), B = place_of(pair.body_B);
    const auto spin = [&](const Place& at, int slot) {
        const scalar turn = sqrt(length_sq(lane_of(bodies.rotation[at.tile].omega, at.lane))) * h;
        return (turn < 2 ? turn : scalar(2)) * surfaces.surfaces[slot].bounding_radius;
    };
    const Vector v = lane_of(bodies.translation[A.tile].v_CM, A.lane) - lane_of(bodies.translation[B.tile].v_CM, B.lane);
    return limits::contact_margin + sqrt(length_sq(v)) * h + spin(A, pair.body_A) + spin(B, pair.body_B);
}

/// The routine for the two shapes; A has the kind that comes first. Only the routines of shapes that the scene names are linked.
template <class Shapes>
void collide_shapes(const PlacedShape& A, const PlacedShape& B, scalar margin, Manifold& manifold, const Manifold& before) {
#define INGOT_PAIR(a, b)                                                             \
    if constexpr (Shapes::has(ShapeKind::a) && Shapes::has(ShapeKind::b))            \
        if (A.shape.kind == ShapeKind::a && B.shape.kind == ShapeKind::b) return collide_##a##_##b(A, B, margin, manifold, &before)
    INGOT_PAIR(sphere, sphere);
    INGOT_PAIR(sphere, capsule);
    INGOT_PAIR(sphere, box);
    INGOT_PAIR(sphere, cylinder);
    INGOT_PAIR(sphere, half_space);
    INGOT_PAIR(capsule, capsule);
    INGOT_PAIR(capsule, box);
    INGOT_PAIR(capsule, half_space);
    INGOT_PAIR(box, box);
    INGOT_PAIR(box, half_space);
#undef INGOT_PAIR
}

/// The furthest that points may have slipped for a manifold to be renewed from its anchors; 0 where a new search costs no more.
INGOT_INLINE scalar slip_allowed(const Surface& A, const Surface& B) {
    if (A.shape.kind == ShapeKind::sphere || B.shape.kind == ShapeKind::sphere) return 0;
    const scalar R_A = A.bounding_radius, R_B = B.bounding_radius;
    const scalar R = R_A == 0 ? R_B : R_B == 0 || R_A < R_B ? R_A : R_B;
    return limits::recycled_slip * R;
}

/// The manifold of a pair, renewed or found, in the order of the slots.
template <class Shapes>
void update_manifold(const BodyView& bodies, const SurfaceView& surfaces, const BodyPair& pair, scalar margin, ManifoldAnchors* anchors,
                     const Manifold& before, Manifold& manifold) {
    const Surface &surface_A = surfaces.surfaces[pair.body_A], &surface_B = surfaces.surfaces[pair.body_B];
    const PlacedShape A = placed_shape(bodies, surfaces, pair.body_A), B = placed_shape(bodies, surfaces, pair.body_B);
    const scalar slip = anchors != nullptr ? slip_allowed(surface_A, surface_B) : 0;
    manifold = before;
    if (before.count > 0 && slip > 0 && renew_from_anchors(A, B, slip, margin, *anchors, manifold)) return;

    const bool swap = surface_B.shape.kind < surface_A.shape.kind;
    Manifold seen = before;
    if (swap) seen.n = -seen.n;
    collide_shapes<Shapes>(swap ? B : A, swap ? A : B, margin, manifold, seen);
    if (swap) manifold.n = -manifold.n;
    if (slip > 0) anchor(A, B, manifold, margin, *anchors);
}

/// Manifolds of all found pairs, those of the step before renewed. Pairs that do not touch are let go.
///
/// Full: contacts that are held stay, new ones are refused in the order of slots, and counted in contacts_lost.
template <class Shapes>
void update_manifolds(const BodyView& bodies, const SurfaceView& surfaces, scalar h, PairSink& found, const ManifoldView& manifolds,
                      StepReport& report) {
    hold_records(manifolds, found);
    for (int pair_i = 0; pair_i < found.count; ++pair_i) {
        BodyPair pair = found.pairs[pair_i];
        const bool held = pair.record != no_record;
        if (!held) pair.record = take_record(manifolds);
        if (pair.record == no_record) {
            count(report.contacts_lost);
            continue;
        }
        ManifoldRecord& record = manifolds.records[pair.record];
        ManifoldAnchors* const anchors = manifolds.anchors != nullptr ? &manifolds.anchors[pair.record] : nullptr;
        const Manifold before = record.manifold;
        update_manifold<Shapes>(bodies, surfaces, pair, margin_of(bodies, surfaces, pair, h), anchors, before, record.manifold);
        if (record.manifold.count == 0) {
            give_back(manifolds, pair.record);
            continue;
        }
        const Surface &A = surfaces.surfaces[pair.body_A], &B = surfaces.surfaces[pair.body_B];
        record.e = A.e > B.e ? A.e : B.e;
        record.mu = sqrt(A.mu * B.mu);
        if (held) carry_impulses(record, before);
        manifolds.pairs[(*manifolds.count)++] = pair;
    }
    count(report.contacts, *manifolds.count);
    count(report.contacts_lost, found.lost);
}

} }  // namespace ingot

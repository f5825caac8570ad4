// SPDX-License-Identifier: MIT
// From pairs that may touch to manifolds. The only file that names the routines of the narrow phase.
#pragma once

#include "../base/limits.h"
#include "../base/report.h"
#include "../math/sqrt.h"
#include "manifold_record.h"
#include "narrow_phase.h"

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

/// Manifolds of all found pairs, those of the step before renewed. Pairs that do not touch are let go.
///
/// Full: contacts that are held stay, new ones are refused in the order of slots, and counted in contacts_lost.
template <class Shapes>
void update_manifolds(const BodyView& bodies, const SurfaceView& surfaces, scalar h, PairSink& found, const ManifoldView& manifolds,
                      StepReport& report) {
    hold_records(manifolds, found);
    for (int pair_i = 0; pair_i < found.count; ++pair_i) {
        BodyPair pair = found.pairs[pair_i];
        const Surface &surface_A = surfaces.surfaces[pair.body_A], &surface_B = surfaces.surfaces[pair.body_B];
        const bool swap = surface_B.shape.kind < surface_A.shape.kind;
        const PlacedShape A = placed_shape(bodies, surfaces, swap ? pair.body_B : pair.body_A);
        const PlacedShape B = placed_shape(bodies, surfaces, swap ? pair.body_A : pair.body_B);

        Manifold before{}, manifold{};
        if (pair.record != no_record) before = manifolds.records[pair.record].manifold;
        if (swap) before.n = -before.n;
        collide_shapes<Shapes>(A, B, margin_of(bodies, surfaces, pair, h), manifold, before);
        if (swap) manifold.n = -manifold.n;
        if (manifold.count == 0) {
            if (pair.record != no_record) give_back(manifolds, pair.record);
            continue;
        }
        if (pair.record == no_record) pair.record = take_record(manifolds);
        if (pair.record == no_record) {
            count(report.contacts_lost);
            continue;
        }
        ManifoldRecord& record = manifolds.records[pair.record];
        record.manifold = manifold;
        carry_impulses(record, before);
        record.e = surface_A.e > surface_B.e ? surface_A.e : surface_B.e;
        record.mu = sqrt(surface_A.mu * surface_B.mu);
        manifolds.pairs[(*manifolds.count)++] = pair;
    }
    count(report.contacts, *manifolds.count);
    count(report.contacts_lost, found.lost);
}

} }  // namespace ingot

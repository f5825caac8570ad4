// SPDX-License-Identifier: MIT
// All pairs of bodies, each tested by the routine of its two shapes.
#pragma once

#include "../base/report.h"
#include "bounds.h"
#include "collide_manifolds.h"
#include "find_contacts.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where manifolds of the step go.
struct ManifoldSink {
    ContactManifold* manifolds;
    uint16_t* count;
    int capacity;
};

/// How far apart two bodies may be and still have a manifold: what they can travel towards each other in the step, and a little.
INGOT_INLINE scalar margin_of(const BodyView& bodies, const SurfaceView& surfaces, int slot_A, int slot_B, scalar h) {
    const Place A = place_of(slot_A), B = place_of(slot_B);
    const Vector v = lane_of(bodies.translation[A.tile].v_CM, A.lane) - lane_of(bodies.translation[B.tile].v_CM, B.lane);
    const scalar spin_A = sqrt(length_sq(lane_of(bodies.rotation[A.tile].omega, A.lane))) * surfaces.surfaces[slot_A].bounding_radius;
    const scalar spin_B = sqrt(length_sq(lane_of(bodies.rotation[B.tile].omega, B.lane))) * surfaces.surfaces[slot_B].bounding_radius;
    return limits::contact_margin + (sqrt(length_sq(v)) + spin_A + spin_B) * h;
}

/// The routine for the two shapes. Pairs without a routine count in pairs_untested.
template <class Shapes>
void collide_pair(const Placed& A, const Placed& B, scalar margin, Manifold& manifold, StepReport& report) {
    [[maybe_unused]] const auto are = [&](ShapeKind a, ShapeKind b) { return A.shape.kind == a && B.shape.kind == b; };
    if constexpr (Shapes::has(ShapeKind::sphere))
        if (are(ShapeKind::sphere, ShapeKind::sphere)) return collide_sphere_sphere(A, B, margin, manifold);
    if constexpr (Shapes::has(ShapeKind::sphere) && Shapes::has(ShapeKind::half_space))
        if (are(ShapeKind::sphere, ShapeKind::half_space)) return collide_sphere_half_space(A, B, margin, manifold);
    if constexpr (Shapes::has(ShapeKind::box) && Shapes::has(ShapeKind::half_space))
        if (are(ShapeKind::box, ShapeKind::half_space)) return collide_box_half_space(A, B, margin, manifold);
    if constexpr (Shapes::has(ShapeKind::box))
        if (are(ShapeKind::box, ShapeKind::box)) return collide_box_box(A, B, margin, manifold);
    if constexpr (Shapes::has(ShapeKind::sphere) && Shapes::has(ShapeKind::box))
        if (are(ShapeKind::sphere, ShapeKind::box)) return collide_sphere_box(A, B, margin, manifold);
    count(report.pairs_untested);
}

/// Fills the manifolds of the step, in the order of the slots: A has the lower one. Two bodies that cannot move do not touch.
template <class Shapes>
void find_manifolds(const BodyView& bodies, const SurfaceView& surfaces, scalar h, const ManifoldSink& sink, StepReport& report) {
    *sink.count = 0;
    for (int slot_A = 0; slot_A < surfaces.slot_count; ++slot_A) {
        if (surfaces.surfaces[slot_A].shape.kind == ShapeKind::none) continue;
        for (int slot_B = slot_A + 1; slot_B < surfaces.slot_count; ++slot_B) {
            if (surfaces.surfaces[slot_B].shape.kind == ShapeKind::none) continue;
            const scalar margin = margin_of(bodies, surfaces, slot_A, slot_B, h);
            if (!may_touch(bodies, surfaces, slot_A, slot_B, margin)) continue;
            const Placed A = placed(bodies, surfaces, slot_A), B = placed(bodies, surfaces, slot_B);
            const bool swap = B.shape.kind < A.shape.kind;  // routines know one order of kinds
            Manifold manifold{};
            collide_pair<Shapes>(swap ? B : A, swap ? A : B, margin, manifold, report);
            if (manifold.count == 0) continue;
            if (*sink.count == sink.capacity) {
                count(report.contacts_lost);
                continue;
            }
            if (swap) manifold.n = -manifold.n;
            const scalar e_A = surfaces.surfaces[slot_A].e, e_B = surfaces.surfaces[slot_B].e;
            const scalar mu = sqrt(surfaces.surfaces[slot_A].mu * surfaces.surfaces[slot_B].mu);
            sink.manifolds[(*sink.count)++] = {static_cast<uint16_t>(slot_A), static_cast<uint16_t>(slot_B), manifold, e_A > e_B ? e_A : e_B, mu};
        }
    }
    report.contacts = *sink.count;
}

} }  // namespace ingot

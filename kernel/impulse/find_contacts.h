// SPDX-License-Identifier: MIT
// All pairs of bodies, each tested by the routine of its two shapes. The only file that names the collide_* routines.
#pragma once

#include "../base/report.h"
#include "../body/body_tiles.h"
#include "../shape/surface.h"
#include "collide_shapes.h"

namespace ingot { inline namespace INGOT_ABI {

/// The routine for the two shapes; a half space is always B. Pairs without a routine count in pairs_untested.
template <class Shapes>
void collide_pair(const Placed& A, const Placed& B, ContactSink& sink, StepReport& report) {
    [[maybe_unused]] const auto are = [&](ShapeKind a, ShapeKind b) { return A.shape.kind == a && B.shape.kind == b; };
    if constexpr (Shapes::has(ShapeKind::sphere))
        if (are(ShapeKind::sphere, ShapeKind::sphere)) return collide_sphere_sphere(A, B, sink);
    if constexpr (Shapes::has(ShapeKind::sphere) && Shapes::has(ShapeKind::half_space))
        if (are(ShapeKind::sphere, ShapeKind::half_space)) return collide_sphere_half_space(A, B, sink);
    if constexpr (Shapes::has(ShapeKind::box) && Shapes::has(ShapeKind::half_space))
        if (are(ShapeKind::box, ShapeKind::half_space)) return collide_box_half_space(A, B, sink);
    count(report.pairs_untested);
}

/// Fills the contacts of the step, pair by pair in the order of the slots. Two bodies that cannot move do not touch.
///
/// Full: contacts with what cannot move are kept first, then the deepest; what is dropped counts in contacts_lost.
/// Cost: bodies (bodies - 1) / 2 tests of bounding spheres.
template <class Shapes>
void find_contacts(const BodyView& bodies, const SurfaceView& surfaces, const ContactView& contacts, StepReport& report) {
    *contacts.count = 0;
    for (int slot_A = 0; slot_A < surfaces.slot_count; ++slot_A) {  // bound: max_bodies
        // bound: max_bodies: next_touchable returns no less than what it is given
        for (int slot_B = next_touchable(bodies, surfaces, slot_A, slot_A + 1); slot_B < surfaces.slot_count;
             slot_B = next_touchable(bodies, surfaces, slot_A, slot_B + 1)) {
            const bool swap = surfaces.surfaces[slot_A].shape.kind == ShapeKind::half_space;
            const int first = swap ? slot_B : slot_A, second = swap ? slot_A : slot_B;
            const scalar e_A = surfaces.surfaces[first].e, e_B = surfaces.surfaces[second].e;
            ContactSink sink{contacts, first, second, e_A > e_B ? e_A : e_B, &report.contacts_lost, &bodies};
            collide_pair<Shapes>(placed(bodies, surfaces, first), placed(bodies, surfaces, second), sink, report);
        }
    }
    report.contacts = *contacts.count;
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// All pairs of bodies, each tested by the routine of its two shapes. The only file that names the collide_* routines.
#pragma once

#include "../base/report.h"
#include "impact_step.h"

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

/// Contacts of two slots that touch at the time `now` of the step, or meet after it. is_again: see ContactSink.
template <class Shapes>
void find_contact(const ImpactStep& step, const ContactView& contacts, int slot_A, int slot_B, scalar now, bool is_again, StepReport& report) {
    ContactSink sink = sink_of(step, contacts, slot_A, slot_B, now, is_again, report);
    const auto place = [&](int slot) {
        if constexpr (Shapes::has(ShapeKind::box)) return turning_at(step, slot, now);
        return placed_at(step, slot, now);
    };
    collide_pair<Shapes>(place(sink.slot_A), place(sink.slot_B), sink, report);
}

/// Fills the contacts of the step, pair by pair in the order of the slots: of what touches, and of what meets in the step as it flies now. Two bodies
/// that cannot move do not touch.
///
/// Full: contacts with what cannot move are kept first, then the deepest; what is dropped counts in contacts_lost.
/// Cost: bodies (bodies - 1) / 2 tests of bounding spheres.
template <class Shapes>
void find_contacts(const ImpactStep& step, const ContactView& contacts, StepReport& report) {
    *contacts.count = 0;
    const SurfaceView& surfaces = step.surfaces;
    for (int slot_A = 0; slot_A < surfaces.slot_count; ++slot_A)  // bound: max_bodies
        // bound: max_bodies: next_touchable returns no less than what it is given
        for (int slot_B = next_touchable(step.bodies, surfaces, step.ways, slot_A, slot_A + 1); slot_B < surfaces.slot_count;
             slot_B = next_touchable(step.bodies, surfaces, step.ways, slot_A, slot_B + 1))
            find_contact<Shapes>(step, contacts, slot_A, slot_B, 0, false, report);
}

} }  // namespace ingot

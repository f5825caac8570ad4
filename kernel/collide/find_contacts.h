// SPDX-License-Identifier: MIT
// All pairs of bodies, each tested by the routine of its two shapes. The only file that names the collide_* routines.
#pragma once

#include "../base/report.h"
#include "../body/body_tiles.h"
#include "collide_shapes.h"
#include "shapes.h"

namespace ingot { inline namespace INGOT_ABI {

/// Shape and material of each body slot; kind `none` where no body lives.
struct Surface {
    Shape shape;
    scalar bounding_radius;  ///< m
    scalar e;                ///< restitution 0 .. 1; of a pair the larger counts
};

struct SurfaceView {
    const Surface* surfaces;
    int slot_count;
};

/// One body as the collide_* routines see it.
INGOT_INLINE Placed placed(const BodyView& bodies, const SurfaceView& surfaces, int slot) {
    const Place at = place_of(slot);
    return {static_cast<uint16_t>(slot), surfaces.surfaces[slot].shape, lane_of(bodies.translation[at.tile].r_CM, at.lane),
            lane_of(bodies.rotation[at.tile].A, at.lane)};
}

/// Fills the contacts of the step, pair by pair in the order of the slots. Two bodies that cannot move do not touch.
///
/// Full: a contact deeper than the shallowest one kept takes its place; what is dropped counts in contacts_lost.
/// Cost: bodies (bodies - 1) / 2 tests of bounding spheres.
template <class Shapes>
void find_contacts(const BodyView& bodies, const SurfaceView& surfaces, const ContactView& contacts, StepReport& report) {
    *contacts.count = 0;
    const auto can_move = [&](int slot) { return bodies.translation[place_of(slot).tile].inv_M[place_of(slot).lane] > 0; };
    const auto kind = [&](int slot) { return surfaces.surfaces[slot].shape.kind; };

    for (int slot_A = 0; slot_A < surfaces.slot_count; ++slot_A) {
        if (kind(slot_A) == ShapeKind::none) continue;
        for (int slot_B = slot_A + 1; slot_B < surfaces.slot_count; ++slot_B) {
            if (kind(slot_B) == ShapeKind::none || !(can_move(slot_A) || can_move(slot_B))) continue;
            const bool swap = kind(slot_A) == ShapeKind::half_space;  // the half space is always B
            const int first = swap ? slot_B : slot_A, second = swap ? slot_A : slot_B;
            const Surface &a = surfaces.surfaces[first], &b = surfaces.surfaces[second];

            const Placed A = placed(bodies, surfaces, first), B = placed(bodies, surfaces, second);
            if (!bounds_overlap(A, a.bounding_radius, B, b.bounding_radius)) continue;
            ContactSink sink{contacts, first, second, a.e > b.e ? a.e : b.e, &report.contacts_lost};
            if (a.shape.kind == ShapeKind::sphere && b.shape.kind == ShapeKind::sphere) {
                if constexpr (Shapes::has(ShapeKind::sphere)) collide_sphere_sphere(A, B, sink);
            } else if (a.shape.kind == ShapeKind::sphere && b.shape.kind == ShapeKind::half_space) {
                if constexpr (Shapes::has(ShapeKind::sphere) && Shapes::has(ShapeKind::half_space))
                    collide_sphere_half_space(A, B, sink);
            } else if (a.shape.kind == ShapeKind::box && b.shape.kind == ShapeKind::half_space) {
                if constexpr (Shapes::has(ShapeKind::box) && Shapes::has(ShapeKind::half_space))
                    collide_box_half_space(A, B, sink);
            } else {
                ++report.pairs_untested;
            }
        }
    }
    report.contacts = *contacts.count;
}

} }  // namespace ingot

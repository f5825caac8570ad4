// SPDX-License-Identifier: MIT
// Tests of pairs of shapes. Each adds the points where A and B overlap or touch, with n from B to A.
#pragma once

#include "../body/body_tiles.h"
#include "../shape/surface.h"
#include "contact.h"

namespace ingot { inline namespace INGOT_ABI {

/// A shape and where it is.
struct Placed {
    Shape shape;
    Vector r_CM;
    Matrix A;
};

/// One body as the collide_* routines see it.
INGOT_INLINE Placed placed(const BodyView& bodies, const SurfaceView& surfaces, int slot) {
    const Place at = place_of(slot);
    return {surfaces.surfaces[slot].shape, lane_of(bodies.translation[at.tile].r_CM, at.lane),
            lane_of(bodies.rotation[at.tile].A, at.lane)};
}

/// Where the routines put what they find. When the array is full it keeps contacts with what cannot move, then the deepest.
struct ContactSink {
    ContactView contacts;
    int slot_A, slot_B;
    scalar e;
    Index* lost;
    const BodyView* bodies = nullptr;  ///< who cannot move; null: depth alone counts

    void add(const Vector& n, const Vector& lever_A, const Vector& lever_B, scalar separation);
};

/// Centres at one place, to the rounding of the radii, have no normal: the x axis of the world is taken.
void collide_sphere_sphere(const Placed& A, const Placed& B, ContactSink& sink);
void collide_sphere_half_space(const Placed& A, const Placed& B, ContactSink& sink);
/// Up to eight points: the corners of A that are not above the face of B by more than limits::flatness.
void collide_box_half_space(const Placed& A, const Placed& B, ContactSink& sink);

} }  // namespace ingot

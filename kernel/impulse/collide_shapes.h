// SPDX-License-Identifier: MIT
// Tests of pairs of shapes. Each adds the points where A and B overlap or touch, with n from B to A.
#pragma once

#include "../body/body_tiles.h"
#include "../shape/surface.h"
#include "contact.h"

namespace ingot { inline namespace INGOT_ABI {

/// A shape, where it is, and how it flies from there: on a parabola. Of a box omega turns the corners.
struct Placed {
    Shape shape;
    Vector r_CM;
    Matrix A;
    Vector v{}, a{}, omega{};  ///< m/s, m s^-2, rad/s
};

/// One body as the collide_* routines see it, standing.
INGOT_INLINE Placed placed(const BodyView& bodies, const SurfaceView& surfaces, int slot) {
    const Place at = place_of(slot);
    return {surfaces.surfaces[slot].shape, lane_of(bodies.translation[at.tile].r_CM, at.lane),
            lane_of(bodies.rotation[at.tile].A, at.lane)};
}

/// Where a contact of the array stands, or is to stand.
struct ContactPlace {
    int index;
    bool is_known;
    scalar tolerance;  ///< m/s, of what there is of the pair
};

/// m/s; corners that a force with this acceleration, m s^-2, brings back within the time `together`, s, have not left. Else what a solve leaves of
/// their speeds would make a tall box rock.
INGOT_INLINE scalar corners_still(scalar acceleration, scalar together) { return -acceleration * together / 2; }

/// Where the routines put what they find. When the array is full it keeps contacts with what cannot move, then the deepest.
struct ContactSink {
    ContactView contacts;
    int slot_A, slot_B;
    scalar e;
    Index* lost;
    const BodyView* bodies = nullptr;  ///< who cannot move; null: depth alone counts
    scalar now = 0;                    ///< s, from the begin of the step to where the shapes are
    scalar rest = 0;                   ///< s, of the step from there
    scalar slow = scalar_max;          ///< m/s; what touches and approaches no faster has met already, and so has what leaves no faster than
    scalar still = scalar_max;         ///< m/s, this
    scalar together = 0;               ///< s; corners of a box that come no later after the first come with it, and stay if they are back by then
    bool is_again = false;             ///< some of its contacts may be there already

    /// Of a corner of the two bodies, found again; else behind their others, or beyond the last.
    ContactPlace find(const Vector& n, int corner) const;
    /// A contact of a pair that has others stands behind them.
    void make_room(int index) const;
    /// when: s from `now`.
    void add(ContactPlace place, const Vector& n, const Vector& lever_A, const Vector& lever_B, scalar separation, scalar when, int corner);
};

/// They meet where they touch already, or within the rest of the step: then the contact is as it will be. What touches and is fast meets when it is
/// all the way there; what leaves, when it comes back.
/// Centres at one place, to the rounding of the radii, have no normal: the x axis of the world is taken.
void collide_sphere_sphere(const Placed& A, const Placed& B, ContactSink& sink);
void collide_sphere_half_space(const Placed& A, const Placed& B, ContactSink& sink);
/// Up to eight points: the corners of A that are not above the face of B by more than limits::flatness, and those that will come.
void collide_box_half_space(const Placed& A, const Placed& B, ContactSink& sink);

} }  // namespace ingot

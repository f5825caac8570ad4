// SPDX-License-Identifier: MIT
// Tests of pairs of shapes. Each adds the points where A and B overlap, touch, or meet in the rest of the step, with n from B to A.
#pragma once

#include "../body/body_tiles.h"
#include "../shape/surface.h"
#include "contact.h"

namespace ingot { inline namespace INGOT_ABI {

/// A shape, where it is, and how it flies on: on a parabola. The corners of a box turn by omega.
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

/// m/s; corners that leave no faster have not left, as this acceleration, m s^-2, brings them back within `together`, s. Else what a solve leaves of
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
    scalar slow = scalar_max;          ///< m/s; what touches and approaches no faster has met already
    scalar still = scalar_max;         ///< m/s; what touches and leaves no faster has met already
    scalar together = 0;               ///< s; corners of a box that come no later after the first come with it: see corners_still too
    bool is_again = false;             ///< some of its contacts may be there already

    /// The place of the contact of this corner, if it is there; else behind the others of the two bodies, or behind all.
    ContactPlace find(const Vector& n, int corner) const;
    /// when: s from `now`.
    void add(ContactPlace place, const Vector& n, const Vector& lever_A, const Vector& lever_B, scalar separation, scalar when, int corner);

private:
    /// Moves the contacts from a place on, for one more of a pair that has others.
    void make_room(int index) const;
};

/// The contact of two that touch, or that meet within the rest of the step; then it is as it will be. What touches and is fast meets once the gap is
/// closed; what leaves meets when it comes back.
/// Centres at one place, to the rounding of the radii, have no normal: the x axis of the world is taken.
void collide_sphere_sphere(const Placed& A, const Placed& B, ContactSink& sink);
void collide_sphere_half_space(const Placed& A, const Placed& B, ContactSink& sink);
/// Up to eight points: the corners of A that are not above the face of B by more than limits::flatness, and those that will come.
void collide_box_half_space(const Placed& A, const Placed& B, ContactSink& sink);

} }  // namespace ingot

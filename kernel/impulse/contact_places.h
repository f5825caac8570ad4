// SPDX-License-Identifier: MIT
// Where impacts without friction take place: for who reads them.
#pragma once

#include "collide_shapes.h"

namespace ingot { inline namespace INGOT_ABI {

/// The point of a contact half-way between the two surfaces, m, world: a sphere's on the way to what it touches, a box's at its corner, which is
/// r_CM + n x (r x n) and along n where the face of the half space is.
/// Needs: bodies where they were when the contact was found.
inline Vector place_of_contact(const Contact& c, const BodyView& bodies, const SurfaceView& surfaces) {
    const Placed A = placed(bodies, surfaces, c.body_A);
    if (A.shape.kind == ShapeKind::sphere) return A.r_CM - c.n * (A.shape.size.x + c.separation / 2);
    const Placed B = placed(bodies, surfaces, c.body_B);
    const scalar height = dot(c.n, A.r_CM - B.r_CM) - B.shape.offset;  // of the centre over the face
    return A.r_CM + cross(c.n, c.lever_A) + c.n * (c.separation / 2 - height);
}
inline void note_places(const ContactView& contacts, const BodyView& bodies, const SurfaceView& surfaces, Vector* places) {
    for (int contact_i = 0; contact_i < *contacts.count; ++contact_i)  // bound: max_contacts
        places[contact_i] = place_of_contact(contacts.contacts[contact_i], bodies, surfaces);
}

} }  // namespace ingot

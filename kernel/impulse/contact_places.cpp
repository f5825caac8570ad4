// SPDX-License-Identifier: MIT
#include "impact_times.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// The point of a contact half-way between the two surfaces, m, world: a sphere's on the way to what it touches, a box's at its corner, which is
/// r_CM + n x (r x n) and along n where the face of the half space is.
Vector place_of_contact(const Contact& c, const Placed& A, const Placed& B) {
    if (A.shape.kind == ShapeKind::sphere) return A.r_CM - c.n * (A.shape.size.x + c.separation / 2);
    const scalar height = dot(c.n, A.r_CM - B.r_CM) - B.shape.offset;  // of the centre over the face
    return A.r_CM + cross(c.n, c.lever_A) + c.n * (c.separation / 2 - height);
}

}  // namespace

void note_new_places(const ImpactStep& step, const ContactView& contacts) {
    for (int contact_i = 0; contact_i < *contacts.count; ++contact_i) {  // bound: max_contacts
        const Contact& c = contacts.contacts[contact_i];
        if (c.is_new) contacts.places[contact_i] = place_of_contact(c, placed_at(step, c.body_A, c.when), placed_at(step, c.body_B, c.when));
    }
}

} }  // namespace ingot

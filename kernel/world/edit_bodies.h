// SPDX-License-Identifier: MIT
// What World does to one body, on views: shared by worlds of every scene. Each call checks all before it writes any.
#pragma once

#include "../body/body_tiles.h"
#include "../body/check_body.h"
#include "../shape/surface.h"
#include "../shape/compound.h"
#include "body_def.h"

namespace ingot { inline namespace INGOT_ABI {

/// Everything about a definition that does not depend on the scene's capacity.
Status check_definition(const BodyDef& def, bool scene_translates, bool scene_has_shape);
/// Shape and restitution, for scenes that have surfaces.
Status check_surface(const BodyDef& def);

// Bodies of several shapes: see shape/compound.h.

/// Where the user's frame lies in the body's. Errors: not_finite, out_of_range, not_a_rotation.
Status check_mass_frame(const MassProperties& mass);
/// Errors: bad_shape (none), not_finite, out_of_range, not_a_rotation.
Status check_place(const ShapeDef& part, const MassProperties& mass);
/// The definition of a body that has this shape alone.
BodyDef with_shape(const BodyDef& def, const ShapeDef& part);
/// Of the ball about the centre of mass that holds the shape, m; 0 for a half space.
scalar radius_about_body(const Shape& shape, const ShapePlace& place);

/// Number by number: what lies between them in memory stays zero, so that equal worlds are equal bytes.
void write_surface(Surface& to, const BodyDef& def);
/// Writes a checked definition into a slot.
void write_body(const BodyView& bodies, int slot, const BodyDef& def);

/// For a body that can move: v_CM and omega stay. Errors: frozen, immovable, those of check_mass_properties.
Status write_mass(const BodyView& bodies, int slot, const MassProperties& mass);
/// Checked ones, of a body at rest.
INGOT_INLINE void write_moments(const BodyView& bodies, int slot, const MassProperties& mass) {
    const Place at = place_of(slot);
    const ScaledInverseInertia inverse = scaled_inverse_inertia(mass.I_body);
    set_lane(bodies.rotation[at.tile].inv_I_ratio, at.lane, inverse.ratio);
    bodies.rotation[at.tile].inv_I_scale[at.lane] = inverse.scale;
    if (bodies.translation != nullptr) bodies.translation[at.tile].inv_M[at.lane] = 1 / mass.M;
}
/// Its principal moments, kg m^2; 0 where it cannot move.
Vector moments_of_slot(const BodyView& bodies, int slot);
/// Immovable from now on, where it is.
void stop_body(const BodyView& bodies, int slot);

/// Errors: not_finite, bad_restitution.
INGOT_INLINE Status check_restitution(scalar e) {
    if (!is_finite(e)) return Status::not_finite;
    return e >= 0 && e <= 1 ? Status::ok : Status::bad_restitution;
}
/// Errors: not_finite, bad_friction.
INGOT_INLINE Status check_friction(scalar mu) {
    if (!is_finite(mu)) return Status::not_finite;
    return mu >= 0 && mu <= limits::friction_max ? Status::ok : Status::bad_friction;
}
/// Number by number, as write_surface; the radius about the shape's own origin.
INGOT_INLINE void write_shape_of(Surface& to, const Shape& shape) {
    to.shape.kind = shape.kind;
    to.shape.size.x = shape.size.x;
    to.shape.size.y = shape.size.y;
    to.shape.size.z = shape.size.z;
    to.shape.offset = shape.offset;
    to.bounding_radius = bounding_radius(shape);
}

/// An immovable body that has the first of a level's shapes: see World::add_level. The state is that of the middle of its box.
BodyDef body_of_level(const LevelTable& level, const LevelDef& def);

// Slots by their generations: see BodyId, odd while a body lives there.

/// The first slot from this one on in which a body lives; `end` if there is none.
int next_living(const uint32_t* generation, int slot, int end);
/// None lives there, and the generation is not used up.
INGOT_INLINE bool is_free(uint32_t generation) { return (generation & 1u) == 0 && generation != UINT32_MAX - 1; }
/// The first that is free; `end` if there is none.
int next_free(const uint32_t* generation, int slot, int end);

BodyState read_state(const BodyView& bodies, int slot);
Status write_state(const BodyView& bodies, int slot, const BodyState& state);

/// F at the centre of mass and tau about it: F_T += F, tau_T += tau.
Status accumulate_force(const BodyView& bodies, int slot, const Vector& F, const Vector& tau);
/// The same of forces in body axes: F_body += F, tau_body += tau.
Status accumulate_body_force(const BodyView& bodies, BodyForceTile& tile, int slot, const Vector& F_body, const Vector& tau_body);
/// An impulse through the centre of mass and an angular impulse: v_CM += j / M, L += k.
Status accumulate_impulse(const BodyView& bodies, int slot, const Vector& j, const Vector& k);
/// r_P x F with r_P from the centre of mass to the world point P (Hecker 1997, Eq. 16).
Vector moment_about_centre(const BodyView& bodies, int slot, const Vector& F, const Vector& P);

/// Figure 4 for the bodies of two slots at the world point P, applied to both.
Result<scalar> collide_bodies(const BodyView& bodies, int slot_A, int slot_B, const Vector& P, const Vector& n, scalar e);
/// The same of bodies with locks, by slot.
Result<scalar> collide_locked_bodies(const BodyView& bodies, const uint8_t* locks, int slot_A, int slot_B, const Vector& P, const Vector& n,
                                     scalar e);

/// What moves with v, m/s, and nothing stops, pushes the body of a slot at the world point P along -n (unit, out of the body): Figure 4 without
/// restitution, by j_max, N s, at most. Needs: a body that can move.
Status push_body(const BodyView& bodies, int slot, const Vector& v, const Vector& P, const Vector& n, scalar j_max);

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// How a kinematic body moves as the partner of a contact sees it, through the substeps of a step: see kinematic_view.h.
#pragma once

#include "../base/limits.h"
#include "../body/kinematic_motion.h"
#include "kinematic_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// For a step of h seconds. of_slots: how bodies move beyond what their tiles show; null: evenly. r_partner: m, centre of the partner.
inline KinematicContact kinematic_contact_of(const BodyView& bodies, const KinematicBody* of_slots, scalar h, int slot, const Vector& r_partner) {
    const Place at = place_of(slot);
    const Vector v_CM_change = of_slots != nullptr ? of_slots[slot].v_CM_change : Vector{};
    const Vector omega_change = of_slots != nullptr ? of_slots[slot].omega_change : Vector{};
    KinematicContact contact = {};
    contact.v_CM = lane_of(bodies.translation[at.tile].v_CM, at.lane) - v_CM_change * scalar(0.5);
    contact.omega = -lane_of(bodies.rotation[at.tile].L, at.lane) - omega_change * scalar(0.5);
    contact.a = v_CM_change * (1 / h);
    contact.alpha = omega_change * (1 / h);
    contact.begin = r_partner - lane_of(bodies.translation[at.tile].r_CM, at.lane);
    return contact;
}

/// The velocity at R. Bodies go by the mean of their velocities at the begin and the end of a substep: with a spin that is larger by its third order
/// they go along the chord of the arc, and not a little less far.
INGOT_INLINE Vector carried_velocity(const Vector& v_CM, const Vector& omega, scalar h, const Vector& R) {
    const scalar angle_sq = min(length_sq(omega) * h * h, scalar(0.25));
    return v_CM + cross(omega, R) * (1 + angle_sq * (scalar(1) / 12));
}
INGOT_INLINE Vector mean_spin(const KinematicContact& contact, scalar h) { return contact.omega + contact.alpha * (h / 2); }

/// The begin of a substep of h seconds, with the partner displaced by `moved` since the step began.
inline void begin_substep(KinematicContact& contact, const Vector& moved) { contact.R = contact.begin + moved - contact.way; }
inline Vector velocity_at_begin(const KinematicContact& contact, scalar h) { return carried_velocity(contact.v_CM, contact.omega, h, contact.R); }
inline Vector acceleration_at_begin(const KinematicContact& contact) {
    return contact.a + cross(contact.alpha, contact.R) + cross(contact.omega, cross(contact.omega, contact.R));
}
/// What contacts of the substep aim at: the velocity at its end.
inline Vector velocity_at_end(const KinematicContact& contact, scalar h) {
    const Vector R = contact.R + change_by_turn(mean_spin(contact, h), h, contact.R);
    return carried_velocity(contact.v_CM + contact.a * h, contact.omega + contact.alpha * h, h, R);
}
/// Whether what an island's sweeps have left, m/s, is more than they ever solve: u is how fast the kinematic body asks it to go.
inline bool asks_too_much(scalar residual, const Vector& u, scalar unit) {
    return residual > limits::kinematic_yield_speed * unit &&
           residual * residual > limits::kinematic_yield_share * limits::kinematic_yield_share * length_sq(u);
}

/// The end of it. Returns: the displacement at R, along its arc.
inline Vector end_substep(KinematicContact& contact, scalar h) {
    const Vector way = (contact.v_CM + contact.a * (h / 2)) * h, displacement = way + change_by_turn(mean_spin(contact, h), h, contact.R);
    contact.way += way;
    contact.v_CM += contact.a * h;
    contact.omega += contact.alpha * h;
    return displacement;
}

} }  // namespace ingot

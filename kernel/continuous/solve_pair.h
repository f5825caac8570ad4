// SPDX-License-Identifier: MIT
// The bodies of a sub-world for a while: by the laws of any step.
#pragma once

#include "../motion/flight_clock.h"
#include "../motion/integrate_L.h"
#include "../motion/integrate_r.h"
#include "../motion/integrate_v.h"
#include "../solver/conduct_substeps.h"
#include "../solver/sequential/move_point_bodies.h"
#include "../solver/sweeps/move_bodies.h"
#include "find_pair_contacts.h"
#include "locked_pair.h"

namespace ingot { inline namespace INGOT_ABI {

/// A free flight of all bodies of a view; h may be negative.
template <class Rotation>
void fly_freely(const BodyView& bodies, const Vector& gravity, scalar h) {
    integrate_L(bodies, h);
    integrate_v(bodies, h, gravity);
    forget_energies(bodies);
    (void)turn_beside_contacts<Rotation>(bodies, h, FlightClock{0, 1, h / 2});
    integrate_r(bodies, h, gravity);
}

/// Bodies, as their paths begin, in a sub-world of their own. slot_B: -1 for one alone.
template <class Collision>
void gather_pair(const Collision& collision, int slot_A, int slot_B, PairRoom<Collision>& room) {
    room.two.clear();
    room.contacts.count = 0;
    room.slots[0] = slot_A;
    room.slots[1] = slot_B;
    if constexpr (Collision::SceneTraits::View::locks_axes)
        for (int which = 0; which < 2; ++which)  // bound: PairSubWorld::movers_max
            room.contacts.locks[which] = room.slots[which] >= 0 ? collision.solver.locks[room.slots[which]] : uint8_t(0);
    for (const int slot : room.slots)
        if (slot >= 0) room.two.take(collision.bodies, collision.shapes, slot, collision.paths[slot]);
    room.at = collision.paths[slot_A].from;
}

/// The shapes that gave each other an impulse, for events.
template <class Collision>
void note_flights([[maybe_unused]] const Collision& collision, [[maybe_unused]] const typename Collision::Contacts& contacts) {
    if constexpr (Collision::SceneTraits::notes_impulses)
        for (int place = 0; place < contacts.count; ++place) {  // bound: limits::pair_manifolds_max
            if (!contacts.notes[place].carried) continue;
            const Manifold& manifold = contacts.records[place].manifold;
            const int A = contacts.shapes[place].A.number, B = contacts.shapes[place].B.number;
            collision.flights.note({static_cast<Index>(A < B ? A : B), static_cast<Index>(A < B ? B : A),
                                    manifold.points[contacts.notes[place].point].P, A < B ? manifold.n : -manifold.n, contacts.notes[place].speed});
        }
}

/// Impulses that have given the bodies of a sub-world energy are lowered, all alike, until they give none: Newton's restitution together with
/// Coulomb's friction may give some (Kane and Levinson 1985), where a solver does not see to it. Along the change the energy is a parabola, which its
/// begin, middle and end give.
INGOT_INLINE void hold_energy(const Movers& movers, const FlightState (&before)[2], scalar energy_before) {
    const scalar gain = movers.kinetic_energy() - energy_before;
    if (!(gain > limits::energy_rounding * energy_before)) return;
    FlightState after[2];
    for (int which = 0; which < movers.count; ++which) after[which] = flight_state(movers.bodies, which);  // bound: PairSubWorld::movers_max
    movers.take_part_of_change(before, scalar(0.5));
    const scalar gain_of_half = movers.kinetic_energy() - energy_before;
    const scalar bend = 2 * (gain - 2 * gain_of_half), slope = gain - bend;
    for (int which = 0; which < movers.count; ++which) put_state(movers.bodies, which, after[which]);  // bound: PairSubWorld::movers_max
    movers.take_part_of_change(before, bend > 0 ? min(max(-slope / bend, scalar(0)), scalar(1)) : scalar(0));
}

/// Gives the bodies of a sub-world what contacts do to those that meet: by the laws of any step, of a time in which nothing moves. Points that are as
/// good as touching do touch; further ones have no part in it.
/// Velocities change, places and attitudes do not: no energy can come of how far a body got meanwhile.
template <class Collision>
void give_impulses(const Collision& collision, PairRoom<Collision>& room) {
    using Traits = typename Collision::SceneTraits;
    const BodyView two = room.two.bodies();
    for (int place = 0; place < room.contacts.count; ++place) {  // bound: limits::pair_manifolds_max
        Manifold& manifold = room.contacts.records[place].manifold;
        for (int point_i = 0; point_i < manifold.count; ++point_i) manifold.points[point_i].separation = 0;  // bound: 4: Manifold::points_max
    }
    if (room.contacts.count == 0) return;
    refresh_inv_I_world(two);
    const LockedPair<Collision> held(room);
    held.restrict_inertia();
    typename Traits::View solver = room.contacts.solver(collision.solver);
    room.two.keep_forces();
    room.two.drop_forces();
    const FlightState before[2] = {room.two.state(0), room.two.state(1)};
    const scalar energy = room.two.movers().kinetic_energy();
    const ContactStep impact = {two, {}, limits::impact_time, {room.contacts.notes, nullptr}};
    Traits::Solver::template solve_pair<Traits::notes_impulses, Traits::bounces>(solver, impact, *collision.report);
    write_contact_motion(solver, NoJointedBodies{}, two, {}, limits::impact_time);
    held.hold_motions();
    if (!gives_energy(solver) && room.two.kinematic_count == 0) hold_energy(room.two.movers(), before, energy);
    room.two.return_forces();
    note_flights(collision, room.contacts);
}

/// Moves the bodies of a sub-world on by h seconds, with the contacts that have been found.
template <class Collision>
void solve_pair(const Collision& collision, PairRoom<Collision>& room, scalar h) {
    using Traits = typename Collision::SceneTraits;
    const BodyView two = room.two.bodies();
    const Vector gravity = collision.clock.gravity;
    const LockedPair<Collision> held(room);
    if (room.contacts.count == 0) {
        hide_kinematic(room);
        fly_freely<typename Traits::Rotation>(two, gravity, h);
        held.turn(h);
    } else {
        refresh_inv_I_world(two);
        held.restrict_inertia();
        typename Traits::View solver = room.contacts.solver(collision.solver);
        room.two.keep_forces();
        Traits::Solver::template solve_pair<Traits::notes_impulses, Traits::bounces>(solver, {two, gravity, h, {room.contacts.notes, nullptr}},
                                                                                     *collision.report);
        hide_kinematic(room);
        integrate_L(two, h);
        integrate_v(two, h, gravity);
        write_contact_motion(solver, NoJointedBodies{}, two, gravity, h);
        forget_energies(two);
        held.hold_motions();
        (void)turn_beside_contacts<typename Traits::Rotation>(two, h, FlightClock{0, 1, h / 2});
        held.turn(h);
        integrate_r(two, h, gravity);
        turn_by_corrections(solver, NoJointedBodies{}, two, h);
        room.two.return_forces();
    }
    held.hold_places();
    room.at += h / collision.clock.h;
}

} }  // namespace ingot

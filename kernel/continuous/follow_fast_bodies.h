// SPDX-License-Identifier: MIT
// What happens to fast bodies within a step, impact by impact.
#pragma once

#include "fast_pairs.h"
#include "next_impact.h"
#include "resolve_impact.h"

namespace ingot { inline namespace INGOT_ABI {

/// A body stays where it is at time t, until the next step.
template <class Collision>
void wait_at(const Collision& collision, int slot, scalar t, PairSubWorld& two) {
    const FlightState motion = motion_at(collision, slot, t, two);
    put_state(collision.bodies, slot, motion);
    end_path(collision.paths[slot], motion.r_CM, motion.A, t);
    collision.paths[slot].in_contact = true;
}

/// The path of a body as it has gone in this step.
template <class Collision>
void lay_path_of_step(const Collision& collision, int slot, PairSubWorld& two) {
    BodyPath& path = collision.paths[slot];
    if (is_kinematic(collision, slot)) {
        begin_kinematic_path(path);
        if (path.fast) collision.lists->add_fast(collision.paths, slot);
        return;
    }
    const PathPoint begin = {path.r_CM, path.way, path.turn, path.A};
    const Vector way = flight_state(collision.bodies, slot).r_CM - begin.r_CM;
    path.in_contact = takes_part(collision.solver, slot);
    path.falls_free = !path.in_contact;
    path.until = 1;
    if (!is_valid(collision, slot)) {
        end_path(path, flight_state(collision.bodies, slot).r_CM, flight_state(collision.bodies, slot).A, 0);
    } else if (path.in_contact) {
        lay_chord(collision, slot, begin, 0);
        path.fast = is_fast_path(path, extent_of(collision.shapes, slot));
    } else if (path.fast) {
        lay_free_path(collision, slot, {path.r_CM, path.v_CM, path.L, path.A}, 0, two);
    } else {
        path.way = way;
    }
    const Vector turn = path.in_contact ? path.turn : omega_of(collision.bodies, slot) * collision.clock.h;
    if (is_tree<typename Collision::TreeType> && leaves_bounds(begin, way, turn, extent_of(collision.shapes, slot), collision.shapes.surfaces.unit))
        collision.lists->add_stray(collision.paths, slot);
    if (path.fast) collision.lists->add_fast(collision.paths, slot);
}

/// The paths of all bodies that move. True if one is fast.
template <class Collision>
bool lay_all_paths(const Collision& collision, PairSubWorld& two) {
    bool some = false;
    collision.moving.for_each([&](int slot) {
        lay_path_of_step(collision, slot, two);
        some = some || collision.paths[slot].fast;
    });
    return some;
}

/// Whether the impact of two bodies at time t is followed in this step; else the one that came waits there for the next.
template <class Collision>
bool is_followed(const Collision& collision, const BodyPath& A, const BodyPath& B, int slot_B, scalar t) {
    if (!(t < 1 - limits::last_moment)) return false;
    const bool sleeps = !collision.moving.has(slot_B) && is_dynamic(collision.bodies, slot_B);  // no contact had room: nothing woke it
    return (t <= limits::last_moment && !sleeps) || (!A.in_contact && !B.in_contact);
}

/// Counts an impact that is to be followed, for both bodies. False where one of them has had as many as there may be: what a body does to others
/// elsewhere takes nothing from it. What cannot move has them without end.
template <class Collision>
bool take_impact(const Collision& collision, const int (&slots)[2], bool followed) {
    for (const int slot : slots) followed = followed && !(is_valid(collision, slot) && collision.paths[slot].impacts >= limits::impacts_of_body_max);
    for (const int slot : slots)
        if (followed && is_valid(collision, slot)) ++collision.paths[slot].impacts;
    return followed;
}

/// Follows the fast bodies of a step of h seconds through their impacts. Comes last, when all bodies are where they would be without.
///
/// Impact by impact in the order of time, two bodies that meet are taken back to that time, touch as in any step, with restitution, friction,
/// forces, and what else their surfaces have, and go on to the end of the step. A body that takes part in the contacts of the step is not taken from
/// them: whoever meets it waits there for the next step, which finds both touching, as does whoever meets one that waits or sleeps; so do those that
/// a body has after limits::impacts_of_body_max. Only what meets at the very begin is not left waiting, lest it wait for ever. They are counted in
/// report.impacts_deferred: the rest of the step is lost to them, and no energy or momentum.
/// What was made fast by the contacts of this step is seen too: all goes by the ways that bodies have gone.
/// Of bodies of several shapes the first pair of shapes that meets counts, and all that touch then are solved together; those that find no room
/// among limits::pair_manifolds_max are counted in report.contacts_lost.
/// Kinematic bodies are met where they are at the time, and one that is fast meets those in its way; it waits for nobody, so it also throws what
/// takes part in the contacts of the step. Whom it has met limits::impacts_of_body_max times it meets in the next step.
/// Bound: impacts_of_body_max impacts a body, and as many parts of paths as their turns need, limits::path_parts_max a body and step.
/// Cost:  for each fast body and part of its path O(log bodies) with a tree, a look at every body without; and some searches for nearest points for
///        those near its path.
template <class Collision>
void follow_fast_bodies(const Collision& collision, StepReport& report) {
    PairRoom<Collision> room;
    if (!lay_all_paths(collision, room.two)) return;
    for_fast(collision, [&](int slot) { find_next(collision, slot); });

    // bound: (limits::path_parts_max + 1 + 2 limits::impacts_of_body_max) max_bodies: a path that ends took 1 / path_parts_max of the step
    // or more; impacts are counted; a body that waits is fast no more, and an impact makes one more fast at most
    for (int slot_A = first_of_all(collision); slot_A >= 0; slot_A = first_of_all(collision)) {
        BodyPath at_rest;
        const BodyPath& A = collision.paths[slot_A];
        const int slots[2] = {slot_A, A.next_slot};
        const BodyPath& B = path_of(collision, slots[1], at_rest);
        const scalar t = A.next;
        note_passed_sensors(collision, slot_A, t);
        if (slots[1] != slot_A && collision.moving.has(slots[1])) note_passed_sensors(collision, slots[1], t);
        if (slots[1] == slot_A) {
            lay_free_path(collision, slot_A, motion_at(collision, slot_A, t, room.two), t, room.two);
        } else if (take_impact(collision, slots, is_kinematic(collision, slot_A) || is_followed(collision, A, B, slots[1], t))) {
            resolve_impact(collision, slots, t, room, report);
        } else {
            const bool both = B.fast && !is_kinematic(collision, slots[1]);
            wait_at(collision, slot_A, t, room.two);
            if (both) wait_at(collision, slots[1], t, room.two);
            if (t < 1 - limits::last_moment) count(report.impacts_deferred, both ? 2 : 1);
        }
        find_next_anew(collision, slot_A, slots[1]);
    }
    for_fast(collision, [&](int slot) { note_passed_sensors(collision, slot, 1); });
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// Two bodies that meet within a step: they go on together for a moment, or wait for the next step.
#pragma once

#include "next_impact.h"
#include "wait_with_figure.h"

namespace ingot { inline namespace INGOT_ABI {

/// Calls each(body) for a body, or all of its figure.
template <class Collision, class Each>
INGOT_INLINE void with_figure(const Collision& collision, int slot, const Each& each) {
    if constexpr (Collision::some_figures)
        if (collision.is_of_figure(slot))
            return collision.for_bodies_with(slot, [&](int body) {
                if (is_valid(collision, body)) each(body);
            });
    each(slot);
}

/// Bodies whose paths have changed may be anywhere, and are followed from then on. All are where they can be found before one of them looks: else
/// who finds whom would depend on the search.
template <class Collision>
void follow_anew(const Collision& collision, const ChangedPaths& changed, PairRoom<Collision>& room) {
    changed.over_all([&](int one) {
        if (!is_valid(collision, one)) return;
        with_figure(collision, one, [&](int slot) {
            put_in_tree(collision, slot);
            collision.lists->follow(slot);
        });
    });
    changed.over_all([&](int one) {
        if (is_valid(collision, one)) with_figure(collision, one, [&](int slot) { find_next(collision, slot, room); });
    });
}

/// The motion of a body that has gone along its path to time t, on that path. The path of a contact is a chord, and where friction slows a body much,
/// it is elsewhere when it is solved to the middle alone: but the path is what was looked along, so all it meets is met there. What is off by less
/// than a skin stays where it was solved to.
template <class Collision>
FlightState on_its_path(const Collision& collision, int slot, scalar t, const FlightState& motion) {
    const PathFrame there = frame_on_path(collision.paths[slot], t);
    const BodyExtent extent = extent_of(collision.shapes, slot);
    const scalar skin = limits::skin_share * extent.least;
    const scalar turned_sq = length_sq(motion.A.c0 - there.A.c0) + length_sq(motion.A.c1 - there.A.c1) + length_sq(motion.A.c2 - there.A.c2);
    const bool is_off = length_sq(motion.r_CM - there.r_CM) > skin * skin || turned_sq * extent.reach * extent.reach > 2 * skin * skin;
    return is_off ? moved_to(collision, slot, motion, there) : motion;
}

/// Ends the path of a body at time t, with the motion that it has there, and that of its partner, which goes on alone. At its end the tiles have that
/// motion. Where contacts of the step have moved it together with others, it has the motion of the end.
template <class Collision>
void cut_path(const Collision& collision, int slot, scalar t, PairRoom<Collision>& room, ChangedPaths& changed) {
    const BodyPath& path = collision.paths[slot];
    if (changed.has(slot) || path.kind == PathKind::standing) return;
    note_passed_sensors(collision, slot, t);
    if (path.kind == PathKind::in_island) {
        const FlightState end = flight_state(collision.bodies, slot);
        put_state(collision.bodies, slot, moved_to(collision, slot, end, frame_on_path(path, t)));
        return changed.add(slot);
    }
    if (!(t < path.until)) return changed.add(slot);
    if (path.kind == PathKind::in_pair) note_passed_sensors(collision, path.partner, t);
    go_along(collision, slot, t, room);
    for (int which = 0; which < room.two.count; ++which) {  // bound: PairSubWorld::movers_max
        put_state(collision.bodies, room.slots[which], on_its_path(collision, room.slots[which], t, room.two.state(which)));
        changed.add(room.slots[which]);
    }
}

/// A body stays where it is at time t, until the next step.
template <class Collision>
void wait_at(const Collision& collision, int slot, scalar t, PairRoom<Collision>& room, ChangedPaths& changed) {
    const PathFrame there = frame_on_path(collision.paths[slot], t);
    cut_path(collision, slot, t, room, changed);
    const FlightState motion = moved_to(collision, slot, flight_state(collision.bodies, slot), there);
    put_state(collision.bodies, slot, motion);
    end_path(collision.paths[slot], motion.r_CM, motion.A, t);
}

/// Of two bodies that meet, the one that came waits, and the other where it is followed too; partners of theirs go on alone. What comes to one that
/// stands already waits there. Returns how many wait.
template <class Collision>
int wait_at_impact(const Collision& collision, int slot, int other, scalar t, PairRoom<Collision>& room, ChangedPaths& changed) {
    const int both[] = {slot, other};
    const bool came = collision.paths[slot].kind != PathKind::standing;
    int waiting = 0;
    for (const int one : both) {
        if (is_kinematic(collision, one) || !is_valid(collision, one) || sleeps(collision, one)) continue;
        if ((came && !collision.paths[one].is_followed) || collision.paths[one].kind == PathKind::standing) continue;
        if constexpr (Collision::some_figures)
            if (collision.is_of_figure(one)) {
                waiting += wait_with_figure(collision, one, t, have_manifold(collision, slot, other));
                changed.add(one);
                continue;
            }
        wait_at(collision, one, t, room, changed);
        ++waiting;
    }
    changed.over_all([&](int one) {
        if (one != slot && one != other) lay_alone(collision, one, flight_state(collision.bodies, one), t, room);
    });
    return waiting;
}

/// Whether the impact of a body with another at time t can be followed in this step; else whoever came waits there for the next. What contacts of the
/// step have moved together with others is not taken from them, unless it would wait for nearly all of the step: it might do so again and again.
template <class Collision>
bool can_follow(const Collision& collision, int slot, int other, scalar t) {
    if (!(t < 1 - limits::last_moment)) return false;
    const int both[] = {slot, other};
    for (const int one : both) {
        if (collision.is_of_figure(one)) return false;
        if (is_kinematic(collision, one)) return true;
        if (!is_valid(collision, one)) continue;
        if (sleeps(collision, one)) return false;  // no contact had room: nothing woke it
        const PathKind kind = collision.paths[one].kind;
        if (kind == PathKind::standing || (kind == PathKind::in_island && t > limits::first_moment)) return false;
    }
    return true;
}

/// Counts an impact that is to be followed, for both bodies. False where one of them has had as many as there may be: what a body does to others
/// elsewhere takes nothing from it. What cannot move has them without end.
template <class Collision>
bool take_impact(const Collision& collision, int slot, int other) {
    const int both[] = {slot, other};
    bool taken = true;
    for (const int one : both) taken = taken && !(is_valid(collision, one) && collision.paths[one].impacts >= limits::impacts_of_body_max);
    for (const int one : both)
        if (taken && is_valid(collision, one)) ++collision.paths[one].impacts;
    return taken;
}

/// The paths of two bodies that have met: together for a moment where they stay together, else each alone.
template <class Collision>
void lay_both(const Collision& collision, const int (&slots)[2], scalar t, PairRoom<Collision>& room) {
    for (const int slot : slots) begin_part(collision, slot, flight_state(collision.bodies, slot), t);
    gather_pair(collision, slots[0], slots[1], room);
    const scalar rest = (1 - t) * collision.clock.h, moment = min(rest, room.two.movers().moment());
    find_pair_contacts(collision, room, {false, moment, nullptr});
    if (!gets_away(collision, room, rest)) return lay_solved_paths(collision, moment < rest ? t + moment / collision.clock.h : scalar(1), room);
    for (const int slot : slots) lay_alone(collision, slot, flight_state(collision.bodies, slot), t, room);
}

/// One or two bodies that have been taken to time t give each other, and to what is around them, the impulses of their impact. kinematic: the slot of
/// a kinematic body that one of them meets; -1: none.
template <class Collision>
void hit(const Collision& collision, const int (&slots)[2], int kinematic, scalar t, PairRoom<Collision>& room) {
    for (const int slot : slots)
        if (slot >= 0) begin_part(collision, slot, flight_state(collision.bodies, slot), t);
    gather_pair(collision, slots[0], slots[1], room);
    find_pair_contacts(collision, room, {true, 0, nullptr, kinematic});
    give_impulses(collision, room);
    for (int which = 0; which < room.two.count; ++which)  // bound: PairSubWorld::movers_max
        put_state(collision.bodies, room.slots[which], room.two.state(which));
}

/// Two bodies that meet at time t: they are taken back to it, give each other their impulses, and go on.
template <class Collision>
void resolve_impact(const Collision& collision, int slot, int other, scalar t, PairRoom<Collision>& room, ChangedPaths& changed) {
    const int both[] = {slot, other};
    int movers[2] = {-1, -1}, count = 0, kinematic = -1;
    for (const int one : both) {
        if (is_kinematic(collision, one)) kinematic = one;
        if (!is_valid(collision, one)) continue;
        cut_path(collision, one, t, room, changed);
        movers[count++] = one;
    }
    if (count == 0) return;
    changed.over_all([&](int one) {
        if (one != movers[0] && one != movers[1]) lay_alone(collision, one, flight_state(collision.bodies, one), t, room);
    });
    hit(collision, movers, kinematic, t, room);
    if (count == 2) return lay_both(collision, movers, t, room);
    lay_alone(collision, movers[0], flight_state(collision.bodies, movers[0]), t, room);
}

/// The path of a body ends: it goes on alone, or with its partner where the two press on each other and do not move far against each other.
template <class Collision>
void lay_on(const Collision& collision, int slot, PairRoom<Collision>& room, ChangedPaths& changed) {
    const BodyPath& path = collision.paths[slot];
    const scalar t = path.until;
    cut_path(collision, slot, t, room, changed);
    const int partner = path.partner;
    if (path.kind == PathKind::in_pair && path.presses && collision.paths[partner].kind == PathKind::in_pair &&
        collision.paths[partner].partner == slot && !(collision.paths[partner].until > t)) {
        cut_path(collision, partner, t, room, changed);
        const int both[] = {slot, partner};
        for (const int one : both) begin_part(collision, one, flight_state(collision.bodies, one), t);
        gather_pair(collision, slot, partner, room);
        const scalar rest = (1 - t) * collision.clock.h;
        const scalar moment = room.two.movers().some_fast(rest) ? min(rest, room.two.movers().moment()) : rest;
        if (!(moment < rest / limits::path_parts_max)) {
            find_pair_contacts(collision, room, {false, moment, nullptr});
            return lay_solved_paths(collision, moment < rest ? t + moment / collision.clock.h : scalar(1), room);
        }
        lay_alone(collision, partner, flight_state(collision.bodies, partner), t, room);
    }
    lay_alone(collision, slot, flight_state(collision.bodies, slot), t, room);
}

} }  // namespace ingot

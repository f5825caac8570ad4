// SPDX-License-Identifier: MIT
// What happens to fast bodies within a step, impact by impact.
#pragma once

#include "../base/report.h"
#include "../blocks/move_bodies.h"
#include "../blocks/solve_manifolds.h"
#include "../body/auxiliary.h"
#include "../contact/update_manifolds.h"
#include "../motion/flight_clock.h"
#include "../motion/integrate_L.h"
#include "../motion/integrate_r.h"
#include "../motion/integrate_v.h"
#include "fast_pairs.h"
#include "time_of_impact.h"
#include "two_bodies.h"

namespace ingot { inline namespace INGOT_ABI {

/// What free fall is made of beside the body: gravity, and h of the whole step.
struct FallClock {
    Vector gravity;
    scalar h;
};

/// Everything the flights of a step work on.
template <class Meets>
struct Flights {
    BodyView bodies;
    SurfaceView surfaces;
    SolverView solver;  ///< done for this step: its memory, and who took part
    BodyPath* paths;
    FallClock clock;
    Meets meets;        ///< bool(slot, slot)
};

/// True for pairs with a manifold in this step. Bound: a search in a sorted list.
INGOT_INLINE bool is_solved(const SolverView& solver, int slot_A, int slot_B) {
    const uint16_t low = static_cast<uint16_t>(slot_A < slot_B ? slot_A : slot_B), high = static_cast<uint16_t>(slot_A < slot_B ? slot_B : slot_A);
    const uint32_t key = BodyPair{low, high, no_record}.key();
    int from = 0, to = solver.manifold_count;
    while (from < to) {
        const int middle = from + (to - from) / 2;
        if (solver.pairs[middle].key() < key)
            from = middle + 1;
        else
            to = middle;
    }
    return from < solver.manifold_count && solver.pairs[from].key() == key;
}

/// Looks whether one body meets another before all else that comes to it.
template <class Meets>
void consider(const Flights<Meets>& flights, int slot, int other) {
    const Surface &A = flights.surfaces.surfaces[slot], &B = flights.surfaces.surfaces[other];
    BodyPath& path = flights.paths[slot];
    const BodyPath& path_B = flights.paths[other];
    if (other == slot || B.shape.kind == ShapeKind::none || !may_meet(path, A, path_B, B) || !flights.meets(slot, other)) return;
    const scalar latest = least(path.next, least(path.until, path_B.until));
    const scalar t = time_of_impact(path, A.shape, path_B, B.shape, latest, !is_solved(flights.solver, slot, other));
    if (!(t < latest)) return;
    path.next = t;
    path.next_slot = static_cast<uint16_t>(other);
}

/// The first that comes to a body.
template <class Meets>
void find_next(const Flights<Meets>& flights, int slot) {
    BodyPath& path = flights.paths[slot];
    path.next = path.until < 1 ? path.until : never;
    path.next_slot = static_cast<uint16_t>(slot);
    for (int other = 0; other < flights.surfaces.slot_count; ++other) consider(flights, slot, other);
}

/// The fast body to which something comes first; -1: nothing comes.
template <class Meets>
int first_of_all(const Flights<Meets>& flights) {
    int first = -1;
    scalar earliest = 1;
    for (int slot = 0; slot < flights.surfaces.slot_count; ++slot) {
        const BodyPath& path = flights.paths[slot];
        if (!path.fast || !(path.next < earliest)) continue;
        first = slot;
        earliest = path.next;
    }
    return first;
}

/// After the paths of two bodies have changed: the impacts that are no more, and those that come of it.
template <class Meets>
void find_next_anew(const Flights<Meets>& flights, int slot_A, int slot_B) {
    for (int slot = 0; slot < flights.surfaces.slot_count; ++slot) {
        const BodyPath& path = flights.paths[slot];
        if (!path.fast) continue;
        if (slot == slot_A || slot == slot_B || path.next_slot == slot_A || path.next_slot == slot_B) {
            find_next(flights, slot);
        } else {
            consider(flights, slot, slot_A);
            if (slot_B != slot_A) consider(flights, slot, slot_B);
        }
    }
}

/// A free flight of all bodies of a view; h may be negative.
template <class Rotation>
void fly_freely(const BodyView& bodies, const Vector& gravity, scalar h) {
    integrate_L(bodies, h);
    integrate_v(bodies, h, gravity);
    (void)Rotation::integrate_A(bodies, h, FlightClock{0, true, h / 2});
    integrate_r(bodies, h, gravity);
}

/// A body in free fall, alone in the room, from the begin of its path to time t.
template <class Rotation, class Meets>
void fly_alone(const Flights<Meets>& flights, int slot, scalar t, TwoBodies& room) {
    const BodyPath& path = flights.paths[slot];
    room.clear();
    room.take(0, flights.bodies, flights.surfaces, slot);
    put_state(room.bodies(), 0, {path.r_CM, path.v_CM, path.L, path.A});
    if (t > path.from) fly_freely<Rotation>(room.bodies(), flights.clock.gravity, (t - path.from) * flights.clock.h);
}

/// The motion of a body at time t. In free fall it is exact. Else it is on the chord, with the velocity of the end; where forces would have worked on
/// it on the rest of the way, its speed is less by that.
template <class Rotation, class Meets>
FlightState motion_at(const Flights<Meets>& flights, int slot, scalar t, TwoBodies& room) {
    const BodyPath& path = flights.paths[slot];
    FlightState motion = flight_state(flights.bodies, slot);
    if (!(flights.bodies.translation[place_of(slot).tile].inv_M[place_of(slot).lane] > 0)) return motion;
    if (path.falls_free) {
        fly_alone<Rotation>(flights, slot, t, room);
        return flight_state(room.bodies(), 0);
    }
    const PlacedShape place = place_on_path(path, flights.surfaces.surfaces[slot].shape, t);
    const scalar work = 2 * dot(flights.clock.gravity, motion.r_CM - place.r), v_sq = length_sq(motion.v_CM);
    if (work > 0 && v_sq > 0) motion.v_CM = motion.v_CM * sqrt(work < v_sq ? 1 - work / v_sq : scalar(0));
    motion.r_CM = place.r;
    motion.A = place.A;
    return motion;
}

INGOT_INLINE PathPoint path_point(const BodyView& bodies, int slot, scalar h) {
    const FlightState motion = flight_state(bodies, slot);
    return {motion.r_CM, motion.v_CM * h, omega_of(bodies, slot) * h, motion.A};
}

/// Lays the path of a body in free fall on from a motion at time t, as far as a steady turn goes; to the end of the step the body itself goes too.
template <class Rotation, class Meets>
void lay_free_path(const Flights<Meets>& flights, int slot, const FlightState& from, scalar t, TwoBodies& room) {
    const Place at = place_of(slot);
    const TranslationTile& tile = flights.bodies.translation[at.tile];
    const scalar h = flights.clock.h;
    const Vector a = lane_of(tile.F_T, at.lane) * tile.inv_M[at.lane] + flights.clock.gravity;
    BodyPath& path = flights.paths[slot];
    path.r_CM = from.r_CM;
    path.v_CM = from.v_CM;
    path.L = from.L;
    path.A = from.A;
    path.from = t;
    path.falls_free = true;
    fly_alone<Rotation>(flights, slot, t, room);
    const PathPoint begin = path_point(room.bodies(), 0, h);
    const scalar until = end_of_path(begin.turn, t);
    fly_alone<Rotation>(flights, slot, until, room);
    lay_path(begin, t, path_point(room.bodies(), 0, h), until, a * (h * h / 2), path);
    const bool is_there = t <= 0;  // a step that flies in one part has gone so already
    if (until >= 1 && !is_there) put_state(flights.bodies, slot, flight_state(room.bodies(), 0));
}

/// Lays the path of a body that contacts have moved from `begin` at time t to the end of the step: a chord.
template <class Meets>
void lay_chord(const Flights<Meets>& flights, int slot, const PathPoint& begin, scalar t) {
    flights.paths[slot].falls_free = false;
    lay_path(begin, t, path_point(flights.bodies, slot, flights.clock.h), 1, {}, flights.paths[slot]);
}

template <class Meets>
bool is_sound(const Flights<Meets>& flights, int slot) {
    const Place at = place_of(slot);
    const TranslationTile& tile = flights.bodies.translation[at.tile];
    return tile.inv_M[at.lane] > 0 && ((flights.bodies.rotation[at.tile].bad | tile.bad) >> at.lane & 1u) == 0;
}

/// Two bodies that touch, alone in their room, for h seconds. True if they press on each other at the end.
template <class Shapes, class Rotation, bool notes_impulses, class Meets>
bool stay_together(const Flights<Meets>& flights, TwoBodies& room, scalar h, StepReport& report) {
    const BodyView two = room.bodies();
    Manifold before, found;
    before.n = {};
    before.count = 0;
    room.pair = {0, 1, 0};
    if (!find_manifold<Shapes>(two, room.surface_view(), room.pair, room.margin(h), before, found)) count(report.pairs_untested);
    room.set_manifold(found);
    if (found.count == 0) {
        fly_freely<Rotation>(two, flights.clock.gravity, h);
        return false;
    }
    mix_materials(room.surface_view(), room.pair, room.record);
    refresh_inv_I_world(two);
    SolverView solver = room.solver(flights.solver);
    ImpactNote note{};
    room.keep_forces();
    solve_manifolds<notes_impulses, true>(solver, two, flights.clock.gravity, h, &note, report);
    integrate_L(two, h);
    integrate_v(two, h, flights.clock.gravity);
    write_contact_motion(solver, two, flights.clock.gravity, h);
    (void)Rotation::integrate_A(two, h, FlightClock{0, true, h / 2});
    integrate_r(two, h, flights.clock.gravity);
    turn_by_corrections(solver, two, h);
    room.return_forces();
    return room.carries();
}

/// Two bodies that meet at time t: they are together for a moment, in which they give each other what contacts do. Then they fly on; where neither
/// is fast any more and they press on each other, they stay together for the rest of the step.
template <class Shapes, class Rotation, bool notes_impulses, class Meets>
void meet(const Flights<Meets>& flights, int slot_A, int slot_B, scalar t, TwoBodies& room, StepReport& report) {
    const int slots[2] = {slot_A, slot_B};
    FlightState states[2];
    for (int which = 0; which < 2; ++which) states[which] = motion_at<Rotation>(flights, slots[which], t, room);
    room.clear();
    for (int which = 0; which < 2; ++which) {
        room.take(which, flights.bodies, flights.surfaces, slots[which]);
        put_state(room.bodies(), which, states[which]);
    }
    const scalar h = (1 - t) * flights.clock.h, moment = least(h, room.moment());
    bool pressed = stay_together<Shapes, Rotation, notes_impulses>(flights, room, moment, report);
    const scalar parted = moment < h ? t + moment / flights.clock.h : scalar(1);
    const bool over = parted >= 1 - limits::last_moment;
    PathPoint after[2];
    for (int which = 0; which < 2; ++which) {
        states[which] = flight_state(room.bodies(), which);
        after[which] = path_point(room.bodies(), which, flights.clock.h);
    }
    pressed = pressed && !over && !room.some_fast(h - moment);
    if (pressed) (void)stay_together<Shapes, Rotation, notes_impulses>(flights, room, h - moment, report);

    const FlightState ends[2] = {flight_state(room.bodies(), 0), flight_state(room.bodies(), 1)};
    for (int which = 0; which < 2; ++which) {
        const int slot = slots[which];
        if (!is_sound(flights, slot)) continue;
        BodyPath& path = flights.paths[slot];
        put_state(flights.bodies, slot, ends[which]);
        if (over)
            end_path(path, ends[which].r_CM, ends[which].A, 1);
        else if (pressed)
            lay_chord(flights, slot, after[which], parted);
        else
            lay_free_path<Rotation>(flights, slot, states[which], parted, room);
        path.fast = !over && is_sound(flights, slot) && is_fast_path(path, flights.surfaces.surfaces[slot]);
    }
}

/// A body stays where it is at time t, until the next step.
template <class Rotation, class Meets>
void wait_at(const Flights<Meets>& flights, int slot, scalar t, TwoBodies& room) {
    const FlightState motion = motion_at<Rotation>(flights, slot, t, room);
    put_state(flights.bodies, slot, motion);
    end_path(flights.paths[slot], motion.r_CM, motion.A, t);
    flights.paths[slot].held = true;
}

/// The paths of all bodies as they have gone in this step. True if one is fast.
template <class Rotation, class Meets>
bool lay_all_paths(const Flights<Meets>& flights, TwoBodies& room) {
    bool some = false;
    for (int slot = 0; slot < flights.surfaces.slot_count; ++slot) {
        BodyPath& path = flights.paths[slot];
        const PathPoint begin = {path.r_CM, path.way, path.turn, path.A};
        path.held = flights.solver.local_of[slot] != 0;
        path.falls_free = !path.held;
        path.until = 1;
        if (!is_sound(flights, slot)) {
            end_path(path, flight_state(flights.bodies, slot).r_CM, flight_state(flights.bodies, slot).A, 0);
        } else if (path.held) {
            lay_chord(flights, slot, begin, 0);
            path.fast = is_fast_path(path, flights.surfaces.surfaces[slot]);
        } else if (path.fast) {
            lay_free_path<Rotation>(flights, slot, {path.r_CM, path.v_CM, path.L, path.A}, 0, room);
        } else {
            path.way = flight_state(flights.bodies, slot).r_CM - begin.r_CM;
        }
        some = some || path.fast;
    }
    return some;
}

/// Follows the fast bodies of a step of h seconds through their impacts. Comes last, when all bodies are where they would be without.
///
/// Impact by impact in the order of time, two bodies that meet are taken back to that time, touch as in any step, with restitution, friction and
/// forces, and go on to the end of the step. A body that takes part in the contacts of the step is not taken from them: whoever meets it waits there
/// for the next step, which finds both touching, as does whoever meets one that waits; so do those that are left after
/// limits::impacts_in_step_max. Only what meets at the very begin is not left waiting, lest it wait for ever. They are counted in
/// report.impacts_left: the rest of the step is lost to them, and no energy or momentum.
/// What was made fast by the contacts of this step is seen too: all goes by the ways that bodies have gone.
/// Bound: impacts_in_step_max impacts, and as many parts of paths as their turns need, limits::path_parts_max a body and step.
/// Cost:  a look at every body for each fast one, and some searches for nearest points for those near its path.
template <class Shapes, class Rotation, bool notes_impulses, class Meets>
void fly_fast_bodies(const Flights<Meets>& flights, StepReport& report) {
    TwoBodies room;
    if (!lay_all_paths<Rotation>(flights, room)) return;
    for (int slot = 0; slot < flights.surfaces.slot_count; ++slot)
        if (flights.paths[slot].fast) find_next(flights, slot);

    int impacts = 0;
    for (int slot_A = first_of_all(flights); slot_A >= 0; slot_A = first_of_all(flights)) {
        const BodyPath& A = flights.paths[slot_A];
        const int slot_B = A.next_slot;
        const BodyPath& B = flights.paths[slot_B];
        const scalar t = A.next;
        if (slot_B == slot_A) {
            lay_free_path<Rotation>(flights, slot_A, motion_at<Rotation>(flights, slot_A, t, room), t, room);
        } else if ((t <= limits::last_moment || (!A.held && !B.held)) && t < 1 - limits::last_moment && impacts < limits::impacts_in_step_max) {
            ++impacts;
            meet<Shapes, Rotation, notes_impulses>(flights, slot_A, slot_B, t, room, report);
        } else {
            const bool both = B.fast;
            wait_at<Rotation>(flights, slot_A, t, room);
            if (both) wait_at<Rotation>(flights, slot_B, t, room);
            if (t < 1 - limits::last_moment) count(report.impacts_left, both ? 2 : 1);
        }
        find_next_anew(flights, slot_A, slot_B);
    }
}

} }  // namespace ingot

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
#include "time_of_impact.h"
#include "two_bodies.h"

namespace ingot { inline namespace INGOT_ABI {

/// Everything the flights of a step work on.
template <class Meets>
struct Flights {
    BodyView bodies;
    SurfaceView surfaces;
    SolverView solver;  ///< done for this step: its memory, and who took part
    BodyPath* paths;
    PathClock clock;
    Meets meets;        ///< bool(slot, slot)
};

/// Looks whether one body meets another before all that it is known to meet.
template <class Meets>
void consider(const Flights<Meets>& flights, int slot, int other) {
    const Surface &A = flights.surfaces.surfaces[slot], &B = flights.surfaces.surfaces[other];
    BodyPath& path = flights.paths[slot];
    const BodyPath& path_B = flights.paths[other];
    if (other == slot || B.shape.kind == ShapeKind::none || !may_meet(path, A, path_B, B) || !flights.meets(slot, other)) return;
    const scalar latest = path.hit < 1 ? path.hit : scalar(1);
    const scalar t = time_of_impact(path, A.shape, path_B, B.shape, latest);
    if (!(t < latest)) return;
    path.hit = t;
    path.hit_slot = static_cast<uint16_t>(other);
}

/// The first impact of a body.
template <class Meets>
void find_hit(const Flights<Meets>& flights, int slot) {
    flights.paths[slot].hit = never;
    for (int other = 0; other < flights.surfaces.slot_count; ++other) consider(flights, slot, other);
}

/// The fast body whose impact comes first; -1: none has any.
template <class Meets>
int first_to_hit(const Flights<Meets>& flights) {
    int first = -1;
    scalar earliest = 1;
    for (int slot = 0; slot < flights.surfaces.slot_count; ++slot) {
        const BodyPath& path = flights.paths[slot];
        if (!path.fast || !(path.hit < earliest)) continue;
        first = slot;
        earliest = path.hit;
    }
    return first;
}

/// After the paths of two bodies have changed: the impacts that are no more, and those that come of it.
template <class Meets>
void find_hits_anew(const Flights<Meets>& flights, int slot_A, int slot_B) {
    for (int slot = 0; slot < flights.surfaces.slot_count; ++slot) {
        const BodyPath& path = flights.paths[slot];
        if (!path.fast) continue;
        const bool own = slot == slot_A || slot == slot_B;
        const bool gone = path.hit < 1 && (path.hit_slot == slot_A || path.hit_slot == slot_B);
        if (own || gone) {
            find_hit(flights, slot);
        } else {
            consider(flights, slot, slot_A);
            consider(flights, slot, slot_B);
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

/// The motion of a body at time t of its path. In free fall it is the motion of the end, flown back. Else it is on the chord, with the velocity of
/// the end; where forces would have worked on it on the rest of the way, its speed is less by that.
template <class Rotation, class Meets>
FlightState motion_at(const Flights<Meets>& flights, int slot, scalar t, TwoBodies& room) {
    const BodyPath& path = flights.paths[slot];
    if (path.falls_free) {
        room.clear();
        room.take(0, flights.bodies, flights.surfaces, slot);
        fly_freely<Rotation>(room.bodies(), flights.clock.gravity, (t - 1) * flights.clock.h);
        return flight_state(room.bodies(), 0);
    }
    const PlacedShape place = place_on_path(path, flights.surfaces.surfaces[slot].shape, t);
    FlightState motion = flight_state(flights.bodies, slot);
    const scalar work = 2 * dot(flights.clock.gravity, motion.r_CM - place.r), v_sq = length_sq(motion.v_CM);
    if (work > 0 && v_sq > 0) motion.v_CM = motion.v_CM * sqrt(work < v_sq ? 1 - work / v_sq : scalar(0));
    motion.r_CM = place.r;
    motion.A = place.A;
    return motion;
}

/// Two bodies that meet at time t go on to the end of the step by themselves.
template <class Shapes, class Rotation, bool notes_impulses, class Meets>
void go_on_together(const Flights<Meets>& flights, int slot_A, int slot_B, scalar t, TwoBodies& room, StepReport& report) {
    const int slots[2] = {slot_A, slot_B};
    FlightState begin[2];
    for (int which = 0; which < 2; ++which) begin[which] = motion_at<Rotation>(flights, slots[which], t, room);
    room.clear();
    for (int which = 0; which < 2; ++which) {
        room.take(which, flights.bodies, flights.surfaces, slots[which]);
        put_state(room.bodies(), which, begin[which]);
    }
    const BodyView two = room.bodies();
    const Vector omega_begin[2] = {omega_of(two, 0), omega_of(two, 1)};
    const scalar h = (1 - t) * flights.clock.h;

    Manifold before, found;
    before.n = {};
    before.count = 0;
    room.pair = {0, 1, 0};
    if (!find_manifold<Shapes>(two, room.surface_view(), room.pair, room.margin(h), before, found)) count(report.pairs_untested);
    room.set_manifold(found);
    if (found.count > 0) {
        mix_materials(room.surface_view(), room.pair, room.record);
        refresh_inv_I_world(two);
        SolverView solver = room.solver(flights.solver);
        ImpactNote note{};
        solve_manifolds<notes_impulses>(solver, two, flights.clock.gravity, h, &note, report);
        integrate_L(two, h);
        integrate_v(two, h, flights.clock.gravity);
        write_contact_motion(solver, two, flights.clock.gravity, h);
        count(report.spins_clamped, Rotation::integrate_A(two, h, FlightClock{0, true, h / 2}));
        integrate_r(two, h, flights.clock.gravity);
        turn_by_corrections(solver, two, h);
    } else {
        fly_freely<Rotation>(two, flights.clock.gravity, h);
    }

    for (int which = 0; which < 2; ++which) {
        const Place at = place_of(slots[which]);
        if (!(flights.bodies.translation[at.tile].inv_M[at.lane] > 0)) continue;
        BodyPath& path = flights.paths[slots[which]];
        put_state(flights.bodies, slots[which], flight_state(two, which));
        end_path(path, begin[which].r_CM, begin[which].A, t);
        path.falls_free = !room.carries();
        lay_path(flights.bodies, flights.surfaces.surfaces[slots[which]], slots[which], omega_begin[which], flights.clock, path);
    }
}

/// A body stays where it is at time t, until the next step.
template <class Rotation, class Meets>
void wait_at(const Flights<Meets>& flights, int slot, scalar t, TwoBodies& room) {
    const FlightState motion = motion_at<Rotation>(flights, slot, t, room);
    put_state(flights.bodies, slot, motion);
    end_path(flights.paths[slot], motion.r_CM, motion.A, t);
}

/// Follows the fast bodies of a step of h seconds through their impacts. Comes last, when all bodies are where they would be without.
///
/// Impact by impact in the order of time, two bodies that meet are taken back to that time and go on together for the rest of the step, with all that
/// contacts have: restitution, friction, forces. A body that takes part in the contacts of the step is not taken from them: whoever meets it waits
/// there for the next step, which finds both touching; so do those that are left after limits::impacts_in_step_max. They are counted in
/// report.flights_cut: the rest of the step is lost to them, and no energy or momentum.
/// What was fast only since the contacts of this step is seen too: all goes by the ways that bodies have gone.
/// Cost: a look at every body for each fast one, and some searches for nearest points for those near its path.
template <class Shapes, class Rotation, bool notes_impulses, class Meets>
void fly_fast_bodies(const Flights<Meets>& flights, StepReport& report) {
    bool some = false;
    for (int slot = 0; slot < flights.surfaces.slot_count; ++slot) {
        BodyPath& path = flights.paths[slot];
        path.held = flights.solver.local_of[slot] != 0;
        path.falls_free = !path.held;
        lay_path(flights.bodies, flights.surfaces.surfaces[slot], slot, path.turn * (1 / flights.clock.h), flights.clock, path);
        some = some || path.fast;
    }
    if (!some) return;
    for (int slot = 0; slot < flights.surfaces.slot_count; ++slot)
        if (flights.paths[slot].fast) find_hit(flights, slot);

    TwoBodies room;
    for (int impact_i = 0; impact_i < limits::impacts_in_step_max; ++impact_i) {
        const int slot_A = first_to_hit(flights);
        if (slot_A < 0) return;
        const BodyPath &A = flights.paths[slot_A], &B = flights.paths[A.hit_slot];
        const int slot_B = A.hit_slot;
        const scalar t = A.hit;
        if (!A.held && !B.held && t < 1 - limits::last_moment) {
            go_on_together<Shapes, Rotation, notes_impulses>(flights, slot_A, slot_B, t, room, report);
        } else {
            const bool B_waits = B.fast;
            wait_at<Rotation>(flights, slot_A, t, room);
            if (B_waits) wait_at<Rotation>(flights, slot_B, t, room);
            if (t < 1 - limits::last_moment) count(report.flights_cut, B_waits ? 2 : 1);
        }
        find_hits_anew(flights, slot_A, slot_B);
    }
    for (int slot = first_to_hit(flights); slot >= 0; slot = first_to_hit(flights)) {
        wait_at<Rotation>(flights, slot, flights.paths[slot].hit, room);
        count(report.flights_cut);
    }
}

} }  // namespace ingot

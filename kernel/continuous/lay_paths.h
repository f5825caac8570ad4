// SPDX-License-Identifier: MIT
// Where a body is at a time within the step, and how its path goes on from there.
#pragma once

#include "../body/auxiliary.h"
#include "solve_pair.h"

namespace ingot { inline namespace INGOT_ABI {

INGOT_INLINE PathPoint path_point(const BodyView& bodies, int slot, scalar h) {
    const FlightState motion = flight_state(bodies, slot);
    return {motion.r_CM, motion.v_CM * h, omega_of(bodies, slot) * h, motion.A};
}

/// Takes a body along its path to time t, in the sub-world: it and its partner, where it has one, as their paths begin, for so long. Exact in free
/// fall; else as good as the path itself, which is the same solved to its end.
template <class Collision>
void go_along(const Collision& collision, int slot, scalar t, PairRoom<Collision>& room) {
    const BodyPath& path = collision.paths[slot];
    const bool in_pair = path.kind == PathKind::in_pair;
    gather_pair(collision, slot, in_pair ? path.partner : -1, room);
    const scalar h = (t - path.from) * collision.clock.h;
    if (!(h > 0)) return;
    // As the step itself has found them: see FastPairs.
    const bool reaches = path.of_step && !path.fast;
    if (path.kind != PathKind::free) find_pair_contacts(collision, room, {!in_pair && !reaches, reaches ? collision.clock.h : h, nullptr});
    solve_pair(collision, room, h);
}

/// Moves a motion to another place and attitude: it gets no energy by that. Gravity's work on the way is taken from its speed, and of its L so much
/// that it does not turn with more.
template <class Collision>
FlightState moved_to(const Collision& collision, int slot, FlightState motion, const PathFrame& to) {
    const scalar work = 2 * dot(collision.clock.gravity, motion.r_CM - to.r_CM), v_sq = length_sq(motion.v_CM);
    if (work > 0 && v_sq > 0) motion.v_CM = motion.v_CM * sqrt(work < v_sq ? 1 - work / v_sq : scalar(0));
    const Place at = place_of(slot);
    const Vector ratio = lane_of(collision.bodies.rotation[at.tile].inv_I_ratio, at.lane);
    const auto twice_energy = [&](const Matrix& A) {
        if constexpr (Collision::SceneTraits::View::locks_axes)
            return dot(motion.L, inverse_inertia_of_free(A, ratio, rotations_locked(collision.solver.locks[slot])) * motion.L);
        else
            return dot(motion.L, inverse_inertia_world(A, ratio) * motion.L);
    };
    const scalar before = twice_energy(motion.A), after = twice_energy(to.A);
    if (after > before) motion.L = motion.L * sqrt(before / after);
    motion.r_CM = to.r_CM;
    motion.A = to.A;
    return motion;
}

template <class Collision>
void begin_part(const Collision& collision, int slot, const FlightState& from, scalar t) {
    BodyPath& path = collision.paths[slot];
    path.r_CM = from.r_CM;
    path.v_CM = from.v_CM;
    path.L = from.L;
    path.A = from.A;
    path.from = t;
    path.of_step = path.presses = false;
    ++path.version;
}

/// Lays the part of a path that has begun, in free fall, as far as a steady turn goes. is_there: the step has flown so already, and a path that needs
/// no parts ends where it has put the body.
template <class Collision>
void lay_free_path(const Collision& collision, int slot, bool is_there, PairRoom<Collision>& room) {
    BodyPath& path = collision.paths[slot];
    const scalar h = collision.clock.h, from = path.from;
    path.kind = PathKind::free;
    gather_pair(collision, slot, -1, room);
    const PathPoint begin = path_point(room.two.bodies(), 0, h);
    const scalar until = end_of_path(seen_turn(collision.shapes, slot, begin.A, begin.turn), from, limits::angle_per_path);
    solve_pair(collision, room, (until - from) * h);
    const Place at = place_of(slot);
    const Vector a = path.F_T * collision.bodies.translation[at.tile].inv_M[at.lane] + collision.clock.gravity;
    lay_path(begin, from, path_point(room.two.bodies(), 0, h), until, a * (h * h / 2), path);
    if (!is_there || until < 1) put_state(collision.bodies, slot, room.two.state(0));
}

/// Lays the parts of the bodies of a sub-world that have begun, with the contacts that have been found: chords.
template <class Collision>
void lay_solved_paths(const Collision& collision, scalar until, PairRoom<Collision>& room) {
    const scalar h = collision.clock.h, from = room.at;
    PathPoint begin[2];
    for (int which = 0; which < room.two.count; ++which) begin[which] = path_point(room.two.bodies(), which, h);  // bound: PairSubWorld::movers_max
    solve_pair(collision, room, (until - from) * h);
    note_flights(collision, room.contacts);
    for (int which = 0; which < room.two.count; ++which) {  // bound: PairSubWorld::movers_max
        BodyPath& path = collision.paths[room.slots[which]];
        path.kind = room.two.count == 2 ? PathKind::in_pair : PathKind::on_fixed;
        path.partner = static_cast<Index>(room.slots[1 - which]);
        path.presses = room.two.count == 2 && room.contacts.carries(0, 1);
        lay_path(begin[which], from, path_point(room.two.bodies(), which, h), until, {}, path);
        put_state(collision.bodies, room.slots[which], room.two.state(which));
    }
}

/// How fast a point of one body of a sub-world leaves that of another, m/s, and how fast the two may be pulled back to each other, m s^-2, along n,
/// from B to A: by forces, and by the turns of both.
template <class Collision>
struct Leaving {
    scalar speed, pull;

    Leaving(const Collision& collision, PairRoom<Collision>& room, const BodyPair& places, const Vector& n, const Vector& P) {
        const auto motion_at = [&](int place) {
            const FlightState at = room.two.state(place);
            return at.v_CM + cross(omega_of(room.two.bodies(), place), P - at.r_CM);
        };
        const auto forces_on = [&](int place) -> Vector {
            if (place >= room.two.count) return {};
            const Place at = place_of(place);
            return lane_of(room.two.translation[at.tile].F_T, at.lane) * room.two.translation[at.tile].inv_M[at.lane] + collision.clock.gravity;
        };
        const auto bend = [&](int place) { return length_sq(omega_of(room.two.bodies(), place)) * room.two.extents[place].reach; };
        speed = dot(n, motion_at(places.body_A) - motion_at(places.body_B));
        pull = dot(n, forces_on(places.body_B) - forces_on(places.body_A)) + bend(places.body_A) + bend(places.body_B);
    }
};

/// True where the bodies of a sub-world get away from each other, or one that is alone from all that it touches, in what is left of the step: h
/// seconds.
template <class Collision>
bool gets_away(const Collision& collision, PairRoom<Collision>& room, scalar h) {
    bool away = true;
    for (int i = 0; i < room.contacts.count; ++i) {  // bound: limits::pair_manifolds_max
        const BodyPair& places = room.contacts.pairs[i];
        if (room.two.count == 2 && places.body_B >= room.two.count) continue;
        const Manifold& manifold = room.contacts.records[i].manifold;
        // bound: 4: Manifold::points_max
        for (int point_i = 0; point_i < manifold.count; ++point_i) {
            const Leaving<Collision> point(collision, room, places, manifold.n, manifold.points[point_i].P);
            away = away && point.speed > max(point.pull * h / 2, scalar(0));
        }
    }
    return away;
}

/// The path of a body that is alone from time t on: with what it touches that cannot move, or free.
template <class Collision>
void lay_alone(const Collision& collision, int slot, const FlightState& from, scalar t, PairRoom<Collision>& room) {
    begin_part(collision, slot, from, t);
    gather_pair(collision, slot, -1, room);
    find_pair_contacts(collision, room, {true, 0, nullptr});
    if (gets_away(collision, room, (1 - t) * collision.clock.h)) return lay_free_path(collision, slot, false, room);
    const PathPoint begin = path_point(room.two.bodies(), 0, collision.clock.h);
    scalar until = end_of_path(seen_turn(collision.shapes, slot, begin.A, begin.turn), t, limits::tilt_of_contact);
    for (int i = 0; i < room.two.kinematic_count; ++i)  // bound: limits::pair_kinematic_max
        until = min(until, end_of_path(collision.paths[room.two.kinematic[i]].turn, t, limits::tilt_of_contact));
    lay_solved_paths(collision, until, room);
}

/// Lays the path of a body that contacts of the step have moved from `begin` to its end: a chord.
template <class Collision>
void lay_chord(const Collision& collision, int slot, const PathPoint& begin) {
    lay_path(begin, 0, path_point(collision.bodies, slot, collision.clock.h), 1, {}, collision.paths[slot]);
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// Where a body is at a time within the step, and how its path goes on from there.
#pragma once

#include "../body/auxiliary.h"
#include "../math/sqrt.h"
#include "../motion/flight_clock.h"
#include "../motion/integrate_L.h"
#include "../motion/integrate_r.h"
#include "../motion/integrate_v.h"
#include "continuous_collision.h"

namespace ingot { inline namespace INGOT_ABI {

/// A free flight of all bodies of a view; h may be negative.
template <class Rotation>
void fly_freely(const BodyView& bodies, const Vector& gravity, scalar h) {
    integrate_L(bodies, h);
    integrate_v(bodies, h, gravity);
    forget_energies(bodies);
    (void)Rotation::integrate_A(bodies, h, FlightClock{0, 1, h / 2});
    integrate_r(bodies, h, gravity);
}

/// A body in free fall, alone in its sub-world, from the begin of its path to time t.
template <class Collision>
void fly_alone(const Collision& collision, int slot, scalar t, PairSubWorld& two) {
    const BodyPath& path = collision.paths[slot];
    two.clear();
    two.take(0, collision.bodies, collision.shapes, slot);
    put_state(two.bodies(), 0, {path.r_CM, path.v_CM, path.L, path.A});
    using Turn = typename Collision::SceneTraits::Rotation;
    if (t > path.from) fly_freely<Turn>(two.bodies(), collision.clock.gravity, (t - path.from) * collision.clock.h);
}

/// The motion of a body at time t. In free fall it is exact. Else it is on the chord, with the velocity of the end; where forces would have worked on
/// it on the rest of the way, its speed is less by that.
template <class Collision>
FlightState motion_at(const Collision& collision, int slot, scalar t, PairSubWorld& two) {
    const BodyPath& path = collision.paths[slot];
    FlightState motion = flight_state(collision.bodies, slot);
    if (is_kinematic(collision, slot)) {
        const PathFrame at = frame_on_path(path, t);
        motion.r_CM = at.r_CM;
        motion.A = at.A;
        return motion;
    }
    if (!(collision.bodies.translation[place_of(slot).tile].inv_M[place_of(slot).lane] > 0)) return motion;
    if (path.falls_free) {
        fly_alone(collision, slot, t, two);
        return flight_state(two.bodies(), 0);
    }
    const PathFrame place = frame_on_path(path, t);
    const scalar work = 2 * dot(collision.clock.gravity, motion.r_CM - place.r_CM), v_sq = length_sq(motion.v_CM);
    if (work > 0 && v_sq > 0) motion.v_CM = motion.v_CM * sqrt(work < v_sq ? 1 - work / v_sq : scalar(0));
    motion.r_CM = place.r_CM;
    motion.A = place.A;
    return motion;
}

INGOT_INLINE PathPoint path_point(const BodyView& bodies, int slot, scalar h) {
    const FlightState motion = flight_state(bodies, slot);
    return {motion.r_CM, motion.v_CM * h, omega_of(bodies, slot) * h, motion.A};
}

/// Lays the path of a body in free fall on from a motion at time t, as far as a steady turn goes; to the end of the step the body itself goes too.
template <class Collision>
void lay_free_path(const Collision& collision, int slot, const FlightState& from, scalar t, PairSubWorld& two) {
    const Place at = place_of(slot);
    const TranslationTile& tile = collision.bodies.translation[at.tile];
    const scalar h = collision.clock.h;
    const Vector a = lane_of(tile.F_T, at.lane) * tile.inv_M[at.lane] + collision.clock.gravity;
    BodyPath& path = collision.paths[slot];
    path.r_CM = from.r_CM;
    path.v_CM = from.v_CM;
    path.L = from.L;
    path.A = from.A;
    path.from = t;
    path.falls_free = true;
    fly_alone(collision, slot, t, two);
    const PathPoint begin = path_point(two.bodies(), 0, h);
    const scalar until = end_of_path(begin.turn, t);
    fly_alone(collision, slot, until, two);
    lay_path(begin, t, path_point(two.bodies(), 0, h), until, a * (h * h / 2), path);
    const bool is_there = t <= 0;  // a step that flies in one part has gone so already
    if (until >= 1 && !is_there) put_state(collision.bodies, slot, flight_state(two.bodies(), 0));
}

/// Lays the path of a body that contacts have moved from `begin` at time t to the end of the step: a chord.
template <class Collision>
void lay_chord(const Collision& collision, int slot, const PathPoint& begin, scalar t) {
    collision.paths[slot].falls_free = false;
    lay_path(begin, t, path_point(collision.bodies, slot, collision.clock.h), 1, {}, collision.paths[slot]);
}

template <class Collision>
bool is_valid(const Collision& collision, int slot) {
    const Place at = place_of(slot);
    const TranslationTile& tile = collision.bodies.translation[at.tile];
    return tile.inv_M[at.lane] > 0 && ((collision.bodies.rotation[at.tile].bad | tile.bad) >> at.lane & 1u) == 0;
}

} }  // namespace ingot

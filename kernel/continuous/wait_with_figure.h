// SPDX-License-Identifier: MIT
// What happens to a figure one of whose bodies meets something on its way: see figures_on_paths.h.
#pragma once

#include "../body/kinematics.h"
#include "close_figure.h"
#include "next_impact.h"

namespace ingot { inline namespace INGOT_ABI {

/// Twice the kinetic energy of a body, J.
INGOT_INLINE scalar twice_kinetic_energy(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    const FlightState motion = flight_state(bodies, slot);
    const RotationTile& rotation = bodies.rotation[at.tile];
    const Vector inv_I = lane_of(rotation.inv_I_ratio, at.lane) * rotation.inv_I_scale[at.lane];
    return length_sq(motion.v_CM) / bodies.translation[at.tile].inv_M[at.lane] + dot(motion.L, inverse_inertia_world(motion.A, inv_I) * motion.L);
}

/// What contacts of the step have had to do with a figure: BodyPath::partner of its bodies, all that hang together in it.
enum class FigureTouches : Index { nothing, what_stands, what_moves };

template <class Collision>
FigureTouches touches_of(const Collision& collision, int slot) {
    return static_cast<FigureTouches>(collision.paths[slot].partner);
}

/// Bodies with joints go as the step has led them.
template <class Collision>
void mark_figures([[maybe_unused]] const Collision& collision) {
    if constexpr (Collision::some_figures) {
        const auto is_in_figure = [&](int slot) { return is_dynamic(collision.bodies, slot) && collision.is_of_figure(slot); };
        const auto mark = [&](int slot, int other) {
            if (!is_in_figure(slot)) return;
            const bool is_own = is_in_figure(other) && collision.machine_of_body(slot) == collision.machine_of_body(other);
            const FigureTouches touches = is_dynamic(collision.bodies, other) && !is_own ? FigureTouches::what_moves : FigureTouches::what_stands;
            if (touches > touches_of(collision, slot)) collision.paths[slot].partner = static_cast<Index>(touches);
        };
        for (int i = 0; i < collision.solved.count; ++i) {  // bound: max_manifolds
            const int A = collision.shapes.body_of({collision.solved.pairs[i].body_A}),
                      B = collision.shapes.body_of({collision.solved.pairs[i].body_B});
            mark(A, B);
            mark(B, A);
        }
        collision.for_machines([&](int first) {
            Index most = 0;
            collision.for_bodies_of(first, [&](int slot) { most = collision.paths[slot].partner > most ? collision.paths[slot].partner : most; });
            collision.for_bodies_of(first, [&](int slot) {
                collision.paths[slot].kind = PathKind::in_island;
                collision.paths[slot].partner = most;
            });
        });
    }
}

/// Lays the path of a body with joints: a chord where its figure has contacts, as impulses may have bent its way anywhere; else the parabola that its
/// motions at both ends ask for, which leaves a circle by a hundredth of its radius times the cube of the angle.
template <class Collision>
void lay_path_of_figure(const Collision& collision, int slot, const PathPoint& begin) {
    BodyPath& path = collision.paths[slot];
    const PathPoint end = path_point(collision.bodies, slot, collision.clock.h);
    const Vector fall = touches_of(collision, slot) != FigureTouches::nothing ? Vector{} : (end.way - begin.way) * scalar(0.5);
    lay_path(begin, 0, end, 1, fall, path);
}

/// How a figure goes on from where it waits: as it began the step, as it is at that time on a smooth way, or as it ends the step.
enum class MotionKept { of_begin, of_way, of_end };

/// The part of the step after which a body meets what cannot move, by the separations and the speeds that the step began with; `never`: it does not.
template <class Collision>
scalar time_of_contact(const Collision& collision, const BodyPair& pair, int slot) {
    const Manifold& manifold = collision.solver.records[pair.record].manifold;
    const BodyPath& path = collision.paths[slot];
    const Place at = place_of(slot);
    const RotationTile& rotation = collision.bodies.rotation[at.tile];
    const Vector omega = spin_of(path.A, lane_of(rotation.inv_I_ratio, at.lane) * rotation.inv_I_scale[at.lane], path.L);
    const Vector n = collision.shapes.body_of({pair.body_A}) == slot ? manifold.n : -manifold.n;
    scalar first = never;
    for (int i = 0; i < manifold.count; ++i) {  // bound: 4: Manifold::points_max
        const scalar closing = -dot(n, path.v_CM + cross(omega, manifold.points[i].P - path.r_CM)) * collision.clock.h;
        const scalar room = max(manifold.points[i].separation, scalar(0));
        if (room < closing * never) first = min(first, room / closing);
    }
    return first;
}

/// Whether a machine has met something that cannot move before time t of the step: then it has the motion that this has left it.
template <class Collision>
bool was_struck_before(const Collision& collision, int first, scalar t) {
    bool struck = false;
    const auto look = [&](const BodyPair& pair, int slot, int other) {
        if (!is_dynamic(collision.bodies, slot) || !collision.is_of_figure(slot) || collision.machine_of_body(slot) != first) return;
        if (!is_dynamic(collision.bodies, other)) struck = struck || !(time_of_contact(collision, pair, slot) > t);
    };
    for (int i = 0; i < collision.solved.count; ++i) {  // bound: max_manifolds
        const BodyPair& pair = collision.solved.pairs[i];
        const int A = collision.shapes.body_of({pair.body_A}), B = collision.shapes.body_of({pair.body_B});
        look(pair, A, B);
        look(pair, B, A);
    }
    return struck;
}

/// What impulses of contacts have given a figure they have taken from others that move: then it goes on as it ends the step. So it does where what
/// it meets had a manifold, whose rows have done to it what they could, and where it was struck before. Else what cannot move has yet to take its
/// motion.
template <class Collision>
MotionKept motion_kept(const Collision& collision, int slot, scalar t, bool solved) {
    const FigureTouches touches = touches_of(collision, slot);
    if (touches == FigureTouches::nothing) return MotionKept::of_way;
    if (touches == FigureTouches::what_moves || solved) return MotionKept::of_end;
    const BodyPath& path = collision.paths[slot];
    // A chord goes as far as the body came, in all of the step.
    const scalar way = sqrt(length_sq(path.way)), free_way = sqrt(length_sq(path.v_CM)) * collision.clock.h;
    const scalar at = way < free_way ? t * (way / free_way) : t;
    return was_struck_before(collision, collision.machine_of_body(slot), at) ? MotionKept::of_end : MotionKept::of_begin;
}

/// Twice the energy of a machine as it is, J, that of height included.
template <class Collision>
scalar twice_energy_of_figure(const Collision& collision, int first) {
    scalar twice = 0;
    collision.for_bodies_of(first, [&](int slot) {
        const Place at = place_of(slot);
        const TranslationTile& tile = collision.bodies.translation[at.tile];
        if (is_valid(collision, slot))
            twice += twice_kinetic_energy(collision.bodies, slot) -
                     2 * dot(collision.clock.gravity, lane_of(tile.r_CM, at.lane) - collision.paths[slot].r_CM) / tile.inv_M[at.lane];
    });
    return twice;
}

/// The bodies of a machine become slower as a whole, so that joints hold as they did, where they have more energy than is due to them; and faster
/// where they have less, if it is tied: a floating one would change its momentum by that.
template <class Collision>
void hold_energy_of_figure(const Collision& collision, int first, scalar twice_due) {
    scalar twice_kinetic = 0;
    collision.for_bodies_of(first, [&](int slot) {
        if (is_valid(collision, slot)) twice_kinetic += twice_kinetic_energy(collision.bodies, slot);
    });
    const scalar due = twice_kinetic + (twice_due - twice_energy_of_figure(collision, first));
    if (!(twice_kinetic > 0) || (!(twice_kinetic > due) && !collision.is_tied(first))) return;
    const scalar share = sqrt(max(min(due / twice_kinetic, scalar(4)), scalar(0)));
    collision.for_bodies_of(first, [&](int slot) {
        if (!is_valid(collision, slot)) return;
        FlightState motion = flight_state(collision.bodies, slot);
        motion.v_CM = motion.v_CM * share;
        motion.L = motion.L * share;
        put_state(collision.bodies, slot, motion);
    });
}

/// Bodies of a machine get the motion that they go on with.
template <class Collision>
void put_motions(const Collision& collision, int first, MotionKept kept, scalar t) {
    collision.for_bodies_of(first, [&](int slot) {
        if (!is_valid(collision, slot)) return;
        const FlightState begin = begin_of(collision.paths[slot]);
        FlightState motion = flight_state(collision.bodies, slot);
        const scalar share = kept == MotionKept::of_begin ? scalar(0) : t;
        motion.v_CM = begin.v_CM + (motion.v_CM - begin.v_CM) * share;
        motion.L = begin.L + (motion.L - begin.L) * share;
        put_state(collision.bodies, slot, motion);
    });
}

/// Puts the bodies of a machine to where they were at time t.
template <class Collision>
void put_on_paths(const Collision& collision, int first, scalar t) {
    collision.for_bodies_of(first, [&](int slot) {
        const PathFrame there = frame_on_path(collision.paths[slot], t);
        FlightState motion = flight_state(collision.bodies, slot);
        motion.r_CM = there.r_CM;
        motion.A = there.A;
        if (is_valid(collision, slot)) put_state(collision.bodies, slot, motion);
    });
}

/// The same, and then to where their joints want them. False where they cannot be, and where this
/// moves one by more than it may be deep in what it meets: paths of bodies that turn far together are not known so well.
template <class Collision>
bool put_figure(const Collision& collision, int first, scalar t) {
    put_on_paths(collision, first, t);
    bool near = close_figure(*collision.figures, *collision.loops, first, collision.end_of_machine(first));
    collision.for_bodies_of(first, [&](int slot) {
        const PathFrame there = frame_on_path(collision.paths[slot], t);
        const FlightState now = flight_state(collision.bodies, slot);
        const BodyExtent extent = extent_of(collision.shapes, slot);
        const scalar turned_sq = length_sq(now.A.c0 - there.A.c0) + length_sq(now.A.c1 - there.A.c1) + length_sq(now.A.c2 - there.A.c2);
        const scalar moved = sqrt(length_sq(now.r_CM - there.r_CM)) + sqrt(turned_sq) * extent.reach;
        near = near && !(moved > limits::depth_of_figure * extent.least);
    });
    return near;
}

/// All bodies that joints hold together with one stay where they are at time t, until the next step; or where they are before it, if that is not
/// known well enough. Joints hold there. solved: the two that meet have a manifold. Returns how many wait.
template <class Collision>
int wait_with_figure(const Collision& collision, int slot, scalar t, bool solved) {
    const int first = collision.machine_of_body(slot);
    int waiting = 0;
    collision.for_bodies_of(first, [&](int body) {
        if (is_valid(collision, body)) note_passed_sensors(collision, body, t);
        ++waiting;
    });
    const MotionKept kept = motion_kept(collision, slot, t, solved);
    scalar twice_due = twice_energy_of_figure(collision, first), at = t;
    if (kept != MotionKept::of_end) put_motions(collision, first, kept, t);
    if (kept == MotionKept::of_begin) {
        put_on_paths(collision, first, 0);
        twice_due = twice_energy_of_figure(collision, first);
    }
    int retreats = 0;
    while (retreats < limits::figure_retreats && !put_figure(collision, first, at)) {  // bound: limits::figure_retreats
        at = at / 2;
        ++retreats;
    }
    if (retreats == limits::figure_retreats) put_on_paths(collision, first, at = t);  // joints that do not hold at all, as of a ring that has burst
    hold_energy_of_figure(collision, first, twice_due);
    collision.for_bodies_of(first, [&](int body) {
        if (!is_valid(collision, body)) return;
        const FlightState there = flight_state(collision.bodies, body);
        end_path(collision.paths[body], there.r_CM, there.A, at);
    });
    return waiting;
}

} }  // namespace ingot

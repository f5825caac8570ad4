// SPDX-License-Identifier: MIT
// What happens to fast bodies within a step, impact by impact.
#pragma once

#include "../base/report.h"
#include "../solver/sweeps/move_bodies.h"
#include "../solver/sweeps/block_sweeps.h"
#include "../body/auxiliary.h"
#include "../narrow_phase/find_manifolds.h"
#include "../motion/flight_clock.h"
#include "../motion/integrate_L.h"
#include "../motion/integrate_r.h"
#include "../motion/integrate_v.h"
#include "fast_pairs.h"
#include "time_of_impact.h"
#include "pair_sub_world.h"

namespace ingot { inline namespace INGOT_ABI {

/// What free fall is made of beside the body: gravity, and h of the whole step.
struct FallClock {
    Vector gravity;
    scalar h;
};

/// Everything the collision of a step work on.
template <class Meets>
struct ContinuousCollision {
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
    // bound: log2(max_manifolds) + 1: to - from is halved each turn
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
void consider(const ContinuousCollision<Meets>& collision, int slot, int other) {
    const Surface &A = collision.surfaces.surfaces[slot], &B = collision.surfaces.surfaces[other];
    BodyPath& path = collision.paths[slot];
    const BodyPath& path_B = collision.paths[other];
    if (other == slot || B.shape.kind == ShapeKind::none || !may_meet(path, A, path_B, B) || !collision.meets(slot, other)) return;
    const scalar latest = min(path.next, min(path.until, path_B.until));
    const scalar t = time_of_impact(path, A.shape, path_B, B.shape, latest, !is_solved(collision.solver, slot, other));
    if (!(t < latest)) return;
    path.next = t;
    path.next_slot = static_cast<uint16_t>(other);
}

/// The first that comes to a body.
template <class Meets>
void find_next(const ContinuousCollision<Meets>& collision, int slot) {
    BodyPath& path = collision.paths[slot];
    path.next = path.until < 1 ? path.until : never;
    path.next_slot = static_cast<uint16_t>(slot);
    // bound: max_bodies
    for (int other = 0; other < collision.surfaces.slot_count; ++other) consider(collision, slot, other);
}

/// The fast body to which something comes first; -1: nothing comes.
template <class Meets>
int first_of_all(const ContinuousCollision<Meets>& collision) {
    int first = -1;
    scalar earliest = 1;
    for (int slot = 0; slot < collision.surfaces.slot_count; ++slot) {
        const BodyPath& path = collision.paths[slot];
        if (!path.fast || !(path.next < earliest)) continue;
        first = slot;
        earliest = path.next;
    }
    return first;
}

/// After the paths of two bodies have changed: the impacts that are no more, and those that come of it.
template <class Meets>
void find_next_anew(const ContinuousCollision<Meets>& collision, int slot_A, int slot_B) {
    for (int slot = 0; slot < collision.surfaces.slot_count; ++slot) {
        const BodyPath& path = collision.paths[slot];
        if (!path.fast) continue;
        if (slot == slot_A || slot == slot_B || path.next_slot == slot_A || path.next_slot == slot_B) {
            find_next(collision, slot);
        } else {
            consider(collision, slot, slot_A);
            if (slot_B != slot_A) consider(collision, slot, slot_B);
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

/// A body in free fall, alone in the sub_world, from the begin of its path to time t.
template <class Rotation, class Meets>
void fly_alone(const ContinuousCollision<Meets>& collision, int slot, scalar t, PairSubWorld& sub_world) {
    const BodyPath& path = collision.paths[slot];
    sub_world.clear();
    sub_world.take(0, collision.bodies, collision.surfaces, slot);
    put_state(sub_world.bodies(), 0, {path.r_CM, path.v_CM, path.L, path.A});
    if (t > path.from) fly_freely<Rotation>(sub_world.bodies(), collision.clock.gravity, (t - path.from) * collision.clock.h);
}

/// The motion of a body at time t. In free fall it is exact. Else it is on the chord, with the velocity of the end; where forces would have worked on
/// it on the rest of the way, its speed is less by that.
template <class Rotation, class Meets>
FlightState motion_at(const ContinuousCollision<Meets>& collision, int slot, scalar t, PairSubWorld& sub_world) {
    const BodyPath& path = collision.paths[slot];
    FlightState motion = flight_state(collision.bodies, slot);
    if (!(collision.bodies.translation[place_of(slot).tile].inv_M[place_of(slot).lane] > 0)) return motion;
    if (path.falls_free) {
        fly_alone<Rotation>(collision, slot, t, sub_world);
        return flight_state(sub_world.bodies(), 0);
    }
    const PlacedShape place = place_on_path(path, collision.surfaces.surfaces[slot].shape, t);
    const scalar work = 2 * dot(collision.clock.gravity, motion.r_CM - place.r), v_sq = length_sq(motion.v_CM);
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
void lay_free_path(const ContinuousCollision<Meets>& collision, int slot, const FlightState& from, scalar t, PairSubWorld& sub_world) {
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
    fly_alone<Rotation>(collision, slot, t, sub_world);
    const PathPoint begin = path_point(sub_world.bodies(), 0, h);
    const scalar until = end_of_path(begin.turn, t);
    fly_alone<Rotation>(collision, slot, until, sub_world);
    lay_path(begin, t, path_point(sub_world.bodies(), 0, h), until, a * (h * h / 2), path);
    const bool is_there = t <= 0;  // a step that flies in one part has gone so already
    if (until >= 1 && !is_there) put_state(collision.bodies, slot, flight_state(sub_world.bodies(), 0));
}

/// Lays the path of a body that contacts have moved from `begin` at time t to the end of the step: a chord.
template <class Meets>
void lay_chord(const ContinuousCollision<Meets>& collision, int slot, const PathPoint& begin, scalar t) {
    collision.paths[slot].falls_free = false;
    lay_path(begin, t, path_point(collision.bodies, slot, collision.clock.h), 1, {}, collision.paths[slot]);
}

template <class Meets>
bool is_valid(const ContinuousCollision<Meets>& collision, int slot) {
    const Place at = place_of(slot);
    const TranslationTile& tile = collision.bodies.translation[at.tile];
    return tile.inv_M[at.lane] > 0 && ((collision.bodies.rotation[at.tile].bad | tile.bad) >> at.lane & 1u) == 0;
}

/// Two bodies that touch, alone in their sub_world, for h seconds. True if they press on each other at the end.
template <class Shapes, class Rotation, bool notes_impulses, class Meets>
bool solve_pair_for(const ContinuousCollision<Meets>& collision, PairSubWorld& sub_world, scalar h, StepReport& report) {
    const BodyView two = sub_world.bodies();
    Manifold before, found;
    before.n = {};
    before.count = 0;
    sub_world.pair = {0, 1, 0};
    if (!find_manifold<Shapes>(two, sub_world.surface_view(), sub_world.pair, sub_world.margin(h), before, found)) count(report.pairs_untested);
    sub_world.set_manifold(found);
    if (found.count == 0) {
        fly_freely<Rotation>(two, collision.clock.gravity, h);
        return false;
    }
    mix_materials(sub_world.surface_view(), sub_world.pair, sub_world.record);
    refresh_inv_I_world(two);
    SolverView solver = sub_world.solver(collision.solver);
    ImpactNote note{};
    sub_world.keep_forces();
    solve_by_sweeps<notes_impulses, true>(solver, {two, collision.clock.gravity, h, &note}, report);
    integrate_L(two, h);
    integrate_v(two, h, collision.clock.gravity);
    write_contact_motion(solver, two, collision.clock.gravity, h);
    (void)Rotation::integrate_A(two, h, FlightClock{0, true, h / 2});
    integrate_r(two, h, collision.clock.gravity);
    turn_by_corrections(solver, two, h);
    sub_world.return_forces();
    return sub_world.carries();
}

/// Two bodies that meet at time t: they are together for a moment, in which they give each other what contacts do. Then they fly on; where neither
/// is fast any more and they press on each other, they stay together for the rest of the step.
template <class Shapes, class Rotation, bool notes_impulses, class Meets>
void resolve_impact(const ContinuousCollision<Meets>& collision, int slot_A, int slot_B, scalar t, PairSubWorld& sub_world, StepReport& report) {
    const int slots[2] = {slot_A, slot_B};
    FlightState states[2];
    for (int which = 0; which < 2; ++which) states[which] = motion_at<Rotation>(collision, slots[which], t, sub_world);
    sub_world.clear();
    for (int which = 0; which < 2; ++which) {
        sub_world.take(which, collision.bodies, collision.surfaces, slots[which]);
        put_state(sub_world.bodies(), which, states[which]);
    }
    const scalar h = (1 - t) * collision.clock.h, moment = min(h, sub_world.moment());
    bool pressed = solve_pair_for<Shapes, Rotation, notes_impulses>(collision, sub_world, moment, report);
    const scalar parted = moment < h ? t + moment / collision.clock.h : scalar(1);
    const bool over = parted >= 1 - limits::last_moment;
    PathPoint after[2];
    for (int which = 0; which < 2; ++which) {
        states[which] = flight_state(sub_world.bodies(), which);
        after[which] = path_point(sub_world.bodies(), which, collision.clock.h);
    }
    pressed = pressed && !over && !sub_world.some_fast(h - moment);
    if (pressed) (void)solve_pair_for<Shapes, Rotation, notes_impulses>(collision, sub_world, h - moment, report);

    const FlightState ends[2] = {flight_state(sub_world.bodies(), 0), flight_state(sub_world.bodies(), 1)};
    for (int which = 0; which < 2; ++which) {
        const int slot = slots[which];
        if (!is_valid(collision, slot)) continue;
        BodyPath& path = collision.paths[slot];
        put_state(collision.bodies, slot, ends[which]);
        if (over)
            end_path(path, ends[which].r_CM, ends[which].A, 1);
        else if (pressed)
            lay_chord(collision, slot, after[which], parted);
        else
            lay_free_path<Rotation>(collision, slot, states[which], parted, sub_world);
        path.fast = !over && is_valid(collision, slot) && is_fast_path(path, collision.surfaces.surfaces[slot]);
    }
}

/// A body stays where it is at time t, until the next step.
template <class Rotation, class Meets>
void wait_at(const ContinuousCollision<Meets>& collision, int slot, scalar t, PairSubWorld& sub_world) {
    const FlightState motion = motion_at<Rotation>(collision, slot, t, sub_world);
    put_state(collision.bodies, slot, motion);
    end_path(collision.paths[slot], motion.r_CM, motion.A, t);
    collision.paths[slot].in_contact = true;
}

/// The paths of all bodies as they have gone in this step. True if one is fast.
template <class Rotation, class Meets>
bool lay_all_paths(const ContinuousCollision<Meets>& collision, PairSubWorld& sub_world) {
    bool some = false;
    for (int slot = 0; slot < collision.surfaces.slot_count; ++slot) {
        BodyPath& path = collision.paths[slot];
        const PathPoint begin = {path.r_CM, path.way, path.turn, path.A};
        path.in_contact = takes_part(collision.solver, slot);
        path.falls_free = !path.in_contact;
        path.until = 1;
        if (!is_valid(collision, slot)) {
            end_path(path, flight_state(collision.bodies, slot).r_CM, flight_state(collision.bodies, slot).A, 0);
        } else if (path.in_contact) {
            lay_chord(collision, slot, begin, 0);
            path.fast = is_fast_path(path, collision.surfaces.surfaces[slot]);
        } else if (path.fast) {
            lay_free_path<Rotation>(collision, slot, {path.r_CM, path.v_CM, path.L, path.A}, 0, sub_world);
        } else {
            path.way = flight_state(collision.bodies, slot).r_CM - begin.r_CM;
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
/// report.impacts_deferred: the rest of the step is lost to them, and no energy or momentum.
/// What was made fast by the contacts of this step is seen too: all goes by the ways that bodies have gone.
/// Bound: impacts_in_step_max impacts, and as many parts of paths as their turns need, limits::path_parts_max a body and step.
/// Cost:  a look at every body for each fast one, and some searches for nearest points for those near its path.
template <class Shapes, class Rotation, bool notes_impulses, class Meets>
void follow_fast_bodies(const ContinuousCollision<Meets>& collision, StepReport& report) {
    PairSubWorld sub_world;
    if (!lay_all_paths<Rotation>(collision, sub_world)) return;
    for (int slot = 0; slot < collision.surfaces.slot_count; ++slot)
        if (collision.paths[slot].fast) find_next(collision, slot);

    int impacts = 0;
    // bound: (limits::path_parts_max + 1) max_bodies + 2 limits::impacts_in_step_max: a path that ends took 1 / path_parts_max of the step
    // or more; impacts are counted; a body that waits is fast no more, and an impact makes one more fast at most
    for (int slot_A = first_of_all(collision); slot_A >= 0; slot_A = first_of_all(collision)) {
        const BodyPath& A = collision.paths[slot_A];
        const int slot_B = A.next_slot;
        const BodyPath& B = collision.paths[slot_B];
        const scalar t = A.next;
        if (slot_B == slot_A) {
            lay_free_path<Rotation>(collision, slot_A, motion_at<Rotation>(collision, slot_A, t, sub_world), t, sub_world);
        } else if ((t <= limits::last_moment || (!A.in_contact && !B.in_contact)) && t < 1 - limits::last_moment &&
                   impacts < limits::impacts_in_step_max) {
            ++impacts;
            resolve_impact<Shapes, Rotation, notes_impulses>(collision, slot_A, slot_B, t, sub_world, report);
        } else {
            const bool both = B.fast;
            wait_at<Rotation>(collision, slot_A, t, sub_world);
            if (both) wait_at<Rotation>(collision, slot_B, t, sub_world);
            if (t < 1 - limits::last_moment) count(report.impacts_deferred, both ? 2 : 1);
        }
        find_next_anew(collision, slot_A, slot_B);
    }
}

} }  // namespace ingot

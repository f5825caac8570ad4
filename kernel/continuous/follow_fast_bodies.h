// SPDX-License-Identifier: MIT
// What happens to fast bodies within a step, impact by impact.
#pragma once

#include "fast_pairs.h"
#include "next_impact.h"
#include "resolve_impact.h"
#include "wait_with_figure.h"

namespace ingot { inline namespace INGOT_ABI {

/// Marks bodies that the contacts of the step have moved together with others that can move.
template <class Collision>
void mark_islands(const Collision& collision) {
    for (int i = 0; i < collision.solved.count; ++i) {  // bound: max_manifolds
        const int A = collision.shapes.body_of({collision.solved.pairs[i].body_A}), B = collision.shapes.body_of({collision.solved.pairs[i].body_B});
        if (is_dynamic(collision.bodies, A) && is_dynamic(collision.bodies, B))
            collision.paths[A].kind = collision.paths[B].kind = PathKind::in_island;
    }
}

/// The path of a body as it has gone in this step.
template <class Collision>
void lay_path_of_step(const Collision& collision, int slot, PairRoom<Collision>& room) {
    BodyPath& path = collision.paths[slot];
    if (is_kinematic(collision, slot)) {
        begin_kinematic_path(path);
        if (path.fast) collision.lists->follow(slot);
        return;
    }
    const PathPoint begin = {path.r_CM, path.way, path.turn, path.A};
    const Vector way = flight_state(collision.bodies, slot).r_CM - begin.r_CM;
    const bool in_contact = path.kind != PathKind::free || takes_part(collision.solver, slot);
    const bool in_figure = collision.is_of_figure(slot);
    path.until = 1;
    if (!is_valid(collision, slot)) {
        end_path(path, flight_state(collision.bodies, slot).r_CM, flight_state(collision.bodies, slot).A, 0);
    } else if (in_contact) {
        if (path.kind == PathKind::free) path.kind = PathKind::on_fixed;
        path.of_step = true;
        if (in_figure)
            lay_path_of_figure(collision, slot, begin);
        else
            lay_chord(collision, slot, begin);
    } else if (path.fast) {
        lay_free_path(collision, slot, true, room);
    } else {
        path.way = way;
    }
    const Vector turn = in_contact ? path.turn : omega_of(collision.bodies, slot) * collision.clock.h;
    if (is_tree<typename Collision::TreeType> &&
        (in_figure || leaves_bounds(begin, way, turn, extent_of(collision.shapes, slot), collision.shapes.surfaces.unit)))
        put_in_tree(collision, slot);
    if (path.fast || (in_contact && is_fast_path(path, extent_of(collision.shapes, slot)))) collision.lists->follow(slot);
}

/// Lets happen what comes first to a body.
template <class Collision>
void go_on(const Collision& collision, int slot, PairRoom<Collision>& room) {
    const int other = collision.paths[slot].next_slot;
    const scalar t = collision.paths[slot].next;
    ChangedPaths changed = {};
    if (other == slot) {
        lay_on(collision, slot, room, changed);
    } else if (can_follow(collision, slot, other, t) && take_impact(collision, slot, other)) {
        resolve_impact(collision, slot, other, t, room, changed);
    } else {
        const int waiting = wait_at_impact(collision, slot, other, t, room, changed);
        if (t < 1 - limits::last_moment) count(collision.report->impacts_deferred, waiting);
    }
    follow_anew(collision, changed, room);
    if (changed.count > 0 && !changed.has(slot)) find_next(collision, slot, room);
    if (changed.count > 0) return;
    collision.paths[slot].next = never;  // nobody is left to wait
    collision.lists->move(slot);
}

/// Follows the fast bodies of a step of h seconds through their impacts. Comes last, when all bodies are where they would be without.
///
/// All goes by paths: each body has one that leads from the begin of the step to where it is, part by part, and what it meets on it is found before
/// it goes there. So no fast body gets deeper into anything than limits::skin_share of the thinner of the two, or than it was at the begin.
/// Impact by impact in the order of time, two bodies that meet are taken back to that time, and for a moment go on together, with restitution,
/// friction, forces, what else their surfaces have, and all that is fixed around them. Then each goes on alone: free, or along what it touches that
/// cannot move; two that press on each other and hardly move against each other go on together.
/// A body that the contacts of the step have moved together with others is not taken from them: it waits where it meets another, and so does the
/// other, for the next step, which finds both touching. So does whoever meets one that waits or sleeps, and whoever meets one that has had
/// limits::impacts_of_body_max impacts. Only what meets at the very begin of the step does not wait, or it might wait for ever. Those who wait are
/// counted in report.impacts_deferred: the rest of the step is lost to them, but no energy or momentum.
/// Of bodies with joints all that hang together in a figure wait, where their joints hold: see figures_on_paths.h.
/// What was made fast by the contacts of this step is seen too: all goes by the ways that bodies have gone.
/// Of bodies of several shapes the first pair of shapes that meets counts, and all that touch then are solved together; those that find no room
/// among limits::pair_manifolds_max are counted in report.contacts_lost.
/// Kinematic bodies are met where they are at the time, and one that is fast meets those in its way; it waits for nobody, so it also throws what
/// the contacts of the step have moved with others. Whom it has met limits::impacts_of_body_max times it meets in the next step.
/// Bound: impacts_of_body_max impacts a body, and as many parts of paths as their turns need, limits::path_parts_max a body and step.
/// Cost:  for each fast body and part of its path O(log bodies) with a tree, a look at every body without; and some searches for nearest points for
///        those near its path.
template <class Collision>
void follow_fast_bodies(const Collision& collision) {
    PairRoom<Collision> room;
    mark_islands(collision);
    mark_figures(collision);
    collision.moving.for_each([&](int slot) { lay_path_of_step(collision, slot, room); });
    collision.moving.for_each([&](int slot) {
        if (collision.paths[slot].is_followed) find_next(collision, slot, room);
    });

    // bound: (4 limits::path_parts_max + 1 + 6 limits::impacts_of_body_max) max_bodies: a path that ends took 1 / path_parts_max of the step or more,
    // or was the moment of an impact, or that of another cut it; impacts are counted; who waits does so once. And each of these makes others look
    // anew, who were to meet one of its bodies
    for (int slot = collision.lists->first(); slot >= 0; slot = collision.lists->first()) {
        if (is_still_met(collision, slot))
            go_on(collision, slot, room);
        else
            find_next(collision, slot, room);
    }
    collision.moving.for_each([&](int slot) { note_passed_sensors(collision, slot, 1); });
    return_to_bounds(collision);
}

} }  // namespace ingot

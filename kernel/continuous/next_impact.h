// SPDX-License-Identifier: MIT
// What comes first to a fast body, and to all of them.
#pragma once

#include "continuous_collision.h"
#include "time_of_impact.h"

namespace ingot { inline namespace INGOT_ABI {

/// Calls each(slot) for the bodies that a body may meet on its path: all, or those whose bounds it comes near, and those that may be outside of
/// theirs. Some more than once.
template <class Collision, class Each>
void for_others_near(const Collision& collision, int slot, const Each& each) {
    if constexpr (is_tree<typename Collision::TreeType>) {
        const BodyPath& path = collision.paths[slot];
        const scalar time = path.until - path.from;
        const Vector end = path.r_CM + (path.way + path.fall * time) * time;
        // A parabola leaves its chord by a quarter of the fall.
        const scalar reach = extent_of(collision.shapes, slot).radius * (1 + limits::flatness) + sum_of_components(path.fall) * scalar(0.25) +
                             limits::contact_margin * collision.shapes.surfaces.unit +
                             8 * epsilon * (sum_of_components(path.r_CM) + sum_of_components(end));
        const Vector more = {reach, reach, reach};
        for_near_shapes(collision.tree, {min(path.r_CM, end) - more, max(path.r_CM, end) + more}, [&](int shape) {
            const int other = collision.shapes.body_of({shape});
            if (other != slot) each(other);
        });
        // bound: max_bodies: a list without rings
        for (int other = collision.lists->first_stray; other != 0; other = collision.paths[other - 1].next_stray)
            if (other - 1 != slot) each(other - 1);
    } else {
        for (int other = 0; other < collision.shapes.body_count(); ++other)  // bound: max_bodies
            if (other != slot) each(other);
    }
}

/// Calls each(slot) for the bodies that are fast.
template <class Collision, class Each>
void for_fast(const Collision& collision, const Each& each) {
    // bound: max_bodies: a list without rings
    for (int slot = collision.lists->first_fast; slot != 0; slot = collision.paths[slot - 1].next_fast)
        if (collision.paths[slot - 1].fast) each(slot - 1);
}

/// Whether a kinematic body takes no notice of another: what cannot move, what sleeps, and what it has met as often as may be.
template <class Collision>
bool is_passed_by(const Collision& collision, int slot, int other) {
    if (!is_kinematic(collision, slot)) return false;
    return !is_dynamic(collision.bodies, other) || !collision.moving.has(other) || collision.paths[other].impacts >= limits::impacts_of_body_max;
}

/// Looks whether one body meets another before all else that comes to it. Of two that come at the same time the first counts, or, where they are
/// looked at in whatever order, the lower.
template <class Collision>
void consider(const Collision& collision, int slot, int other, bool lower_counts) {
    if (is_passed_by(collision, slot, other)) return;
    const scalar unit = collision.shapes.surfaces.unit;
    BodyPath at_rest, &path = collision.paths[slot];
    const BodyPath& path_B = path_of(collision, other, at_rest);
    collision.shapes.for_shapes(slot, [&](ShapeSlot shape_A) {
        const ShapeOnPath A = shape_on_path(collision.shapes, shape_A, path);
        collision.shapes.for_shapes(other, [&](ShapeSlot shape_B) {
            const ShapeOnPath B = shape_on_path(collision.shapes, shape_B, path_B);
            if (!may_meet(A, B, unit) || !collision.meets(shape_A.number, shape_B.number)) return;
            const scalar latest = min(path.next, min(path.until, path_B.until));
            const scalar t = time_of_impact(A, B, unit, latest, !is_solved(collision, {shape_A, shape_B}));
            if (is_kinematic(collision, slot) && !(t < 1 - limits::last_moment)) return;  // the next step finds them
            const bool ties = lower_counts && t <= latest && !(t < path.next) && path.next_slot != slot && other < path.next_slot;
            if (!(t < latest || ties)) return;
            path.next = t;
            path.next_slot = static_cast<Index>(other);
        });
    });
}

/// Sensors that a fast body passes on its path until time t.
template <class Collision>
void note_passed_sensors([[maybe_unused]] const Collision& collision, [[maybe_unused]] int slot, [[maybe_unused]] scalar t) {
    if constexpr (decltype(collision.sensors)::some) {
        const scalar unit = collision.shapes.surfaces.unit;
        const BodyPath& path = collision.paths[slot];
        if (!path.fast || is_kinematic(collision, slot)) return;
        for_others_near(collision, slot, [&](int other) {
            BodyPath at_rest;
            const BodyPath& path_B = path_of(collision, other, at_rest);
            collision.shapes.for_shapes(slot, [&](ShapeSlot shape_A) {
                collision.shapes.for_shapes(other, [&](ShapeSlot shape_B) {
                    if (!collision.sensors.has(shape_A.number, shape_B.number)) return;
                    const ShapeOnPath A = shape_on_path(collision.shapes, shape_A, path), B = shape_on_path(collision.shapes, shape_B, path_B);
                    if (may_meet(A, B, unit) && time_of_impact(A, B, unit, t, false) <= t) collision.sensors.note(shape_A.number, shape_B.number);
                });
            });
        });
    }
}

/// The first that comes to a body.
template <class Collision>
void find_next(const Collision& collision, int slot) {
    BodyPath& path = collision.paths[slot];
    path.next = path.until < 1 ? path.until : never;
    path.next_slot = static_cast<Index>(slot);
    for_others_near(collision, slot, [&](int other) { consider(collision, slot, other, true); });
}

/// The fast body to which something comes first; -1: nothing comes.
template <class Collision>
int first_of_all(const Collision& collision) {
    int first = -1;
    scalar earliest = 1;
    for_fast(collision, [&](int slot) {
        const scalar next = collision.paths[slot].next;
        if (!(next < earliest || (next <= earliest && slot < first))) return;
        first = slot;
        earliest = next;
    });
    return first;
}

/// After the paths of two bodies have changed: the impacts that are no more, and those that come of it.
template <class Collision>
void find_next_anew(const Collision& collision, int slot_A, int slot_B) {
    for_fast(collision, [&](int slot) {
        const BodyPath& path = collision.paths[slot];
        if (slot == slot_A || slot == slot_B || path.next_slot == slot_A || path.next_slot == slot_B) {
            find_next(collision, slot);
        } else {
            consider(collision, slot, slot_A, false);
            if (slot_B != slot_A) consider(collision, slot, slot_B, false);
        }
    });
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// What comes first to a fast body, and to all of them.
#pragma once

#include "continuous_collision.h"
#include "time_of_impact.h"

namespace ingot { inline namespace INGOT_ABI {

/// Looks whether one body meets another before all else that comes to it.
template <class Collision>
void consider(const Collision& collision, int slot, int other) {
    if (other == slot) return;
    BodyPath at_rest, &path = collision.paths[slot];
    const BodyPath& path_B = path_of(collision, other, at_rest);
    collision.shapes.for_shapes(slot, [&](ShapeSlot shape_A) {
        const ShapeOnPath A = shape_on_path(collision.shapes, shape_A, path);
        collision.shapes.for_shapes(other, [&](ShapeSlot shape_B) {
            const ShapeOnPath B = shape_on_path(collision.shapes, shape_B, path_B);
            if (!may_meet(A, B) || !collision.meets(shape_A.number, shape_B.number)) return;
            const scalar latest = min(path.next, min(path.until, path_B.until));
            const scalar t = time_of_impact(A, B, latest, !is_solved(collision, {shape_A, shape_B}));
            if (!(t < latest)) return;
            path.next = t;
            path.next_slot = static_cast<uint16_t>(other);
        });
    });
}

/// Sensors that a fast body passes on its path until time t.
template <class Collision>
void note_passed_sensors([[maybe_unused]] const Collision& collision, [[maybe_unused]] int slot, [[maybe_unused]] scalar t) {
    if constexpr (decltype(collision.sensors)::some) {
        const BodyPath& path = collision.paths[slot];
        if (!path.fast) return;
        for (int other = 0; other < collision.shapes.body_count(); ++other) {  // bound: max_bodies
            if (other == slot) continue;
            BodyPath at_rest;
            const BodyPath& path_B = path_of(collision, other, at_rest);
            collision.shapes.for_shapes(slot, [&](ShapeSlot shape_A) {
                collision.shapes.for_shapes(other, [&](ShapeSlot shape_B) {
                    if (!collision.sensors.has(shape_A.number, shape_B.number)) return;
                    const ShapeOnPath A = shape_on_path(collision.shapes, shape_A, path), B = shape_on_path(collision.shapes, shape_B, path_B);
                    if (may_meet(A, B) && time_of_impact(A, B, t, false) <= t) collision.sensors.note(shape_A.number, shape_B.number);
                });
            });
        }
    }
}

/// The first that comes to a body.
template <class Collision>
void find_next(const Collision& collision, int slot) {
    BodyPath& path = collision.paths[slot];
    path.next = path.until < 1 ? path.until : never;
    path.next_slot = static_cast<uint16_t>(slot);
    for (int other = 0; other < collision.shapes.body_count(); ++other) consider(collision, slot, other);  // bound: max_bodies
}

/// The fast body to which something comes first; -1: nothing comes.
template <class Collision>
int first_of_all(const Collision& collision) {
    int first = -1;
    scalar earliest = 1;
    collision.moving.for_each([&](int slot) {
        const BodyPath& path = collision.paths[slot];
        if (!path.fast || !(path.next < earliest)) return;
        first = slot;
        earliest = path.next;
    });
    return first;
}

/// After the paths of two bodies have changed: the impacts that are no more, and those that come of it.
template <class Collision>
void find_next_anew(const Collision& collision, int slot_A, int slot_B) {
    collision.moving.for_each([&](int slot) {
        const BodyPath& path = collision.paths[slot];
        if (!path.fast) return;
        if (slot == slot_A || slot == slot_B || path.next_slot == slot_A || path.next_slot == slot_B) {
            find_next(collision, slot);
        } else {
            consider(collision, slot, slot_A);
            if (slot_B != slot_A) consider(collision, slot, slot_B);
        }
    });
}

} }  // namespace ingot

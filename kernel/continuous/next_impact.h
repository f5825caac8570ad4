// SPDX-License-Identifier: MIT
// What comes first to a fast body, and to all of them.
#pragma once

#include "contacts_of_figures.h"

namespace ingot { inline namespace INGOT_ABI {

/// All that a body reaches on its path as it is.
template <class Collision>
TreeBox box_of_path(const Collision& collision, int slot) {
    const BodyPath& path = collision.paths[slot];
    const scalar time = path.until - path.from;
    const Vector end = path.r_CM + (path.way + path.fall * time) * time;
    // A parabola leaves its chord by a quarter of the fall.
    const scalar reach = extent_of(collision.shapes, slot).radius * (1 + limits::flatness) + sum_of_components(path.fall) * scalar(0.25) +
                         8 * epsilon * (sum_of_components(path.r_CM) + sum_of_components(end));
    const Vector more = {reach, reach, reach};
    return {min(path.r_CM, end) - more, max(path.r_CM, end) + more};
}

/// Whoever looks for a body that may have left the bounds of the step finds it where its path is.
template <class Collision>
void put_in_tree([[maybe_unused]] const Collision& collision, [[maybe_unused]] int slot) {
    if constexpr (is_tree<typename Collision::TreeType>) {
        const TreeBox box = box_of_path(collision, slot);
        collision.lists->add_stray(slot);
        collision.shapes.for_shapes(slot, [&](ShapeSlot shape) { trees::put_in_place(collision.tree, shape.number, box, true); });
    }
}
/// Ends that, once all bodies are where they stay: the search for pairs goes by fat AABBs.
template <class Collision>
void return_to_bounds([[maybe_unused]] const Collision& collision) {
    if constexpr (is_tree<typename Collision::TreeType>)
        // bound: max_bodies: a list without rings
        for (int slot = collision.lists->first_stray; slot != 0; slot = collision.paths[slot - 1].next_stray)
            collision.shapes.for_shapes(slot - 1, [&](ShapeSlot shape) {
                trees::put_in_place(collision.tree, shape.number, trees::box_of(collision.floor.bounds, shape.number), true);
            });
}

/// Calls each(slot) for the bodies that a body may meet on its path: all that can move, or those whose bounds it comes near. Some more than once.
template <class Collision, class Each>
void for_others_near(const Collision& collision, int slot, const Each& each) {
    const TreeBox box = box_of_path(collision, slot);
    const scalar margin = limits::contact_margin * collision.shapes.surfaces.unit;
    const Vector more = {margin, margin, margin};
    int last = -1;  // of a body of several shapes
    for_shapes_in_box(collision, slot, {box.low - more, box.high + more}, [&](ShapeSlot shape) {
        const int other = collision.shapes.body_of(shape);
        if (other != last) each(other);
        last = other;
    });
}

/// Whether a body does not look for another. A kinematic body passes what it cannot move, as it is fixed or rests, and leaves whom it has met
/// limits::impacts_of_body_max times to the next step. One that stands lets others come to it.
template <class Collision>
bool is_passed_by(const Collision& collision, int slot, int other) {
    const bool stands = collision.paths[slot].kind == PathKind::standing;
    if (!stands && !is_kinematic(collision, slot)) return false;
    if (!is_dynamic(collision.bodies, other) || !collision.moving.has(other)) return true;
    return stands ? collision.paths[other].kind == PathKind::standing : collision.paths[other].impacts >= limits::impacts_of_body_max;
}

/// Whether the contacts of two shapes have been solved along the path of the first body, as it is. solved: their manifold of the step, or null.
template <class Collision>
bool is_solved(const Collision& collision, int slot, int other, const BodyPair* solved) {
    const BodyPath& path = collision.paths[slot];
    if (path.of_step) return solved != nullptr;
    if (path.kind == PathKind::in_pair && path.partner == other) return true;
    return (path.kind == PathKind::in_pair || path.kind == PathKind::on_fixed) && !is_dynamic(collision.bodies, other);
}

/// Whether a manifold is that of two shapes; of a level, one of its own.
template <class Collision>
bool is_part_of([[maybe_unused]] const Collision& collision, const ShapePair& of, const ShapePair& pair) {
    if constexpr (sees_levels<Collision>)
        if (collision.shapes.surface(pair.B).shape.kind == ShapeKind::level)
            return of.A.number == pair.A.number && of.B.number >= pair.B.number && of.B.number < pair.B.number + level_patches;
    return of.is(pair);
}

/// Whether two shapes that touch at time t go on into each other, on their paths as they are: whether a point of their contact would be deeper by the
/// gap of an impact after the time `rest`. Points that an edge inside a floor makes are none. met: where they touch, if they have just come to touch;
/// else null.
template <class Collision>
bool closes_in(const Collision& collision, int slot, int other, const ShapePair& pair, scalar t, scalar rest, const MetPoint* met,
               PairRoom<Collision>& room) {
    BodyPath at_rest;
    const bool two_move = is_valid(collision, other);
    const BodyPath* const paths[2] = {&collision.paths[slot], &path_of(collision, other, at_rest)};
    PathFrame at[2];
    gather_pair(collision, slot, two_move ? other : -1, room);
    for (int which = 0; which < 2; ++which) {
        at[which] = frame_on_path(*paths[which], t);
        if (which < room.two.count) put_state(room.two.bodies(), which, {at[which].r_CM, paths[which]->way, paths[which]->L, at[which].A});
    }
    room.at = t;
    StepReport& report = *collision.report;
    const Index lost = report.contacts_lost, untested = report.pairs_untested;
    if (two_move)
        find_contact(collision, room, {true, 0, met}, pair, {0, 1, no_record});
    else
        find_pair_contacts(collision, room, {true, 0, met, other});
    report.contacts_lost = lost;  // who only looks loses nothing
    report.pairs_untested = untested;
    const auto way_of = [&](int which, const Vector& P) {
        const BodyPath& path = *paths[which];
        const Vector arm = P - at[which].r_CM;
        // At its begin the motion is known, and a steady turn is only its mean.
        if (which < room.two.count && !(t > path.from)) return (path.v_CM + cross(omega_of(room.two.bodies(), which), arm)) * collision.clock.h;
        return path.way + path.fall * (2 * (t - path.from)) + cross(path.turn, arm);
    };
    scalar closing = 0;
    // bound: limits::pair_manifolds_max
    for (int place = 0; place < room.contacts.count; ++place) {
        if (!is_part_of(collision, room.contacts.shapes[place], pair)) continue;
        const Manifold& manifold = room.contacts.records[place].manifold;
        // bound: 4: Manifold::points_max
        for (int point_i = 0; point_i < manifold.count; ++point_i) {
            const Vector& P = manifold.points[point_i].P;
            closing = max(closing, dot(manifold.n, way_of(1, P) - way_of(0, P)));
        }
    }
    const scalar least = min(least_half_extent(collision.shapes.surface(pair.A).shape, collision.shapes.hull(pair.A)),
                             least_half_extent(collision.shapes.surface(pair.B).shape, collision.shapes.hull(pair.B)));
    // In a heap that is hit bodies meet again and again: those with many impacts may get as deep as their skins.
    const auto is_often_hit = [](const BodyPath& path) { return path.impacts > limits::impacts_of_body_max / 2; };
    const scalar gap = min(limits::impact_gap * least, limits::impact_gap_max * collision.shapes.surfaces.unit);
    return closing * rest > (is_often_hit(*paths[0]) || is_often_hit(*paths[1]) ? limits::skin_share * least : gap);
}

/// When two shapes, or a shape and a triangle of a level, meet on the paths of their bodies, as these are.
///
/// Where they touch already, and no contact has seen to it, they meet at once if they close in. And a body that is led along by what it touches does
/// not meet the next part of the same floor: the two are passed as if they touched. manifold: theirs of the step, or null.
template <class Collision>
scalar time_of_meeting(const Collision& collision, const MetPair& met, const BodyPair* manifold, scalar latest, PairRoom<Collision>& room) {
    const ShapeOnPath &A = met.A, &B = met.B;
    if (has_stayed_outside(collision, met, manifold)) return never;
    const BodyPath& path = A.path;
    const scalar unit = collision.shapes.surfaces.unit, begin = max(path.from, B.path.from);
    const bool solved = is_solved(collision, met.slot, met.other, manifold);
    const scalar touch =
        solved ? limits::touching_gap * scale_of(unit, collision.shapes.surfaces.halvings(met.pair.A.number, met.pair.B.number)) : scalar(0);
    const TimeOfImpact first = time_of_impact(A, B, {unit, 0, latest, touch});
    const auto closes_at = [&](scalar t, scalar rest, const MetPoint* point) {
        return closes_in(collision, met.slot, met.other, met.pair, t, rest, point, room);
    };
    if (first.touched && begin <= latest && !solved && closes_at(begin, 1 - begin, nullptr)) return begin;
    const bool is_led = path.kind != PathKind::free && !is_dynamic(collision.bodies, met.other) && !is_kinematic(collision, met.other);
    const MetPoint point = {met.pair, first.n, first.P};
    if (!(first.t < never) || first.touched || !is_led || closes_at(first.t, path.until - first.t, &point)) return first.t;
    return time_of_impact(A, B, {unit, first.t, latest, touch}).t;
}

/// Calls each(B, n) for what a shape may meet of another on their paths: that one, or the triangles of a level, and their normals.
template <class Collision, class Each>
void for_parts_on_path([[maybe_unused]] const Collision& collision, const ShapeOnPath& A, const ShapeOnPath& B, const Each& each) {
    const scalar unit = collision.shapes.surfaces.unit;
    if (!may_meet(A, B, unit)) return;
    if constexpr (sees_levels<Collision>)
        if (B.shape.kind == ShapeKind::level) return for_triangles_on_path<typename Collision::SceneTraits::Shapes>(A, B, unit, each);
    each(B, Vector{});
}

/// The same of two shapes, whatever they are.
template <class Collision>
scalar time_of_meeting(const Collision& collision, int slot, int other, const ShapePair& pair, scalar latest, PairRoom<Collision>& room) {
    BodyPath at_rest;
    const ShapeOnPath A = shape_on_path(collision.shapes, pair.A, collision.paths[slot]);
    const ShapeOnPath B = shape_on_path(collision.shapes, pair.B, path_of(collision, other, at_rest));
    scalar first = never;
    for_parts_on_path(collision, A, B, [&](const ShapeOnPath& part, const Vector& n) {
        const MetPair met = {slot, other, pair, A, part};
        first = min(first, time_of_meeting(collision, met, find_solved(collision, pair, n), min(latest, first), room));
    });
    return first;
}

/// Looks whether one body meets another before all else that comes to it. Of two that come at the same time the lower counts.
template <class Collision>
void consider(const Collision& collision, int slot, int other, PairRoom<Collision>& room) {
    if (is_passed_by(collision, slot, other) || is_carried_along(collision, slot, other)) return;
    BodyPath at_rest, &path = collision.paths[slot];
    const BodyPath& path_B = path_of(collision, other, at_rest);
    const scalar until = min(path.until, path_B.until);
    collision.shapes.for_shapes(slot, [&](ShapeSlot shape_A) {
        collision.shapes.for_shapes(other, [&](ShapeSlot shape_B) {
            if (!collision.meets(shape_A.number, shape_B.number) || is_companion(collision, shape_B)) return;
            const scalar latest = min(path.next, until), t = time_of_meeting(collision, slot, other, {shape_A, shape_B}, latest, room);
            if (is_kinematic(collision, slot) && !(t < 1 - limits::last_moment)) return;  // the next step finds them
            if (is_left_to_contacts(collision, slot, other, {shape_A, shape_B}, t)) return;
            const bool ties = t <= latest && !(t < path.next) && path.next_slot != slot && other < path.next_slot;
            if (!(t < latest || ties)) return;
            path.next = t;
            path.next_slot = static_cast<Index>(other);
            path.next_version = path_B.version;
        });
    });
}

/// Sensors that a fast body passes on its path until time t.
template <class Collision>
void note_passed_sensors([[maybe_unused]] const Collision& collision, [[maybe_unused]] int slot, [[maybe_unused]] scalar t) {
    if constexpr (decltype(collision.sensors)::some) {
        const scalar unit = collision.shapes.surfaces.unit;
        const BodyPath& path = collision.paths[slot];
        if (!path.is_followed || path.kind == PathKind::standing || is_kinematic(collision, slot)) return;
        for_others_near(collision, slot, [&](int other) {
            BodyPath at_rest;
            const BodyPath& path_B = path_of(collision, other, at_rest);
            collision.shapes.for_shapes(slot, [&](ShapeSlot shape_A) {
                collision.shapes.for_shapes(other, [&](ShapeSlot shape_B) {
                    if (!collision.sensors.has(shape_A.number, shape_B.number) || is_companion(collision, shape_B)) return;
                    const ShapeOnPath A = shape_on_path(collision.shapes, shape_A, path), B = shape_on_path(collision.shapes, shape_B, path_B);
                    bool meet = false;
                    for_parts_on_path(collision, A, B, [&](const ShapeOnPath& part, const Vector&) {
                        meet = meet || time_of_impact(A, part, {unit, 0, t, 0}).t <= t;
                    });
                    if (meet) collision.sensors.note(shape_A.number, shape_B.number);
                });
            });
        });
    }
}

/// Finds what comes first to a body. Two that meet need not both find it: so nothing is found anew for a body whose path has not changed.
template <class Collision>
void find_next(const Collision& collision, int slot, PairRoom<Collision>& room) {
    BodyPath& path = collision.paths[slot];
    path.next = path.until < 1 ? path.until : never;
    path.next_slot = static_cast<Index>(slot);
    for_others_near(collision, slot, [&](int other) { consider(collision, slot, other, room); });
    collision.lists->move(slot);
}

/// Whether what comes first to a body still does: whom it meets has had no other path since that was found.
template <class Collision>
bool is_still_met(const Collision& collision, int slot) {
    BodyPath at_rest;
    const BodyPath& path = collision.paths[slot];
    return path.next_slot == slot || path_of(collision, path.next_slot, at_rest).version == path.next_version;
}

/// Bodies whose paths have changed.
struct ChangedPaths {
    static constexpr int room = 4;  ///< two that meet, and their partners
    int slots[room], count;

    /// Calls each(slot) for all of them, in the order in which they came.
    template <class Each>
    INGOT_INLINE void over_all(const Each& each) const {
        for (int i = 0; i < count; ++i) each(slots[i]);  // bound: room
    }
    bool has(int slot) const {
        bool found = false;
        over_all([&](int changed) { found = found || changed == slot; });
        return found;
    }
    void add(int slot) {
        if (!has(slot)) slots[count++] = slot;
    }
};

} }  // namespace ingot

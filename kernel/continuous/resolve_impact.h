// SPDX-License-Identifier: MIT
// Two bodies that meet within a step, in a world of their own.
#pragma once

#include "../narrow_phase/find_manifolds.h"
#include "../solver/conduct_substeps.h"
#include "../solver/sweeps/move_bodies.h"
#include "../body/kinematic_motion.h"
#include "free_paths.h"

namespace ingot { inline namespace INGOT_ABI {

/// How fast the points of two bodies approach each other.
INGOT_INLINE ImpactNote note_of(const BodyView& two, const Manifold& manifold) {
    const FlightState A = flight_state(two, 0), B = flight_state(two, 1);
    const Vector omega_A = omega_of(two, 0), omega_B = omega_of(two, 1);
    ImpactNote note{};
    // bound: 4: Manifold::points_max
    for (int point_i = 0; point_i < manifold.count; ++point_i) {
        const Vector& P = manifold.points[point_i].P;
        const scalar speed = dot(manifold.n, B.v_CM + cross(omega_B, P - B.r_CM) - A.v_CM - cross(omega_A, P - A.r_CM));
        if (!(speed > note.speed)) continue;
        note.speed = speed;
        note.point = static_cast<uint8_t>(point_i);
    }
    return note;
}

/// The shapes that gave each other an impulse, for events.
template <class Collision>
void note_flights(const Collision& collision, const typename Collision::Contacts& contacts) {
    for (int place = 0; place < contacts.count; ++place) {  // bound: limits::pair_manifolds_max
        if (!contacts.notes[place].carried) continue;
        const Manifold& manifold = contacts.records[place].manifold;
        const int A = contacts.shapes[place].A.number, B = contacts.shapes[place].B.number;
        collision.flights.note({static_cast<Index>(A < B ? A : B), static_cast<Index>(A < B ? B : A),
                                manifold.points[contacts.notes[place].point].P, A < B ? manifold.n : -manifold.n, contacts.notes[place].speed});
    }
}

/// The manifolds of two bodies in their sub-world that can touch within h seconds, with what their surfaces are to each other.
template <class Collision>
void find_pair_contacts(const Collision& collision, const int (&slots)[2], PairRoom<Collision>& room, scalar h, StepReport& report) {
    const SurfaceView& surfaces = collision.shapes.surfaces;
    const scalar margin = room.two.margin(h, surfaces.unit);
    const FlightState states[2] = {flight_state(room.two.bodies(), 0), flight_state(room.two.bodies(), 1)};
    const auto placed = [&](int which, ShapeSlot shape) {
        const BodyShapes& shapes = collision.shapes;
        return place_on_body(shapes.surface(shape).shape, shapes.place(shape), shapes.hull(shape), states[which].r_CM, states[which].A);
    };
    room.contacts.count = 0;
    collision.shapes.for_shapes(slots[0], [&](ShapeSlot shape_A) {
        const PlacedShape A = placed(0, shape_A);
        collision.shapes.for_shapes(slots[1], [&](ShapeSlot shape_B) {
            if (!collision.meets(shape_A.number, shape_B.number)) return;
            const PlacedShape B = placed(1, shape_B);
            Manifold before, found;
            before.n = {};
            before.count = 0;
            found.halvings = static_cast<uint16_t>(surfaces.halvings(shape_A.number, shape_B.number));
            const Margin search = {margin, limits::fast_margin * scale_of(surfaces.unit, found.halvings)};
            if (!collide_placed<typename Collision::SceneTraits::Shapes>(A, B, search, before, found)) count(report.pairs_untested);
            if (found.count == 0) return;
            const int place = room.contacts.place_for(found, report.contacts_lost);
            if (place < 0) return;
            room.contacts.put(place, found, {shape_A, shape_B});
            const BodyPair pair = {static_cast<Index>(shape_A.number), static_cast<Index>(shape_B.number), no_record};
            mix_materials(surfaces, pair, room.contacts.records[place]);
            room.contacts.notes[place] = note_of(room.two.bodies(), found);
            room.contacts.mix(place, collision.materials, {A.A, B.A});
        });
    });
}

/// Kinematic bodies of a sub-world as they are at time t, and how they move: see body/kinematic_motion.h.
template <class Collision>
void show_kinematic(const Collision& collision, const int (&slots)[2], scalar t, PairSubWorld& two) {
    for (int which = 0; which < 2; ++which) {
        if (!is_kinematic(collision, slots[which])) continue;
        const BodyPath& path = collision.paths[slots[which]];
        const PathFrame at = frame_on_path(path, t);
        put_state(two.bodies(), which, {at.r_CM, {}, {}, at.A});
        show_kinematic_motion(two.bodies(), which, path.way * (1 / collision.clock.h), path.turn * (1 / collision.clock.h));
    }
}
template <class Collision>
void hide_kinematic(const Collision& collision, const int (&slots)[2], PairSubWorld& two) {
    for (int which = 0; which < 2; ++which)
        if (is_kinematic(collision, slots[which])) hide_kinematic_motion(two.bodies(), which);
}

/// Two bodies in their sub-world for h seconds, by the laws of any step. True if they press on each other at the end.
template <class Collision>
bool solve_pair_for(const Collision& collision, const int (&slots)[2], PairRoom<Collision>& room, scalar h, StepReport& report) {
    using Traits = typename Collision::SceneTraits;
    const BodyView two = room.two.bodies();
    const Vector gravity = collision.clock.gravity;
    find_pair_contacts(collision, slots, room, h, report);
    if (room.contacts.count == 0) {
        hide_kinematic(collision, slots, room.two);
        fly_freely<typename Traits::Rotation>(two, gravity, h);
        return false;
    }
    refresh_inv_I_world(two);
    typename Traits::View solver = room.contacts.solver(collision.solver);
    room.two.keep_forces();
    Traits::Solver::template solve_pair<Traits::notes_impulses, Traits::bounces>(solver, {two, gravity, h, {room.contacts.notes, nullptr}}, report);
    hide_kinematic(collision, slots, room.two);
    integrate_L(two, h);
    integrate_v(two, h, gravity);
    write_contact_motion(solver, NoJointedBodies{}, two, gravity, h);
    forget_energies(two);
    (void)Traits::Rotation::integrate_A(two, h, FlightClock{0, 1, h / 2});
    integrate_r(two, h, gravity);
    turn_by_corrections(solver, NoJointedBodies{}, two, h);
    room.two.return_forces();
    return room.contacts.carries();
}

/// Two bodies that meet at time t: they are together for a moment, in which they give each other what contacts do. Then they fly on; where neither
/// is fast any more and they press on each other, they stay together for the rest of the step.
template <class Collision>
void resolve_impact(const Collision& collision, const int (&slots)[2], scalar t, PairRoom<Collision>& room, StepReport& report) {
    PairSubWorld& two = room.two;
    FlightState states[2];
    for (int which = 0; which < 2; ++which) states[which] = motion_at(collision, slots[which], t, two);
    two.clear();
    for (int which = 0; which < 2; ++which) {
        two.take(which, collision.bodies, collision.shapes, slots[which]);
        put_state(two.bodies(), which, states[which]);
    }
    show_kinematic(collision, slots, t, two);
    const scalar h = (1 - t) * collision.clock.h, moment = min(h, two.moment());
    bool pressed = solve_pair_for(collision, slots, room, moment, report);
    if constexpr (Collision::SceneTraits::notes_impulses) note_flights(collision, room.contacts);
    const scalar parted = moment < h ? t + moment / collision.clock.h : scalar(1);
    const bool over = parted >= 1 - limits::last_moment;
    show_kinematic(collision, slots, parted, two);
    PathPoint after[2];
    for (int which = 0; which < 2; ++which) {
        states[which] = flight_state(two.bodies(), which);
        after[which] = path_point(two.bodies(), which, collision.clock.h);
    }
    pressed = pressed && !over && !two.some_fast(h - moment);
    if (pressed) (void)solve_pair_for(collision, slots, room, h - moment, report);

    const FlightState ends[2] = {flight_state(two.bodies(), 0), flight_state(two.bodies(), 1)};
    const BodyExtent extents[2] = {two.extents[0], two.extents[1]};
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
            lay_free_path(collision, slot, states[which], parted, two);
        path.fast = !over && is_valid(collision, slot) && is_fast_path(path, extents[which]);
        collision.lists->add_stray(collision.paths, slot);
        if (path.fast) collision.lists->add_fast(collision.paths, slot);
    }
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// What the bodies of a sub-world touch: each other, and around them all that impulses do not move, as one floor.
#pragma once

#include "../body/kinematic_motion.h"
#include "../math/sqrt.h"
#include "../narrow_phase/find_level_manifolds.h"
#include "../narrow_phase/inner_edges.h"
#include "../narrow_phase/level_seams.h"
#include "continuous_collision.h"
#include "level_on_path.h"
#include "time_of_impact.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where two shapes have just come to touch, as the search for that time has found it. Found anew there, rounding would turn its normal.
struct MetPoint {
    ShapePair pair;
    Vector n, P;
};
/// How far the bodies of a sub-world may be from what they have contacts with.
struct PairReach {
    bool touching;        ///< they have to touch: a body may pass by what is further
    scalar h;             ///< s; else they may be as far as they travel in this time
    const MetPoint* met;  ///< the contact of one pair, where it is known; else null
    int kinematic = -1;   ///< the slot of a kinematic body that is met, which always has room; -1: none is
};

/// A kinematic body in its place in the sub-world, as it is at the time of the sub-world, and how it moves: see body/kinematic_motion.h.
template <class Collision>
void show_kinematic(const Collision& collision, PairRoom<Collision>& room, int i, int slot) {
    const BodyPath& path = collision.paths[slot];
    const PathFrame at = frame_on_path(path, room.at);
    const int place = room.two.first_kinematic + i;
    room.two.put_kinematic(collision.shapes, i, slot);
    put_state(room.two.bodies(), place, {at.r_CM, {}, {}, at.A});
    show_kinematic_motion(room.two.bodies(), place, path.way * (1 / collision.clock.h), path.turn * (1 / collision.clock.h));
}
template <class Collision>
void hide_kinematic(PairRoom<Collision>& room) {
    if constexpr (Collision::SceneTraits::sees_kinematic)
        for (int i = 0; i < room.two.kinematic_count; ++i)  // bound: limits::pair_kinematic_max
            hide_kinematic_motion(room.two.bodies(), room.two.first_kinematic + i);
}

/// A shape of a body that is at a place in the sub-world; of what stands still, as it is in the world.
template <class Collision>
PlacedShape placed_in(const Collision& collision, PairRoom<Collision>& room, int place, ShapeSlot shape) {
    const BodyShapes& shapes = collision.shapes;
    const FlightState at = place == room.two.fixed ? flight_state(collision.bodies, shapes.body_of(shape)) : room.two.state(place);
    return place_on_body(shapes.surface(shape).shape, shapes.place(shape), shapes.hull(shape), at.r_CM, at.A);
}

template <class Collision>
uint16_t halvings_of(const Collision& collision, const ShapePair& pair) {
    return static_cast<uint16_t>(collision.shapes.surfaces.halvings(pair.A.number, pair.B.number));
}
/// m, how far apart two shapes may be for a manifold.
template <class Collision>
scalar margin_of(const Collision& collision, PairRoom<Collision>& room, const PairReach& reach, const BodyPair& places,
                 const PlacedShape (&of)[2], uint16_t halvings) {
    const scalar unit = collision.shapes.surfaces.unit;
    if (!reach.touching) return room.two.movers().margin(places.body_A, places.body_B, reach.h, unit);
    return limits::touching_gap * scale_of(unit, halvings) + 8 * epsilon * (sum_of_components(of[0].r) + sum_of_components(of[1].r));
}

/// The manifold of two shapes, if they are near enough.
template <class Collision>
void find_contact(const Collision& collision, PairRoom<Collision>& room, const PairReach& reach, const ShapePair& pair, const BodyPair& places) {
    const PlacedShape A = placed_in(collision, room, places.body_A, pair.A), B = placed_in(collision, room, places.body_B, pair.B);
    Manifold before, found;
    before.n = {};
    before.count = 0;
    found.halvings = halvings_of(collision, pair);
    const scalar scale = scale_of(collision.shapes.surfaces.unit, found.halvings);
    const scalar margin = margin_of(collision, room, reach, places, {A, B}, found.halvings);
    if (reach.met != nullptr && reach.met->pair.is(pair))
        one_point(reach.met->n, reach.met->P, 0, 0, found);
    else if (!collide_placed<typename Collision::SceneTraits::Shapes>(A, B, {margin, limits::fast_margin * scale}, before, found))
        count(collision.report->pairs_untested);
    if (found.count != 0) room.contacts.take(found, pair, places, collision.report->contacts_lost);
}

/// The manifolds of a shape with a level, one a patch.
template <class Collision>
void find_level_contacts(const Collision& collision, PairRoom<Collision>& room, const PairReach& reach, const ShapePair& pair,
                         const BodyPair& places) {
    const PlacedShape body = placed_in(collision, room, places.body_A, pair.A), level = placed_in(collision, room, places.body_B, pair.B);
    const uint16_t halvings = halvings_of(collision, pair);
    const LevelTouch<typename Collision::SceneTraits::Shapes> touch(body, level, margin_of(collision, room, reach, places, {body, level}, halvings),
                                                                    flush_of(body, collision.shapes.surfaces.unit));
    for (int patch_i = 0; patch_i < touch.count(); ++patch_i) {  // bound: level_patches
        Manifold found;
        found.halvings = halvings;
        touch.write(patch_i, no_manifold_before, found);
        found.material = touch.material(patch_i);
        if (found.count != 0) room.contacts.take(found, {pair.A, {pair.B.number + patch_i}}, places, collision.report->contacts_lost);
    }
}

/// Calls each(shape, place) for the shapes near a mover of bodies that no impulse moves. All that is kinematic is at first_kinematic, while it is
/// looked at: who is near depends on the search, and takes no place by that. See place_kinematic.
template <class Collision, class Each>
void for_unmoved_near(const Collision& collision, PairRoom<Collision>& room, int which, const PairReach& reach, const Each& each) {
    const FlightState at = room.two.state(which);
    const scalar way = reach.touching ? scalar(0) : sqrt(length_sq(at.v_CM)) * reach.h;
    const scalar size = room.two.extents[which].radius * (1 + limits::flatness) + way + limits::contact_margin * collision.shapes.surfaces.unit +
                        8 * epsilon * sum_of_components(at.r_CM);
    const Vector more = {size, size, size};
    for_shapes_in_box(collision, room.slots[which], {at.r_CM - more, at.r_CM + more}, [&](ShapeSlot shape) {
        const int other = collision.shapes.body_of(shape);
        if (is_dynamic(collision.bodies, other) || collision.shapes.surface(shape).shape.kind == ShapeKind::none) return;
        int place = room.two.fixed;
        if constexpr (Collision::SceneTraits::sees_kinematic)
            if (is_kinematic(collision, other)) {
                place = room.two.first_kinematic;
                show_kinematic(collision, room, 0, other);
            }
        each(shape, place);
    });
}

/// Shapes of the movers as the search for inner edges sees them: where they are in the sub-world, for as long as a stage runs.
template <class Collision, class Stage>
void with_movers_shown(const Collision& collision, PairRoom<Collision>& room, const Stage& stage) {
    constexpr auto room_for = static_cast<unsigned>(2 * Collision::SceneTraits::shapes_of_body);
    PathFrame before[room_for];
    const auto over_shapes = [&](const auto& each) {
        int shape_i = 0;
        for (int which = 0; which < room.two.count; ++which)  // bound: PairSubWorld::movers_max
            collision.shapes.for_shapes(room.slots[which], [&](ShapeSlot shape) {
                const Place at = place_of(shape.number);
                each(which, shape, collision.floor.shapes.translation[at.tile], collision.floor.shapes.rotation[at.tile], at.lane, before[shape_i++]);
            });
    };
    over_shapes([&](int which, ShapeSlot shape, TranslationTile& translation, RotationTile& rotation, int lane_i, PathFrame& kept) {
        const PlacedShape placed = placed_in(collision, room, which, shape);
        kept = {lane_of(translation.r_CM, lane_i), lane_of(rotation.A, lane_i)};
        set_lane(translation.r_CM, lane_i, placed.r);
        set_lane(rotation.A, lane_i, placed.A);
    });
    stage();
    over_shapes([&](int, ShapeSlot, TranslationTile& translation, RotationTile& rotation, int lane_i, const PathFrame& kept) {
        set_lane(translation.r_CM, lane_i, kept.r_CM);
        set_lane(rotation.A, lane_i, kept.A);
    });
}

/// Drops the points that edges inside of a floor make: see narrow_phase/inner_edges.h. Contacts with kinematic bodies, and between two movers, are no
/// part of it.
template <class Collision>
void hide_internal_edges([[maybe_unused]] const Collision& collision, [[maybe_unused]] PairRoom<Collision>& room) {
    if constexpr (Collision::SceneTraits::hides_internal_edges) {
        auto& contacts = room.contacts;
        BodyPair pairs[Collision::Contacts::room], found_pairs[Collision::Contacts::room];
        Index count = 0, lost = 0;
        // bound: limits::pair_manifolds_max
        for (int place = 0; place < contacts.count; ++place) {
            if (contacts.pairs[place].body_B != room.two.fixed) continue;
            const ShapePair& of = contacts.shapes[place];
            found_pairs[count] = {static_cast<Index>(of.A.number), static_cast<Index>(of.B.number), static_cast<Index>(place)};
            pairs[count] = found_pairs[count];
            ++count;
        }
        if (count < 2) return;
        Index used = contacts.count, first_free = 0, found_count = count;
        const PairList found = {found_pairs, count, &found_count, &lost};
        const ManifoldView manifolds = {pairs, &count, contacts.records, nullptr, &used, &first_free, count};
        using Shapes = typename Collision::SceneTraits::Shapes;
        const FixedShapes fixed = {collision.floor.shapes, collision.shapes.surfaces, collision.floor.bounds, collision.shapes.hulls,
                                   collision.materials.surface_velocities};
        with_movers_shown(collision, room, [&] {
            drop_hidden_points<Shapes>(fixed, found, collision.floor.last_of_shape, manifolds);
            if constexpr (sees_levels<Collision>) drop_points_at_seams<Shapes>(fixed, found, collision.floor.last_of_shape, manifolds);
        });
        // bound: limits::pair_manifolds_max
        for (int place = contacts.count - 1; place >= 0; --place)
            if (contacts.records[place].manifold.count == 0) contacts.drop(place);
    }
}

/// Kinematic bodies that have contacts get places of their own: the one that is met, then those that are deepest. The contacts of others are lost.
template <class Collision>
void place_kinematic([[maybe_unused]] const Collision& collision, [[maybe_unused]] PairRoom<Collision>& room, [[maybe_unused]] int met) {
    if constexpr (Collision::SceneTraits::sees_kinematic) {
        auto& contacts = room.contacts;
        hide_kinematic_motion(room.two.bodies(), room.two.first_kinematic);  // of who was looked at last
        const auto body_of = [&](int place) { return collision.shapes.body_of(contacts.shapes[place].B); };
        const auto waits = [&](int place) {
            return contacts.pairs[place].body_B >= room.two.first_kinematic && room.two.place_of_kinematic(body_of(place)) < 0;
        };
        const auto is_before = [&](int place_A, int place_B) {
            if (body_of(place_A) == met || body_of(place_B) == met) return body_of(place_A) == met && body_of(place_B) != met;
            return depth_of(contacts.records[place_A].manifold) > depth_of(contacts.records[place_B].manifold);
        };
        // bound: limits::pair_kinematic_max
        while (room.two.kinematic_count < limits::pair_kinematic_max) {
            int next = -1;
            for (int place = 0; place < contacts.count; ++place)  // bound: limits::pair_manifolds_max
                if (waits(place) && (next < 0 || is_before(place, next))) next = place;
            if (next < 0) break;
            show_kinematic(collision, room, room.two.kinematic_count, body_of(next));
            ++room.two.kinematic_count;
        }
        // bound: limits::pair_manifolds_max
        for (int place = contacts.count - 1; place >= 0; --place) {
            if (contacts.pairs[place].body_B < room.two.first_kinematic) continue;
            const int kinematic = room.two.place_of_kinematic(body_of(place));
            if (kinematic >= 0) {
                contacts.pairs[place].body_B = static_cast<Index>(kinematic);
            } else {
                contacts.drop(place);
                count(collision.report->contacts_lost);
            }
        }
    }
}

/// The fastest of the points of a manifold that approach each other, and its speed.
INGOT_INLINE ImpactNote note_of(const BodyView& two, const BodyPair& places, const Manifold& manifold) {
    const FlightState A = flight_state(two, places.body_A), B = flight_state(two, places.body_B);
    const Vector omega_A = omega_of(two, places.body_A), omega_B = omega_of(two, places.body_B);
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

/// The contacts of the bodies of a sub-world, as they are in it, with each other and with what is around them.
template <class Collision>
void find_pair_contacts(const Collision& collision, PairRoom<Collision>& room, const PairReach& reach) {
    room.contacts.count = 0;
    room.two.kinematic_count = 0;
    if (room.two.count == 2)
        collision.shapes.for_shapes(room.slots[0], [&](ShapeSlot A) {
            collision.shapes.for_shapes(room.slots[1], [&](ShapeSlot B) {
                if (collision.meets(A.number, B.number)) find_contact(collision, room, reach, {A, B}, {0, 1, no_record});
            });
        });
    for (int which = 0; which < room.two.count; ++which)  // bound: PairSubWorld::movers_max
        for_unmoved_near(collision, room, which, reach, [&](ShapeSlot other, int place) {
            if (is_companion(collision, other)) return;
            collision.shapes.for_shapes(room.slots[which], [&](ShapeSlot own) {
                if (!collision.meets(own.number, other.number)) return;
                const BodyPair places = {static_cast<Index>(which), static_cast<Index>(place), no_record};
                if constexpr (sees_levels<Collision>)
                    if (collision.shapes.surface(other).shape.kind == ShapeKind::level)
                        return find_level_contacts(collision, room, reach, {own, other}, places);
                find_contact(collision, room, reach, {own, other}, places);
            });
        });
    hide_internal_edges(collision, room);
    place_kinematic(collision, room, reach.kinematic);
    // bound: limits::pair_manifolds_max
    for (int place = 0; place < room.contacts.count; ++place) {
        const ShapePair& of = room.contacts.shapes[place];
        const BodyPair& bodies = room.contacts.pairs[place];
        room.contacts.mix(place, collision.shapes.surfaces, collision.materials,
                          {placed_in(collision, room, bodies.body_A, of.A).A, placed_in(collision, room, bodies.body_B, of.B).A});
        if constexpr (sees_levels<Collision>) {
            const BodyPair shapes = {static_cast<Index>(of.A.number), static_cast<Index>(of.B.number), no_record};
            if (is_with_level(collision.shapes.surfaces, shapes))
                mix_level_material<typename Collision::SceneTraits::Shapes>(collision.shapes.surfaces, shapes, room.contacts.records[place]);
        }
        room.contacts.notes[place] = note_of(room.two.bodies(), bodies, room.contacts.records[place].manifold);
    }
}

} }  // namespace ingot

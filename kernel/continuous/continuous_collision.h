// SPDX-License-Identifier: MIT
// What the collision of a step works on: bodies, their shapes and paths, and who may move.
#pragma once

#include "../broad_phase/all_pairs.h"
#include "../broad_phase/near_shapes.h"
#include "../broad_phase/tree_walk.h"
#include "../constraint/flight_impact.h"
#include "../island/rest_view.h"
#include "body_path.h"
#include "figures_on_paths.h"
#include "pair_contacts.h"
#include "pair_sub_world.h"

namespace ingot { inline namespace INGOT_ABI {

/// What free fall is made of beside the body: gravity, and h of the whole step.
struct FallClock {
    Vector gravity;
    scalar h;
};

/// The bodies that a step may move: all of them.
struct EveryBody {
    static constexpr bool some_rest = false;
    int slot_count;

    static constexpr bool has(int) { return true; }
    template <class Each>
    INGOT_INLINE void for_each(const Each& each) const {
        for (int slot = 0; slot < slot_count; ++slot) each(slot);  // bound: max_bodies
    }
};
/// Those that are awake, in scenes whose bodies sleep.
struct AwakeBodies {
    static constexpr bool some_rest = true;
    RestView rest;

    bool has(int slot) const { return rest.is_awake(slot); }
    template <class Each>
    INGOT_INLINE void for_each(const Each& each) const {
        for_awake(rest, each);
    }
};

/// The manifolds of the step, as pairs of shapes in the order of their keys.
struct SolvedPairs {
    const BodyPair* pairs;
    int count;

    /// Bound: a search in a sorted list.
    bool has(ShapeSlot A, ShapeSlot B) const {
        const PairKey key = key_of(A, B);
        const int from = place_of_key(key);
        return from < count && pairs[from].key() == key;
    }
    /// Null: they have no manifold.
    const BodyPair* find(ShapeSlot A, ShapeSlot B) const { return has(A, B) ? pairs + place_of_key(key_of(A, B)) : nullptr; }

private:
    static PairKey key_of(ShapeSlot A, ShapeSlot B) {
        const bool in_order = A.number < B.number;
        return BodyPair{static_cast<Index>(in_order ? A.number : B.number), static_cast<Index>(in_order ? B.number : A.number), no_record}.key();
    }
    INGOT_INLINE int place_of_key(PairKey key) const {
        int from = 0, to = count;
        // bound: log2(max_manifolds) + 1: to - from is halved each turn
        while (from < to) {
            const int middle = from + (to - from) / 2;
            if (pairs[middle].key() < key)
                from = middle + 1;
            else
                to = middle;
        }
        return from;
    }
};

/// What the search for edges inside a floor asks of the world: see narrow_phase/inner_edges.h.
struct FloorView {
    BodyView shapes;  ///< as bodies, by shape slot
    const BoundsTile* bounds;
    Index* last_of_shape;
};

/// What the collision of a step works on.
///
/// Scene: as types and numbers, Shapes (with the forms of hulls), Rotation, Solver, View (of that solver), notes_impulses, bounces,
/// hides_internal_edges, and pair_manifolds, the room for what two bodies do to each other and to what is fixed; sees_kinematic, where bodies may be
/// kinematic; Figures: FiguresOnPaths, or NoFiguresOnPaths.
/// Meets: bool(shape slot, shape slot), of those that are solid to each other. Sensors: PassedSensors, or NoPassedSensors.
/// Tree: a SortedTreeView over the fat AABBs of all shapes, or NoTree.
template <class Scene, class MovingBodies, class Meets, class Sensors, class Tree>
struct ContinuousCollision : Scene::Figures {
    using SceneTraits = Scene;
    using TreeType = Tree;
    using SubWorld = PairSubWorld<Scene::sees_kinematic ? limits::pair_kinematic_max : 0>;
    using Contacts = PairContacts<Scene::pair_manifolds, SubWorld::slots, typename Scene::View>;

    BodyView bodies;
    BodyShapes shapes;
    ShapeMaterials materials;
    FloorView floor;
    typename Scene::View solver;  ///< done for this step: its memory, and who took part
    SolvedPairs solved;
    BodyPath* paths;  ///< by body slot
    FallClock clock;
    MovingBodies moving;
    Meets meets;
    Sensors sensors;
    FlightImpactList flights;  ///< for events, where Scene::notes_impulses
    Tree tree;
    FollowedBodies* lists;  ///< empty as the step begins
    StepReport* report;
};

/// Two bodies and their contacts, for a while of the step.
template <class Collision>
struct PairRoom {
    typename Collision::SubWorld two;
    typename Collision::Contacts contacts;
    int slots[2];  ///< of the movers
    scalar at;     ///< the time of the step that it is at
};

/// Whether a body goes its way whoever it meets.
template <class Collision>
bool is_kinematic([[maybe_unused]] const Collision& collision, [[maybe_unused]] int slot) {
    if constexpr (Collision::SceneTraits::sees_kinematic)
        return collision.moving.has(slot) && is_kinematic_path(collision.bodies, collision.paths[slot], slot);
    else
        return false;
}

/// Whether the motion of a body is known, and impulses change it.
template <class Collision>
bool is_valid(const Collision& collision, int slot) {
    const Place at = place_of(slot);
    const TranslationTile& tile = collision.bodies.translation[at.tile];
    return tile.inv_M[at.lane] > 0 && ((collision.bodies.rotation[at.tile].bad | tile.bad) >> at.lane & 1u) == 0;
}

/// One that can move and does not, for the whole step.
template <class Collision>
bool sleeps(const Collision& collision, int slot) {
    return !collision.moving.has(slot) && is_dynamic(collision.bodies, slot);
}

/// The path of a body. One that rests stays where it is; whoever meets it waits there for the next step, which wakes it.
template <class Collision>
const BodyPath& path_of(const Collision& collision, int slot, [[maybe_unused]] BodyPath& at_rest) {
    if constexpr (decltype(collision.moving)::some_rest) {
        if (!collision.moving.has(slot)) {
            at_rest = {};
            const FlightState motion = flight_state(collision.bodies, slot);
            end_path(at_rest, motion.r_CM, motion.A, 0);
            at_rest.next_slot = static_cast<Index>(slot);
            return at_rest;
        }
    }
    return collision.paths[slot];
}

/// Calls each(shape slot) for the shapes of other bodies whose fat AABBs come into a box; without a tree for all that can move. In any order: whoever
/// asks has to do the same whatever it is, and whoever else that is further away is among them.
template <class Collision, class Each>
void for_shapes_in_box(const Collision& collision, int slot, const TreeBox& box, const Each& each) {
    const auto of_others = [&](int shape) {
        const int body = collision.shapes.body_of({shape});
        if (body == slot) return;
        // The boxes of a tree that queries go by may be larger.
        const bool stays_in_bounds = !is_dynamic(collision.bodies, body);
        if (!stays_in_bounds || trees::overlap(trees::box_of(collision.floor.bounds, shape), box)) each(ShapeSlot{shape});
    };
    if constexpr (is_tree<typename Collision::TreeType>)
        for_near_shapes(collision.tree, box, of_others);
    else
        for (int body = 0; body < collision.shapes.body_count(); ++body)  // bound: max_bodies
            collision.shapes.for_shapes(body, [&](ShapeSlot shape) { of_others(shape.number); });
}

} }  // namespace ingot

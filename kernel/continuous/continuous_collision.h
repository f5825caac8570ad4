// SPDX-License-Identifier: MIT
// What the collision of a step works on: bodies, their shapes and paths, and who may move.
#pragma once

#include "../broad_phase/all_pairs.h"
#include "../broad_phase/near_shapes.h"
#include "../constraint/flight_impact.h"
#include "../island/rest_view.h"
#include "pair_contacts.h"

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

/// What the collision of a step works on.
///
/// Scene: as types and numbers, Shapes (with the forms of hulls), Rotation, Solver, View (of that solver), notes_impulses, bounces, and
/// pair_manifolds, the room for what two bodies do to each other; sees_kinematic, where bodies may be kinematic.
/// Meets: bool(shape slot, shape slot), of those that are solid to each other. Sensors: PassedSensors, or NoPassedSensors.
/// Tree: a SortedTreeView over the fat AABBs of all shapes, or NoTree.
template <class Scene, class MovingBodies, class Meets, class Sensors, class Tree>
struct ContinuousCollision {
    using SceneTraits = Scene;
    using TreeType = Tree;
    using Contacts = PairContacts<Scene::pair_manifolds, typename Scene::View>;

    BodyView bodies;
    BodyShapes shapes;
    ShapeMaterials materials;
    typename Scene::View solver;  ///< done for this step: its memory, and who took part
    const BodyPair* solved;       ///< pairs of shapes with a manifold in this step, in the order of their keys
    int solved_count;
    BodyPath* paths;              ///< by body slot
    FallClock clock;
    MovingBodies moving;
    Meets meets;
    Sensors sensors;
    FlightImpactList flights;     ///< for events, where Scene::notes_impulses
    Tree tree;
    FastBodies* lists;            ///< empty as the step begins
};

/// Two bodies and their contacts, for a while of the step.
template <class Collision>
struct PairRoom {
    PairSubWorld two;
    typename Collision::Contacts contacts;
};

/// Whether a body goes its way whoever it meets.
template <class Collision>
bool is_kinematic([[maybe_unused]] const Collision& collision, [[maybe_unused]] int slot) {
    if constexpr (Collision::SceneTraits::sees_kinematic)
        return collision.moving.has(slot) && is_kinematic_path(collision.bodies, collision.paths[slot], slot);
    else
        return false;
}

/// True for shapes with a manifold in this step. Bound: a search in a sorted list.
template <class Collision>
bool is_solved(const Collision& collision, const ShapePair& shapes) {
    const int A = shapes.A.number, B = shapes.B.number;
    const PairKey key = BodyPair{static_cast<Index>(A < B ? A : B), static_cast<Index>(A < B ? B : A), no_record}.key();
    int from = 0, to = collision.solved_count;
    // bound: log2(max_manifolds) + 1: to - from is halved each turn
    while (from < to) {
        const int middle = from + (to - from) / 2;
        if (collision.solved[middle].key() < key)
            from = middle + 1;
        else
            to = middle;
    }
    return from < collision.solved_count && collision.solved[from].key() == key;
}

/// The path of a body. One that rests stays where it is; whoever meets it waits there for the next step, which wakes it.
template <class Collision>
const BodyPath& path_of(const Collision& collision, int slot, [[maybe_unused]] BodyPath& at_rest) {
    if constexpr (decltype(collision.moving)::some_rest) {
        if (!collision.moving.has(slot)) {
            const FlightState motion = flight_state(collision.bodies, slot);
            end_path(at_rest, motion.r_CM, motion.A, 0);
            at_rest.next_slot = static_cast<Index>(slot);
            at_rest.in_contact = is_dynamic(collision.bodies, slot);
            return at_rest;
        }
    }
    return collision.paths[slot];
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "../base/workers.h"
#include "../broad_phase/all_pairs.h"
#include "../broad_phase/query_tree.h"
#include "../energy_momentum/energy_momentum.h"
#include "../shape/compound.h"
#include "../impulse/frictionless_impacts.h"
#include "../joint/joints.h"
#include "../level/level_table.h"
#include "../solver/direct/hybrid_islands.h"
#include "../motion/forced_flight.h"
#include "../motion/exact_elliptic.h"
#include "../motion/lie_midpoint.h"
#include "../motion/listing1_euler.h"
#include "../motion/moser_veselov.h"
#include "../motion/rk4_polar.h"
#include "../motion/symmetric_top.h"
#include "../solver/sequential/sequential_impulses.h"

namespace ingot { inline namespace INGOT_ABI {

/// What a world is made of. A scene inherits the least there is, one body that only turns, and adds what it needs; what it
/// does not name costs no flash, no RAM and no time.
///
///     struct Crates : ingot::Scene {
///         static constexpr int  max_bodies   = 10;
///         static constexpr bool translates   = true;    // r_CM, v_CM, forces, gravity
///         static constexpr int  max_contacts = 80;      // and collisions
///         using solver = ingot::FrictionlessImpacts;
///         using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
///     };
///     static ingot::World<Crates> world;                // .bss; no constructor runs; memcpy is a snapshot
///
/// A trait that is misspelt, `max_bodys`, is a member of your own that nobody asks for, and no compiler knows that it was meant for one: by
/// INGOT_TRAIT and INGOT_TRAIT_TYPE it does not compile. Where a range ends at 65535, INGOT_INDEX_BITS=32 lets it go on to 16 million.
struct Scene {
    static constexpr int  max_bodies   = 1;      ///< 1 .. 65536
    static constexpr bool translates   = false;  ///< bodies have a place and a velocity: r_CM, v_CM, forces, gravity
    static constexpr scalar length_unit = 1;     ///< m, 1e-5 .. 1e5: the size of a typical thing, which the lengths and speeds of limits.h are for
    static constexpr bool gravity_shares = false; ///< bodies may feel more or less of gravity than others: World::set_gravity_share
    static constexpr bool body_forces  = false;  ///< forces and torques that turn with their body: World::add_body_force
    static constexpr bool damping      = false;  ///< velocities die away, by rates of each body: World::set_damping
    static constexpr bool axis_locks   = false;  ///< bodies may be kept from moving along axes, or turning about them: BodyDef::locks
    static constexpr bool compensated_sums = false; ///< L, v_CM and r_CM keep what their roundings take off: for float at high rates
    static constexpr bool kinematic_bodies = false; ///< bodies may move as they are told, whatever is in their way: BodyDef::kinematic
    static constexpr bool user_data    = false;  ///< a word of each body is the user's: World::set_user_data
    static constexpr bool reads_contacts = false; ///< World::contact tells all impulses of a step, and where impacts of max_contacts are
    static constexpr int  max_joints   = 0;      ///< joints between bodies, or a body and the world, 0 .. 32767
    /// Of these, how many may close loops: between bodies that hang together without them, or the second of a figure that leads to what cannot move,
    /// as the second hinge of a door does; and all rods, ropes, targets and servos. 0 .. max_joints; each takes half a KB, and each body with joints
    /// 24 bytes for each of its rows
    static constexpr int  max_loops    = 0;
    static constexpr int  max_contacts = 0;      ///< points of contact in one step, 0 .. 65535, of FrictionlessImpacts
    static constexpr int  max_manifolds = 0;     ///< pairs of bodies that touch in one step, 0 .. 65534, of every other solver
    static constexpr int  max_pairs    = 0;      ///< pairs of bodies whose bounds overlap in one step; 0: twice max_manifolds
    /// Visits of the solver to contacts in a step, all together; 0: as many as it takes. An island that has had its share counts in
    /// sweeps_unfinished, and is solved as far as it came, which may give energy: see base/work_budget.h. Direct solves, pushes out of overlaps
    /// and fast bodies have bounds of their own, in limits.h. Bodies of max_contacts, of whose last step nothing is kept, may sink while it is scarce
    static constexpr int  work_budget  = 0;
    static constexpr Effort effort     = {};     ///< substeps and sweeps for contacts with friction: low_effort, high_effort, or numbers of your own
    static constexpr bool filters      = false;  ///< bodies have a BodyFilter that says whom they meet
    static constexpr int  max_overlaps = 0;      ///< pairs of a sensor and a body in it, in one step, 0 .. 65535
    static constexpr int  max_events   = 0;      ///< of contacts and sensors in one step, 0 .. 65535: see events/contact_events.h
    static constexpr scalar hit_speed  = 1;      ///< m/s; contacts that meet faster are told as hits
    static constexpr bool recycles_manifolds = true;   ///< where bodies hardly move, manifolds are moved along with them and not searched anew
    static constexpr bool hides_internal_edges = true;  ///< fixed boxes and hulls side by side are one floor; false: bodies stumble at edges there
    /// Where arrays are full, who needs a contact most has one, and the others are stopped: see StepReport::contacts_lost. false: who comes late
    /// falls, for 10 KB less flash. Scenes whose arrays have room for each body with each other, n (n - 1) / 2, save that by themselves
    static constexpr bool holds_crowds = true;
    static constexpr bool bounces      = true;   ///< bodies may have a restitution; false: none bounces, for 7 KB less flash
    static constexpr bool sleeps       = false;  ///< islands of bodies at rest are left out of the step until something wakes them
    static constexpr scalar sleep_speed = limits::sleep_speed;  ///< length_unit/s; no point of a body at rest moves faster
    static constexpr scalar sleep_time  = limits::sleep_time;   ///< s; for which all bodies of an island are at rest before it falls asleep
    static constexpr bool rolling_resistance = false;  ///< shapes may resist being rolled: World::set_rolling_resistance
    static constexpr bool surface_velocities = false;  ///< surfaces may move by themselves, as belts do: World::set_surface_velocity
    static constexpr bool continuous   = false;  ///< fast bodies are followed within a step, impact by impact: none passes through another
    using broad_phase = AllPairs;                ///< or SortedTree, for many bodies, or QueryTree, for queries among many
    /// Of contacts. BlockSweeps carry piles, towers of 20, and up to 100 kg on 1 kg, with no memory of their own: what a small target
    /// wants. HybridIslands<> picks for each island: sweeps, or for mass ratios from 50 on, towers of 15 and more, and what sweeps do not settle
    /// a direct solve in double; it takes 121 KB of RAM (HybridIslands<20, 10>, for smaller islands, 39), so a scene has to name it.
    /// SequentialImpulses is for a few bodies on a small target: a third less flash than BlockSweeps, and half of the RAM. These three have friction,
    /// stacks and piles. FrictionlessImpacts is the article's collision: what flies and bounces, in max_contacts.
    using solver = BlockSweeps;
    using shapes   = Shapes<>;  ///< or those of its bodies: Shapes<Sphere, Box, HalfSpace>
    using joints   = Joints<>;                   ///< or the kinds there are: Joints<BallJoint, HingeJoint, WithDrives>, see joint/joints.h
    using figure_motion = ArticulatedSubsteps;   ///< or EnergyMomentum<>, for what swings freely: see energy_momentum/energy_momentum.h
    static constexpr NoHulls hulls = {};         ///< or `static constexpr ConvexHull hulls[]`, in flash: the forms of its Hull shapes, in body frames
    static constexpr NoLevels levels = {};       ///< or `static constexpr LevelTable levels[]`, in flash, or in memory that is filled before it
                                                 /// is used: ground for World::add_level
    static constexpr int max_shapes_of_body = 1; ///< 1 .. 255; more: World::add takes several shapes for one body, see shape/compound.h
    using workers  = OneCore;                    ///< or a type that brings other cores along: see base/workers.h. The bits are the same
    using rotation = MoserVeselov;               ///< or another method of motion/
    using force_field = NoForceField;            ///< or one of motion/force_fields.h, or your own
    using flight   = KickDriftKick;              ///< or another scheme of motion/forced_flight.h, for scenes with a field
};

/// Names a trait that is a number or an Effort, with the type that it has: `INGOT_TRAIT(max_bodies) = 10;`. One that is none of Scene's does not
/// compile.
#define INGOT_TRAIT(name) static constexpr decltype(::ingot::Scene::name) name
/// Names a trait that is a type: `INGOT_TRAIT_TYPE(solver) = ingot::FrictionlessImpacts;`. The lists hulls and levels are written out: Hull and Level
/// among the shapes ask for them.
#define INGOT_TRAIT_TYPE(name)                                    \
    static_assert(sizeof(typename ::ingot::Scene::name) > 0, ""); \
    using name

template <bool is_scene, class S>
struct SceneOrNone {
    using type = S;
};
template <class S>
struct SceneOrNone<false, S> {
    static_assert(INGOT_IS_BASE_OF(Scene, S), "a scene inherits what it does not name: struct Crates : ingot::Scene");
    using type = Scene;  // so that the sentence is not followed by a line for every trait
};
/// The scene of World<S>: S, or, behind a sentence, the least scene, where S is none.
template <class S>
using SceneOf = typename SceneOrNone<INGOT_IS_BASE_OF(Scene, S), S>::type;

template <class T>
T& any_of();  // in types only: std::declval, which freestanding code has not

template <class S>
inline constexpr bool collides = S::max_contacts > 0;

template <class S>
inline constexpr bool stacks = S::max_manifolds > 0;
/// Its contacts are solved point by point.
template <class S>
inline constexpr bool solves_pointwise = S::solver::is_pointwise;
/// Its islands may be solved directly.
template <class S>
inline constexpr bool solves_directly = S::solver::is_direct;

/// It has several cores; and its contacts are solved in parts, side by side.
template <class S>
inline constexpr bool shares_work = S::workers::workers > 1;
template <class S>
inline constexpr bool solves_in_parts = shares_work<S> && stacks<S> && !solves_pointwise<S> && !solves_directly<S> && S::max_joints == 0;

template <class S>
inline constexpr bool has_shapes = collides<S> || stacks<S>;

template <class S>
inline constexpr bool has_joints = S::max_joints > 0;
template <class S>
inline constexpr bool has_joint_limits = has_joints<S> && S::joints::has_limits;
template <class S>
inline constexpr bool has_joint_drives = has_joints<S> && S::joints::has_drives;
template <class S>
inline constexpr bool has_wheels = has_joints<S> && S::joints::has(JointKind::wheel);
template <class S>
inline constexpr bool has_joint_rows = has_joint_limits<S> || has_joint_drives<S>;  ///< beside those of what joints lock
template <class S>
inline constexpr bool has_joint_reactions = has_joints<S> && S::joints::has_reactions;
template <class S>
inline constexpr bool has_joint_breaking = has_joints<S> && S::joints::may_break;
/// Its figures move by the energy-momentum step where they touch nothing.
template <class S>
inline constexpr bool swings_freely = has_joints<S> && S::figure_motion::is_implicit;
template <class S>
inline constexpr bool has_loops = S::max_loops > 0;
/// Rods, ropes, targets: rows beside the trees.
template <class S>
inline constexpr bool has_ties = has_joints<S> && S::joints::has_ties;
template <class S>
inline constexpr bool has_servos = has_joints<S> && S::joints::has_servos;
template <class S>
inline constexpr bool has_gears = has_joints<S> && S::joints::has(JointKind::gear);
template <class S>
inline constexpr bool has_targets = has_joints<S> && S::joints::has(JointKind::target);

/// The hulls a scene names.
template <class S>
inline constexpr HullTable hulls_of = table_of(S::hulls);
template <class S>
constexpr bool are_hulls() {
    // bound: the hulls that the scene names
    for (int form = 0; form < hulls_of<S>.count; ++form)
        if (!(hulls_of<S>.hulls[form].face_count >= 4 && hulls_of<S>.hulls[form].radius > 0)) return false;
    return true;
}

/// The hull of this number as a shape of a body. One that the scene has not is refused by World::add as bad_shape.
template <class S>
constexpr Hull hull_of(int form) {
    return {form >= 0 && form < hulls_of<S>.count ? hulls_of<S>.hulls[form].radius : scalar(0), form};
}

/// The levels a scene names.
template <class S>
inline constexpr LevelTables levels_of = levels_in(S::levels);
template <class S>
inline constexpr bool has_levels = levels_of<S>.count > 0;
/// Slots of bodies that a level takes.
template <class S>
inline constexpr int bodies_of_level = (level_patches + S::max_shapes_of_body - 1) / S::max_shapes_of_body;

template <class S>
inline constexpr bool has_compounds = S::max_shapes_of_body > 1;
/// Slots of shapes: those of the bodies, where each has one shape.
template <class S>
inline constexpr int shape_capacity = S::max_bodies * S::max_shapes_of_body;

/// Pairs that a search may find: shapes of one body too, which are dropped then.
template <class S>
inline constexpr long long pairs_with_own = (S::max_pairs != 0 ? S::max_pairs : 2LL * S::max_manifolds) +
                                            static_cast<long long>(S::max_bodies) * S::max_shapes_of_body * (S::max_shapes_of_body - 1) / 2;

/// The shapes of a scene as narrow phase and queries ask for them: which there are, and the form of a hull.
template <class S>
struct ShapesOf : S::shapes {
    static const ConvexHull* hull_of([[maybe_unused]] const Shape& shape) {
        if constexpr (hulls_of<S>.count > 0)
            if (shape.kind == ShapeKind::hull) return hulls_of<S>.hulls + static_cast<int>(shape.size.y);
        return nullptr;
    }
    static const LevelTable* level_of(const Shape& shape) { return levels_of<S>.levels + level_number(shape); }
    /// Of the ball that holds the shape, m; 0: a half space.
    static scalar radius_of(const Surface& surface) {
        if constexpr (has_compounds<S>) return ingot::bounding_radius(surface.shape);
        return surface.bounding_radius;
    }
    /// False for a level whose number and size are those of none of the scene's.
    static constexpr bool names_its_level([[maybe_unused]] const Shape& shape) {
        if constexpr (has_levels<S>) {
            if (shape.kind != ShapeKind::level) return true;
            if (!(shape.offset >= 0 && shape.offset < static_cast<scalar>(levels_of<S>.count * level_patches))) return false;
            const int number = level_number(shape);
            if (static_cast<scalar>(number * level_patches + patch_number(shape)) != shape.offset) return false;
            const Vector half = half_extents_of(levels_of<S>.levels[number]);
            return shape.size.x == half.x && shape.size.y == half.y && shape.size.z == half.z;
        }
        return true;
    }
    /// False for a hull whose number and size are those of none of the scene's.
    static constexpr bool names_its_hull([[maybe_unused]] const Shape& shape) {
        if constexpr (hulls_of<S>.count > 0) {
            if (shape.kind != ShapeKind::hull) return true;
            if (!(shape.size.y >= 0 && shape.size.y < static_cast<scalar>(hulls_of<S>.count))) return false;
            const int form = static_cast<int>(shape.size.y);
            return static_cast<scalar>(form) == shape.size.y && shape.size.x == hulls_of<S>.hulls[form].radius;
        }
        return true;
    }
};

/// Its fixed shapes may hide each other's edges: see narrow_phase/inner_edges.h.
template <class S>
inline constexpr bool hides_internal_edges =
    stacks<S> && S::hides_internal_edges && (S::shapes::has(ShapeKind::box) || S::shapes::has(ShapeKind::hull) || S::shapes::has(ShapeKind::level));

/// Its queries go through the tree that finds its pairs.
template <class S>
inline constexpr bool queries_by_tree = stacks<S> && S::broad_phase::answers_queries;

template <class S>
inline constexpr bool has_sensors = S::max_overlaps > 0;

template <class S>
inline constexpr bool has_events = S::max_events > 0;

template <class S>
inline constexpr bool follows_fast_bodies = S::continuous;

template <class S>
inline constexpr bool has_materials = S::rolling_resistance || S::surface_velocities;

/// Something moves that is no ball.
template <class S>
inline constexpr bool has_more_than_balls = S::shapes::has(ShapeKind::box) || S::shapes::has(ShapeKind::capsule) ||
                                            S::shapes::has(ShapeKind::cylinder) || S::shapes::has(ShapeKind::hull);

/// Its shapes are balls and half spaces.
template <class S>
inline constexpr bool has_only_balls = !has_more_than_balls<S> && !S::shapes::has(ShapeKind::level);

/// Its arrays of contacts can be full. Where they have room for each body with each other nobody is left without a place, and what looks after
/// those who are is not linked. Two balls are one point of max_contacts; compounds and levels make more of a pair.
template <class S>
inline constexpr bool can_be_crowded = [] {
    constexpr long long pairs = static_cast<long long>(S::max_bodies) * (S::max_bodies - 1) / 2;
    if (!S::holds_crowds) return false;
    if (S::max_shapes_of_body > 1 || has_levels<S>) return true;
    if (collides<S> && (S::max_contacts < pairs || has_more_than_balls<S>)) return true;
    return stacks<S> && (S::max_manifolds < pairs || pairs_with_own<S> < pairs);
}();

/// Manifolds may be moved along with their bodies: see worth_renewing.
template <class S>
inline constexpr bool renews_manifolds = S::recycles_manifolds && has_more_than_balls<S>;

/// All that moves is balls, and nothing asks for more of the solver than sweeps: manifolds have one point. See BallView.
template <class S>
inline constexpr bool sweeps_balls_alone = stacks<S> && !S::solver::is_pointwise && !S::solver::is_direct && !has_materials<S> && !S::continuous &&
                                           !has_more_than_balls<S>;

template <class S>
inline constexpr bool has_field = is_field<typename S::force_field>;

/// Scenes whose steps are made of kicks by the field and free flights. Contacts, and Listing 1, take the field as a force that is
/// constant over the step.
template <class S>
inline constexpr bool flies_in_field = has_field<S> && !has_shapes<S> && !has_joints<S> && !S::rotation::as_printed;

/// Scenes whose bodies fly freely, without what would have to hold them between two kicks: forces that turn with a body kick it before the flight and
/// after. Others take such forces as constant over the step.
template <class S>
inline constexpr bool halves_body_forces = S::body_forces && !stacks<S> && !collides<S> && !has_joints<S> && !has_field<S> &&
                                           !S::rotation::as_printed && !S::compensated_sums && !S::axis_locks && !S::sleeps;

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// What the sequential solver works on, without its capacities: bodies as its rows read and write them, and what it keeps of a manifold within a step.
//
// Rows are not stored. What a manifold does to two bodies is an impulse at a point and a moment; what a row reads is their motion against each
// other at a point. Both are worked out in the visit, from r_CM and inv_I_world, and are the same for velocities and for displacements.
#pragma once

#include "../../base/effort.h"
#include "../../base/if.h"
#include "../../base/work_budget.h"
#include "../../body/body_tiles.h"
#include "../../constraint/kinematic_view.h"
#include "../../constraint/response.h"
#include "../../constraint/surface_materials.h"
#include "../../narrow_phase/manifold_record.h"
#include "../../base/contact_lengths.h"

namespace ingot { inline namespace INGOT_ABI {

/// A motion of a body and its cause: angular = inv_I_world moment.
struct PointMotion {
    Vector linear;   ///< m/s of velocities; m of displacements
    Vector angular;  ///< rad/s; rad
    Vector moment;   ///< kg m^2/s, which is L; kg m^2
};

/// World axes. A body with inv_M = 0 cannot move, has gone bad, or touches nothing: of its other members only hit and root are valid.
struct PointBody : FreeBodyOf<scalar> {
    PointMotion forces;        ///< per second, of velocity: gravity, and what the user adds
    PointMotion velocity;
    PointMotion displacement;  ///< since the step began
    PointMotion begin;         ///< velocity at the begin of the substep
    bool hit;         ///< in the substep: its velocity changed by more than forces explain
    Index root;    ///< slot of the lowest body of its island; no_root: it is of none
};
inline constexpr Index no_root = index_max;

/// What a manifold gives: A gets it, B the opposite.
struct PointImpulses {
    scalar j[Manifold::points_max];  ///< N s, along n at the points
    Vector friction;                 ///< N s, at the middle
    scalar torsion;                   ///< N m s, about n
};

/// A compliance of 0 is not known yet: it is worked out by the first row that changes.
struct PointContact {
    Vector middle;      ///< m, where friction takes hold
    scalar radius;      ///< m, mean distance of the points from it: the lever of torsion; 0 for one point
    scalar K[Manifold::points_max];       ///< kg^-1, of the normals
    scalar K_friction;                    ///< kg^-1, at the middle, across n: no less than 3/4 of the greatest
    scalar target[Manifold::points_max];  ///< m/s, that A may approach B with in the substep, at least
    Vector before_reversal;               ///< against the slip, as long as reversal_share; zero: the slip does not turn round in the substep
    PointImpulses change, along;  ///< of the sweep; conjugate gradients: the direction so far
};

struct PointView {
    static constexpr bool is_pointwise = true;
    static constexpr bool rolls = false, has_belts = false, bounces = false;  ///< see PointViewOf
    static constexpr bool articulates = false, locks_axes = false;

    const BodyPair* pairs;    ///< that touch, sorted by slots
    ManifoldRecord* records;  ///< of the pairs
    int manifold_count;
    scalar unit = 1;          ///< m; of lengths and speeds in limits.h: see base/contact_lengths.h
    PointBody* bodies;        ///< by body slot
    PointContact* contacts;   ///< by place in pairs
    Index* members;        ///< manifolds of the island at hand, in the order of pairs, and behind them those of the islands to come
    Index* body_slots;     ///< of its bodies
    int slot_count;           ///< bodies looked at
    int member_count, body_count, members_left;  ///< of the island; members_left: of it and those to come
    int sweeps_of_step = no_budget;  ///< that each island may have
    Effort effort = {};
};

/// Whether the body of a slot is one that a manifold of the step moves.
inline bool takes_part(const PointView& solver, int slot) { return solver.bodies[slot].inv_M > 0; }

/// Of a manifold whose surfaces resist being rolled.
struct PointRolling {
    scalar K;     ///< kg^-1 m^-2, of turning across n: no less than 3/4 of the greatest; 0: not known yet
    scalar size;  ///< m; what turns an angular velocity into a speed worth settling
    Vector change, along;  ///< N m s, as in PointContact
};
/// Where points that bounce are at the end of the substep, m; limits::unbounded: they do not.
struct PointLandings {
    scalar at[Manifold::points_max];
};

/// The part of scenes that name rolling resistance, surfaces that move, or restitution. The verbs of the sequential solver are templates over the
/// view: scenes that name none of them compile nothing of this.
template <bool surfaces_roll, bool surfaces_move, bool bodies_bounce>
struct PointMaterialView : PointView {
    static constexpr bool rolls = surfaces_roll, has_belts = surfaces_move, bounces = bodies_bounce;

    PointRolling* rolling;           ///< by place in pairs, as contacts
    RollingRecord* rolling_records;  ///< by record
    const Vector* belt_velocities;   ///< by record, m/s, world
    PointLandings* landings;         ///< by place in pairs
};
template <bool rolls, bool has_belts, bool bounces>
using PointViewOf = If<rolls || has_belts || bounces, PointMaterialView<rolls, has_belts, bounces>, PointView>;

/// The kinematic body of a manifold, as constraint/kinematic_view.h has it, and its motion as the partner would have it.
struct KinematicPoint {
    KinematicContact body;
    Vector r_partner;  ///< m, centre of the partner as the step begins
    PointMotion forces, velocity, displacement, begin;  ///< as of a PointBody; there is no moment
    scalar sign;       ///< 1: it is B of the manifold; -1: A; 0: there is none
};
struct KinematicPoints {
    KinematicPoint* points;         ///< by place in pairs, as contacts
    const KinematicBody* of_slots;  ///< how bodies move; null: evenly
};
/// View: any other of the sequential solver.
template <class View>
struct KinematicPointViewOf : View {
    KinematicPoints kinematic;
};
template <class View>
inline constexpr bool sees_kinematic<KinematicPointViewOf<View>> = true;

} }  // namespace ingot

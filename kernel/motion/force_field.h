// SPDX-License-Identifier: MIT
// What a force field is; ready ones stand in force_fields.h.
#pragma once

#include "../body/body_tiles.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// The motion of `lanes` bodies, as a field sees it at one moment within a step.
struct BodyMotion {
    Vec3<lane> r_CM;        ///< m, world; zero in a scene that does not translate
    Vec3<lane> v_CM;        ///< m/s, world; likewise
    Mat3<lane> A;           ///< body to world
    Vec3<lane> omega;       ///< rad/s, world; only for a field that depends_on_velocity, else zero
    Vec3<lane> inv_I_body;  ///< kg^-1 m^-2, principal; zero for immovable bodies
    lane inv_M;             ///< kg^-1; zero for immovable bodies, and where the scene does not translate
    scalar t;               ///< s, see World::time
    int first_slot;         ///< of the body in lane 0; the others follow. For fields with a number for each body.
};

/// Mass, kg; 0 for immovable bodies.
INGOT_INLINE lane mass_of(const BodyMotion& body) {
    const auto movable = body.inv_M > lane{};
    return select(movable, splat<lane>(1) / select(movable, body.inv_M, splat<lane>(1)), lane{});
}

/// Principal moments, kg m^2; 0 for immovable bodies.
INGOT_INLINE Vec3<lane> moments_of(const BodyMotion& body) {
    const auto movable = body.inv_I_body.x > lane{};
    const auto inverse = [&](lane J) { return select(movable, splat<lane>(1) / select(movable, J, splat<lane>(1)), lane{}); };
    return {inverse(body.inv_I_body.x), inverse(body.inv_I_body.y), inverse(body.inv_I_body.z)};
}

/// A force through the centre of mass, N, and a torque about it, N m; world axes. (About the fixed point, for a scene whose
/// bodies turn about one.)
struct Wrench {
    Vec3<lane> F, tau;  ///< N; N m

    INGOT_INLINE static Wrench force(const Vec3<lane>& F) { return {F, Vec3<lane>{}}; }  ///< a force alone
    INGOT_INLINE static Wrench torque(const Vec3<lane>& tau) { return {Vec3<lane>{}, tau}; }  ///< a torque alone
    INGOT_INLINE friend Wrench operator+(const Wrench& a, const Wrench& b) { return {a.F + b.F, a.tau + b.tau}; }  ///< both
};

/// The same vector for every body.
INGOT_INLINE Vec3<lane> splat(const Vector& v) { return {splat<lane>(v.x), splat<lane>(v.y), splat<lane>(v.z)}; }

/// A field is a struct that a scene names, `using force_field = ...`, made of plain numbers, with
///     Wrench operator()(const BodyMotion& body) const;
/// which is inlined into the step and asked as often as the scheme of the scene needs it. The world holds the field, and
/// gives it out by World::force_field(), to set its numbers. A field without velocities says so, which halves its cost:
///
///     struct Buoy : ingot::ForceField {
///         static constexpr bool depends_on_velocity = false;
///         ingot::scalar k;  // N/m
///         ingot::Wrench operator()(const ingot::BodyMotion& body) const {
///             const ingot::lane none{}, F_z = body.r_CM.z * ingot::splat<ingot::lane>(-k);
///             return ingot::Wrench::force({none, none, F_z});
///         }
///     };
///
/// A field that is to go into portable snapshots (world/snapshot.h) hands out its numbers, one by one: scalars, vectors, matrices and
/// unsigned integers of 8 to 64 bits. A name before them tells the field from another with as many numbers: their worlds refuse each other's
/// snapshots.
///
///         template <class Each> constexpr void numbers(Each& each) {
///             each.name("buoy");
///             each(k);
///         }
///
/// Only + - * / sqrt, and select() in place of branches, keep the bits equal on all targets. A field that gives NaN or infinity
/// makes the body freeze, see World::is_frozen. What it gives to immovable bodies counts nothing.
struct ForceField {
    static constexpr bool depends_on_velocity = true;  ///< it reads v_CM or omega
    /// What the field gives a body at rest depends on the body, its place and the numbers of the field alone, not on the time: bodies may sleep in
    /// it, and wake when its numbers change. See Scene::sleeps.
    static constexpr bool is_steady = false;
};

/// No field: bodies are driven by gravity, forces and torques that are constant over a step.
struct NoForceField : ForceField {
    static constexpr bool depends_on_velocity = false;  ///< it reads neither
};

template <class Field>
inline constexpr bool is_field = true;
template <>
inline constexpr bool is_field<NoForceField> = false;

} }  // namespace ingot

#pragma GCC diagnostic pop

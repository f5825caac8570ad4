// SPDX-License-Identifier: MIT
// Force fields ready to use; see force_field.h for what a field is. Numbers are those of all bodies of the world; a field of
// zeros gives no force.
#pragma once

#include "../math/sqrt.h"
#include "force_field.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// 1/|d|^3 and 1/|d|^5 of a distance; 0 at zero distance.
struct InversePowers {
    lane cubed{}, fifth{};
};
INGOT_INLINE InversePowers inverse_powers(const Vec3<lane>& d) {
    const lane d_sq = length_sq(d);
    const auto apart = d_sq > lane{};
    const lane inverse_sq = select(apart, splat<lane>(1) / select(apart, d_sq, splat<lane>(1)), lane{});
    const lane cubed = inverse_sq * sqrt(inverse_sq);
    return {cubed, cubed * inverse_sq};
}

/// Gravity of a mass at a point: F = -M mu d/|d|^3, d = r_CM - centre. Bodies orbit.
struct PointMassGravity : ForceField {
    static constexpr bool is_steady = true;
    static constexpr bool depends_on_velocity = false;
    scalar mu{};    ///< m^3 s^-2, gravitational constant times the mass
    Vector centre{};  ///< m, world

    template <class Each>
    constexpr void numbers(Each& each) {
        each.name("point_mass_gravity");
        each(mu);
        each(centre);
    }

    INGOT_INLINE Wrench operator()(const BodyMotion& body) const {
        const Vec3<lane> d = body.r_CM - splat(centre);
        return Wrench::force(d * (inverse_powers(d).cubed * mass_of(body) * splat<lane>(-mu)));
    }
};

/// The torque that the same gravity has on a body: tau = 3 mu/|d|^5 d x (I d), to first order in size over distance.
/// Source: Hughes, Spacecraft Attitude Dynamics, 1986, 8.1.
struct GravityGradient : ForceField {
    static constexpr bool is_steady = true;
    static constexpr bool depends_on_velocity = false;
    scalar mu{};    ///< m^3 s^-2
    Vector centre{};  ///< m, world

    template <class Each>
    constexpr void numbers(Each& each) {
        each.name("gravity_gradient");
        each(mu);
        each(centre);
    }

    INGOT_INLINE Wrench operator()(const BodyMotion& body) const {
        const Vec3<lane> d = body.r_CM - splat(centre);
        const Vec3<lane> d_body = transpose_times(body.A, d);
        const Vec3<lane> torque_body = cross(d_body, scaled(moments_of(body), d_body));
        return Wrench::torque(body.A * (torque_body * (inverse_powers(d).fifth * splat<lane>(3 * mu))));
    }
};

/// Drag of a thick fluid: F = -c v_CM, tau = -c_turn omega.
struct LinearDrag : ForceField {
    static constexpr bool is_steady = true;
    scalar c{};     ///< N s/m
    scalar c_turn{};  ///< N m s/rad

    template <class Each>
    constexpr void numbers(Each& each) {
        each.name("linear_drag");
        each(c);
        each(c_turn);
    }

    INGOT_INLINE Wrench operator()(const BodyMotion& body) const {
        return {body.v_CM * splat<lane>(-c), body.omega * splat<lane>(-c_turn)};
    }
};

/// Drag of a thin fluid: F = -c |v_CM| v_CM, tau = -c_turn |omega| omega.
struct QuadraticDrag : ForceField {
    static constexpr bool is_steady = true;
    scalar c{};     ///< N s^2/m^2, half of density, area and drag coefficient
    scalar c_turn{};  ///< N m s^2/rad^2

    template <class Each>
    constexpr void numbers(Each& each) {
        each.name("quadratic_drag");
        each(c);
        each(c_turn);
    }

    INGOT_INLINE Wrench operator()(const BodyMotion& body) const {
        return {body.v_CM * (sqrt(length_sq(body.v_CM)) * splat<lane>(-c)), body.omega * (sqrt(length_sq(body.omega)) * splat<lane>(-c_turn))};
    }
};

/// A spring of no length from a point of the body to a point of the world: F = -k (P - anchor), P = r_CM + A r_body.
struct Spring : ForceField {
    static constexpr bool is_steady = true;
    static constexpr bool depends_on_velocity = false;
    scalar k{};     ///< N/m
    Vector r_body{};  ///< m, body axes, from the centre of mass
    Vector anchor{};  ///< m, world

    template <class Each>
    constexpr void numbers(Each& each) {
        each.name("spring");
        each(k);
        each(r_body);
        each(anchor);
    }

    INGOT_INLINE Wrench operator()(const BodyMotion& body) const {
        const Vec3<lane> r_P = body.A * splat(r_body);
        const Vec3<lane> F = (body.r_CM + r_P - splat(anchor)) * splat<lane>(-k);
        return {F, cross(r_P, F)};
    }
};

/// The same with a damper beside the spring: F = -k (P - anchor) - c v_P.
struct SpringDamper : ForceField {
    static constexpr bool is_steady = true;
    scalar k{};     ///< N/m
    scalar c{};     ///< N s/m
    Vector r_body{};  ///< m, body axes, from the centre of mass
    Vector anchor{};  ///< m, world

    template <class Each>
    constexpr void numbers(Each& each) {
        each.name("spring_damper");
        each(k);
        each(c);
        each(r_body);
        each(anchor);
    }

    INGOT_INLINE Wrench operator()(const BodyMotion& body) const {
        const Vec3<lane> r_P = body.A * splat(r_body);
        const Vec3<lane> v_P = body.v_CM + cross(body.omega, r_P);
        const Vec3<lane> F = (body.r_CM + r_P - splat(anchor)) * splat<lane>(-k) - v_P * splat<lane>(c);
        return {F, cross(r_P, F)};
    }
};

/// Torque of a magnetic field on a dipole of the body: tau = (A m_body) x B.
struct MagneticDipole : ForceField {
    static constexpr bool is_steady = true;
    static constexpr bool depends_on_velocity = false;
    Vector m_body{};  ///< A m^2, body axes
    Vector B{};     ///< T, world

    template <class Each>
    constexpr void numbers(Each& each) {
        each.name("magnetic_dipole");
        each(m_body);
        each(B);
    }

    INGOT_INLINE Wrench operator()(const BodyMotion& body) const { return Wrench::torque(cross(body.A * splat(m_body), splat(B))); }
};

/// Weight of bodies that turn about a fixed point (heavy tops): tau = (A r_body) x weight. The moments of such a body are those
/// about the point, and its scene does not translate.
struct WeightAboutPoint : ForceField {
    static constexpr bool is_steady = true;
    static constexpr bool depends_on_velocity = false;
    Vector r_body{};  ///< m, body axes, from the fixed point to the centre of mass
    Vector weight{};  ///< N, world: {0, 0, -M g}

    template <class Each>
    constexpr void numbers(Each& each) {
        each.name("weight_about_point");
        each(r_body);
        each(weight);
    }

    INGOT_INLINE Wrench operator()(const BodyMotion& body) const { return Wrench::torque(cross(body.A * splat(r_body), splat(weight))); }
};

/// Thrusters bolted to the body, each with a throttle for each body: F = sum of A F_body throttle.
/// bodies: max_bodies of the scene.
template <int thrusters, int bodies = 1>
struct ThrusterTable : ForceField {
    static constexpr bool is_steady = true;
    static constexpr bool depends_on_velocity = false;
    /// One thruster of a body.
    struct Thruster {
        Vector r_body{};  ///< m, body axes, from the centre of mass
        Vector F_body{};  ///< N, body axes, at full throttle
        scalar throttle[static_cast<unsigned>((bodies + lanes - 1) / lanes * lanes)]{};  ///< by slot of the body, 0 .. 1
    };
    Thruster thruster[static_cast<unsigned>(thrusters)]{};  ///< each in turn

    template <class Each>
    constexpr void numbers(Each& each) {
        each.name("thruster_table");
        for (Thruster& one : thruster) {
            each(one.r_body);
            each(one.F_body);
            // bound: max_bodies: the argument of a table of thrusters
            for (int body_i = 0; body_i < bodies; ++body_i) each(one.throttle[body_i]);  // not of spare lanes
        }
    }

    INGOT_INLINE Wrench operator()(const BodyMotion& body) const {
        Wrench sum{};
        for (const Thruster& one : thruster) {
            const Vec3<lane> F_body = splat(one.F_body) * load(one.throttle + body.first_slot);
            sum = sum + Wrench{F_body, cross(splat(one.r_body), F_body)};
        }
        return {body.A * sum.F, body.A * sum.tau};
    }
};

/// Two fields at once; nest it for more.
template <class First, class Second>
struct BothFields : ForceField {
    static constexpr bool is_steady = First::is_steady && Second::is_steady;
    static constexpr bool depends_on_velocity = First::depends_on_velocity || Second::depends_on_velocity;
    First first{};  ///< with its own numbers
    Second second{};  ///< with its own numbers

    template <class Each>
    constexpr void numbers(Each& each) {
        first.numbers(each);
        second.numbers(each);
    }

    INGOT_INLINE Wrench operator()(const BodyMotion& body) const { return first(body) + second(body); }
};

} }  // namespace ingot

#pragma GCC diagnostic pop

// SPDX-License-Identifier: MIT
// What a contact scene is: bodies by number, as plain data. No scene here names a solver, a capacity or a feature; those are
// the choice of who runs it.
//
// A scene is a struct with
//
//     name, body_count, gravity, h (s, one step call), seconds (how long its criterion asks for)
//     static PlacedBody body(int body_i)          // bodies 0 .. body_count - 1, immovable ones first
//
// so that the smallest target can go through the bodies one by one and keep none. Joined friction and restitution of a pair are
// those of the scene: all of its bodies carry the same mu and e, whatever the rule of mixing, unless it says otherwise.
#pragma once

#include <ingot/ingot.h>

namespace scenes {

using ingot::scalar;
using ingot::Vector;

constexpr scalar standard_gravity = scalar(9.81);  ///< m s^-2
constexpr scalar display_rate_h = scalar(1) / 60;  ///< s

/// A body in its place. What BodyDef does not know of yet stands beside it.
struct PlacedBody {
    ingot::BodyDef def{};   ///< mass, state, shape, restitution, immovable
    scalar mu = 0;          ///< Coulomb friction
    Vector omega{};         ///< rad/s, world; def.state.L follows from it
    Vector corner[8] = {};  ///< m, body frame: of a convex hull with the faces of a box (see hexahedron_face)
    bool is_hull = false;   ///< def.shape is none: the corners say what it is

    constexpr void move(const Vector& v_CM, const Vector& spin = {}) {
        def.state.v_CM = v_CM;
        omega = spin;
        def.state.L = ingot::angular_momentum_of_spin(def.state.A, def.mass.I_body, spin);
    }
    constexpr void turn(const ingot::Matrix& A) {
        def.state.A = A;
        move(def.state.v_CM, omega);
    }
};

/// Corner i of a box has the signs of bits 0, 1, 2 of i for x, y, z; a hexahedron numbers its corners in the same way. The four
/// corners of each face, counter-clockwise from outside.
constexpr int hexahedron_face[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

constexpr ingot::MassProperties mass_of(const ingot::MassDistribution& solid) {
    return {solid.M, {solid.I.xx, solid.I.yy, solid.I.zz}, {}, ingot::identity_matrix<scalar>()};
}

/// A solid box of mass M along the world's axes, at rest.
constexpr PlacedBody solid_box(scalar M, const Vector& half_extents, const Vector& r_CM, scalar mu, scalar e = 0) {
    PlacedBody body;
    body.def.mass = mass_of(ingot::with_mass(ingot::solid_box(1, half_extents), M));
    body.def.shape = ingot::Box{half_extents};
    body.def.restitution = e;
    body.def.state.r_CM = r_CM;
    body.mu = mu;
    return body;
}

/// A cube of 1 m and 1 kg, the unit of the anchors.
constexpr PlacedBody unit_cube(const Vector& r_CM, scalar mu) {
    return solid_box(1, {scalar(0.5), scalar(0.5), scalar(0.5)}, r_CM, mu);
}

/// A solid ball of mass M at rest.
constexpr PlacedBody solid_ball(scalar M, scalar radius, const Vector& r_CM, scalar mu, scalar e = 0) {
    PlacedBody body;
    body.def.mass = mass_of(ingot::with_mass(ingot::solid_sphere(1, radius), M));
    body.def.shape = ingot::Sphere{radius};
    body.def.restitution = e;
    body.def.state.r_CM = r_CM;
    body.mu = mu;
    return body;
}

/// Ground or wall: all points with normal . r <= offset.
constexpr PlacedBody half_space(const Vector& normal, scalar offset, scalar mu, scalar e = 0) {
    PlacedBody body;
    body.def.shape = ingot::HalfSpace{normal, offset};
    body.def.restitution = e;
    body.def.immovable = true;
    body.mu = mu;
    return body;
}

/// Flat ground at height 0.
constexpr PlacedBody flat_ground(scalar mu, scalar e = 0) { return half_space({0, 0, 1}, 0, mu, e); }

/// A box that nothing moves.
constexpr PlacedBody fixed_box(const Vector& half_extents, const Vector& r_CM, scalar mu, scalar e = 0) {
    PlacedBody body;
    body.def.shape = ingot::Box{half_extents};
    body.def.restitution = e;
    body.def.state.r_CM = r_CM;
    body.def.immovable = true;
    body.mu = mu;
    return body;
}

/// Floor and four walls of a square pit of this inner side around the z axis: bodies 0 to 4.
constexpr PlacedBody pit_wall(int wall_i, scalar side, scalar mu, scalar e = 0) {
    const Vector normals[5] = {{0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
    return half_space(normals[wall_i], wall_i == 0 ? 0 : -side / 2, mu, e);
}

/// A number in [-1, 1), a multiple of 2^-23, that depends on index and channel alone: bodies can be asked for in any order.
/// Source: the mixing function of Steele, Lea and Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.
constexpr scalar scattered(int index, int channel) {
    uint64_t bits = (static_cast<uint64_t>(index) * 64 + static_cast<uint64_t>(channel) + 1) * 0x9e3779b97f4a7c15u;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    bits ^= bits >> 31;
    return static_cast<scalar>(static_cast<int32_t>(bits >> 40) - (1 << 23)) * (scalar(1) / (1 << 23));
}

/// A rotation that depends on index alone, without a root: of an integer quaternion.
constexpr ingot::Matrix scattered_rotation(int index) {
    scalar q[4] = {};
    for (int i = 0; i < 4; ++i) q[i] = static_cast<scalar>(static_cast<int>(scattered(index, 32 + i) * 8));
    if (q[0] == 0) q[0] = 1;
    const scalar n = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    const auto entry = [&](int r, int c) {  // 2 (q_r q_c) / n, r and c from 1
        return 2 * q[r] * q[c] / n;
    };
    const auto turn = [&](int i) { return 2 * q[0] * q[i] / n; };
    return {{1 - entry(2, 2) - entry(3, 3), entry(1, 2) + turn(3), entry(1, 3) - turn(2)},
            {entry(1, 2) - turn(3), 1 - entry(1, 1) - entry(3, 3), entry(2, 3) + turn(1)},
            {entry(1, 3) + turn(2), entry(2, 3) - turn(1), 1 - entry(1, 1) - entry(2, 2)}};
}

/// Gravity downwards and a frame of 1/60 s: what scenes have unless they say otherwise.
struct OnEarth {
    static constexpr Vector gravity = {0, 0, -standard_gravity};
    static constexpr scalar h = display_rate_h;
};

}  // namespace scenes

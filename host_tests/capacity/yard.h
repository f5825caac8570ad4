// SPDX-License-Identifier: MIT
// A world with everything in it, and worlds compared by their bytes.
#pragma once

#include <ingot/ingot.h>

#include <string.h>

namespace yard {

using ingot::BodyDef;
using ingot::BodyId;
using ingot::BodyState;
using ingot::MassProperties;
using ingot::Matrix;
using ingot::Result;
using ingot::scalar;
using ingot::Shape;
using ingot::Status;
using ingot::StepReport;
using ingot::Vector;
using ingot::World;
namespace limits = ingot::limits;

inline constexpr scalar h = scalar(1) / 60;

inline MassProperties mass_of(scalar M, const Vector& I_body) {
    MassProperties mass{};
    mass.M = M;
    mass.I_body = I_body;
    mass.A_principal = ingot::identity_matrix<scalar>();
    return mass;
}

/// A body of mass 1 whose three moments differ, at rest at r_CM.
inline BodyDef plain_body(const Vector& r_CM, const Shape& shape = {}) {
    BodyDef def;
    def.mass = mass_of(1, {1, scalar(1.5), 2});
    def.state.r_CM = r_CM;
    def.shape = shape;
    return def;
}

/// z <= 0.
inline BodyDef ground() {
    BodyDef def;
    def.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    def.immovable = true;
    return def;
}

template <class S>
void copy(World<S>& to, const World<S>& from) {
    memcpy(static_cast<void*>(&to), &from, sizeof to);
}

template <class S>
void clear(World<S>& world) {
    memset(static_cast<void*>(&world), 0, sizeof world);
}

template <class S>
bool same_bytes(const World<S>& a, const World<S>& b) {
    return memcmp(&a, &b, sizeof a) == 0;
}

inline bool same_bits(const BodyState& a, const BodyState& b) {
    static_assert(sizeof(BodyState) == 18 * sizeof(scalar), "a state without padding is compared by its bytes");
    return memcmp(&a, &b, sizeof a) == 0;
}

/// Seven bodies leave lanes empty in tiles of 2, 4, 8 and 16.
struct Yard : ingot::Scene {
    static constexpr int max_bodies = 7;
    static constexpr bool translates = true;
    static constexpr int max_contacts = 24;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};

/// Who is in a yard.
struct Cast {
    BodyId ground;    ///< immovable
    BodyId box;       ///< on the ground
    BodyId ball;      ///< on the ground
    BodyId spinner;   ///< tumbles, touches nothing; lives in the slot of a body that was removed
    BodyId heavy;     ///< of the largest mass, with forces and torques pending, each three quarters of what is allowed
    BodyId frozen;
    BodyId removed;   ///< its slot is empty
    BodyId outlived;  ///< its slot is the spinner's
};

/// A yard in mid-life: contacts, spins, a frozen body, an empty slot, forces pending.
inline Cast fill(World<Yard>& world) {
    Cast cast{};
    (void)world.set_tag(7);
    (void)world.set_gravity({0, 0, scalar(-9.8125)});
    cast.ground = world.add(ground()).value;

    BodyDef box = plain_body({0, 0, 1}, ingot::Box{{1, 1, 1}});
    box.restitution = scalar(0.25);
    cast.box = world.add(box).value;

    BodyDef ball = plain_body({5, 0, scalar(0.5)}, ingot::Sphere{scalar(0.5)});
    ball.state.L = {0, 0, 3};
    cast.ball = world.add(ball).value;

    cast.outlived = world.add(plain_body({0, 0, 50})).value;
    (void)world.remove(cast.outlived);
    BodyDef spinner = plain_body({0, 0, 1000});
    spinner.state.A = ingot::rotation_about({scalar(0.6), 0, scalar(0.8)}, 1).value;
    spinner.state.L = {1, -2, 3};
    cast.spinner = world.add(spinner).value;

    BodyDef heavy = plain_body({0, 2000, 0});
    heavy.mass = mass_of(limits::mass_max, {scalar(1e15), scalar(1e15), scalar(1e15)});
    cast.heavy = world.add(heavy).value;

    BodyDef leaving = plain_body({limits::position_max, 0, 0});
    leaving.state.v_CM = {limits::speed_max, 0, 0};
    leaving.state.L = {1, 1, 1};
    cast.frozen = world.add(leaving).value;

    cast.removed = world.add(plain_body({9, 9, 9}, ingot::Sphere{1})).value;
    (void)world.remove(cast.removed);

    for (int step_i = 0; step_i < 30; ++step_i) (void)ingot::step(world, h);
    (void)world.add_central_force(cast.heavy, {limits::force_max * scalar(0.75), 0, 0});
    (void)world.add_torque(cast.heavy, {0, limits::torque_max * scalar(0.75), 0});
    (void)world.add_force(cast.spinner, {1, 2, 3}, {0, 0, 1001});
    return cast;
}

}  // namespace yard

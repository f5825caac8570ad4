// SPDX-License-Identifier: MIT
// The same few bodies for every rotation method and every flight: what their golden hashes are taken of.
#pragma once

#include <ingot/ingot.h>

namespace scenes {

using ingot::scalar;

/// Bodies of every kind, more than any tile has lanes for, at spins from rest to substeps.
template <class W>
ingot::Status set_up_spinning(W& world) {
    constexpr ingot::Vector moments[] = {{1, 2, 3}, {1, 1, scalar(1.75)}, {2, 2, 2}, {scalar(0.03125), 1, 1}};
    constexpr ingot::Vector spins[] = {{scalar(0.25), 3, scalar(-0.5)}, {1, scalar(0.5), 2}, {-2, 1, scalar(0.25)}, {}, {9, -6, 24}};
    for (int body_i = 0; body_i < W::max_bodies; ++body_i) {
        ingot::BodyDef def;
        const ingot::Vector I = moments[body_i % 4];
        def.mass = {2, I, {}, ingot::identity_matrix<scalar>()};
        def.state.L = ingot::angular_momentum_of_spin(def.state.A, I, spins[body_i % 5]);
        if (W::scene::translates) {
            def.state.r_CM = {4 + static_cast<scalar>(body_i) / 2, scalar(0.5), -1};
            def.state.v_CM = {scalar(-0.25), 1, scalar(0.5)};
        }
        const ingot::Status status = world.add(def).status;
        if (status != ingot::Status::ok) return status;
    }
    return ingot::Status::ok;
}

template <class Rotation>
struct Spinning : ingot::Scene {
    static constexpr int max_bodies = 9;
    static constexpr scalar h = scalar(1) / 60;
    static constexpr int golden_steps = 300;
    using rotation = Rotation;
};

template <class Rotation>
ingot::Status set_up(ingot::World<Spinning<Rotation>>& world) {
    return set_up_spinning(world);
}

/// In the gravity of a mass, with the torque of its gradient and, where the flight takes it, drag.
using Tide = ingot::BothFields<ingot::PointMassGravity, ingot::GravityGradient>;
using TideAndDrag = ingot::BothFields<Tide, ingot::QuadraticDrag>;

inline void set_numbers(Tide& tide) {
    tide.first.mu = 8;
    tide.second.mu = 8;
}
inline void set_numbers(TideAndDrag& field) {
    set_numbers(field.first);
    field.second.c = scalar(0.0625);
    field.second.c_turn = scalar(0.03125);
}

template <class Flight, class Field>
struct InTide : ingot::Scene {
    static constexpr int max_bodies = 9;
    static constexpr bool translates = true;
    static constexpr scalar h = scalar(1) / 60;
    static constexpr int golden_steps = 300;
    using force_field = Field;
    using flight = Flight;
};

using TideOfMethods = InTide<ingot::BlanesMoan4, Tide>;

template <class Flight, class Field>
ingot::Status set_up(ingot::World<InTide<Flight, Field>>& world) {
    set_numbers(world.force_field());
    return set_up_spinning(world);
}

}  // namespace scenes

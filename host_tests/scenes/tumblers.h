// SPDX-License-Identifier: MIT
#pragma once

#include "random.h"

namespace scenes {

/// 64 balls of four sizes fly, tumble and collide elastically in a closed box of 2 m, without gravity.
///
/// Their moments are unequal (a ball with a heavy core that is no ball), so each tumbles on a way of its own. No force
/// does work, so the kinetic energy stays to rounding; the walls take momentum, and their impulses tell how much.
struct Tumblers : ingot::Scene {
    static constexpr const char* name = "tumblers";
    static constexpr const char* title = "64 balls in a closed box";
    static constexpr int ball_count = 64;
    static constexpr int max_bodies = ball_count + 6;
    static constexpr bool translates = true;
    static constexpr int max_contacts = 48;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;

    static constexpr ingot::scalar h = ingot::scalar(1) / 120;  ///< s
    static constexpr int golden_steps = 240;
    static constexpr int demo_steps = 7200;  ///< one minute
};

inline ingot::Status set_up(ingot::World<Tumblers>& world) {
    using ingot::scalar;
    for (int wall_i = 0; wall_i < 6; ++wall_i) {
        const scalar inward = wall_i % 2 == 0 ? scalar(1) : scalar(-1);
        ingot::BodyDef wall;
        wall.immovable = true;
        wall.restitution = 1;
        wall.shape = ingot::HalfSpace{{wall_i / 2 == 0 ? inward : 0, wall_i / 2 == 1 ? inward : 0, wall_i / 2 == 2 ? inward : 0}, -1};
        const ingot::Status status = world.add(wall).status;
        if (status != ingot::Status::ok) return status;
    }

    Random random(1997);
    for (int ball_i = 0; ball_i < Tumblers::ball_count; ++ball_i) {
        const scalar radius = scalar(0.06) + scalar(0.02) * static_cast<scalar>(ball_i % 4);
        const scalar M = 1000 * radius * radius * radius;  // about a quarter of water
        const scalar I = scalar(0.4) * M * radius * radius;
        const auto grid = [](int index) { return scalar(0.45) * (static_cast<scalar>(index) - scalar(1.5)); };

        ingot::BodyDef ball;
        ball.mass = {M, {I * scalar(0.75), I, I * scalar(1.125)}, {}, ingot::identity_matrix<scalar>()};
        ball.shape = ingot::Sphere{radius};
        ball.restitution = 1;
        ball.state.r_CM = {grid(ball_i % 4), grid(ball_i / 4 % 4), grid(ball_i / 16)};
        ball.state.v_CM = random.symmetric_vector();
        ball.state.A = ingot::axis_angle({0, scalar(0.6), scalar(0.8)}, 3 * random.symmetric());
        ball.state.L = ingot::angular_momentum_of_spin(ball.state.A, ball.mass.I_body, random.symmetric_vector() * scalar(6));
        const ingot::Status status = world.add(ball).status;
        if (status != ingot::Status::ok) return status;
    }
    return ingot::Status::ok;
}

}  // namespace scenes

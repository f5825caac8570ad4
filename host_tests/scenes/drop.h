// SPDX-License-Identifier: MIT
#pragma once

#include <ingot/ingot.h>

namespace scenes {

/// Boxes dropped on a plane flat, on an edge and on a corner, and two balls: they bounce, fall over and come to rest.
struct Drop : ingot::Scene {
    static constexpr const char* name = "drop";
    static constexpr const char* title = "boxes and balls fall on a plane";
    static constexpr int box_count = 4, ball_count = 2;
    static constexpr int max_bodies = 1 + box_count + ball_count;
    static constexpr bool translates = true;
    static constexpr int max_contacts = 20;  ///< four corners a box, one point a ball, and two to spare
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;

    static constexpr ingot::scalar h = ingot::scalar(1) / 240;  ///< s
    static constexpr int golden_steps = 480;
    static constexpr int demo_steps = 2400;  ///< ten seconds
    static constexpr ingot::scalar g = ingot::scalar(9.81);     ///< m s^-2
};

inline ingot::Status set_up(ingot::World<Drop>& world) {
    using ingot::scalar;
    ingot::Status status = world.set_gravity({0, 0, -Drop::g});

    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    if (status == ingot::Status::ok) status = world.add(ground).status;

    // Turned so that the box meets the plane with a face, an edge, a corner, and with nothing aligned.
    constexpr ingot::Vector x = {1, 0, 0}, y = {0, 1, 0};
    constexpr scalar eighth = scalar(0.78539816339744830962);           // pi / 4
    constexpr scalar to_corner = scalar(0.61547970867038734107);        // atan(1 / sqrt 2)
    const ingot::Matrix on_edge = ingot::axis_angle(x, eighth);
    const ingot::Matrix turns[Drop::box_count] = {ingot::identity_matrix<scalar>(), on_edge, ingot::axis_angle(y, to_corner) * on_edge,
                                                  ingot::axis_angle({0, scalar(0.6), scalar(0.8)}, 1)};
    for (int box_i = 0; box_i < Drop::box_count && status == ingot::Status::ok; ++box_i) {
        constexpr ingot::Vector half = {scalar(0.5), scalar(0.4), scalar(0.3)};
        constexpr ingot::MassDistribution solid = ingot::solid_box(100, half);
        ingot::BodyDef box;
        box.mass = {solid.M, {solid.I.xx, solid.I.yy, solid.I.zz}, {}, ingot::identity_matrix<scalar>()};
        box.shape = ingot::Box{half};
        box.restitution = scalar(0.5);
        box.state.r_CM = {3 * static_cast<scalar>(box_i), 0, 2};
        box.state.A = turns[box_i];
        status = world.add(box).status;
    }
    for (int ball_i = 0; ball_i < Drop::ball_count && status == ingot::Status::ok; ++ball_i) {
        constexpr scalar radius = scalar(0.25);
        constexpr ingot::MassDistribution solid = ingot::solid_sphere(100, radius);
        ingot::BodyDef ball;
        ball.mass = {solid.M, {solid.I.xx, solid.I.yy, solid.I.zz}, {}, ingot::identity_matrix<scalar>()};
        ball.shape = ingot::Sphere{radius};
        ball.restitution = ball_i == 0 ? scalar(0.5) : scalar(0.9);
        ball.state.r_CM = {3 * static_cast<scalar>(ball_i), 3, 2};
        status = world.add(ball).status;
    }
    return status;
}

}  // namespace scenes

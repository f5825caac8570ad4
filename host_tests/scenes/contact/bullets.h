// SPDX-License-Identifier: MIT
// Bodies too fast for a step: nothing may pass through anything.
#pragma once

#include "placed_body.h"

namespace scenes {

/// I11: a ball of 5 cm diameter and 0.5 kg at 1000 m/s along x against an immovable plate 1 cm thick at x = 0; it starts
/// `phase` (0 .. 1) of a frame's path further from the plate than two frames. No gravity.
///
/// Criterion: never passes; time of impact within 1e-6 s at 60 Hz.
struct BulletAndPlate {
    static constexpr const char* name = "bullet_and_plate";
    static constexpr int body_count = 2;
    static constexpr Vector gravity = {0, 0, 0};
    static constexpr scalar h = display_rate_h;
    static constexpr scalar speed = 1000, radius = scalar(0.025), half_thickness = scalar(0.005);

    static constexpr PlacedBody body(int body_i, scalar phase, scalar e) {
        if (body_i == 0) return fixed_box({half_thickness, 2, 2}, {0, 0, 0}, 0, e);
        PlacedBody ball = solid_ball(scalar(0.5), radius, {-(2 + phase) * speed * h, 0, 0}, 0, e);
        ball.move({speed, 0, 0});
        return ball;
    }
    /// s from the start.
    static constexpr scalar time_of_impact(scalar phase) { return (2 + phase) * h - (radius + half_thickness) / speed; }
};

/// Two bodies of 0.5 m, 1 kg, head-on at 10 to 80 m/s each, in 40 phases of a frame. No gravity.
///
/// Criterion: none passes: body 0 stays left of body 1.
struct HeadOn {
    static constexpr const char* name = "head_on";
    static constexpr int body_count = 2, phase_count = 40;
    static constexpr Vector gravity = {0, 0, 0};
    static constexpr scalar h = display_rate_h;

    static constexpr PlacedBody body(int body_i, bool balls, scalar speed, int phase_i) {
        const scalar away = scalar(0.3) + 2 * speed * h * (1 + static_cast<scalar>(phase_i) / phase_count);
        const scalar side = body_i == 0 ? scalar(-1) : scalar(1);
        constexpr scalar half = scalar(0.25);
        PlacedBody one = balls ? solid_ball(1, half, {side * away, 0, 0}, scalar(0.5))
                               : solid_box(1, {half, half, half}, {side * away, 0, 0}, scalar(0.5));
        one.move({-side * speed, 0, 0});
        return one;
    }
};

/// I12: a bar of 2 m x 4 cm x 4 cm and 1 kg spins about its middle with 300 m/s at the tips (300 rad/s, 286 degrees a frame)
/// and drifts at 10 m/s into an immovable wall 2 cm thick at x = 0. No gravity.
///
/// Criterion: its centre never gets beyond the wall's middle plane, and it is never across the wall for two frames.
struct SpinningBar {
    static constexpr const char* name = "spinning_bar";
    static constexpr int body_count = 2;
    static constexpr Vector gravity = {0, 0, 0};
    static constexpr scalar h = display_rate_h;
    static constexpr scalar seconds = 1;

    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return fixed_box({scalar(0.01), 5, 5}, {0, 0, 0}, scalar(0.3));
        PlacedBody bar = solid_box(1, {1, scalar(0.02), scalar(0.02)}, {-3, 0, 0}, scalar(0.3));
        bar.move({10, 0, 0}, {0, 0, 300});
        return bar;
    }
};

/// A ball of 5 cm at 1000 m/s flies by an immovable box of half a metre: along its face, `away` above its edge. No gravity.
///
/// Criterion: away > 0: neither speed nor spin nor direction changes by one bit.
struct Grazing {
    static constexpr const char* name = "grazing";
    static constexpr int body_count = 2;
    static constexpr Vector gravity = {0, 0, 0};
    static constexpr scalar h = display_rate_h;
    static constexpr scalar speed = 1000, radius = scalar(0.025), half = scalar(0.25);

    /// oblique: past a corner of the box turned by 45 degrees, instead of along a face.
    static constexpr PlacedBody body(int body_i, scalar away, scalar phase, bool oblique) {
        constexpr scalar root_half = scalar(0.70710678118654752);
        if (body_i == 0) {
            PlacedBody box = fixed_box({half, half, half}, {0, 0, 0}, scalar(0.5), scalar(0.5));
            if (oblique) box.turn({{root_half, root_half, 0}, {-root_half, root_half, 0}, {0, 0, 1}});
            return box;
        }
        const scalar top = oblique ? half / root_half : half;
        PlacedBody ball = solid_ball(scalar(0.5), radius, {-(1 + phase) * speed * h, top + radius + away, 0}, scalar(0.5), scalar(0.5));
        ball.move({speed, 0, 0});
        return ball;
    }
};

/// A ball of 5 cm at 1000 m/s bounces between two immovable plates, 1 cm thick and 1 m apart. e = 1, no gravity: 17 impacts a frame.
///
/// Criterion: stays between them; keeps its energy; is where a ball in a gap of 0.95 m is.
struct BetweenPlates {
    static constexpr const char* name = "between_plates";
    static constexpr int body_count = 3;
    static constexpr Vector gravity = {0, 0, 0};
    static constexpr scalar h = display_rate_h;
    static constexpr scalar speed = 1000, radius = scalar(0.025), half_gap = scalar(0.5);

    static constexpr PlacedBody body(int body_i, scalar speed_of_ball) {
        constexpr scalar half_thickness = scalar(0.005);
        if (body_i < 2) return fixed_box({half_thickness, 2, 2}, {(body_i == 0 ? -1 : 1) * (half_gap + half_thickness), 0, 0}, 0, 1);
        PlacedBody ball = solid_ball(scalar(0.5), radius, {0, 0, 0}, 0, 1);
        ball.move({speed_of_ball, 0, 0});
        return ball;
    }
};

/// A ball of 5 cm at 1000 m/s through a gap 6 cm wide between two immovable boxes. No gravity.
///
/// Criterion: gets through without a touch.
struct ThroughGap {
    static constexpr const char* name = "through_gap";
    static constexpr int body_count = 3;
    static constexpr Vector gravity = {0, 0, 0};
    static constexpr scalar h = display_rate_h;
    static constexpr scalar speed = 1000, radius = scalar(0.025), half_gap = scalar(0.03);

    static constexpr PlacedBody body(int body_i, scalar phase) {
        if (body_i < 2) return fixed_box({scalar(0.2), 1, 1}, {0, (body_i == 0 ? -1 : 1) * (half_gap + 1), 0}, scalar(0.5), scalar(0.5));
        PlacedBody ball = solid_ball(scalar(0.5), radius, {-(1 + phase) * speed * h, 0, 0}, scalar(0.5), scalar(0.5));
        ball.move({speed, 0, 0});
        return ball;
    }
};

/// A ball of 5 cm and 0.1 kg at 500 m/s into the middle of a stack of five cubes of 20 cm and 4 kg each.
///
/// Criterion: stays in front of the cube it hits; energy never grows.
struct BulletIntoStack : OnEarth {
    static constexpr const char* name = "bullet_into_stack";
    static constexpr int body_count = 7;
    static constexpr scalar seconds = 2;
    static constexpr scalar speed = 500, radius = scalar(0.025), half = scalar(0.1), mu = scalar(0.5);

    static constexpr PlacedBody body(int body_i, scalar phase) {
        if (body_i == 0) return flat_ground(mu);
        if (body_i < 6) return solid_box(4, {half, half, half}, {0, 0, half * static_cast<scalar>(2 * body_i - 1)}, mu);
        PlacedBody ball = solid_ball(scalar(0.1), radius, {-(8 + phase) * speed * h, scalar(0.01), 5 * half + scalar(0.02)}, mu);
        ball.move({speed, 0, 0});
        return ball;
    }
};

/// Bullets through a shooting range: four walls, each a plate of 1 m x 1 m x 2 cm and 2 kg that stands on the ground, and behind them an
/// immovable plate of 1 cm. Four balls of 5 cm and 0.5 kg come one after another, at 200 to 800 m/s.
///
/// Criterion: bodies stay in their order along x; energy never grows.
struct BulletWalls : OnEarth {
    static constexpr const char* name = "bullet_walls";
    static constexpr int wall_count = 4, ball_count = 4, body_count = 2 + wall_count + ball_count;
    static constexpr scalar seconds = 2;
    static constexpr scalar mu = scalar(0.5), e = scalar(0.25), half_wall = scalar(0.01);

    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return flat_ground(mu, e);
        if (body_i == 1) return fixed_box({scalar(0.005), 5, 5}, {5, 0, 5}, mu, e);
        const int movable_i = body_i - 2;
        if (movable_i < wall_count)
            return solid_box(2, {half_wall, scalar(0.5), scalar(0.5)}, {static_cast<scalar>(1 + movable_i), 0, scalar(0.5)}, mu, e);
        const int ball_i = movable_i - wall_count;
        const scalar number = static_cast<scalar>(ball_i);
        PlacedBody ball = solid_ball(scalar(0.5), scalar(0.025),
                                     {-4 - 5 * number, scalar(0.1) * scattered(ball_i, 0), scalar(0.5) + scalar(0.1) * scattered(ball_i, 1)}, mu, e);
        ball.move({200 * (number + 1), 0, 0});
        return ball;
    }
};

}  // namespace scenes

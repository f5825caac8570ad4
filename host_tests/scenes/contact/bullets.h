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

}  // namespace scenes

// SPDX-License-Identifier: MIT
// Bounces, Newton's cradle, a box dropped flat, overlaps at the start.
#pragma once

#include "placed_body.h"

namespace scenes {

/// S8: a ball of radius 0.5 m and 1 kg falls 2 m (centre from 2.5 m) on flat ground.
///
/// Criterion: e = 1: energy error after 10 s <= 1e-6 at 30, 60, 240, 1000 Hz, never growing. e = 0.5: at rest within two steps
/// of 1.916 s (3 sqrt(2 h / g)), first peak 0.5 m. Best published: e = 1 last peak within 4e-5 % (Jolt, 60 Hz); e = 0.5 rest
/// after 1.85 s (ReactPhysics3D), 1.767 (Jolt).
template <int e_percent>
struct Bounce : OnEarth {
    static constexpr const char* name = "bounce";
    static constexpr int body_count = 2;
    static constexpr scalar seconds = e_percent == 100 ? 10 : 4;
    static constexpr scalar e = scalar(e_percent) / 100;

    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return flat_ground(0, e);
        return solid_ball(1, scalar(0.5), {0, 0, scalar(2.5)}, 0, e);
    }
};

/// A case of the tables bouncing_ball and bouncing_ball_impacts: z is the height of the ball's lowest point.
///
/// I5, I6. Criterion: elastic: energy <= 1e-9 with time of impact (double); half: rest within 1 step, then speed < 1e-6 m/s.
struct BounceCase {
    const char* table_case;
    scalar h_0, v_0, e, seconds;

    static constexpr scalar radius = scalar(0.25);
    static constexpr Vector gravity = {0, 0, scalar(-9.8125)};

    constexpr PlacedBody body(int body_i) const {
        if (body_i == 0) return flat_ground(0, e);
        PlacedBody ball = solid_ball(1, radius, {0, 0, h_0 + radius}, 0, e);
        ball.move({0, 0, v_0});
        return ball;
    }
};

constexpr BounceCase bounce_cases[] = {
    {"elastic", 2, 0, 1, 20}, {"half", 2, 0, scalar(0.5), 4}, {"lively", 1, 3, scalar(0.875), 10}, {"dead", 1, 0, 0, 2}};

/// I7: equal balls in a line, radius 0.1 m, gap_um micrometres apart (0: touching), no gravity; `coming` of them come from 0.1
/// m away at 1 m/s. e = 1, mu = 0.
///
/// Criterion: with 1 um gaps as many balls leave as came, velocities within 1 %; momentum and energy kept to 1e-6. Touching:
/// documented behaviour, momentum and energy kept to 1e-6.
template <int balls, int coming, int gap_um>
struct Cradle {
    static constexpr const char* name = "cradle";
    static constexpr int body_count = balls;
    static constexpr Vector gravity = {0, 0, 0};
    static constexpr scalar h = display_rate_h;
    static constexpr scalar seconds = 1;

    static constexpr PlacedBody body(int body_i) {
        constexpr scalar radius = scalar(0.1), gap = scalar(gap_um) * scalar(1e-6);
        const bool comes = body_i < coming;
        PlacedBody ball = solid_ball(
            1, radius, {static_cast<scalar>(body_i) * (2 * radius + gap) - (comes ? scalar(0.1) : scalar(0)), 0, 0}, 0, 1);
        if (comes) ball.move({1, 0, 0});
        return ball;
    }
};

/// I8: a box of 1 x 0.8 x 0.6 m and 2 kg dropped 1 m, flat.
///
/// Criterion: four equal impulses m v (1 + e) / 4; no induced rotation: |omega| <= 1e-10 rad/s (double), 1e-4 (float).
template <int e_percent>
struct BoxDroppedFlat : OnEarth {
    static constexpr const char* name = "box_dropped_flat";
    static constexpr int body_count = 2;
    static constexpr scalar seconds = 4;
    static constexpr scalar mu = scalar(0.5), e = scalar(e_percent) / 100;

    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return flat_ground(mu, e);
        return solid_box(2, {scalar(0.5), scalar(0.4), scalar(0.3)}, {0, 0, scalar(1.3)}, mu, e);
    }
};

/// C16, C17: two unit cubes, no gravity, overlapping by overlap_percent of their size along x; 100: coincident centres.
///
/// Criterion: finite, the same direction every time; they part at no more than the configured speed and no energy is put in
/// beyond that.
template <int overlap_percent, bool balls>
struct Overlap {
    static constexpr const char* name = "overlap";
    static constexpr int body_count = 2;
    static constexpr Vector gravity = {0, 0, 0};
    static constexpr scalar h = display_rate_h;
    static constexpr scalar seconds = 4;

    static constexpr PlacedBody body(int body_i) {
        const Vector r = {static_cast<scalar>(body_i) * (1 - scalar(overlap_percent) / 100), 0, 0};
        if (balls) return solid_ball(1, scalar(0.5), r, scalar(0.5));
        return unit_cube(r, scalar(0.5));
    }
};

}  // namespace scenes

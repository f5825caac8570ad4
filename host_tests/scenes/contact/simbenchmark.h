// SPDX-License-Identifier: MIT
// Scenes of SimBenchmark (Kang and Hwangbo, 2018, github.com/leggedrobotics/SimBenchmark): what is defined there, and the best
// errors it has on record, with CPU seconds of an i7-class desktop of 2018, at steps of 1 and 10 ms. Errors are means over all
// steps, each taken before its step, the first at t = 0.
#pragma once

#include "placed_body.h"

namespace scenes {

struct SimBenchmark {
    static constexpr Vector gravity = {0, 0, -standard_gravity};
    static constexpr scalar h = scalar(0.001);
};

/// rolling: a box of 20 x 20 x 1 m and 10 kg on the ground, 5 x 5 balls of radius 0.5 m and 1 kg on it, 2 m apart; 150 N at the
/// box's centre of mass for 4 s, along (1/2, sqrt(3)/2) ("diagonal") or y. Friction 0.8 ball and box, 0.4 box and ground: of
/// materials 0.5 (ground), 0.8 (box), 1 (ball) the product counts. Bodies start 2e-5 m inside each other, as there.
///
/// Error: |v_box - a_box t|^2 + |v_ball - a_ball t|^2 of ball 0, m^2 s^-2; a_box = (F - mu_1 (M + 25 m) g) / (M + 25 m 2/7)
/// = 0.73850 m s^-2, a_ball = 2/7 a_box. Best diagonal: Bullet 5.7e-9 in 0.56 s (3.9e-27 with 400 iterations, no ERP),
/// RaiSim 4.1e-7 in 0.31 s; with a pyramid for a cone 3.14. Along y: ODE 7.7e-9. C21 asks <= 1e-8.
struct SimRolling : SimBenchmark {
    static constexpr const char* name = "simbenchmark_rolling";
    static constexpr int balls_a_side = 5;
    static constexpr int body_count = 2 + balls_a_side * balls_a_side;
    static constexpr scalar seconds = 4;
    static constexpr scalar force = 150;
    static constexpr Vector push_diagonal = {force / 2, force*scalar(0.86602540378443864676), 0}, push_along_y = {0, force, 0};
    static constexpr scalar mu_ground_box = scalar(0.4), mu_box_ball = scalar(0.8);
    static constexpr scalar penetration = scalar(2e-5);
    static constexpr int pushed_body = 1, measured_ball = 2;

    /// mu of a body is that of its material; a pair's is the product.
    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return flat_ground(scalar(0.5));
        if (body_i == 1) return solid_box(10, {10, 10, scalar(0.5)}, {0, 0, scalar(0.5) - penetration}, scalar(0.8));
        const int ball_i = body_i - 2;
        return solid_ball(1, scalar(0.5),
                          {static_cast<scalar>(ball_i / balls_a_side * 2 - 4),
                           static_cast<scalar>(ball_i % balls_a_side * 2 - 4), scalar(1.5) - 3 * penetration},
                          1);
    }
};

/// bouncing: 7 x 7 balls of radius 0.1 m and 10 kg, 2 m apart, centres at 5 m; e = 1, no friction, 20 s.
///
/// Error: (E - E_0)^2, J^2, with E the sum of kinetic energy and m g z (z of the centre), E_0 = 49 m g 5 m = 24.03 kJ. Best:
/// RaiSim 1.9e-2 in 0.235 s (186 in 0.025 s at 10 ms); ODE 185; DART 7.2e4; Bullet 7.5e4. A relative 5.7e-6.
struct SimBouncing : SimBenchmark {
    static constexpr const char* name = "simbenchmark_bouncing";
    static constexpr int balls_a_side = 7;
    static constexpr int body_count = 1 + balls_a_side * balls_a_side;
    static constexpr scalar seconds = 20;

    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return flat_ground(0, 1);
        const int ball_i = body_i - 1;
        return solid_ball(10, scalar(0.1),
                          {static_cast<scalar>(ball_i / balls_a_side * 2), static_cast<scalar>(ball_i % balls_a_side * 2), 5},
                          0, 1);
    }
};

/// 666 and elastic 666: 6 x 6 x 6 balls of radius 0.1 m and 10 kg on a grid of 0.21 m, each coordinate plus a uniform 0 .. 1 mm
/// (its generator, seed 42, is not part of the definition: ours is `scattered`), lowest centres at 0.101 m (elastic: 1.101 m);
/// no friction, 10 s, open ground.
///
/// 666: e = 0; error: sum over pairs and ground of squared penetration, m^2. Best: RaiSim 1.35e-4 in 1.51 s (1.5e-2 in 0.17 s
/// at 10 ms), ODE 1.55e-4 in 10.0 s, DART 2.8e-4, MuJoCo 9.5e-2, Bullet 0.38. elastic 666: e = 1; error: (E - E at the
/// start)^2, J^2. Best: RaiSim 8.4 in 0.66 s (5.2e6 at 10 ms), ODE 112 in 5.6 s, Bullet 4.1e4, DART 3.5e5.
template <bool elastic>
struct Sim666 : SimBenchmark {
    static constexpr const char* name = elastic ? "simbenchmark_elastic_666" : "simbenchmark_666";
    static constexpr int n = 6;
    static constexpr int body_count = 1 + n * n * n;
    static constexpr scalar seconds = 10;
    static constexpr scalar e = elastic ? 1 : 0;
    static constexpr scalar radius = scalar(0.1);

    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return flat_ground(0, e);
        const int ball_i = body_i - 1;
        const auto place = [&](int cell, int channel) {
            return scalar(0.21) * static_cast<scalar>(cell) + scalar(0.0005) * (scattered(ball_i, channel) + 1);
        };
        return solid_ball(10, radius,
                          {place(ball_i / (n * n), 0), place(ball_i / n % n, 1),
                           place(ball_i % n, 2) + (elastic ? scalar(1.101) : scalar(0.101))},
                          0, e);
    }
};

}  // namespace scenes

// SPDX-License-Identifier: MIT
// Cubes on cubes: pyramids, towers, mass ratios, ten boxes.
#pragma once

#include "placed_body.h"

namespace scenes {

/// S2 of the anchors: a wall of 1 m, 1 kg cubes, `base` in the lowest row, one less in each above, touching vertically, 0.1 m
/// apart sideways. pyramid<10> has 55 cubes, <20> 210, <30> 465.
///
/// Criterion (10 s): 210: shift <= 1.5 mm, settling <= 0.5 mm, <= 0.22 of Bullet's time with 4 lanes; 465: shift <= 3 mm.
/// Best published at 60 Hz, 210: shift 10.3, settling 29 mm (Box3D 0.1); 25 and 31 mm (Jolt 5.5).
template <int base>
struct Pyramid : OnEarth {
    static constexpr const char* name = "pyramid";
    static constexpr int cube_count = base * (base + 1) / 2;
    static constexpr int body_count = 1 + cube_count;
    static constexpr scalar seconds = 10;
    static constexpr scalar mu = scalar(0.6);

    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return flat_ground(mu);
        int row = 0, place = body_i - 1;
        while (place >= base - row) place -= base - row++;
        const scalar pitch = scalar(1.1), row_length = static_cast<scalar>(base - row - 1) * pitch;
        return unit_cube({static_cast<scalar>(place) * pitch - row_length / 2, 0, static_cast<scalar>(row) + scalar(0.5)}, mu);
    }
};

/// S3: a column of 1 m, 1 kg cubes.
///
/// Criterion: 20: stands for 60 s; the top sinks <= 0.2 mm and drifts <= 0.1 mm, also without recycled manifolds. 40: stands
/// for 60 s. Best published at 60 Hz, 20 cubes: sinks 106 mm, drifts 3.4 mm in 20 s (Box3D 0.1); falls after 3 s (Jolt 5.5,
/// Bullet). C8 asks it of 10 and 20: top drift < 1 mm, tilt < 1e-3 rad in 60 s, contact forces sum to the weight within 1 %.
template <int height>
struct Tower : OnEarth {
    static constexpr const char* name = "tower";
    static constexpr int body_count = 1 + height;
    static constexpr scalar seconds = 60;
    static constexpr scalar mu = scalar(0.6);

    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return flat_ground(mu);
        return unit_cube({0, 0, static_cast<scalar>(body_i) - scalar(0.5)}, mu);
    }
};

/// S6: a column of light cubes of 1 kg with one of top_kg on top, all 1 m. `light` = 1, top_kg = 1000 is the anchor.
///
/// Criterion (10 s): 1000 on 1: interpenetration <= 0.1 mm with the default; 1e6 on 1 and nine of 1 kg under 1000 kg: stand,
/// with float state. Best published at 60 Hz, 1000 on 1: ODE's direct step 2e-5 mm; iterative engines at their defaults: 273 mm
/// (Box3D 0.1), crushed (Jolt, Bullet, qu3e, ReactPhysics3D).
template <int light, int top_kg>
struct MassRatio : OnEarth {
    static constexpr const char* name = "mass_ratio";
    static constexpr int body_count = 2 + light;
    static constexpr scalar seconds = 10;
    static constexpr scalar mu = scalar(0.6);

    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return flat_ground(mu);
        constexpr scalar half = scalar(0.5);
        return solid_box(body_i > light ? scalar(top_kg) : scalar(1), {half, half, half},
                         {0, 0, static_cast<scalar>(body_i) - half}, mu);
    }
};

/// Ten cubes of 1 m and 1 kg, side by side or in one column: the budget of a Cortex-M4F.
///
/// Criterion: <= 24 KB flash, <= 10 KB RAM, a resting step <= 80 k instructions side by side and <= 160 k in a column.
template <bool column>
struct TenBoxes : OnEarth {
    static constexpr const char* name = column ? "ten_boxes_column" : "ten_boxes_row";
    static constexpr int body_count = 11;
    static constexpr scalar seconds = 10;
    static constexpr scalar mu = scalar(0.6);

    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return flat_ground(mu);
        const scalar i = static_cast<scalar>(body_i - 1);
        if (column) return unit_cube({0, 0, i + scalar(0.5)}, mu);
        return unit_cube({i * scalar(1.5), 0, scalar(0.5)}, mu);
    }
};

/// C12: a cube on a cube with its centre of mass `over_mm` beyond the edge of the lower, which nothing moves.
///
/// Criterion: at -1 mm it rests for 60 s, at +1 mm it tips.
template <int over_mm>
struct Overhang : OnEarth {
    static constexpr const char* name = "overhang";
    static constexpr int body_count = 2;
    static constexpr scalar seconds = 60;
    static constexpr scalar mu = scalar(0.6);

    static constexpr PlacedBody body(int body_i) {
        constexpr scalar half = scalar(0.5);
        if (body_i == 0) return fixed_box({half, half, half}, {0, 0, half}, mu);
        return unit_cube({half + scalar(over_mm) / 1000, 0, 3 * half}, mu);
    }
};

/// C18: a box of 1000 : 1 : 1 on the ground, lying or a plate of 1000 : 1000 : 1.
///
/// Criterion: rests for 60 s without jitter.
template <bool plate>
struct Sliver : OnEarth {
    static constexpr const char* name = plate ? "sliver_plate" : "sliver_rod";
    static constexpr int body_count = 2;
    static constexpr scalar seconds = 60;
    static constexpr scalar mu = scalar(0.6);

    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return flat_ground(mu);
        constexpr scalar thin = scalar(0.001);
        return solid_box(1, {1, plate ? scalar(1) : thin, thin}, {0, 0, thin}, mu);
    }
};

}  // namespace scenes

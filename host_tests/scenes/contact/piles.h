// SPDX-License-Identifier: MIT
// Many bodies dropped into a box: spheres, mixed boxes, planks; and a slab on a floor of tiles.
#pragma once

#include "placed_body.h"

namespace scenes {

/// S4: n^3 balls of radius 0.5 m and 1 kg on a jittered grid, dropped into a box with five walls, floor side 1.125 n. pile<4>
/// has 64, <8> 512, <16> 4096. The grid's pitch is 1.125 m, its jitter +-0.05 m; the lowest balls are 1 m above the floor.
///
/// Criterion (10 s, figures over the last 5): 512: mean overlap <= 0.01 mm at rest, <= 0.40 of Bullet's time, nothing escapes;
/// time per body grows by <= 1.4 to 4096. Best published at 60 Hz: mean 1.7, largest 11.6 mm (Box3D 0.1); 7.3 and 20 mm
/// (Jolt 5.5).
template <int n>
struct SpherePile : OnEarth {
    static constexpr const char* name = "sphere_pile";
    static constexpr int wall_count = 5;
    static constexpr int body_count = wall_count + n * n * n;
    static constexpr scalar seconds = 10;
    static constexpr scalar mu = scalar(0.5);
    static constexpr scalar side = scalar(1.125) * n;

    static constexpr PlacedBody body(int body_i) {
        if (body_i < wall_count) return pit_wall(body_i, side, mu);
        const int ball_i = body_i - wall_count;
        const auto place = [&](int cell, int channel) {
            return scalar(1.125) * (static_cast<scalar>(cell) + scalar(0.5)) + scalar(0.05) * scattered(ball_i, channel);
        };
        constexpr scalar radius = scalar(0.5);
        return solid_ball(
            1, radius, {place(ball_i % n, 0) - side / 2, place(ball_i / n % n, 1) - side / 2, place(ball_i / (n * n), 2) + 1},
            mu);
    }
};

/// 125 boxes of mixed sizes (half extents 0.15 to 0.35 m, density 400 kg m^-3) and attitudes, the lowest 4 m above the floor of
/// a pit of 6.5 m.
///
/// Criterion: no step gains more than 1e-4 of the energy there was at its start (potential energy counted from the floor); at
/// rest after 10 s; nothing escapes.
struct PitOfBoxes : OnEarth {
    static constexpr const char* name = "pit_of_boxes";
    static constexpr int wall_count = 5;
    static constexpr int body_count = wall_count + 125;
    static constexpr scalar seconds = 10;
    static constexpr scalar mu = scalar(0.5);
    static constexpr scalar side = scalar(6.5);

    static constexpr PlacedBody body(int body_i) {
        if (body_i < wall_count) return pit_wall(body_i, side, mu);
        const int box_i = body_i - wall_count;
        const auto half = [&](int channel) { return scalar(0.25) + scalar(0.1) * scattered(box_i, channel); };
        const auto place = [](int cell) {
            return scalar(1.25) * static_cast<scalar>(cell - 2);
        };  // circumscribed radius <= 0.607
        const Vector half_extents = {half(0), half(1), half(2)};
        const scalar M = 400 * 8 * half_extents.x * half_extents.y * half_extents.z;
        PlacedBody box = solid_box(
            M, half_extents, {place(box_i % 5), place(box_i / 5 % 5), place(box_i / 25) + scalar(2.5) + scalar(4.625)}, mu);
        box.turn(scattered_rotation(box_i));
        return box;
    }
};

/// Boxes dropped on each other, of 1 kg, but every third of heavy_kg.
///
/// Criterion: no step gains more than 1e-4 of the energy there was; at rest after 10 s, and not inside each other.
template <int count, int heavy_kg>
struct UnevenBoxes : OnEarth {
    static constexpr const char* name = "uneven_boxes";
    static constexpr int body_count = count + 1;
    static constexpr scalar seconds = 10;
    static constexpr scalar mu = scalar(0.5);
    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return flat_ground(mu);
        const int box_i = body_i - 1;
        const auto half = [&](int channel) { return scalar(0.3) + scalar(0.1) * scattered(box_i, channel); };
        PlacedBody box =
            solid_box(box_i % 3 == 2 ? scalar(heavy_kg) : scalar(1), {half(0), half(1), half(2)},
                      {scalar(0.2) * scattered(box_i, 3), scalar(0.2) * scattered(box_i, 4), scalar(0.8) + static_cast<scalar>(box_i)}, mu);
        box.turn(scattered_rotation(box_i));
        return box;
    }
};

/// 12 planks of 2 x 0.4 x 0.1 m and 10 kg, crossed and tilted, dropped on top of each other.
///
/// Criterion: no step gains more than 1e-4 of the energy there was; at rest after 10 s.
struct FallingPlanks : OnEarth {
    static constexpr const char* name = "falling_planks";
    static constexpr int body_count = 13;
    static constexpr scalar seconds = 10;
    static constexpr scalar mu = scalar(0.5);

    static constexpr PlacedBody body(int body_i) {
        if (body_i == 0) return flat_ground(mu);
        const int plank_i = body_i - 1;
        const scalar tilt = scalar(0.1) * scattered(plank_i, 0), turn = scalar(3.1415926536) * scattered(plank_i, 1);
        PlacedBody plank = solid_box(10, {1, scalar(0.2), scalar(0.05)},
                                     {scalar(0.2) * scattered(plank_i, 2), scalar(0.2) * scattered(plank_i, 3),
                                      1 + scalar(0.5) * static_cast<scalar>(plank_i)},
                                     mu);
        plank.turn(ingot::axis_angle({0, 0, 1}, turn) * ingot::axis_angle({1, 0, 0}, tilt));
        return plank;
    }
};

/// A slab of 7.9 x 4.9 x 0.5 m and 1000 kg, 0.1 m above a floor of 1000 immovable tiles of 0.2 x 0.2 x 0.1 m, tops at height 0.
///
/// Criterion (10 s): with room for all pairs and contacts it lands and rests on the tiles. With less room nothing falls through
/// while there is room for what bears it; when there is none the report says so, and the world stays finite.
struct SlabOnTiles : OnEarth {
    static constexpr const char* name = "slab_on_tiles";
    static constexpr int tiles_x = 40, tiles_y = 25;
    static constexpr int body_count = tiles_x * tiles_y + 1;
    static constexpr scalar seconds = 10;
    static constexpr scalar mu = scalar(0.6);

    static constexpr PlacedBody body(int body_i) {
        constexpr scalar tile = scalar(0.2);
        if (body_i < tiles_x * tiles_y) {
            const scalar x = static_cast<scalar>(body_i % tiles_x) + scalar(0.5) - scalar(tiles_x) / 2;
            const scalar y = static_cast<scalar>(body_i / tiles_x) + scalar(0.5) - scalar(tiles_y) / 2;
            return fixed_box({tile / 2, tile / 2, scalar(0.05)}, {x * tile, y * tile, scalar(-0.05)}, mu);
        }
        return solid_box(1000, {scalar(3.95), scalar(2.45), scalar(0.25)}, {0, 0, scalar(0.35)}, mu);
    }
};

}  // namespace scenes

// SPDX-License-Identifier: MIT
// Piles of solids of random sizes and attitudes, run beside other engines only.
#pragma once

#include "scenes/contact/placed_body.h"

namespace scenes {

/// n x n x layers solids of 400 kg m^-3 dropped into a pit, the lowest 1.6 m above its floor, each in a cell of 1.25 m. Boxes with half
/// extents of 0.15 to 0.35 m; or mixed: a ball of 0.15 to 0.35 m, a capsule of radius 0.15 to 0.25 m and half length 0.1 to 0.3 m, such a
/// box, in turns. All fit their cells in any attitude. <8, 8> has 512, <16, 8> 2048.
template <int n, int layers, bool mixed>
struct RandomPile : OnEarth {
    static constexpr const char* name = mixed ? "mixed_pile" : "box_pile";
    static constexpr int wall_count = 5;
    static constexpr int solid_count = n * n * layers;
    static constexpr int body_count = wall_count + solid_count;
    static constexpr scalar seconds = 10;
    static constexpr scalar mu = scalar(0.5);
    static constexpr scalar cell = scalar(1.25);
    static constexpr scalar side = cell * n;

    static constexpr PlacedBody body(int body_i) {
        if (body_i < wall_count) return pit_wall(body_i, side, mu);
        const int solid_i = body_i - wall_count;
        PlacedBody solid = mixed && solid_i % 3 == 0 ? ball(solid_i) : mixed && solid_i % 3 == 1 ? capsule(solid_i) : box(solid_i);
        const auto place = [](int cell_i) { return cell * (static_cast<scalar>(cell_i) + scalar(0.5)); };
        solid.def.state.r_CM = {place(solid_i % n) - side / 2, place(solid_i / n % n) - side / 2, place(solid_i / (n * n)) + 1};
        solid.turn(scattered_rotation(solid_i));
        return solid;
    }

private:
    static constexpr scalar density = 400;  ///< kg m^-3

    static constexpr scalar size(int solid_i, int channel, scalar middle) { return middle + scalar(0.1) * scattered(solid_i, channel); }

    static constexpr PlacedBody of(const ingot::MassDistribution& mass, const ingot::Shape& shape) {
        PlacedBody body;
        body.def.mass = mass_of(mass);
        body.def.shape = shape;
        body.mu = mu;
        return body;
    }
    static constexpr PlacedBody ball(int solid_i) {
        const scalar radius = size(solid_i, 0, scalar(0.25));
        return of(ingot::solid_sphere(density, radius), ingot::Sphere{radius});
    }
    static constexpr PlacedBody capsule(int solid_i) {
        const scalar radius = scalar(0.2) + scalar(0.05) * scattered(solid_i, 0), half_length = size(solid_i, 1, scalar(0.2));
        return of(ingot::solid_capsule(density, radius, half_length), ingot::Capsule{radius, half_length});
    }
    static constexpr PlacedBody box(int solid_i) {
        const Vector half = {size(solid_i, 0, scalar(0.25)), size(solid_i, 1, scalar(0.25)), size(solid_i, 2, scalar(0.25))};
        return of(ingot::solid_box(density, half), ingot::Box{half});
    }
};

}  // namespace scenes

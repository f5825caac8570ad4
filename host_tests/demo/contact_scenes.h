// SPDX-License-Identifier: MIT
// A tower and a pile: worlds for two of the contact scenes.
#pragma once

#include <ingot/ingot.h>

#include "../scenes/contact/piles.h"
#include "../scenes/contact/stacks.h"

namespace demo {

/// Twenty cubes on each other for a minute.
struct TowerOfCubes : ingot::Scene {
    using placed = scenes::Tower<20>;
    static constexpr const char* name = "tower";
    static constexpr const char* title = "twenty cubes stand on each other";
    static constexpr int max_bodies = placed::body_count;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 40;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
    static constexpr ingot::scalar h = placed::h;  ///< s
    static constexpr int demo_steps = 3600;
    static constexpr double camera_height = 9.5, camera_width = 24;  ///< m: the middle of the picture, and what it shows
};

/// 512 balls dropped into a box.
struct PileOfBalls : ingot::Scene {
    using placed = scenes::SpherePile<8>;
    static constexpr const char* name = "pile";
    static constexpr const char* title = "512 balls fall into a box";
    static constexpr int max_bodies = placed::body_count;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 2500;
    static constexpr int max_pairs = 10000;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;
    using broad_phase = ingot::SortedTree;
    static constexpr ingot::scalar h = placed::h;  ///< s
    static constexpr int demo_steps = 600;
    static constexpr double camera_height = 3.5, camera_width = 15;
};

template <class S, class = typename S::placed>
ingot::Status set_up(ingot::World<S>& world) {
    ingot::Status status = world.set_gravity(S::placed::gravity);
    for (int body_i = 0; body_i < S::max_bodies && status == ingot::Status::ok; ++body_i) {
        const scenes::PlacedBody placed = S::placed::body(body_i);
        ingot::BodyDef def = placed.def;
        def.friction = placed.mu;
        status = world.add(def).status;
    }
    return status;
}

}  // namespace demo

// SPDX-License-Identifier: MIT
// Prints the hashes of walkers on their way, side by side, pushed and at their torque: the same on kernels of any number of lanes.
#include <cinttypes>
#include <cstdio>
#include <memory>

#include "scenes/walker_in_space.h"

namespace {

using ingot::scalar;
using ingot::Status;

constexpr int seconds = 4, rate = 60, walkers = 9;

/// More than there are lanes.
struct Street : scenes::WalkingInPlane {
    static constexpr int max_bodies = 7 * walkers + 1, max_joints = 11 * walkers, max_loops = 5 * walkers, max_manifolds = 60, max_pairs = 200;
};

bool walk_in_plane(scalar most) {
    const auto world = std::make_unique<ingot::World<Street>>();
    scenes::Walker all[walkers];
    scenes::WalkState states[walkers];
    scenes::Gait gait;
    gait.max_torque = most;
    bool sound = scenes::add_ground(*world) == Status::ok;
    for (int i = 0; i < walkers; ++i) {
        const auto n = static_cast<scalar>(i);
        sound = sound && scenes::add_walker(*world, {n / 2, n, 0}, scalar(0.8) + n / 100, all[i]) == Status::ok;
    }
    for (int step_i = 1; step_i <= seconds * rate; ++step_i) {
        for (int i = 0; i < walkers; ++i)
            sound = sound && scenes::walk(*world, all[i], gait, states[i], scalar(1) / rate) == Status::ok;
        if (step_i == 2 * rate) sound = sound && world->apply_central_impulse(all[4].trunk, {-40, 0, 0}) == Status::ok;
        (void)ingot::step(*world, scalar(1) / rate);
        if (step_i % 20 == 0) std::printf("plane, step %d: %016" PRIx64 "\n", step_i, world->state_hash());
    }
    return sound;
}

bool walk_in_space(scalar most) {
    const auto world = std::make_unique<ingot::World<scenes::WalkingInSpace>>();
    scenes::SpatialWalker walker;
    scenes::WalkState state;
    scenes::SpatialGait gait;
    gait.max_torque = most;
    bool sound = scenes::add_ground(*world) == Status::ok && scenes::add_walker(*world, scalar(0.6), walker) == Status::ok;
    for (int step_i = 1; step_i <= seconds * rate; ++step_i) {
        sound = sound && scenes::walk(*world, walker, gait, state, scalar(1) / rate) == Status::ok;
        (void)ingot::step(*world, scalar(1) / rate);
        if (step_i % 20 == 0) std::printf("space, step %d: %016" PRIx64 "\n", step_i, world->state_hash());
    }
    return sound;
}

}  // namespace

int main() {
    const bool plain = walk_in_plane(ingot::unlimited) && walk_in_space(ingot::unlimited);
    return plain && walk_in_plane(100) && walk_in_space(120) ? 0 : 1;
}

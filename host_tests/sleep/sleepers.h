// SPDX-License-Identifier: MIT
// Scenes that sleep, their twins that do not, and what the tests of sleep share.
#pragma once

#include <gtest/gtest.h>

#include <cstring>

#include "contact/play.h"

namespace ingot_sleep {

using namespace ingot_contact;
using namespace scenes;

constexpr scalar h = OnEarth::h;
constexpr double sleep_speed = static_cast<double>(ingot::limits::sleep_speed), sleep_time = static_cast<double>(ingot::limits::sleep_time);

template <int size, bool sleepy, class BroadPhase, int manifolds>
struct BedroomOfSize : Room<size, BroadPhase, true, manifolds> {
    static constexpr bool sleeps = sleepy;
    static constexpr bool filters = true;
};
template <int bodies, bool sleepy = true, class BroadPhase = ingot::AllPairs, int manifolds = 8 * room_size(bodies)>
using Bedroom = BedroomOfSize<room_size(bodies), sleepy, BroadPhase, manifolds>;

/// Steps in sleep_time.
inline const int steps_to_sleep = static_cast<int>(std::lround(sleep_time / static_cast<double>(h)));

/// Runs until all bodies sleep. Returns the steps it took; -1 if some are still awake after so many.
template <class S>
int run_until_asleep(Play<S>& play, int steps_max) {
    int movers = 0;
    for (int body_i = 0; body_i < play.body_count(); ++body_i) movers += play.moves(body_i);
    for (int step_i = 1; step_i <= steps_max; ++step_i) {
        (void)play.step(h);
        if (play.world().asleep_count() == movers) return step_i;
    }
    return -1;
}

inline bool same_bits(const BodyState& a, const BodyState& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

template <class S>
bool same_world(const ingot::World<S>& a, const ingot::World<S>& b) {
    return std::memcmp(static_cast<const void*>(&a), static_cast<const void*>(&b), sizeof a) == 0;
}
template <class S>
void copy_world(ingot::World<S>& to, const ingot::World<S>& from) {
    std::memcpy(static_cast<void*>(&to), static_cast<const void*>(&from), sizeof to);
}

inline bool at_rest(const BodyState& state) {
    return state.v_CM.x == 0 && state.v_CM.y == 0 && state.v_CM.z == 0 && state.L.x == 0 && state.L.y == 0 && state.L.z == 0;
}

/// Columns of cubes on flat ground, 3 m apart: body 0 is the ground.
inline std::vector<PlacedBody> columns(int count, int height, scalar mu = scalar(0.6)) {
    std::vector<PlacedBody> bodies = {flat_ground(mu)};
    for (int column_i = 0; column_i < count; ++column_i)
        for (int cube_i = 0; cube_i < height; ++cube_i)
            bodies.push_back(unit_cube({static_cast<scalar>(3 * column_i), 0, static_cast<scalar>(cube_i) + scalar(0.5)}, mu));
    return bodies;
}

}  // namespace ingot_sleep

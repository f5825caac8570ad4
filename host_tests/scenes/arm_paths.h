// SPDX-License-Identifier: MIT
// The arm of six hinges on paths drawn at random, on hosts: how far it is off by torques that are computed, and by stiff servos.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "driven_arm.h"
#include "reference/random_input.h"

namespace scenes {

/// Each joint swings; at 0 all are at rest where the arm is set up.
struct Waves {
    double size[6], frequency[6];  // rad, rad/s

    explicit Waves(ingot_reference::RandomInput& random) {
        constexpr double pi = 3.14159265358979323846;
        for (int i = 0; i < 6; ++i) {
            size[i] = random.real(-0.5, 0.5);
            frequency[i] = 2 * pi * random.real(0.3, 1);
        }
    }
    /// size (1 - cos), and its derivatives.
    void at(double t, PathPoint (&path)[6]) const {
        using ingot::scalar;
        for (int i = 0; i < 6; ++i) {
            const double w = frequency[i], s = std::sin(w * t), c = std::cos(w * t);
            path[i] = {static_cast<scalar>(size[i] * (1 - c)), static_cast<scalar>(size[i] * w * s), static_cast<scalar>(size[i] * w * w * c)};
        }
    }
};

/// rad, of the worst joint in 3 s; infinity where a call was refused. control(world, ids, t, h): before each step.
template <class Control>
double worst_off(const Waves& waves, double rate, const Control& control) {
    const auto world = std::make_unique<ingot::World<DrivenArm>>();
    ArmIds ids;
    bool sound = set_up(*world, ids) == ingot::Status::ok;
    const double h = 1 / rate;
    double worst = 0;
    for (int step_i = 0; step_i < static_cast<int>(3 * rate) && sound; ++step_i) {
        sound = control(*world, ids, step_i * h, h) == ingot::Status::ok;
        (void)ingot::step(*world, static_cast<ingot::scalar>(h));
        PathPoint path[6];
        waves.at((step_i + 1) * h, path);
        for (int i = 0; i < 6; ++i)
            worst = std::max(worst, std::abs(static_cast<double>(world->joint_angle(ids.hinge[i]).value) - static_cast<double>(path[i].angle)));
    }
    return sound ? worst : std::numeric_limits<double>::infinity();
}
inline double off_by_torques(const Waves& waves, double rate) {
    ComputedTorque torques;
    return worst_off(waves, rate, [&](auto& world, const auto& ids, double t, double) {
        PathPoint path[6];
        waves.at(t, path);
        return torques.follow(world, ids, path, 10);
    });
}
inline double off_by_servos(const Waves& waves, double rate) {
    return worst_off(waves, rate, [&](auto& world, const auto& ids, double t, double h) {
        PathPoint path[6], ahead[6];
        waves.at(t, path);
        waves.at(t + h, ahead);
        return follow_by_servos(world, ids, path, ahead, static_cast<ingot::scalar>(h));
    });
}

}  // namespace scenes

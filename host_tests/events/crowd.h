// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/kernel_types.h"
#include "reference/random_input.h"
#include "stage.h"

namespace events_stage {

struct Telling : Plain {
    static constexpr int max_events = 40;
    static constexpr scalar hit_speed = scalar(0.5);
};

struct Crowd : Telling {
    static constexpr int max_bodies = 40;
    static constexpr int max_manifolds = 200;
    static constexpr int max_events = 500;
};

/// A pit of balls, some of which are taken out and put back all the time; `look(world, states before the step)` after each step.
template <class Look>
void run_crowd(const Look& look) {
    static World<Crowd> world;
    memset(static_cast<void*>(&world), 0, sizeof world);
    ingot_reference::RandomInput random(3);
    (void)world.set_gravity({0, 0, -g});
    for (const Vector& n : {Vector{0, 0, 1}, Vector{1, 0, 0}, Vector{-1, 0, 0}, Vector{0, 1, 0}, Vector{0, -1, 0}})
        (void)world.add(fixed(ingot::HalfSpace{n, n.z > 0 ? scalar(0) : scalar(-1.5)}));
    std::vector<BodyId> balls;
    const auto add = [&] {
        BodyDef def = ball(static_cast<scalar>(random.real(0.2, 0.5)),
                           ingot_reference::to_vector(Eigen::Vector3d(random.vector(1) + Eigen::Vector3d(0, 0, 3.5))));
        def.restitution = static_cast<scalar>(random.real(0, 0.8));
        balls.push_back(world.add(def).value);
    };
    for (int i = 0; i < 30; ++i) add();
    for (int step_i = 0; step_i < 300; ++step_i) {
        if (step_i % 5 == 0) {
            const auto leaving = static_cast<std::size_t>(random.integer(0, 29));
            (void)world.remove(balls[leaving]);
            balls.erase(balls.begin() + static_cast<std::ptrdiff_t>(leaving));
            add();
        }
        static World<Crowd> before;
        copy(before, world);
        const StepReport report = ingot::step(world, h);
        EXPECT_EQ(report.contacts_lost, 0);
        EXPECT_EQ(report.events_lost, 0);
        look(world, before);
    }
}

}  // namespace events_stage

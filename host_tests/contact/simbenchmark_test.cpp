// SPDX-License-Identifier: MIT
// C20 and C21: SimBenchmark's scenes at its step of 1 ms, against the best that is on record for them (scenes/contact/simbenchmark.h).
#include <gtest/gtest.h>

#include "contact/play.h"

namespace {

using namespace ingot_contact;
using namespace scenes;

/// Mean over the steps, each taken before its step, of (E - E_0)^2, J^2.
template <class Scene>
double energy_error(Play<Room<Scene::body_count, ingot::SortedTree>>& scene) {
    const double start = scene.energy();
    double sum = 0, last = 0;
    int steps = 0;
    scene.run(Scene::h, static_cast<double>(Scene::seconds), [&](int) {
        sum += last;
        ++steps;
        last = (scene.energy() - start) * (scene.energy() - start);
    });
    return sum / steps;
}

/// C20, bouncing 7 x 7: <= 1.9e-2 J^2 (RaiSim). In float an energy of 490 J a ball is right to 490 epsilon / 2 a step at best.
TEST(SimBenchmark, elastic_balls_keep_their_energy) {
    auto scene = play<SimBouncing, ingot::SortedTree>();
    ASSERT_TRUE(scene.sound());
    const double error = energy_error<SimBouncing>(scene);
    figure("energy error, J^2", error);
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(error, 1.9e-2);
}

/// C20, elastic 666: <= 8.4 J^2 (RaiSim).
TEST(SimBenchmark, elastic_666_keeps_its_energy) {
    auto scene = play<Sim666<true>, ingot::SortedTree>();
    ASSERT_TRUE(scene.sound());
    const double error = energy_error<Sim666<true>>(scene);
    figure("energy error, J^2", error);
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(error, 8.4);
}

/// C20, 666: sum over pairs of squared penetration, in the mean over every tenth step: <= 1.35e-4 m^2 (RaiSim).
TEST(SimBenchmark, pile_666_does_not_overlap) {
    auto scene = play<Sim666<false>, ingot::SortedTree>();
    ASSERT_TRUE(scene.sound());
    double sum = 0;
    int samples = 0;
    scene.run(SimBenchmark::h, static_cast<double>(Sim666<false>::seconds), [&](int step_i) {
        if (step_i % 10 != 0) return;
        for (const double deep : scene.overlaps()) sum += deep * deep;
        ++samples;
    });
    figure("squared overlap, m^2", sum / samples);
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(sum / samples, 1.35e-4);
}

}  // namespace

// SPDX-License-Identifier: MIT
// Which islands are solved directly: those in which a body carries more than limits::direct_mass_ratio of its own mass, or is so much heavier than
// what it touches, whatever the masses are, and beside whatever.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/play.h"
#include "reference/draws.h"
#include "reference/random_input.h"

namespace {

using namespace ingot_contact;
using namespace scenes;
using ingot_reference::RandomInput;

using Loads = Play<Room<24, ingot::AllPairs, true, 100, 200, ingot::HybridIslands<>>>;

constexpr double rates[] = {60, 120, 240, 1000};

PlacedBody cube(double kg, double half, double x, double z) {
    const scalar side = static_cast<scalar>(half);
    return solid_box(static_cast<scalar>(kg), {side, side, side}, {static_cast<scalar>(x), 0, static_cast<scalar>(z)}, scalar(0.6));
}

/// Cubes on each other. How much one of them bears of its own mass, which is all that is above it; or two that touch have of each other's.
struct Tower {
    std::vector<double> M;  ///< kg, from below
    double ratio() const {
        double most = 0, above = 0;
        for (std::size_t i = M.size(); i-- > 0; above += M[i]) {
            most = std::max(most, above / M[i]);
            if (i > 0) most = std::max({most, M[i] / M[i - 1], M[i - 1] / M[i]});
        }
        return most;
    }
};

/// With a ratio about the limit, at one cube or another, which others do not have.
Tower drawn_tower(RandomInput& random) {
    for (;;) {
        Tower tower;
        const double scale = std::exp(random.real(std::log(0.01), std::log(1000.0)));
        for (int i = random.integer(2, 5); i > 0; --i) tower.M.push_back(scale * std::exp(random.real(0, std::log(30.0))));
        const std::size_t light = static_cast<std::size_t>(random.integer(0, static_cast<int>(tower.M.size()) - 2));
        double above = 0;
        for (std::size_t i = light + 1; i < tower.M.size(); ++i) above += tower.M[i];
        const double spread = random.integer(0, 1) == 0 ? 0.7 : 0.05;
        tower.M[light] = above / (static_cast<double>(ingot::limits::direct_mass_ratio) * std::exp(random.real(-spread, spread)));
        const double off = tower.ratio() / static_cast<double>(ingot::limits::direct_mass_ratio);
        if (std::abs(off - 1) > 0.001 && off < 3 && above < 1e5) return tower;
    }
}

TEST(ChosenIslands, carry_more_than_sweeps_do) {
    RandomInput random(1);
    int direct = 0, swept = 0, steps = 0, unsettled = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(240); ++run_i) {
        const double rate = rates[random.integer(0, 3)], half = random.real(0.2, 0.5);
        std::vector<PlacedBody> bodies = {flat_ground(scalar(0.6))};
        double most = 0;
        const int towers = random.integer(1, 3);
        for (int tower_i = 0; tower_i < towers; ++tower_i) {
            const Tower tower = drawn_tower(random);
            most = std::max(most, tower.ratio());
            for (std::size_t i = 0; i < tower.M.size(); ++i)
                bodies.push_back(cube(tower.M[i], half, 4.0 * tower_i, (2 * static_cast<double>(i) + 1) * half));
        }
        Loads scene(bodies, OnEarth::gravity);
        ASSERT_TRUE(scene.sound());
        const bool due = most > static_cast<double>(ingot::limits::direct_mass_ratio);
        for (int step_i = 0; step_i < 20; ++step_i) {
            const StepReport report = scene.step(static_cast<scalar>(1 / rate));
            if (step_i < 4) continue;  // what pushes on what is known from the step before
            const bool is = (report.direct & ingot::DirectBits::solved) != 0;
            ++steps;
            unsettled += is && !due ? 1 : 0;
            ASSERT_TRUE(is || !due) << run_i << ", step " << step_i << ": " << most << " to one";
        }
        ++(due ? direct : swept);
    }
    EXPECT_LE(unsettled, steps / 1000) << "what sweeps do not settle is solved directly too, and that is seldom";
    EXPECT_GT(direct, ingot_reference::draws(240) / 4);
    EXPECT_GT(swept, ingot_reference::draws(240) / 12);
}

}  // namespace

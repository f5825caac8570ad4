// SPDX-License-Identifier: MIT
// Energy: figures that fall, lie and lean on themselves get none from their joints, contacts, limits and loops.
#include <gtest/gtest.h>

#include <ingot/solver/sweeps/figure_shares.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "joints/figure_measures.h"
#include "joints/figure_scenes.h"
#include "random_trees.h"
#include "reference/draws.h"
#include "scene_in_world.h"

namespace {

using namespace figures;
using namespace ingot_figures;

struct Fallen : ingot::Scene {
    static constexpr int max_bodies = 24, max_joints = 24, max_manifolds = 80;
    static constexpr bool translates = true, sleeps = true;
    using joints = AllJoints;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
struct Looped : Fallen {
    static constexpr int max_loops = 4;
};
struct Limited : Fallen {
    using joints = AllJointsWith<ingot::WithLimits>;
};

struct LimitedLoops : Looped {
    using joints = AllJointsWith<ingot::WithLimits>;
};

FigureScene turning_tree_with_limits(RandomInput& random) { return limited_tree(random, 8, random.integer(0, 1) == 1, 6); }
FigureScene turning_ring_with_limits(RandomInput& random) { return limited_ring(random, 8, random.integer(0, 1) == 1, 6); }

/// What a limit takes in one step it may give back in the next, so the larger of the last two counts. Overlaps that are pushed out, and second orders
/// of turns, are allowed a hundredth of what the figure has when it falls a metre, beside its motion.
template <class Scene, class Draw>
void expect_no_energy(uint64_t seed, double shrink, const Draw& draw) {
    RandomInput random(seed);
    for (int case_i = 0; case_i < ingot_reference::draws(60); ++case_i) {
        FigureScene scene = draw(random);
        double z = 0, M = 0;
        for (FigureBody& body : scene.bodies) {
            body.half_extent *= shrink;
            z = std::max(z, random.real(0.01, 0.5) + body.half_extent.norm() - body.r_CM.z());
            M += body.M;
        }
        for (FigureBody& body : scene.bodies) body.r_CM.z() += z;
        for (FigureJoint& joint : scene.joints) joint.anchor.z() += z;
        const double rate = rates[random.integer(0, 4)];
        const auto world = std::make_unique<ingot::World<Scene>>();
        const Built built = add_scene(*world, scene);
        ASSERT_TRUE(built.sound && add_ground(*world));
        const JointRows rows(scene);
        double last = energy(rows, state_of(*world, built)), before = last;
        for (int step_i = 0; step_i < std::min(300, static_cast<int>(2 * rate)); ++step_i) {
            (void)ingot::step(*world, static_cast<scalar>(1 / rate));
            const double now = energy(rows, state_of(*world, built));
            ASSERT_LE(now, std::max(last, before) + 0.01 * (M * g + std::abs(last))) << "case " << case_i << ", " << rate << " Hz, step " << step_i;
            before = last;
            last = now;
        }
    }
}

TEST(JointEnergy, no_step_gives_any_to_trees_that_fall) { expect_no_energy<Fallen>(1, 0.2, plain_tree); }
TEST(JointEnergy, no_step_gives_any_to_rings_that_fall) { expect_no_energy<Looped>(2, 0.2, ring_and_tree); }
TEST(JointEnergy, no_step_gives_any_to_trees_with_limits) { expect_no_energy<Limited>(3, 0.2, turning_tree_with_limits); }
TEST(JointEnergy, no_step_gives_any_to_rings_with_limits) { expect_no_energy<LimitedLoops>(4, 0.2, turning_ring_with_limits); }

/// What an island has with all of its impulses, a half and a fourth of them says where on the parabola of these it has least. Where it gains with
/// all of them, the share is there, or it is none.
TEST(SharesOfFigures, are_where_an_island_has_least_energy) {
    RandomInput random(217);
    int taken = 0;
    for (int i = 0; i < 1000; ++i) {
        const double without = random.real(0, 10), q = random.real(0.1, 10), d = random.real(-12, 2);
        const auto energy = [&](double share) { return static_cast<scalar>(without + share * d + share * share * q); };
        const ingot::ThreeEnergies energies = {energy(1), energy(0.5), energy(0.25)};
        const double gain = d + q, slack = 100 * static_cast<double>(ingot::epsilon) * (without + std::abs(d) + q);
        const double allowed = static_cast<double>(ingot::limits::figure_gain_allowed) * without;
        if (gain < allowed - slack) {
            EXPECT_EQ(static_cast<double>(energies.share()), 1) << i;
        } else if (gain > allowed + slack) {
            ++taken;
            EXPECT_NEAR(static_cast<double>(energies.share()), std::min(std::max(-d / (2 * q), 0.0), 1.0), 4 * slack / q) << i;
        }
    }
    EXPECT_GT(taken, 300);
}

}  // namespace

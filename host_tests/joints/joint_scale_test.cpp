// SPDX-License-Identifier: MIT
// Scale: figures whose lengths, speeds, gravity and length_unit are 2^k times as large, and their masses 2^m, go the same way to the bit, as bodies
// without joints do (host_tests/contact/scale_test.cpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "joints/figure_scenes.h"
#include "random_trees.h"
#include "reference/draws.h"
#include "reference/powers_of_two.h"
#include "scene_in_world.h"

namespace {

using namespace figures;
using namespace ingot_figures;
using ingot::Status;
using ingot_reference::equal;
using ingot_reference::power_of_two;

template <int k>
struct Limited : ingot::Scene {
    static constexpr int max_bodies = 24, max_joints = 24, max_manifolds = 80;
    static constexpr bool translates = true, sleeps = true;
    static constexpr scalar length_unit = power_of_two(k);
    using joints = AllJointsWith<ingot::WithLimits>;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
template <int k>
struct Free : ingot::Scene {
    static constexpr int max_bodies = 24, max_joints = 24;
    static constexpr bool translates = true;
    static constexpr scalar length_unit = power_of_two(k);
    using joints = AllJointsWith<ingot::WithLimits>;
};
template <int k>
struct Looped : ingot::Scene {
    static constexpr int max_bodies = 24, max_joints = 24, max_manifolds = 80, max_loops = 4;
    static constexpr bool translates = true, sleeps = true;
    static constexpr scalar length_unit = power_of_two(k);
    using joints = AllJoints;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
};
template <int k>
struct LimitedLoops : Looped<k> {
    using joints = AllJointsWith<ingot::WithLimits>;
};
template <int k>
struct FreeLoops : Free<k> {
    static constexpr int max_loops = 4;
};

FigureScene scaled(FigureScene scene, double length, double mass) {
    scene.g *= length;
    for (FigureBody& body : scene.bodies) {
        body.M *= mass;
        body.I_body *= mass * length * length;
        body.r_CM *= length;
        body.v_CM *= length;
        body.half_extent *= length;
    }
    for (FigureJoint& joint : scene.joints) {
        joint.anchor *= length;
        if (joint.kind != FigureJointKind::slider) continue;
        joint.lower *= length;
        joint.upper *= length;
    }
    return scene;
}

FigureScene turning_tree_with_limits(RandomInput& random) { return limited_tree(random, 8, random.integer(0, 1) == 1, 6); }
FigureScene turning_ring_with_limits(RandomInput& random) { return limited_ring(random, 8, random.integer(0, 1) == 1, 6); }
/// With its lowest body this far above the ground, or further.
FigureScene lifted(FigureScene scene, double height) {
    double z = 0;
    for (const FigureBody& body : scene.bodies) z = std::max(z, height + body.half_extent.norm() - body.r_CM.z());
    for (FigureBody& body : scene.bodies) body.r_CM.z() += z;
    for (FigureJoint& joint : scene.joints) joint.anchor.z() += z;
    return scene;
}

template <template <int> class SceneAt, int k, class Draw>
void expect_same_way(uint64_t seed, const Draw& draw) {
    RandomInput random(seed);
    constexpr scalar length = power_of_two(k);
    for (int case_i = 0; case_i < ingot_reference::draws(40); ++case_i) {
        const FigureScene scene = lifted(draw(random), random.real(0.01, 0.5));
        // The square root of a compliance, in the Cholesky factor of loops, is exact for every other power.
        const int m = 2 * random.integer(0, 5);
        const scalar mass = power_of_two(m), h = static_cast<scalar>(1 / rates[random.integer(0, 4)]);
        const auto plain = std::make_unique<ingot::World<SceneAt<0>>>();
        const auto other = std::make_unique<ingot::World<SceneAt<k>>>();
        const Built A = add_scene(*plain, scene), B = add_scene(*other, scaled(scene, static_cast<double>(length), static_cast<double>(mass)));
        ASSERT_TRUE(A.sound && B.sound);
        if constexpr (ingot::has_shapes<SceneAt<0>>) {
            ASSERT_TRUE(add_ground(*plain) && add_ground(*other));
        }
        for (int step_i = 0; step_i < 120; ++step_i) {
            const ingot::StepReport a = ingot::step(*plain, h), b = ingot::step(*other, h);
            SCOPED_TRACE(::testing::Message() << "seed " << seed << ", case " << case_i << ", step " << step_i);
            ASSERT_EQ(a.contacts, b.contacts);
            ASSERT_EQ(a.sweeps, b.sweeps);
            for (std::size_t i = 0; i < A.bodies.size(); ++i) {
                const ingot::BodyState of_plain = plain->state(A.bodies[i]).value, of_other = other->state(B.bodies[i]).value;
                ASSERT_TRUE(equal(of_plain.r_CM * length, of_other.r_CM)) << i;
                ASSERT_TRUE(equal(of_plain.v_CM * length, of_other.v_CM)) << i;
                ASSERT_TRUE(equal(of_plain.L * (mass * length * length), of_other.L)) << i;
                ASSERT_TRUE(equal(of_plain.A.c0, of_other.A.c0) && equal(of_plain.A.c1, of_other.A.c1)) << i;
            }
        }
    }
}

TEST(ScaleOfJoints, is_no_matter_to_limits) {
    expect_same_way<Free, -9>(1, turning_tree_with_limits);
    expect_same_way<Free, 8>(2, turning_tree_with_limits);
}
TEST(ScaleOfJoints, is_no_matter_in_contact) { expect_same_way<Limited, -7>(3, turning_tree_with_limits); }
TEST(ScaleOfJoints, is_no_matter_to_loops) { expect_same_way<Looped, 9>(4, ring_and_tree); }
TEST(ScaleOfJoints, is_no_matter_to_loops_with_limits) {
    expect_same_way<FreeLoops, 9>(5, turning_ring_with_limits);
    expect_same_way<LimitedLoops, -8>(6, turning_ring_with_limits);
}

}  // namespace

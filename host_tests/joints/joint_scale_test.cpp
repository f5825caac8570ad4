// SPDX-License-Identifier: MIT
// Scale: figures whose lengths, speeds, gravity and length_unit are 2^k times as large, and their masses 2^m, go the same way to the bit, as bodies
// without joints do (host_tests/contact/scale_test.cpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "joints/figure_scenes.h"
#include "random_trees.h"
#include "reference/draws.h"
#include "scene_in_world.h"

namespace {

using namespace figures;
using namespace ingot_figures;
using ingot::Status;

constexpr scalar power_of_two(int k) { return k == 0 ? scalar(1) : k > 0 ? 2 * power_of_two(k - 1) : power_of_two(k + 1) / 2; }

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

/// A tree with limits and twists that turns as it falls on the ground or swings above it.
FigureScene limited_tree(RandomInput& random) {
    FigureScene scene = turning_tree(random, 8, random.integer(0, 1) == 1, 6, 4, [&](FigureJoint& joint) {
        joint.lower = -random.real(0.02, 0.5);
        joint.upper = random.real(0.02, 0.5);
        joint.cone = random.real(0.1, 0.6);
        joint.twist_lower = -random.real(0.02, 0.5);
        joint.twist_upper = random.real(0.02, 0.5);
        joint.restitution = random.integer(0, 2) * 0.4;
    });
    return scene;
}
/// The same without limits, and the last body of it joined to its first by a ball.
FigureScene ring_and_tree(RandomInput& random) {
    FigureScene scene = turning_tree(random, 8, random.integer(0, 1) == 1, 2, 2, [](FigureJoint&) {});
    FigureJoint last;
    last.kind = FigureJointKind::ball;
    last.body_A = 0;
    last.body_B = scene.body_count() - 1;
    last.anchor = scene.body(last.body_B).r_CM + random.direction() * 0.3;
    if (scene.body_count() > 2) scene.join(last);
    return scene;
}
/// With its lowest body this far above the ground, or further.
FigureScene lifted(FigureScene scene, double height) {
    double z = 0;
    for (const FigureBody& body : scene.bodies) z = std::max(z, height + body.half_extent.norm() - body.r_CM.z());
    for (FigureBody& body : scene.bodies) body.r_CM.z() += z;
    for (FigureJoint& joint : scene.joints) joint.anchor.z() += z;
    return scene;
}

/// Equal, or where products of what is left of a number lie below the smallest that float has with all its digits: there no power of two is exact.
bool equal(scalar a, scalar b) {
    const double lost = std::sqrt(static_cast<double>(std::numeric_limits<scalar>::min()));
    return a == b || (std::abs(static_cast<double>(a)) < lost && std::abs(static_cast<double>(b)) < lost);
}
bool equal(const Vector& a, const Vector& b) { return equal(a.x, b.x) && equal(a.y, b.y) && equal(a.z, b.z); }

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
    expect_same_way<Free, -9>(1, limited_tree);
    expect_same_way<Free, 8>(2, limited_tree);
}
TEST(ScaleOfJoints, is_no_matter_in_contact) { expect_same_way<Limited, -7>(3, limited_tree); }
TEST(ScaleOfJoints, is_no_matter_to_loops) { expect_same_way<Looped, 9>(4, ring_and_tree); }

}  // namespace

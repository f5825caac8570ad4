// SPDX-License-Identifier: MIT
// A scene of balls and half spaces has smaller batches and a smaller manifold, see BallView: no choice of code may show in a bit.
#include <gtest/gtest.h>

#include <cmath>

#include "contact/play.h"
#include "reference/brief_types.h"
#include "reference/random_input.h"

namespace {

using namespace ingot_contact;
using namespace scenes;
using ingot_reference::RandomInput;

constexpr int balls = 40, floors = 3;

template <bool asleep, class BroadPhase, bool renews>
struct Balls : ingot::Scene {
    static constexpr int max_bodies = balls + floors, max_manifolds = 8 * max_bodies, max_pairs = 2 * max_manifolds;
    static constexpr bool translates = true, sleeps = asleep, recycles_manifolds = renews;
    using broad_phase = BroadPhase;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;
};
/// The same, but that it could have boxes.
template <class OfBalls>
struct WithBoxes : OfBalls {
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};
static_assert(ingot::sweeps_balls_alone<Balls<false, ingot::AllPairs, true>>);
static_assert(!ingot::sweeps_balls_alone<WithBoxes<Balls<false, ingot::AllPairs, true>>>);

/// A trough of three half spaces, and balls of a tenth of `size` to it that fall, roll and rest there; some far away as a heap of their own.
std::vector<PlacedBody> heap(RandomInput& random, double size) {
    std::vector<PlacedBody> bodies;
    const double mu = random.real(0, 1) < 0.2 ? 0 : random.real(0, 1), most_e = random.real(0, 1) < 0.3 ? 0 : random.real(0, 1);
    const double slope = random.real(0, 0.7);
    for (const double tilt : {0.0, slope, -slope}) {
        const ingot::Vector normal = {static_cast<scalar>(std::sin(tilt)), 0, static_cast<scalar>(std::cos(tilt))};
        bodies.push_back(half_space(normal, 0, static_cast<scalar>(mu)));
    }
    for (int i = 0; i < balls; ++i) {
        const double R = size * std::pow(10, random.real(-1, 0)), M = std::pow(10, random.real(-1, 1));
        Vector3d r = random.vector(2 * size);
        r.z() = size * random.real(0, 8);
        if (i % 8 == 0) r.y() += 100 * size;
        PlacedBody ball = solid_ball(static_cast<scalar>(M), static_cast<scalar>(R), ingot_reference::to_vector(r), static_cast<scalar>(mu),
                                     static_cast<scalar>(random.real(0, 1) * most_e));
        ball.move(ingot_reference::to_vector(random.vector(size)), ingot_reference::to_vector(random.vector(3)));
        bodies.push_back(ball);
    }
    return bodies;
}

template <class S>
class HeapsOfBalls : public ::testing::Test {};
using Scenes = ingot_reference::BriefTypes<2, Balls<true, ingot::SortedTree, true>, Balls<false, ingot::SortedTree, false>,
                                           Balls<false, ingot::AllPairs, true>>;
TYPED_TEST_SUITE(HeapsOfBalls, Scenes);

TYPED_TEST(HeapsOfBalls, go_as_in_a_scene_that_could_have_boxes) {
    RandomInput random(20254);
    for (int case_i = 0; case_i < 12; ++case_i) {
        const double size = std::pow(10, random.real(-2, 2)), rates[] = {30, 60, 240, 1000};
        const std::vector<PlacedBody> bodies = heap(random, size);
        const ingot::Vector gravity = {0, 0, static_cast<scalar>(-9.81 * size)};
        const auto h = static_cast<scalar>(1 / rates[random.integer(0, 3)]);
        Play<TypeParam> alone(bodies, gravity);
        Play<WithBoxes<TypeParam>> with_boxes(bodies, gravity);
        for (int step_i = 0; step_i < 240; ++step_i) {
            const StepReport a = ingot::step(alone.world(), h), b = ingot::step(with_boxes.world(), h);
            ASSERT_EQ(alone.world().state_hash(), with_boxes.world().state_hash()) << "case " << case_i << ", step " << step_i;
            ASSERT_EQ(a.contacts, b.contacts);
            ASSERT_EQ(a.sweeps, b.sweeps);
            ASSERT_EQ(a.residual, b.residual);
        }
    }
}

}  // namespace

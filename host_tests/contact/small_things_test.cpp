// SPDX-License-Identifier: MIT
// Small and thin things among others, in a scene that says nothing of their size: coins, dice, dominoes, a crumb in a hall. What holds for a metre
// holds for a tenth of a millimetre.
#include <gtest/gtest.h>

#include <cmath>

#include "contact/play.h"
#include "reference/random_input.h"

namespace {

using namespace ingot_contact;
using namespace scenes;
using ingot_reference::RandomInput;

template <class Solver, bool asleep = true>
struct Small : ingot::Scene {
    static constexpr int max_bodies = 48, max_manifolds = 300;
    static constexpr bool translates = true, sleeps = asleep;
    using solver = Solver;
    using broad_phase = ingot::SortedTree;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
};
template <class S>
class SmallThings : public ::testing::Test {};
using Scenes = ::testing::Types<Small<ingot::BlockSweeps>, Small<ingot::HybridIslands<24>>, Small<ingot::SequentialImpulses>>;
TYPED_TEST_SUITE(SmallThings, Scenes);

constexpr ingot::Vector down = {0, 0, -standard_gravity};

PlacedBody coin(double radius, double thickness, const ingot::Vector& r, scalar mu) {
    PlacedBody body;
    const auto half = static_cast<scalar>(thickness / 2), R = static_cast<scalar>(radius);
    body.def.shape = ingot::Cylinder{R, half};
    body.def.mass = ingot::principal(ingot::with_mass(ingot::solid_cylinder(8000, R, half), scalar(0.005))).value;
    body.def.state.r_CM = r;
    body.mu = mu;
    return body;
}

/// How far apart bodies that rest on each other may be: as far as points are stopped as if they touched, and by roundings of the place.
double gap_of(double least_half_extent, double place) {
    const double unit_gap = static_cast<double>(ingot::limits::touching_gap), thin = static_cast<double>(ingot::limits::thin_extent);
    return unit_gap * std::min(1.0, least_half_extent / thin) + 32 * static_cast<double>(ingot::epsilon) * place;
}

/// Coins of ten to half a hundred times their thickness, put down one on the other: they stay, sleep, and lie as high as they are thick.
TYPED_TEST(SmallThings, stack_coins) {
    RandomInput random(20260);
    const double rates[] = {30, 60, 120, 240, 1000};
    for (int case_i = 0; case_i < 20; ++case_i) {
        const double thickness = std::pow(10, random.real(-4, -1.5)), radius = thickness * random.real(5, 25), rate = rates[case_i % 5];
        std::vector<PlacedBody> bodies = {flat_ground(scalar(0.5))};
        const int count = random.integer(2, 6);
        for (int i = 0; i < count; ++i)
            bodies.push_back(coin(radius, thickness, {static_cast<scalar>(radius * random.real(-0.1, 0.1)), 0,
                                                      static_cast<scalar>(thickness * (i + 0.5))}, scalar(0.5)));
        Play<TypeParam> play(bodies, down);
        ASSERT_TRUE(play.sound());
        play.run(static_cast<scalar>(1 / rate), 3);
        SCOPED_TRACE(::testing::Message() << count << " of " << thickness << " m at " << rate << " Hz");
        for (int i = 1; i <= count; ++i) {
            EXPECT_TRUE(play.world().is_asleep(play.id(i))) << i;
            EXPECT_NEAR(play.r(i).z(), thickness * (i - 0.5), i * gap_of(thickness / 2, count * thickness)) << i;
            EXPECT_LE(play.drift(i), gap_of(thickness / 2, radius)) << i;
        }
        EXPECT_TRUE(play.reports().clean());
    }
}

/// Cubes of a tenth of a millimetre to a centimetre, dropped by half an edge: they come to rest on each other, although they fall by up to eight
/// edges in a step (one with the sequential solver). Nobody sleeps: what they are pressed into each other by takes a second to be taken back.
TYPED_TEST(SmallThings, drop_dice_on_each_other) {
    RandomInput random(20261);
    const double rates[] = {30, 60, 120, 240, 1000};
    for (int case_i = 0; case_i < 20; ++case_i) {
        const double rate = rates[case_i % 5], fall = static_cast<double>(standard_gravity) / (rate * rate);
        const double edge = std::max(std::pow(10, random.real(-4, -2)), fall / (TypeParam::solver::is_pointwise ? 1 : 8));
        const auto half = static_cast<scalar>(edge / 2);
        std::vector<PlacedBody> bodies = {flat_ground(scalar(0.5))};
        for (int i = 0; i < 3; ++i)
            bodies.push_back(
                solid_box(static_cast<scalar>(1000 * edge), {half, half, half}, {0, 0, static_cast<scalar>(edge * (1.5 * i + 1))}, scalar(0.5)));
        Play<Small<typename TypeParam::solver, false>> play(bodies, down);
        play.run(static_cast<scalar>(1 / rate), 3);
        SCOPED_TRACE(::testing::Message() << edge << " m at " << rate << " Hz");
        for (int i = 1; i <= 3; ++i) EXPECT_NEAR(play.r(i).z(), edge * (i - 0.5), i * gap_of(edge / 2, 4 * edge)) << i;
    }
}

/// Dominoes of 48 x 24 x 8 mm: the first is pushed over, all others follow, lie down and sleep.
TYPED_TEST(SmallThings, topple_dominoes) {
    for (const double rate : {60.0, 240.0}) {
        const ingot::Vector half = {scalar(0.004), scalar(0.012), scalar(0.024)};
        std::vector<PlacedBody> bodies = {flat_ground(scalar(0.4))};
        for (int i = 0; i < 40; ++i) bodies.push_back(solid_box(scalar(0.01), half, {scalar(0.02) * scalar(i), 0, half.z}, scalar(0.3)));
        bodies[1].move({scalar(0.1), 0, 0}, {0, scalar(0.1) / scalar(0.024), 0});
        Play<TypeParam> play(bodies, down);
        play.run(static_cast<scalar>(1 / rate), 8);
        double highest = 0;
        int asleep = 0;
        for (int i = 1; i <= 40; ++i) {
            highest = std::max(highest, play.r(i).z());
            asleep += play.world().is_asleep(play.id(i));
        }
        EXPECT_LT(highest, 0.0235) << rate;  // none stands
        EXPECT_EQ(asleep, 40) << rate;
    }
}

/// A crumb of a millimetre falls on the floor of a hall of 100 m, and lies there.
TYPED_TEST(SmallThings, lie_in_a_large_hall) {
    for (const double rate : {30.0, 60.0, 240.0}) {
        const scalar half = scalar(0.0005);
        std::vector<PlacedBody> bodies = {fixed_box({50, 50, 1}, {0, 0, -1}, scalar(0.5))};
        bodies.push_back(solid_box(scalar(1e-6), {half, half, half}, {scalar(1), scalar(0.5), scalar(0.002)}, scalar(0.5)));
        Play<TypeParam> play(bodies, down);
        play.run(static_cast<scalar>(1 / rate), 2);
        EXPECT_NEAR(play.r(1).z(), 0.0005, gap_of(0.0005, 1)) << rate;
        EXPECT_TRUE(play.world().is_asleep(play.id(1))) << rate;
    }
}

}  // namespace

// SPDX-License-Identifier: MIT
// Contacts give no energy: bodies of every shape, thrown about in a closed room, and heaps in a tray.
#include "laws/thrown_bodies.h"

#include <cstdio>

#include "reference/brief_types.h"

namespace {

using namespace thrown_bodies;

template <class S>
class Energy : public ::testing::Test {};
using Engines = ingot_reference::BriefTypes<2, Room<ingot::BlockSweeps, true>, Room<ingot::HybridIslands<8, 24>, false>,
                                            Room<ingot::BlockSweeps, false>>;
TYPED_TEST_SUITE(Energy, Engines);

/// One body, no gravity: any shape, e in 0 .. 1 and its ends, with friction and without.
TYPED_TEST(Energy, of_a_body_in_a_room_does_not_grow) {
    RandomInput random(71);
    double worst = 0;
    for (int case_i = 0; case_i < 96; ++case_i) {
        const double e = case_i % 3 == 0 ? 1 : case_i % 3 == 1 ? random.real(0, 1) : 0.95, mu = case_i % 2 == 0 ? 0 : random.real(0, 1);
        const double rates[] = {30, 60, 120, 240, 1000}, h = 1 / rates[case_i % 5];
        Thrown<TypeParam> thrown(0, {e, mu});
        close_room(thrown, 2);
        const Vector3d r = any_vector(1, random), v = any_vector(6, random), omega = any_vector(8, random);
        thrown.body(any_shape(case_i / 5, 0.4, random), r, v, omega, random);
        const double gain = largest_gain(thrown, h, 5);
        EXPECT_LE(gain, gain_of_step<TypeParam>) << "case " << case_i << " e " << e << " mu " << mu << " h " << h;
        worst = std::max(worst, gain);
    }
    printf("    largest gain of a step, of the energy %.3g, allowed %.3g\n", worst, gain_of_step<TypeParam>);
}

/// Forty of them among each other.
TYPED_TEST(Energy, of_many_in_a_room_does_not_grow) {
    if (TypeParam::continuous) GTEST_SKIP() << "not a law yet: fast bodies among each other gain 1e-5 of the energy in single steps";
    RandomInput random(72);
    double worst = 0;
    for (int case_i = 0; case_i < 8; ++case_i) {
        const double e = case_i % 4 == 0 ? 1 : random.real(0, 1), mu = case_i % 2 == 0 ? 0 : random.real(0, 1);
        Thrown<TypeParam> thrown(0, {e, mu});
        close_room(thrown, 2);
        throw_forty(thrown, random);
        const double gain = largest_gain(thrown, 1.0 / 60, 5);
        EXPECT_LE(gain, gain_of_step<TypeParam>) << "case " << case_i << " e " << e << " mu " << mu;
        worst = std::max(worst, gain);
    }
    printf("    largest gain of a step, of the energy %.3g, allowed %.3g\n", worst, gain_of_step<TypeParam>);
}

using Tray = Room<ingot::BlockSweeps, false>;

/// Seconds until forty dice in a tray sleep, of the mean of the seeds, and how many impacts were resolved one after another.
struct Settling {
    double seconds, impact_waves;
};
Settling settle(double e) {
    constexpr int seeds = 8;
    Settling mean = {0, 0};
    for (int seed = 0; seed < seeds; ++seed) {
        RandomInput random(static_cast<uint32_t>(100 + seed));
        Thrown<Tray> dice(9.81, {e, 0.5});
        drop_dice(dice, 40, random);
        int step_i = 0;
        while (step_i++ < 15 * 60 && dice.world->awake_count() > 0) mean.impact_waves += ingot::step(*dice.world, scalar(1) / 60).impact_waves;
        mean.seconds += step_i / 60.0 / seeds;
    }
    mean.impact_waves /= seeds;
    return mean;
}

/// Restitution in a heap: what bears load does not bounce, so a heap comes to rest as soon as one that does not bounce at all, give or take half.
TEST(Heap, that_bounces_settles_as_one_that_does_not) {
    const Settling still = settle(0);
    printf("    e 0: %.2f s\n", still.seconds);
    for (const double e : {0.1, 0.2, 0.5}) {
        const Settling bouncing = settle(e);
        printf("    e %.1f: %.2f s, %.0f impacts\n", e, bouncing.seconds, bouncing.impact_waves);
        EXPECT_LE(bouncing.seconds, 1.5 * still.seconds) << e;
        EXPECT_GT(bouncing.impact_waves, 40) << e;  // each die bounces
        EXPECT_LE(bouncing.impact_waves, 40 * 40) << e;  // a die meets a dozen others, thrice before it rests
    }
}

}  // namespace

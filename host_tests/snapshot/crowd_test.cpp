// SPDX-License-Identifier: MIT
// Snapshots of worlds whose pairs have no room: what is lost is told by the state alone, not by when pairs were searched for.
#include "snapshot/life.h"

#include <gtest/gtest.h>

namespace {

using namespace life;
using Bytes = std::vector<uint8_t>;

/// Too few pairs for what may touch at times, and for what comes near more often.
template <int pairs, class BroadPhase>
struct CrowdedPile : ingot::Scene {
    static constexpr int max_bodies = 9;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 12, max_pairs = pairs;
    using shapes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
    using broad_phase = BroadPhase;
};

/// Eight that fly at each other over the ground, and bounce.
template <class S>
void fill_crowd(World<S>& world) {
    clear(world);
    ASSERT_EQ(world.set_gravity({0, 0, -10}), Status::ok);
    ASSERT_TRUE(world.add(ground()).ok());
    for (int body_i = 0; body_i < 8; ++body_i) {
        const scalar x = static_cast<scalar>(body_i % 3) - 1, y = static_cast<scalar>(body_i / 3) - 1;
        const Vector r_CM = {scalar(1.5) * x, scalar(1.5) * y, scalar(0.6) + scalar(0.3) * static_cast<scalar>(body_i)};
        BodyDef def = plain_body(r_CM, ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.5)}});
        def.friction = scalar(0.6);
        def.state.v_CM = {-2 * x, scalar(-2.5) * y, 0};
        def.restitution = scalar(0.5);
        ASSERT_TRUE(world.add(def).ok());
    }
}

/// Contacts of the next step, and those it has no room for, are the same in both worlds, to the bit.
template <class S>
StepReport step_alike(World<S>& world, World<S>& other) {
    const StepReport report = ingot::step(world, h), of_other = ingot::step(other, h);
    EXPECT_EQ(of_other.contacts, report.contacts);
    EXPECT_EQ(of_other.contacts_lost, report.contacts_lost);
    EXPECT_EQ(saved(other), saved(world));
    return report;
}

template <class S>
class SavedCrowd : public ::testing::Test {};
using Crowds = ::testing::Types<CrowdedPile<6, ingot::AllPairs>, CrowdedPile<6, ingot::SortedTree>, CrowdedPile<16, ingot::AllPairs>,
                                CrowdedPile<16, ingot::SortedTree>>;
TYPED_TEST_SUITE(SavedCrowd, Crowds);

TYPED_TEST(SavedCrowd, loses_the_pairs_that_the_world_loses_that_was_never_left) {
    using S = TypeParam;
    static World<S> world, restored, gone_on;
    fill_crowd(world);
    int lost = 0, touching = 0;
    for (int moment = 0; moment < 60; ++moment) {
        const StepReport report = ingot::step(world, h);
        lost += report.contacts_lost > 0;
        touching += report.contacts_lost == 0 && report.contacts > 0;
        const Bytes bytes = saved(world);
        ASSERT_EQ(ingot::load_snapshot(restored, bytes.data(), bytes.size()), Status::ok);
        copy(gone_on, world);
        for (int step_i = 0; step_i < 40; ++step_i) {
            (void)step_alike(gone_on, restored);
            ASSERT_FALSE(this->HasFailure()) << "moment " << moment << " step " << step_i;
        }
    }
    EXPECT_GT(lost, 0);
    EXPECT_GT(touching, 0);
}

}  // namespace

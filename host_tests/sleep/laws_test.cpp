// SPDX-License-Identifier: MIT
// Laws of worlds that sleep in parts: what is awake does not feel who sleeps elsewhere, what sleeps does not feel who is awake, an island wakes as a
// whole and no other does; and the same for bodies of several shapes and in a field.
#include "sleep/nursery.h"

namespace {

using namespace ingot_sleep;

/// Heaps of cubes and balls 30 m apart, each of its own making. Body 0 is the ground.
template <class S>
struct Heaps {
    static constexpr int heaps = 4, in_heap = 6;
    std::unique_ptr<ingot::World<S>> world{new ingot::World<S>{}};
    BodyId id[heaps][in_heap];

    Heaps(uint64_t seed, int built) {
        begin(*world);
        for (int heap_i = 0; heap_i < built; ++heap_i) {
            Dice dice(100 * seed + static_cast<uint64_t>(heap_i));
            for (int body_i = 0; body_i < in_heap; ++body_i) {
                const Vector r = {30 * static_cast<scalar>(heap_i) + dice.between(scalar(-0.4), scalar(0.4)), dice.between(scalar(-0.4), scalar(0.4)),
                                  scalar(0.6) + scalar(0.9) * static_cast<scalar>(body_i)};
                PlacedBody body = solid_box(1, {scalar(0.5), scalar(0.4), dice.between(scalar(0.2), scalar(0.45))}, r, 0);
                body.def.friction = scalar(0.6);
                id[heap_i][body_i] = world->add(body.def).value;
            }
        }
    }
    void step() { (void)ingot::step(*world, h); }
    int asleep_in(int heap_i) const {
        int count = 0;
        for (const BodyId& one : id[heap_i]) count += world->is_asleep(one);
        return count;
    }
    void kick(int heap_i, Dice& dice) {
        for (const BodyId& one : id[heap_i])
            (void)world->apply_central_impulse(one, {dice.between(-2, 2), dice.between(-2, 2), dice.between(0, 3)});
    }
};

template <bool sleepy, class BroadPhase>
struct HeapScene : ingot::Scene {
    static constexpr int max_bodies = 1 + 4 * 6, max_manifolds = 150, max_overlaps = 1;
    static constexpr bool translates = true, filters = true, sleeps = sleepy;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    using broad_phase = BroadPhase;
};
template <class BroadPhase>
class Parts : public ::testing::Test {};
using BroadPhases = ::testing::Types<ingot::AllPairs, ingot::SortedTree>;
TYPED_TEST_SUITE(Parts, BroadPhases);

/// A ball that rolls past heaps which fall asleep goes where it goes past heaps that do not.
TYPED_TEST(Parts, what_is_awake_rolls_as_in_a_world_where_nothing_sleeps) {
    double differ = 0;
    for (uint64_t seed = 1; seed <= 6; ++seed) {
        Heaps<HeapScene<true, TypeParam>> heaps(seed, 3);
        Heaps<HeapScene<false, TypeParam>> twin(seed, 3);
        PlacedBody ball = solid_ball(1, scalar(0.5), {-30, 15, scalar(0.5)}, 0);
        ball.move({5, 0, 0}, {0, 10, 0});
        const BodyId rolls = heaps.world->add(ball.def).value, rolls_too = twin.world->add(ball.def).value;
        for (int step_i = 0; step_i < 600; ++step_i) {
            heaps.step();
            twin.step();
            differ = std::max(differ, (to_eigen(heaps.world->state(rolls).value.r_CM) - to_eigen(twin.world->state(rolls_too).value.r_CM)).norm());
        }
        EXPECT_EQ(heaps.world->asleep_count(), 18) << "seed " << seed;
    }
    figure("apart after 50 m, m", differ);
    EXPECT_LE(differ, 1e-3);
}

/// The last heap is hit again and again, so that it never sleeps; the others fall asleep.
TYPED_TEST(Parts, what_is_awake_moves_as_in_a_world_where_nothing_sleeps) {
    double differ = 0;
    for (uint64_t seed = 1; seed <= 6; ++seed) {
        Heaps<HeapScene<true, TypeParam>> heaps(seed, 4);
        Heaps<HeapScene<false, TypeParam>> twin(seed, 4);
        Dice dice(seed), dice_of_twin(seed);
        int slept = 0;
        for (int step_i = 0; step_i < 600; ++step_i) {
            if (step_i % 25 == 0) {
                heaps.kick(3, dice);
                twin.kick(3, dice_of_twin);
            }
            heaps.step();
            twin.step();
            slept += heaps.asleep_in(0) + heaps.asleep_in(1) + heaps.asleep_in(2);
            ASSERT_EQ(heaps.asleep_in(3), 0) << "seed " << seed << " step " << step_i;
        }
        EXPECT_GT(slept, 1000) << "seed " << seed;
        for (int body_i = 0; body_i < 6; ++body_i)
            differ = std::max(differ, (to_eigen(heaps.world->state(heaps.id[3][body_i]).value.r_CM) -
                                       to_eigen(twin.world->state(twin.id[3][body_i]).value.r_CM)).norm());
    }
    figure("apart, m", differ);
    EXPECT_EQ(differ, 0);
}

/// What happens 30 m away changes no bit of an island that sleeps, nor when it fell asleep.
TYPED_TEST(Parts, what_sleeps_does_not_feel_what_happens_elsewhere) {
    using S = HeapScene<true, TypeParam>;
    for (uint64_t seed = 1; seed <= 6; ++seed) {
        Heaps<S> heaps(seed, 4);
        Dice dice(seed);
        BodyState before[3][6] = {};
        bool slept[3] = {};
        int kept = 0;
        for (int step_i = 0; step_i < 900; ++step_i) {
            if (step_i % 20 == 0) heaps.kick(3, dice);
            if (step_i == 700) (void)heaps.world->remove(heaps.id[3][0]);
            heaps.step();
            for (int heap_i = 0; heap_i < 3; ++heap_i) {
                const int asleep = heaps.asleep_in(heap_i);
                for (int body_i = 0; body_i < 6; ++body_i) {
                    const BodyState now = heaps.world->state(heaps.id[heap_i][body_i]).value;
                    if (slept[heap_i]) {
                        ASSERT_TRUE(same_bits(now, before[heap_i][body_i])) << "seed " << seed << " step " << step_i;
                        ++kept;
                    }
                    before[heap_i][body_i] = now;
                }
                ASSERT_FALSE(slept[heap_i] && asleep != 6) << "seed " << seed << " step " << step_i;
                slept[heap_i] = asleep == 6;
            }
        }
        EXPECT_GT(kept, 1000) << "seed " << seed;
    }
}

/// An island wakes as a whole: when one of its bodies is touched, nobody who touches what is awake sleeps. Other heaps sleep on.
TYPED_TEST(Parts, an_island_wakes_as_a_whole_and_no_other) {
    using S = HeapScene<true, TypeParam>;
    int woken = 0;
    for (uint64_t seed = 1; seed <= 6; ++seed) {
        Heaps<S> heaps(seed, 4);
        Dice dice(seed);
        for (int step_i = 0; step_i < 900; ++step_i) heaps.step();
        ASSERT_EQ(heaps.world->asleep_count(), 24) << "seed " << seed;
        const int islands = heaps.world->asleep_island_count();
        static ingot::World<S> asleep;
        copy_world(asleep, *heaps.world);
        for (int heap_i = 0; heap_i < 4; ++heap_i) {
            for (int body_i = 0; body_i < 6; ++body_i) {
                copy_world(*heaps.world, asleep);
                ASSERT_EQ(heaps.world->wake(heaps.id[heap_i][body_i]), Status::ok);
                EXPECT_EQ(heaps.world->asleep_island_count(), islands - 1);
                const int asleep_now = heaps.world->asleep_count();
                heaps.step();
                EXPECT_EQ(heaps.world->asleep_count(), asleep_now) << "nobody was left behind: seed " << seed << " heap " << heap_i;
                for (int other = 0; other < 4; ++other) EXPECT_TRUE(other == heap_i || heaps.asleep_in(other) == 6);
                woken += 24 - asleep_now;
            }
        }
    }
    EXPECT_GE(woken, 6 * 24);
}

// A field.

/// The same acceleration for all bodies, as gravity that can be turned.
struct Pull : ingot::ForceField {
    static constexpr bool depends_on_velocity = false, is_steady = true;
    Vector a;  ///< m s^-2

    template <class Each>
    constexpr void numbers(Each& each) {
        each(a);
    }
    ingot::Wrench operator()(const ingot::BodyMotion& body) const { return ingot::Wrench::force(ingot::splat(a) * ingot::mass_of(body)); }
};
struct Pulled : ingot::Scene {
    static constexpr int max_bodies = 9, max_manifolds = 30;
    static constexpr bool translates = true, sleeps = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    using force_field = Pull;
};
/// Two towers of three, without gravity but for the field.
void begin_pulled(ingot::World<Pulled>& world) {
    std::memset(static_cast<void*>(&world), 0, sizeof world);
    world.force_field().a = {0, 0, scalar(-9.81)};
    for (PlacedBody body : columns(2, 3)) {
        body.def.friction = body.mu;
        ASSERT_TRUE(world.add(body.def).ok());
    }
    for (int step_i = 0; step_i < 120; ++step_i) (void)ingot::step(world, h);
}

TEST(SleepInAField, what_it_presses_down_falls_asleep_and_to_read_its_numbers_wakes_nobody) {
    static ingot::World<Pulled> world;
    begin_pulled(world);
    ASSERT_EQ(world.asleep_count(), 6);
    const BodyState before = world.state(world.body_at(3)).value;
    for (int step_i = 0; step_i < 60; ++step_i) {
        EXPECT_EQ(world.force_field().a.x, 0);
        (void)ingot::step(world, h);
    }
    EXPECT_EQ(world.asleep_count(), 6);
    EXPECT_TRUE(same_bits(world.state(world.body_at(3)).value, before));
    EXPECT_NEAR(static_cast<double>(world.time()), 180 * static_cast<double>(h), 1e-5) << "time goes on in their sleep";
}

TEST(SleepInAField, its_new_numbers_wake_all_in_the_next_step_and_in_a_world_that_was_saved_before_it_too) {
    static ingot::World<Pulled> world, loaded;
    begin_pulled(world);
    world.force_field().a = {10, 0, scalar(-9.81)};
    uint8_t bytes[ingot::snapshot_size<Pulled>()];
    const ingot::Result<size_t> size = ingot::save_snapshot(world, bytes, sizeof bytes);
    ASSERT_TRUE(size.ok());
    ASSERT_EQ(ingot::load_snapshot(loaded, bytes, size.value), Status::ok);
    for (int step_i = 0; step_i < 60; ++step_i) {
        (void)ingot::step(world, h);
        (void)ingot::step(loaded, h);
        ASSERT_EQ(loaded.state_hash(), world.state_hash()) << step_i;
        ASSERT_EQ(world.asleep_count(), 0) << step_i;
    }
    EXPECT_GT(world.state(world.body_at(1)).value.r_CM.x, scalar(0.1)) << "friction of 0.6 does not hold 10 m s^-2";
}

TEST(SleepInAField, who_is_awake_is_pulled_beside_who_sleeps) {
    static ingot::World<Pulled> world;
    begin_pulled(world);
    const BodyId ball = world.add(solid_ball(1, scalar(0.5), {10, 0, 8}, 0).def).value;
    for (int step_i = 0; step_i < 60; ++step_i) (void)ingot::step(world, h);
    EXPECT_EQ(world.asleep_count(), 6);
    EXPECT_NEAR(static_cast<double>(world.state(ball).value.r_CM.z), 8 - 9.81 / 2, 1e-3);
}

}  // namespace

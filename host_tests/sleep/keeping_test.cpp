// SPDX-License-Identifier: MIT
// What sleep keeps: bits, snapshots, events, sensors; in worlds where anything may happen.
#include "reference/brief_types.h"
#include "reference/draws.h"
#include "sleep/nursery.h"

namespace {

using namespace ingot_sleep;

template <class S>
std::vector<uint8_t> saved(const ingot::World<S>& world) {
    std::vector<uint8_t> bytes(ingot::snapshot_size<S>());
    const ingot::Result<size_t> size = ingot::save_snapshot(world, bytes.data(), bytes.size());
    EXPECT_TRUE(size.ok());
    bytes.resize(size.value);
    return bytes;
}

template <class S>
class Keeping : public ::testing::Test {};
using Nurseries = ingot_reference::BriefTypes<5, Nursery<ingot::LieMidpoint, ingot::SortedTree>, Nursery<ingot::ExactElliptic>,
                                              Nursery<ingot::DiscreteMoserVeselov<4, true, true>, ingot::SortedTree>, Compounds<ingot::AllPairs>,
                                              Crowd<ingot::SortedTree>, Nursery<ingot::MoserVeselov>, Compounds<ingot::SortedTree>,
                                              Crowd<ingot::AllPairs>>;
TYPED_TEST_SUITE(Keeping, Nurseries);

TYPED_TEST(Keeping, who_sleeps_keeps_every_bit_until_it_wakes) {
    using S = TypeParam;
    static ingot::World<S> world;
    int kept = 0, next_to_awake = 0;
    for (uint64_t seed = 1; seed <= 20; ++seed) {
        begin(world);
        Dice dice(seed);
        BodyState before[S::max_bodies] = {};
        BodyId slept[S::max_bodies] = {};
        for (int call_i = 0; call_i < 1000; ++call_i) {
            live(world, dice);
            int awake = 0;
            for (int slot = 0; slot < S::max_bodies; ++slot) {
                const BodyId id = world.body_at(slot);
                const bool asleep = world.is_asleep(id);
                awake += id.generation != 0 && !asleep && world.mass(id).value > 0;
                if (asleep) {
                    const BodyState now = world.state(id).value;
                    ASSERT_TRUE(at_rest(now));
                    if (slept[slot] == id) {
                        ASSERT_TRUE(same_bits(now, before[slot])) << "seed " << seed << " call " << call_i << " slot " << slot;
                        ++kept;
                    }
                    before[slot] = now;
                }
                slept[slot] = asleep ? id : BodyId{};
            }
            next_to_awake += awake > 0 && world.asleep_count() > 0;
        }
    }
    EXPECT_GT(kept, 10000);
    EXPECT_GT(next_to_awake, 1000);
}

TYPED_TEST(Keeping, a_world_that_was_saved_goes_on_to_the_bit) {
    using S = TypeParam;
    static ingot::World<S> world, restored, copied;
    int asleep = 0;
    const int seeds = ingot_reference::draws(20);
    for (int seed = 1; seed <= seeds; ++seed) {
        begin(world);
        Dice dice(static_cast<uint64_t>(seed));
        for (int moment = 0; moment < 20; ++moment) {
            for (int call_i = 0; call_i < 40; ++call_i) live(world, dice);
            const std::vector<uint8_t> bytes = saved(world);
            std::memset(static_cast<void*>(&restored), 0xa5, sizeof restored);
            ASSERT_EQ(ingot::load_snapshot(restored, bytes.data(), bytes.size()), Status::ok);
            ASSERT_EQ(saved(restored), bytes);
            copy_world(copied, world);
            const uint32_t saved_at = world.step_count();
            asleep += world.asleep_count();
            EXPECT_EQ(restored.asleep_count(), world.asleep_count());
            EXPECT_EQ(restored.asleep_island_count(), world.asleep_island_count());
            Dice dices[] = {dice, dice, dice};
            ingot::World<S>* const all[] = {&world, &restored, &copied};
            for (int call_i = 0; call_i < 40; ++call_i) {
                for (int world_i = 0; world_i < 3; ++world_i) live(*all[world_i], dices[world_i]);
                ASSERT_EQ(restored.state_hash(), world.state_hash()) << "seed " << seed << " moment " << moment << " call " << call_i;
                ASSERT_EQ(saved(restored), saved(world)) << "seed " << seed << " moment " << moment << " call " << call_i;
                if (world.step_count() == saved_at) continue;  // who is in a sensor is found anew by a step
                ASSERT_EQ(restored.overlap_count(), world.overlap_count()) << "seed " << seed << " moment " << moment << " call " << call_i;
            }
            ASSERT_EQ(saved(copied), saved(world));
            dice = dices[0];
        }
    }
    EXPECT_GT(asleep, 20 * seeds);
}

using Slept = Nursery<ingot::MoserVeselov>;

/// A tower of three that sleeps beside a ball that does not.
void put_to_sleep(ingot::World<Slept>& world) {
    begin(world);
    for (int cube_i = 0; cube_i < 3; ++cube_i)
        ASSERT_TRUE(world.add(solid_box(1, {scalar(0.5), scalar(0.5), scalar(0.5)}, {0, 0, static_cast<scalar>(cube_i) + scalar(0.5)}, 0).def).ok());
    for (int step_i = 0; step_i < 60; ++step_i) (void)ingot::step(world, h);
    ASSERT_EQ(world.asleep_count(), 3);
}

TEST(Kept, the_hash_of_the_state_tells_who_sleeps_and_for_how_long_others_were_slow) {
    static ingot::World<Slept> world;
    put_to_sleep(world);
    const uint64_t asleep = world.state_hash();
    ASSERT_EQ(world.wake(world.body_at(1)), Status::ok);
    const uint64_t awake = world.state_hash();
    EXPECT_NE(awake, asleep);
    ASSERT_EQ(world.sleep(world.body_at(1)), Status::ok);
    EXPECT_NE(world.state_hash(), awake);
}

// A step of a world at rest does nothing; the first after loading makes bounds, and must not tell of it.
TEST(Kept, a_world_that_was_loaded_asleep_reports_what_the_saved_one_does) {
    static ingot::World<Slept> world, loaded;
    put_to_sleep(world);
    const std::vector<uint8_t> bytes = saved(world);
    ASSERT_EQ(ingot::load_snapshot(loaded, bytes.data(), bytes.size()), Status::ok);
    const ingot::StepReport of_saved = ingot::step(world, h), of_loaded = ingot::step(loaded, h);
    ASSERT_EQ(loaded.asleep_count(), 3);
    EXPECT_EQ(of_loaded.contacts, 3);
    EXPECT_EQ(of_saved.contacts, 3);
    EXPECT_EQ(of_loaded.sweeps, 0);
    EXPECT_EQ(of_saved.sweeps, 0);
    EXPECT_EQ(of_loaded.residual, of_saved.residual);
    EXPECT_EQ(saved(loaded), saved(world));
}

TEST(Kept, a_snapshot_of_a_sleeper_that_moves_is_refused) {
    static ingot::World<Slept> world, other;
    put_to_sleep(world);
    std::vector<uint8_t> bytes = saved(world);
    ASSERT_EQ(ingot::load_snapshot(other, bytes.data(), bytes.size()), Status::ok);

    // The same world awake and moving, with the mark of sleep of the first: only `awake` and `rest_time` differ in their places.
    ingot::SavedBody body{};
    body.v_CM = {0, 0, 1};
    EXPECT_FALSE(ingot::is_valid(ingot::SavedRest{0, 0}, body, 1));
    EXPECT_TRUE(ingot::is_valid(ingot::SavedRest{1, 0}, body, 1));
    EXPECT_FALSE(ingot::is_valid(ingot::SavedRest{2, 0}, body, 1)) << "due, and moving";
    EXPECT_TRUE(ingot::is_valid(ingot::SavedRest{2, 0}, {}, 1));
    EXPECT_FALSE(ingot::is_valid(ingot::SavedRest{3, 0}, {}, 1));
    EXPECT_FALSE(ingot::is_valid(ingot::SavedRest{1, scalar(1.5)}, {}, 1));
    EXPECT_FALSE(ingot::is_valid(ingot::SavedRest{1, scalar(-0.5)}, {}, 1));
    EXPECT_FALSE(ingot::is_valid(ingot::SavedRest{1, std::numeric_limits<scalar>::quiet_NaN()}, {}, 1));
    EXPECT_TRUE(ingot::is_valid(ingot::SavedRest{0, 1}, {}, 1));
    for (ingot::Vector ingot::SavedBody::*part : {&ingot::SavedBody::L, &ingot::SavedBody::tau_T, &ingot::SavedBody::F_T}) {
        ingot::SavedBody pushed{};
        (pushed.*part).y = 1;
        EXPECT_FALSE(ingot::is_valid(ingot::SavedRest{0, 0}, pushed, 1));
    }
}

TEST(Kept, queries_and_sensors_see_who_sleeps) {
    static ingot::World<Slept> world;
    put_to_sleep(world);
    const ingot::Result<ingot::QueryHit> hit = world.cast_ray({0, 0, 10}, {0, 0, -20});
    ASSERT_TRUE(hit.ok());
    EXPECT_EQ(hit.value.body, world.body_at(3));
    EXPECT_EQ(world.asleep_count(), 3);

    ingot::BodyDef def = fixed_box({1, 1, scalar(0.2)}, {0, 0, scalar(1.5)}, 0).def;
    def.sensor = true;
    const BodyId sensor = world.add(def).value;
    for (int step_i = 0; step_i < 5; ++step_i) {
        (void)ingot::step(world, h);
        ASSERT_EQ(world.overlap_count(), 1) << "in a step where nothing moves too";
        EXPECT_EQ(world.overlap(0).value.sensor, sensor);
        EXPECT_EQ(world.overlap(0).value.visitor, world.body_at(2));
        EXPECT_EQ(world.asleep_count(), 3) << "a sensor wakes nobody";
    }
    ASSERT_EQ(world.remove(sensor), Status::ok);
    (void)ingot::step(world, h);
    EXPECT_EQ(world.overlap_count(), 0);
    EXPECT_EQ(world.asleep_count(), 3);
}

struct Telling : Nursery<ingot::MoserVeselov> {
    static constexpr int max_events = 40;
};
TEST(Kept, contacts_neither_end_nor_begin_when_an_island_sleeps_or_wakes) {
    static ingot::World<Telling> world;
    begin(world);
    for (int cube_i = 0; cube_i < 3; ++cube_i)
        ASSERT_TRUE(world.add(solid_box(1, {scalar(0.5), scalar(0.5), scalar(0.5)}, {0, 0, static_cast<scalar>(cube_i) + scalar(0.5)}, 0).def).ok());
    const BodyId far = world.add(solid_ball(1, scalar(0.5), {10, 0, 3}, 0, scalar(0.9)).def).value;
    int begins = 0, others = 0, slept = 0, far_events = 0;
    for (int step_i = 0; step_i < 200; ++step_i) {
        if (step_i == 100) {
            ASSERT_EQ(world.wake(world.body_at(2)), Status::ok);
        }
        (void)ingot::step(world, h);
        slept += world.asleep_count() == 3;
        for (const ingot::Event& event : world.events()) {
            if (event.A == far || event.B == far)
                ++far_events;
            else
                ++(event.kind == ingot::EventKind::begin ? begins : others);
        }
    }
    EXPECT_EQ(begins, 3);
    EXPECT_EQ(others, 0);
    EXPECT_GT(slept, 100);
    EXPECT_GT(far_events, 4) << "a ball that bounces meanwhile";

    ASSERT_EQ(world.remove(far), Status::ok);
    for (int step_i = 0; step_i < 100; ++step_i) (void)ingot::step(world, h);
    ASSERT_EQ(world.asleep_count(), 3);
    EXPECT_EQ(world.events().count, 0);
    ASSERT_EQ(world.remove(world.body_at(2)), Status::ok);
    (void)ingot::step(world, h);
    ASSERT_EQ(world.events().count, 2) << "both contacts of the cube end";
    EXPECT_EQ(world.events()[0].kind, ingot::EventKind::end);
    EXPECT_EQ(world.events()[1].kind, ingot::EventKind::end);
}

/// Manifolds for two bodies, and three that want one: whoever has one keeps it in its sleep, and the third lies on the
/// ground without, awake.
TEST(Kept, full_arrays_leave_sleepers_what_they_have) {
    using S = Bedroom<5, true, ingot::AllPairs, 2>;
    std::vector<PlacedBody> bodies = columns(3, 1);
    Play<S> play(bodies, OnEarth::gravity);
    (void)play.step(h);
    EXPECT_EQ(play.reports().lost, 1);
    for (int step_i = 0; step_i < 120; ++step_i) (void)play.step(h);
    EXPECT_TRUE(play.world().is_asleep(play.id(1)));
    EXPECT_TRUE(play.world().is_asleep(play.id(2)));
    EXPECT_FALSE(play.world().is_asleep(play.id(3)));
    EXPECT_NEAR(play.r(3).z(), 0.5, static_cast<double>(ingot::limits::touching_gap)) << "and every step tells of it";
    EXPECT_EQ(play.reports().lost, 121);
    EXPECT_NEAR(play.r(1).z(), 0.5, static_cast<double>(ingot::limits::touching_gap));
}

}  // namespace

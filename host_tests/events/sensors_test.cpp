// SPDX-License-Identifier: MIT
#include <vector>

#include "collide/placed.h"
#include "stage.h"

using namespace events_stage;

namespace {

struct Sensing : Plain {
    static constexpr int max_overlaps = 3;
    static constexpr bool filters = true;
};

TEST(Sensors, give_no_impulse) {
    World<Sensing> with, without;
    const Shape shapes[] = {ingot::Sphere{1}, ingot::Capsule{1, 2}, ingot::Box{{1, 1, 1}}, ingot::HalfSpace{{0, 0, 1}, 0}};
    for (World<Sensing>* world : {&with, &without}) (void)world->set_gravity({0, 0, -g});
    for (const Shape& shape : shapes) (void)with.add(sensor(fixed(shape, {0, 0, -2})));
    const BodyDef def = body(ingot::Box{{1, scalar(0.5), 2}}, {0, 0, 4}, {1, 0, 0});
    const BodyId in = with.add(def).value, out = without.add(def).value;
    bool met = false;
    for (int step_i = 0; step_i < 120; ++step_i) {
        const StepReport report = ingot::step(with, h);
        EXPECT_EQ(report.contacts, 0);
        met = met || with.overlap_count() > 0;
        (void)ingot::step(without, h);
        ASSERT_TRUE(same_motion(with, in, without, out)) << step_i;
    }
    EXPECT_TRUE(met);
}

/// A sensor that moves, through bodies that stand, and the other way round.
TEST(Sensors, note_who_is_in_them_as_the_oracle_does) {
    ingot_reference::RandomInput random(7);
    int with = 0, without = 0;
    for (int case_i = 0; case_i < 400; ++case_i) {
        const auto any_shape = [&]() -> Shape {
            const auto size = [&] { return static_cast<scalar>(random.real(0.3, 1.5)); };
            switch (random.integer(0, 2)) {
                case 0: return ingot::Sphere{size()};
                case 1: return ingot::Capsule{size(), size()};
                default: return ingot::Box{{size(), size(), size()}};
            }
        };
        World<Sensing> world;
        const auto put = [&](bool still) {
            BodyDef def = still ? fixed(any_shape()) : body(any_shape(), {}, ingot_reference::to_vector(random.vector(2)));
            def.state.r_CM = ingot_reference::to_vector(random.vector(2));
            def.state.A = ingot_reference::to_matrix(random.rotation());
            return def;
        };
        const bool sensor_moves = random.integer(0, 1) != 0;
        BodyDef defs[2] = {sensor(put(!sensor_moves)), put(sensor_moves && random.integer(0, 1) != 0)};
        BodyId ids[2];
        const int first = random.integer(0, 1);  // either slot
        ids[first] = world.add(defs[first]).value;
        ids[1 - first] = world.add(defs[1 - first]).value;
        for (int step_i = 0; step_i < 8; ++step_i) {
            const auto placed_now = [&](int i) {
                const ingot::BodyState state = state_of(world, ids[i]);
                return ingot::PlacedShape{defs[i].shape, state.r_CM, state.A, nullptr};
            };
            const auto gap = static_cast<double>(
                ingot_oracle::signed_distance(ingot_collide::oracle_of(placed_now(0)), ingot_collide::oracle_of(placed_now(1))));
            EXPECT_TRUE(ingot::step(world, h * 8).clean());
            // Positions up to 4 m and sizes up to 3 m: separations carry some tens of roundings of these.
            if (std::abs(gap) < 100 * static_cast<double>(ingot::epsilon)) continue;
            ASSERT_EQ(world.overlap_count(), gap < 0 ? 1 : 0) << case_i << " " << gap;
            ++(gap < 0 ? with : without);
            if (gap > 0) continue;
            EXPECT_EQ(world.overlap(0).value.sensor, ids[0]);
            EXPECT_EQ(world.overlap(0).value.visitor, ids[1]);
        }
    }
    EXPECT_GT(with, 300);
    EXPECT_GT(without, 300);
}

TEST(Sensors, a_full_list_keeps_the_lowest_slots_and_says_what_it_lost) {
    World<Sensing> world;
    const BodyId zone = world.add(sensor(fixed(ingot::Sphere{5}))).value;
    BodyId inside[5];
    for (int i = 0; i < 5; ++i) inside[i] = world.add(ball(scalar(0.1), {scalar(i) - 2, 0, 0})).value;
    const StepReport report = ingot::step(world, h);
    EXPECT_EQ(report.overlaps_lost, 2);
    EXPECT_FALSE(report.clean());
    ASSERT_EQ(world.overlap_count(), 3);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(world.overlap(i).value.sensor, zone);
        EXPECT_EQ(world.overlap(i).value.visitor, inside[i]);
    }
    EXPECT_EQ(world.overlap(3).status, Status::out_of_range);
    EXPECT_EQ(world.overlap(-1).status, Status::out_of_range);

    // With room again it is clean again; who is removed is told with the id it had, until the next step.
    (void)world.remove(inside[0]);
    (void)world.remove(inside[4]);
    EXPECT_FALSE(world.is_alive(world.overlap(0).value.visitor));
    EXPECT_TRUE(ingot::step(world, h).clean());
    EXPECT_EQ(world.overlap_count(), 3);
    EXPECT_EQ(world.overlap(0).value.visitor, inside[1]);
}

TEST(Sensors, do_not_note_each_other_nor_whom_the_filter_keeps_apart) {
    World<Sensing> world;
    const BodyId zone = world.add(filtered(sensor(ball(1, {})), 1, 2)).value;
    (void)world.add(filtered(sensor(ball(1, {})), ~0u, ~0u));
    (void)world.add(filtered(ball(1, {}), 1, ~0u));  // the zone does not meet it; the other sensor does
    const BodyId friend_of_zone = world.add(filtered(ball(1, {4, 0, 0}), 2, 1)).value;
    EXPECT_TRUE(ingot::step(world, h).clean());
    EXPECT_EQ(world.overlap_count(), 1);
    EXPECT_NE(world.overlap(0).value.sensor, zone);
    ingot::BodyState state = state_of(world, friend_of_zone);
    state.r_CM = {};
    EXPECT_EQ(world.set_state(friend_of_zone, state), Status::ok);
    EXPECT_EQ(world.set_filter(friend_of_zone, {2, 1}), Status::ok);
    (void)ingot::step(world, h);
    bool noted = false;
    for (int i = 0; i < world.overlap_count(); ++i)
        noted = noted || (world.overlap(i).value.sensor == zone && world.overlap(i).value.visitor == friend_of_zone);
    EXPECT_TRUE(noted);
}

struct More : Sensing {
    static constexpr int max_overlaps = 3 + 64;
};

TEST(Sensors, cost_their_arrays_where_they_are_named) {
    EXPECT_EQ(sizeof(World<More>) - sizeof(World<Sensing>), 64u * 16);
}

}  // namespace

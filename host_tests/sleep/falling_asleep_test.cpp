// SPDX-License-Identifier: MIT
// What falls asleep, when, and what never does.
#include "sleep/sleepers.h"

namespace {

using namespace ingot_sleep;

TEST(FallingAsleep, a_box_on_the_floor_sleeps_after_the_time_and_keeps_every_bit) {
    Play<Bedroom<2>> play(columns(1, 1), OnEarth::gravity);
    for (int step_i = 1; step_i < steps_to_sleep; ++step_i) {
        (void)play.step(h);
        ASSERT_FALSE(play.world().is_asleep(play.id(1))) << step_i;
    }
    for (int step_i = 0; step_i < 2; ++step_i) (void)play.step(h);  // one for what rounding may lack in the sum of h
    ASSERT_TRUE(play.world().is_asleep(play.id(1)));
    EXPECT_FALSE(play.world().is_asleep(play.id(0))) << "the ground cannot move";
    EXPECT_EQ(play.world().asleep_count(), 1);
    EXPECT_EQ(play.world().asleep_island_count(), 1);

    const BodyState before = play.state(1);
    EXPECT_TRUE(at_rest(before));
    const uint64_t hash = play.world().state_hash();
    (void)play.step(h);
    for (int step_i = 0; step_i < 1000; ++step_i) {
        const StepReport report = play.step(h);
        ASSERT_TRUE(report.clean());
        ASSERT_EQ(report.contacts, 1);
        ASSERT_EQ(report.sweeps, 0) << "nothing is solved";
        ASSERT_TRUE(same_bits(play.state(1), before)) << step_i;
    }
    EXPECT_EQ(play.world().state_hash(), hash);
}

TEST(FallingAsleep, a_tower_of_ten_is_one_island_and_two_towers_are_two) {
    Play<Bedroom<11>> tower(columns(1, 10), OnEarth::gravity);
    EXPECT_GT(run_until_asleep(tower, 120), 0);
    EXPECT_EQ(tower.world().asleep_island_count(), 1);
    Play<Bedroom<21>> towers(columns(2, 10), OnEarth::gravity);
    EXPECT_GT(run_until_asleep(towers, 120), 0);
    EXPECT_EQ(towers.world().asleep_island_count(), 2);
}

TEST(FallingAsleep, bodies_and_islands_are_awake_or_asleep) {
    constexpr int columns_of_three = 4, height = 3, bodies = columns_of_three * height;
    Play<Bedroom<bodies + 1>> play(columns(columns_of_three, height), OnEarth::gravity);
    EXPECT_EQ(play.world().awake_count(), bodies);
    EXPECT_EQ(play.world().awake_island_count(), bodies) << "before a step each stands for itself";
    (void)play.step(h);
    EXPECT_EQ(play.world().awake_island_count(), columns_of_three);
    for (int step_i = 0; step_i < 2 * steps_to_sleep; ++step_i) {
        (void)play.step(h);
        ASSERT_EQ(play.world().awake_count() + play.world().asleep_count(), bodies);
        ASSERT_EQ(play.world().awake_island_count() + play.world().asleep_island_count(), columns_of_three);
    }
    EXPECT_EQ(play.world().awake_count(), 0);
    ASSERT_EQ(play.world().wake(play.id(2)), Status::ok);
    static ingot::World<Bedroom<bodies + 1>> before;
    copy_world(before, play.world());
    EXPECT_EQ(play.world().awake_count(), height);
    EXPECT_EQ(play.world().awake_island_count(), 1);
    EXPECT_TRUE(same_world(before, play.world())) << "who asks changes nothing";
}

TEST(FallingAsleep, an_island_waits_for_its_last_body) {
    std::vector<PlacedBody> bodies = columns(2, 2);
    bodies[2].move({}, {0, 0, 2});  // spins on the first column until friction stops it
    Play<Bedroom<5>> play(bodies, OnEarth::gravity);
    const ingot::World<Bedroom<5>>& world = play.world();
    int first = 0, last = 0;
    for (int step_i = 1; step_i <= 600; ++step_i) {
        (void)play.step(h);
        ASSERT_EQ(world.is_asleep(play.id(1)), world.is_asleep(play.id(2))) << "one island";
        ASSERT_EQ(world.is_asleep(play.id(3)), world.is_asleep(play.id(4))) << "one island";
        if (first == 0 && world.is_asleep(play.id(3))) first = step_i;
        if (last == 0 && world.is_asleep(play.id(1))) last = step_i;
    }
    // I omega = mu M g r t with I = M/6 and r, where friction takes hold, at most the 0.71 m of a corner: at least 0.08 s.
    EXPECT_GT(first, 0);
    EXPECT_GE(last, first + static_cast<int>(0.08 * 60));
}

/// Slow for 2 s around the top of its flight, four times the time after which bodies at rest sleep.
TEST(FallingAsleep, not_at_the_top_of_a_flight_however_weak_gravity_is) {
    const scalar g = scalar(1e-3);
    std::vector<PlacedBody> bodies = {flat_ground(0), solid_ball(1, scalar(0.5), {0, 0, 10}, 0)};
    bodies[1].move({0, 0, 4 * g});
    Play<Bedroom<2>> play(bodies, {0, 0, -g});
    for (int step_i = 1; step_i <= 480; ++step_i) {
        (void)play.step(h);
        ASSERT_FALSE(play.world().is_asleep(play.id(1))) << step_i;
    }
    // Back after 8 s. Each step rounds r once: 480 halves of an ulp of 10 m. So does v, at its own size.
    const double ulp = static_cast<double>(ingot::epsilon);
    EXPECT_NEAR(play.r(1).z(), 10, 480 * 8 * ulp + 1e-9);
    EXPECT_NEAR(play.v(1).z(), -4 * static_cast<double>(g), 480 * ulp * 4e-3);
}

/// Down an incline of which friction holds all but a: slow only for sleep_speed / a, and then it moves.
TEST(FallingAsleep, not_on_an_incline_where_it_begins_to_slide) {
    const double g = 9.81, sine = 0.3, cosine = std::sqrt(1 - sine * sine);
    for (const double a : {4 * sleep_speed / sleep_time, 0.05, 0.5}) {
        const scalar mu = static_cast<scalar>((g * sine - a) / (g * cosine));
        std::vector<PlacedBody> bodies = {flat_ground(mu), unit_cube({0, 0, scalar(0.5)}, mu)};
        Play<Bedroom<2>> play(bodies, {static_cast<scalar>(g * sine), 0, static_cast<scalar>(-g * cosine)});
        const double seconds = 4;
        play.run(h, seconds, [&](int step_i) { ASSERT_FALSE(play.world().is_asleep(play.id(1))) << "a " << a << " step " << step_i; });
        // mu is rounded to 1 ulp of 0.3, which friction makes of g: below 1e-6 m/s^2. The first step makes the contact: h of the way's speed.
        EXPECT_NEAR(play.r(1).x(), a * seconds * seconds / 2, a * seconds / 60 + 1e-5 * seconds * seconds) << a;
    }
}

/// Up a slope of 1/1000 and back, as a pendulum swings: slow for 0.28 s at its turn.
TEST(FallingAsleep, not_where_a_slow_swing_turns_back) {
    const double g = 9.81, slope = 1e-3, a = 5.0 / 7 * g * slope, v = 5e-3;
    std::vector<PlacedBody> bodies = {flat_ground(1), solid_ball(1, scalar(0.5), {0, 0, scalar(0.5)}, 1)};
    bodies[1].move({static_cast<scalar>(v), 0, 0}, {0, static_cast<scalar>(2 * v), 0});
    Play<Bedroom<2>> play(bodies, {static_cast<scalar>(-g * slope), 0, static_cast<scalar>(-g)});
    const double seconds = 2 * v / a;
    play.run(h, seconds, [&](int step_i) { ASSERT_FALSE(play.world().is_asleep(play.id(1))) << step_i; });
    EXPECT_NEAR(play.v(1).x(), -v, a / 60 + 1e-5) << "within a step of the time it comes back as fast";
}

/// A body that is slower than the limit for good loses that motion, and no more energy than M speed^2.
TEST(FallingAsleep, what_rolls_faster_than_the_limit_rolls_on_and_what_is_slower_loses_no_more_than_that) {
    for (const double factor : {0.5, 2.0}) {
        const double v = factor * sleep_speed;
        std::vector<PlacedBody> bodies = {flat_ground(1), solid_ball(1, scalar(0.5), {0, 0, scalar(0.5)}, 1)};
        bodies[1].move({static_cast<scalar>(v), 0, 0}, {0, static_cast<scalar>(2 * v), 0});
        Play<Bedroom<2>> play(bodies, OnEarth::gravity);
        const double energy = play.kinetic();
        play.run(h, 10);
        EXPECT_EQ(play.world().is_asleep(play.id(1)), factor < 1);
        if (factor > 1) {
            EXPECT_NEAR(play.r(1).x(), 10 * v, 0.01 * 10 * v);
        } else {
            EXPECT_EQ(play.kinetic(), 0);
            EXPECT_LE(energy, sleep_speed * sleep_speed);
        }
    }
}

TEST(FallingAsleep, without_gravity_only_what_stands_still_sleeps) {
    std::vector<PlacedBody> bodies = {solid_ball(1, scalar(0.5), {}, 0), solid_ball(1, scalar(0.5), {5, 0, 0}, 0),
                                      solid_ball(1, scalar(0.5), {10, 0, 0}, 0), solid_ball(1, scalar(0.5), {15, 0, 0}, 0)};
    bodies[0].move({scalar(1e-6), 0, 0});
    bodies[1].move({}, {0, 0, scalar(1e-20)});
    bodies[3].move({0, scalar(1e-6), 0});
    Play<Bedroom<4>> play(bodies, {});
    play.run(h, 2);
    EXPECT_FALSE(play.world().is_asleep(play.id(0))) << "it drifts";
    EXPECT_FALSE(play.world().is_asleep(play.id(3))) << "it drifts";
    EXPECT_FALSE(play.world().is_asleep(play.id(1))) << "it turns";
    EXPECT_TRUE(play.world().is_asleep(play.id(2)));
    EXPECT_EQ(play.state(0).v_CM.x, scalar(1e-6));
}

TEST(FallingAsleep, what_is_told_to_sleep_need_not_wait) {
    Play<Bedroom<11>> play(columns(1, 10), OnEarth::gravity);
    for (int body_i = 1; body_i <= 10; ++body_i) ASSERT_EQ(play.world().sleep(play.id(body_i)), Status::ok);
    int steps = 0;
    while (play.world().asleep_count() == 0 && steps < steps_to_sleep) {
        (void)play.step(h);
        ++steps;
        for (int body_i = 1; body_i <= 10; ++body_i) (void)play.world().sleep(play.id(body_i));
    }
    figure("steps", steps);
    EXPECT_EQ(play.world().asleep_count(), 10);
    EXPECT_LT(steps, 10);

    std::vector<PlacedBody> falling = {flat_ground(0), solid_ball(1, scalar(0.5), {0, 0, 3}, 0)};
    Play<Bedroom<2>> ball(falling, OnEarth::gravity);
    for (int step_i = 0; step_i < 20; ++step_i) {
        ASSERT_EQ(ball.world().sleep(ball.id(1)), Status::ok);
        (void)ball.step(h);
        ASSERT_FALSE(ball.world().is_asleep(ball.id(1))) << "what falls is not at rest";
    }
}

struct Drowsy : Bedroom<2> {
    static constexpr scalar sleep_speed = scalar(0.1);
    static constexpr scalar sleep_time = scalar(2);
};
TEST(FallingAsleep, a_scene_may_say_how_slow_and_for_how_long) {
    std::vector<PlacedBody> bodies = {flat_ground(1), solid_ball(1, scalar(0.5), {0, 0, scalar(0.5)}, 1)};
    bodies[1].move({scalar(0.05), 0, 0}, {0, scalar(0.1), 0});
    Play<Drowsy> play(bodies, OnEarth::gravity);
    const int steps = run_until_asleep(play, 200);
    EXPECT_GE(steps, 119);
    EXPECT_LE(steps, 123);
}

/// 512 boxes of mixed sizes in a pit, dropped.
struct Boxes512 : OnEarth {
    static constexpr int wall_count = 5, body_count = wall_count + 512;
    static PlacedBody body(int body_i) {
        const scalar mu = scalar(0.5);
        if (body_i < wall_count) return pit_wall(body_i, 11, mu);
        const int box_i = body_i - wall_count;
        const auto half = [&](int channel) { return scalar(0.35) + scalar(0.1) * scattered(box_i, channel); };
        const auto place = [](int cell) { return (static_cast<scalar>(cell) - scalar(3.5)) * scalar(1.3); };
        const Vector e = {half(0), half(1), half(2)};
        PlacedBody box =
            solid_box(400 * 8 * e.x * e.y * e.z, e, {place(box_i % 8), place(box_i / 8 % 8), static_cast<scalar>(box_i / 64) * scalar(1.6) + 1}, mu);
        box.turn(scattered_rotation(box_i));
        return box;
    }
};
/// What is slow need not wait there; what moves, and what has begun to fall, does not sleep for that. At any rate, saved and loaded as it goes.
struct AtOnce : Bedroom<2> {
    static constexpr scalar sleep_time = 0;
};
TEST(FallingAsleep, at_once_is_not_before_it_rests) {
    for (const int rate : {30, 60, 240, 1000}) {
        Play<AtOnce> play({flat_ground(1), solid_ball(1, scalar(0.5), {0, 0, 3}, 1)}, OnEarth::gravity);
        auto& world = play.world();
        int steps = 0;
        for (; world.asleep_count() == 0 && steps < 20 * rate; ++steps) {
            (void)ingot::step(world, 1 / static_cast<scalar>(rate));
            std::vector<uint8_t> bytes(ingot::snapshot_size<AtOnce>());
            const auto size = ingot::save_snapshot(world, bytes.data(), bytes.size());
            ASSERT_TRUE(size.ok());
            ASSERT_EQ(ingot::load_snapshot(world, bytes.data(), size.value), ingot::Status::ok) << rate << " Hz, step " << steps;
        }
        EXPECT_EQ(world.asleep_count(), 1) << rate;
        EXPECT_LT(play.state(1).r_CM.z, scalar(0.51)) << rate << " Hz: it lies";
    }
}

TEST(FallingAsleep, a_pile_of_512_boxes_sleeps_as_a_whole) {
    using S = Bedroom<Boxes512::body_count, true, ingot::SortedTree>;
    Play<S> play(bodies_from<Boxes512::body_count>(Boxes512::body), OnEarth::gravity);
    const int steps = run_until_asleep(play, 60 * 60);
    figure("asleep after, s", steps / 60.0);
    figure("islands", play.world().asleep_island_count());
    ASSERT_GT(steps, 0);
    static ingot::World<S> before;
    (void)play.step(h);  // the last look at bounds and manifolds
    copy_world(before, play.world());
    const uint64_t hash = before.state_hash();
    for (int step_i = 0; step_i < 100; ++step_i) (void)play.step(h);
    EXPECT_EQ(play.world().state_hash(), hash);
    EXPECT_LE(play.deepest_overlap(), 1e-3);
}

}  // namespace

// SPDX-License-Identifier: MIT
// What wakes an island, all of it at once, and what leaves it asleep.
#include "scenes/stacked.h"
#include "sleep/sleepers.h"

#include <functional>

namespace {

using namespace ingot_sleep;

/// Two towers of three that sleep: bodies 1 to 3 and 4 to 6.
class TwoTowers : public ::testing::Test {
protected:
    using S = Bedroom<9>;
    void SetUp() override {
        ASSERT_TRUE(play.sound());
        ASSERT_GT(run_until_asleep(play, 120), 0);
        (void)play.step(h);
    }
    ingot::World<S>& world() { return play.world(); }
    BodyId id(int body_i) const { return play.id(body_i); }
    int awake_in(int tower_i) {
        int awake = 0;
        for (int cube_i = 1; cube_i <= 3; ++cube_i)
            awake += world().is_alive(id(3 * tower_i + cube_i)) && !world().is_asleep(id(3 * tower_i + cube_i));
        return awake;
    }
    Play<S> play{columns(2, 3), OnEarth::gravity};
};

TEST_F(TwoTowers, every_call_that_does_something_wakes_the_island_and_no_other) {
    const struct {
        const char* name;
        std::function<Status(ingot::World<S>&, BodyId)> call;
    } calls[] = {
        {"wake", [](auto& w, BodyId b) { return w.wake(b); }},
        {"set_state", [](auto& w, BodyId b) { return w.set_state(b, w.state(b).value); }},
        {"set_filter", [](auto& w, BodyId b) { return w.set_filter(b, w.filter(b).value); }},
        {"add_force", [](auto& w, BodyId b) { return w.add_force(b, {0, 0, 1}, {}); }},
        {"add_central_force", [](auto& w, BodyId b) { return w.add_central_force(b, {0, 0, 1}); }},
        {"add_torque", [](auto& w, BodyId b) { return w.add_torque(b, {0, 0, 1}); }},
        {"apply_impulse", [](auto& w, BodyId b) { return w.apply_impulse(b, {0, 0, 1}, {}); }},
        {"apply_central_impulse", [](auto& w, BodyId b) { return w.apply_central_impulse(b, {0, 0, 1}); }},
        {"apply_angular_impulse", [](auto& w, BodyId b) { return w.apply_angular_impulse(b, {0, 0, 1}); }},
    };
    static ingot::World<S> asleep;
    copy_world(asleep, world());
    for (const auto& call : calls) {
        for (int cube_i = 1; cube_i <= 3; ++cube_i) {
            copy_world(world(), asleep);
            ASSERT_EQ(call.call(world(), id(cube_i)), Status::ok) << call.name;
            EXPECT_EQ(awake_in(0), 3) << call.name;
            EXPECT_EQ(awake_in(1), 0) << call.name;
            (void)play.step(h);
            EXPECT_EQ(awake_in(0), 3) << call.name;
            EXPECT_EQ(awake_in(1), 0) << call.name;
        }
    }
}

TEST_F(TwoTowers, a_collision_by_hand_wakes_both) {
    ASSERT_EQ(world().apply_central_impulse(id(1), {0, 0, 0}), Status::ok);
    ASSERT_EQ(awake_in(1), 0);
    ASSERT_EQ(world().apply_central_impulse(id(1), {1, 0, 0}), Status::ok);
    ASSERT_TRUE(world().collide(id(4), id(1), {scalar(1.5), 0, scalar(0.5)}, {1, 0, 0}, 0).ok());
    EXPECT_EQ(awake_in(1), 3);
}

TEST_F(TwoTowers, refused_calls_change_no_byte) {
    static ingot::World<S> before;
    copy_world(before, world());
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN();
    const BodyId stale = {id(1).slot, id(1).world_tag, id(1).generation + 2}, foreign = {id(1).slot, 7, id(1).generation};
    EXPECT_EQ(world().wake(stale), Status::stale_id);
    EXPECT_EQ(world().wake({}), Status::stale_id);
    EXPECT_EQ(world().wake(foreign), Status::foreign_id);
    EXPECT_EQ(world().wake(id(0)), Status::immovable);
    EXPECT_EQ(world().sleep(stale), Status::stale_id);
    EXPECT_EQ(world().sleep(foreign), Status::foreign_id);
    EXPECT_EQ(world().sleep(id(0)), Status::immovable);
    EXPECT_FALSE(world().is_asleep(stale));
    EXPECT_FALSE(world().is_asleep(foreign));
    EXPECT_EQ(world().apply_central_impulse(id(1), {nan, 0, 0}), Status::not_finite);
    EXPECT_EQ(world().add_central_force(id(1), {nan, 0, 0}), Status::not_finite);
    EXPECT_EQ(world().set_gravity({nan, 0, 0}), Status::not_finite);
    EXPECT_EQ(world().set_gravity(OnEarth::gravity), Status::ok) << "gravity as it is";
    EXPECT_EQ(world().set_state(id(0), BodyState{{}, {1, 0, 0}, ingot::identity_matrix<scalar>(), {}}), Status::immovable);
    EXPECT_EQ(world().remove(stale), Status::stale_id);
    EXPECT_EQ(world().collide(id(1), id(4), {nan, 0, 0}, {1, 0, 0}, 0).status, Status::not_finite);
    const ingot::Result<scalar> none = world().collide(id(4), id(1), {scalar(1.5), 0, scalar(0.5)}, {1, 0, 0}, 0);
    EXPECT_TRUE(none.ok() && none.value == 0) << "a collision of what is at rest";
    EXPECT_TRUE(same_world(world(), before));
}

TEST_F(TwoTowers, gravity_that_turns_wakes_all) {
    static ingot::World<S> before;
    copy_world(before, world());
    for (const Vector& more : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) {
        copy_world(world(), before);
        ASSERT_EQ(world().set_gravity(OnEarth::gravity + more), Status::ok);
        EXPECT_EQ(world().asleep_count(), 0);
    }
}

/// A cube that freezes where it stands is no more asleep than awake: nobody can wake it, and what it stood on can be moved without it.
TEST_F(TwoTowers, one_that_freezes_is_left_out) {
    ASSERT_EQ(world().wake(id(1)), Status::ok);
    ASSERT_EQ(world().add_torque(id(1), {0, 0, ingot::limits::torque_max}), Status::ok);
    EXPECT_EQ(play.step(h).bodies_frozen, 1);
    ASSERT_TRUE(world().is_frozen(id(1)));
    EXPECT_FALSE(world().is_asleep(id(1)));
    EXPECT_EQ(world().wake(id(1)), Status::frozen);
    EXPECT_EQ(world().sleep(id(1)), Status::frozen);
    const BodyState frozen = play.state(1);
    ASSERT_EQ(awake_in(1), 0);
    ASSERT_EQ(world().set_state(id(0), play.state(0)), Status::ok);
    EXPECT_EQ(awake_in(1), 3) << "the other tower's ground was moved";
    play.run(h, 2);
    EXPECT_TRUE(same_bits(play.state(1), frozen));
    EXPECT_TRUE(world().is_asleep(id(2)) && world().is_asleep(id(3))) << "on the frozen one";
    EXPECT_EQ(awake_in(1), 0);
}

TEST_F(TwoTowers, another_gravity_wakes_all_and_what_is_up_falls_down) {
    ASSERT_EQ(world().set_gravity({0, 0, standard_gravity}), Status::ok);
    EXPECT_EQ(world().asleep_count(), 0);
    play.run(h, 1);
    // All rise freely: g t^2 / 2 of 1 s, each step rounded to an ulp of 8 m.
    for (int body_i = 1; body_i <= 6; ++body_i)
        EXPECT_NEAR(play.moved(body_i).z(), 9.81 / 2, 60 * 8 * static_cast<double>(ingot::epsilon) + 1e-3) << body_i;
}

TEST_F(TwoTowers, removing_the_lowest_cube_drops_the_others) {
    ASSERT_EQ(world().remove(id(1)), Status::ok);
    EXPECT_EQ(awake_in(0), 2);
    EXPECT_EQ(awake_in(1), 0);
    for (int step_i = 0; step_i < 180; ++step_i) (void)play.step(h);
    EXPECT_NEAR(play.r(2).z(), 0.5, 1e-3);
    EXPECT_NEAR(play.r(3).z(), 1.5, 1e-3);
    EXPECT_EQ(awake_in(0), 0) << "and they sleep again";
}

TEST_F(TwoTowers, removing_the_ground_drops_all) {
    ASSERT_EQ(world().remove(id(0)), Status::ok);
    EXPECT_EQ(world().asleep_count(), 0);
    play.run(h, 1);
    EXPECT_LT(play.r(1).z(), -4);
    EXPECT_LT(play.r(4).z(), -4);
}

TEST_F(TwoTowers, a_slot_that_is_used_again_is_another_body) {
    const BodyId old = id(3);
    ASSERT_EQ(world().remove(old), Status::ok);
    ingot::BodyDef def = unit_cube({30, 0, scalar(0.5)}, scalar(0.6)).def;
    const BodyId fresh = world().add(def).value;
    ASSERT_EQ(fresh.slot, old.slot);
    EXPECT_FALSE(world().is_asleep(old));
    EXPECT_FALSE(world().is_asleep(fresh));
    EXPECT_EQ(world().wake(old), Status::stale_id);
    for (int step_i = 0; step_i < 120; ++step_i) (void)ingot::step(world(), h);
    EXPECT_TRUE(world().is_asleep(fresh));
    EXPECT_EQ(world().asleep_island_count(), 3);
    ASSERT_EQ(world().wake(fresh), Status::ok);
    EXPECT_EQ(world().asleep_count(), 5) << "it has nothing to do with the tower that its slot was of";
}

TEST_F(TwoTowers, removing_one_that_sleeps_alone_is_seen) {
    const BodyId fresh = world().add(unit_cube({30, 0, scalar(0.5)}, scalar(0.6)).def).value;
    for (int step_i = 0; step_i < 120; ++step_i) (void)ingot::step(world(), h);
    ASSERT_TRUE(world().is_asleep(fresh));
    ASSERT_EQ(world().remove(fresh), Status::ok);
    EXPECT_EQ(world().asleep_count(), 6);
    EXPECT_EQ(ingot::step(world(), h).contacts, 6);
    EXPECT_EQ(world().asleep_count(), 6);
}

TEST_F(TwoTowers, what_is_added_or_moved_next_to_them_wakes_them) {
    static ingot::World<S> asleep;
    copy_world(asleep, world());
    // 1 cm from the first tower: nearer than limits::contact_margin.
    ASSERT_TRUE(world().add(unit_cube({scalar(-1.01), 0, scalar(0.5)}, scalar(0.6)).def).ok());
    (void)play.step(h);
    EXPECT_EQ(awake_in(0), 3);
    EXPECT_EQ(awake_in(1), 0);

    // An immovable box that was far away pushes into the second tower.
    copy_world(world(), asleep);
    const BodyId wall = world().add(fixed_box({scalar(0.5), scalar(0.5), scalar(0.5)}, {20, 0, scalar(0.5)}, scalar(0.6)).def).value;
    for (int step_i = 0; step_i < 3; ++step_i) (void)play.step(h);
    ASSERT_EQ(world().asleep_count(), 6) << "far away it wakes nobody";
    BodyState state = world().state(wall).value;
    state.r_CM.x = scalar(3.95);
    ASSERT_EQ(world().set_state(wall, state), Status::ok);
    (void)play.step(h);
    EXPECT_EQ(awake_in(0), 0);
    EXPECT_EQ(awake_in(1), 3);
    play.run(h, 2);
    EXPECT_LT(play.r(4).x(), 2.97) << "pushed aside by 5 cm, but for what is taken back later";
}

TEST_F(TwoTowers, a_filter_that_lets_go_of_the_ground_drops_what_stood_on_it) {
    ASSERT_EQ(world().set_filter(id(0), {1, 0}), Status::ok);
    EXPECT_EQ(world().asleep_count(), 0);
    play.run(h, 1);
    EXPECT_LT(play.r(1).z(), -4);
}

/// A lift under a box, moved by hand.
TEST_F(TwoTowers, what_was_woken_stays_up_for_the_time) {
    ASSERT_EQ(world().wake(id(1)), Status::ok);
    ASSERT_EQ(awake_in(0), 3);
    EXPECT_GE(run_until_asleep(play, 2 * steps_to_sleep), steps_to_sleep - 1);
}

/// A body in the first slot, met by the first pair there is.
TEST(Waking, the_first_of_all_is_woken_by_what_meets_it_and_by_gravity) {
    std::vector<PlacedBody> balls = {solid_ball(1, scalar(0.5), {}, 0), solid_ball(1, scalar(0.5), {3, 0, 0}, 0)};
    balls[1].move({-2, 0, 0});
    Play<Bedroom<2>> play(balls, {});
    play.run(h, 0.9);  // they meet after 1 s
    ASSERT_TRUE(play.world().is_asleep(play.id(0)));
    play.run(h, 0.3);
    EXPECT_FALSE(play.world().is_asleep(play.id(0)));
    EXPECT_LT(play.state(0).v_CM.x, -scalar(0.9)) << "without restitution they go on together";

    balls.pop_back();
    Play<Bedroom<2>> alone(balls, {});
    ASSERT_GT(run_until_asleep(alone, 2 * steps_to_sleep), 0);
    ASSERT_EQ(alone.world().set_gravity({0, 0, -1}), Status::ok);
    EXPECT_FALSE(alone.world().is_asleep(alone.id(0)));
}

TEST(Waking, a_support_that_is_moved_away_or_up_takes_the_sleeper_along) {
    std::vector<PlacedBody> bodies = {fixed_box({1, 1, scalar(0.5)}, {}, 1), unit_cube({0, 0, 1}, 1)};
    Play<Bedroom<2>> play(bodies, OnEarth::gravity);
    ASSERT_GT(run_until_asleep(play, 120), 0);
    BodyState lift = play.state(0);
    lift.r_CM.z += scalar(0.01);
    ASSERT_EQ(play.world().set_state(play.id(0), lift), Status::ok);
    EXPECT_FALSE(play.world().is_asleep(play.id(1)));
    play.run(h, 2);
    EXPECT_TRUE(play.world().is_asleep(play.id(1)));
    EXPECT_NEAR(play.r(1).z(), 1.01, 1e-3);
    lift.r_CM.x = 10;
    ASSERT_EQ(play.world().set_state(play.id(0), lift), Status::ok);
    play.run(h, 1);
    EXPECT_LT(play.r(1).z(), -3);
}

TEST(Waking, a_ball_that_rolls_against_a_box_wakes_it_and_pushes_it) {
    const auto scene = [](bool rolls) {
        std::vector<PlacedBody> bodies = {flat_ground(scalar(0.3)), unit_cube({0, 0, scalar(0.5)}, scalar(0.3)),
                                          solid_ball(1, scalar(0.5), {-6, 0, scalar(0.5)}, scalar(0.3))};
        if (rolls) bodies[2].move({3, 0, 0}, {0, 6, 0});
        return bodies;
    };
    Play<Bedroom<3>> play(scene(true), OnEarth::gravity);
    Play<Bedroom<3, false>> twin(scene(true), OnEarth::gravity);
    bool slept = false;
    int woke_at = 0;
    for (int step_i = 1; step_i <= 240; ++step_i) {
        const bool asleep = play.world().is_asleep(play.id(1));
        slept = slept || asleep;
        (void)play.step(h);
        (void)twin.step(h);
        if (asleep && !play.world().is_asleep(play.id(1))) woke_at = step_i;
    }
    EXPECT_TRUE(slept);
    // 5 m at 3 m/s: 100 steps. It wakes when they may meet within a step.
    EXPECT_GE(woke_at, 98);
    EXPECT_LE(woke_at, 101);
    EXPECT_GT(play.r(1).x(), 0.05) << "pushed";
    // The same but for the motion that sleep took from the box, below sleep_speed; it slides on for v / (mu g) s at most.
    EXPECT_NEAR(play.r(1).x(), twin.r(1).x(), sleep_speed * 3 / (0.3 * 9.81) + sleep_speed);
}

/// The impulse drives the top cube over the one below, v^2 / (2 mu g) = 8 cm far.
TEST(Waking, a_tower_that_slept_moves_as_one_that_never_did) {
    Play<Bedroom<11>> play(columns(1, 10), OnEarth::gravity);
    Play<Bedroom<11, false>> twin(columns(1, 10), OnEarth::gravity);
    for (int step_i = 0; step_i < 300; ++step_i) {
        (void)play.step(h);
        (void)twin.step(h);
    }
    ASSERT_EQ(play.world().asleep_count(), 10);
    double differ = 0;
    for (int body_i = 1; body_i <= 10; ++body_i) differ = std::max(differ, (play.r(body_i) - twin.r(body_i)).norm());
    figure("apart after 5 s, m", differ);
    // 4.5 s of what a resting tower does, less than what limits::settled_speed leaves: 4 of it in a step.
    EXPECT_LE(differ, 4.5 * 4 * static_cast<double>(ingot::limits::settled_speed) + 1e-6);

    const scalar j = 1;
    ASSERT_EQ(play.world().apply_central_impulse(play.id(10), {j, 0, 0}), Status::ok);
    ASSERT_EQ(twin.world().apply_central_impulse(twin.id(10), {j, 0, 0}), Status::ok);
    for (int step_i = 0; step_i < 120; ++step_i) {
        (void)play.step(h);
        (void)twin.step(h);
    }
    double apart = 0;
    for (int body_i = 1; body_i <= 10; ++body_i) apart = std::max(apart, (play.r(body_i) - twin.r(body_i)).norm());
    figure("apart 2 s after the impulse, m", apart);
    figure("the top went, m", play.r(10).x());
    EXPECT_GT(play.r(10).x(), 0.05);
    // v differs by what sleep took, below sleep_speed: v dv / (mu g), and the same again for the cubes below that are dragged along.
    EXPECT_LE(apart, 2 * 1 * sleep_speed / (0.6 * 9.81) + differ);
}

/// The scene of the golden hashes: when it ends, the tower that was hit moves and two sleep.
TEST(Waking, the_golden_scene_holds_sleepers_and_others) {
    static ingot::World<SleepingTowers> world;
    std::memset(static_cast<void*>(&world), 0, sizeof world);
    ASSERT_EQ(set_up(world), Status::ok);
    int most_islands = 0;
    for (int step_i = 0; step_i < SleepingTowers::golden_steps; ++step_i) {
        (void)ingot::step(world, SleepingTowers::h);
        most_islands = std::max(most_islands, world.asleep_island_count());
    }
    EXPECT_EQ(most_islands, 3);
    EXPECT_EQ(world.asleep_island_count(), 2);
    EXPECT_EQ(world.asleep_count(), 8);
}

/// What is hit in the same step by something fast meets what sleeps next to it, and wakes it before.
TEST(Waking, what_is_hit_between_two_steps_does_not_pass_through_a_sleeper) {
    std::vector<PlacedBody> bodies = {flat_ground(scalar(0.5)), unit_cube({0, 0, scalar(0.5)}, scalar(0.5)),
                                      unit_cube({scalar(1.01), 0, scalar(0.5)}, scalar(0.5)), solid_ball(100, scalar(0.5), {-10, 0, scalar(0.5)}, 0)};
    bodies[3].move({5, 0, 0});
    Play<Bedroom<4>> play(bodies, OnEarth::gravity);
    double deepest = 0;
    bool slept = false;
    for (int step_i = 0; step_i < 200; ++step_i) {
        slept = slept || play.world().asleep_count() == 2;
        (void)play.step(h);
        deepest = std::max(deepest, play.overlap(1, 2));
    }
    figure("deepest overlap, m", deepest);
    EXPECT_TRUE(slept);
    EXPECT_GT(play.r(2).x(), 2);
    EXPECT_LE(deepest, 0.01) << "a step of the ball is 8 cm";
}

}  // namespace

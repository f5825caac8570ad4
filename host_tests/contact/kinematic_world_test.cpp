// SPDX-License-Identifier: MIT
// Kinematic bodies as a world has them: exact motion, goals, kinds, refusals, sleep, islands, company, snapshots, events, queries.
#include "kinematic.h"

namespace {

using namespace kinematic;

template <class S>
struct InWorld : testing::Test {};
using Scenes = BriefTypes<5, SweptAsleep, HybridFast, LightFast, Rich, Impacts, Swept, Hybrid, Light, SweptFast>;
TYPED_TEST_SUITE(InWorld, Scenes);

double distance(const Matrix& A, const Matrix& B) { return std::fmax(std::fmax(length(A.c0 - B.c0), length(A.c1 - B.c1)), length(A.c2 - B.c2)); }
template <class S>
std::vector<uint8_t> saved(const World<S>& world) {
    std::vector<uint8_t> bytes(snapshot_size<S>());
    bytes.resize(save_snapshot(world, bytes.data(), bytes.size()).value);
    return bytes;
}
template <class S>
std::vector<uint8_t> bytes_of(const World<S>& world) {
    const auto* const begin = reinterpret_cast<const uint8_t*>(&world);
    return {begin, begin + sizeof world};
}

/// r_CM along a line and A by exp(omega t). v h and omega h are rounded once, the same in every step: a rounding of the way and of the angle, and one
/// more of 1/rate. sin and 1 - cos of half of the angle are right to a rounding each, and so is each product: four roundings of the angle in all.
/// Sums are compensated, so what is left is a rounding of the place, and of A some of its columns' length.
TYPED_TEST(InWorld, a_body_goes_exactly_on_its_way) {
    for (const int rate : rates) {
        World<TypeParam>& world = empty_world<TypeParam>();
        const Vector r = {100, -30, 7}, v = {scalar(1.6), scalar(0.001), scalar(-3)}, omega = {scalar(0.3), -2, scalar(1.1)};
        const BodyId id = add(world, platform({1, 1, 1}, {r, identity_matrix<scalar>()}, {v, omega}));
        const int steps = 20 * rate;
        for (int i = 0; i < steps; ++i) (void)step(world, scalar(1) / of(rate));
        const double way = 20 * length(v), angle = 20 * length(omega), eps = static_cast<double>(epsilon);
        EXPECT_LT(length(state(world, id).r_CM - (r + v * 20)), 4 * eps * (way + length(r))) << rate;
        const Matrix A = axis_angle(omega * (1 / of(length(omega))), of(angle));
        EXPECT_LT(distance(state(world, id).A, A), 8 * eps * angle + 16 * eps) << rate;
        EXPECT_LT(orthogonality_error(state(world, id).A), 16 * epsilon) << rate;
        EXPECT_EQ(length(world.omega(id).value - omega), 0);
    }
}
TYPED_TEST(InWorld, a_goal_is_reached_to_the_bit_and_held) {
    for (const int rate : rates) {
        for (int k = 0; k < 20; ++k) {
            World<TypeParam>& world = empty_world<TypeParam>();
            const BodyId id = add(world, platform({1, 1, 1}, {{1, 2, 3}, axis_angle({1, 0, 0}, of(0.3 * k))}));
            const Vector r = {of(0.1 * k), of(-5 + k), of(1.0 / (1 + k))};
            const Matrix A = axis_angle({0, scalar(0.6), scalar(0.8)}, of(0.7 * k - 5));
            ASSERT_EQ(world.move_to(id, r, A), Status::ok);
            for (int i = 0; i < 3; ++i) {
                (void)step(world, scalar(1) / of(rate));
                EXPECT_EQ(length(state(world, id).r_CM - r), 0) << rate;
                EXPECT_EQ(distance(state(world, id).A, nearest_rotation(A)), 0) << rate;
                EXPECT_EQ(length(state(world, id).v_CM) + length(world.omega(id).value), 0);
            }
        }
    }
}
TYPED_TEST(InWorld, the_kinds_of_bodies_change_into_each_other) {
    World<TypeParam>& world = empty_world<TypeParam>();
    const BodyDef def = ball(scalar(0.25), {0, 0, 5});
    const BodyId id = add(world, def);
    EXPECT_FALSE(world.is_kinematic(id));
    EXPECT_EQ(world.set_velocity(id, {1, 0, 0}), Status::immovable);
    EXPECT_EQ(world.move_to(id, {}, identity_matrix<scalar>()), Status::immovable);
    ASSERT_EQ(world.set_kinematic(id), Status::ok);
    EXPECT_TRUE(world.is_kinematic(id) && !world.is_movable(id));
    (void)step(world, scalar(1) / 60);
    EXPECT_EQ(state(world, id).r_CM.z, 5);  // no gravity
    EXPECT_EQ(world.apply_central_impulse(id, {1, 0, 0}), Status::immovable);
    EXPECT_EQ(world.add_central_force(id, {1, 0, 0}), Status::immovable);
    ASSERT_EQ(world.set_velocity(id, {60, 0, 0}, {0, 0, 1}), Status::ok);
    (void)step(world, scalar(1) / 60);
    EXPECT_NEAR(state(world, id).r_CM.x, 1, 1e-6);
    EXPECT_EQ(world.mass(id).value, 0);
    EXPECT_EQ(static_cast<double>(world.kinetic_energy()) + length(world.linear_momentum()) + length(world.angular_momentum()), 0);
    ASSERT_EQ(world.set_state(id, state(world, id)), Status::ok);  // what is read can be set: nothing changes
    EXPECT_EQ(state(world, id).v_CM.x, 60);
    EXPECT_EQ(world.omega(id).value.z, 1);
    ASSERT_EQ(world.set_immovable(id), Status::ok);
    EXPECT_FALSE(world.is_kinematic(id));
    (void)step(world, scalar(1) / 60);
    EXPECT_NEAR(state(world, id).r_CM.x, 1, 1e-6);
    ASSERT_EQ(world.set_kinematic(id), Status::ok);
    ASSERT_EQ(world.set_velocity(id, {60, 0, 0}), Status::ok);
    ASSERT_EQ(world.set_movable(id, def.mass), Status::ok);
    EXPECT_FALSE(world.is_kinematic(id));
    EXPECT_EQ(length(state(world, id).v_CM), 0);
    (void)step(world, scalar(1) / 60);
    EXPECT_LT(state(world, id).r_CM.z, 5);
    ASSERT_EQ(world.set_kinematic(id), Status::ok);
    ASSERT_EQ(world.remove(id), Status::ok);
    EXPECT_EQ(world.set_velocity(id, {}), Status::stale_id);
    EXPECT_FALSE(world.is_kinematic(add(world, def)));  // in the slot that was left
}
TYPED_TEST(InWorld, bad_input_is_refused_and_changes_no_bit) {
    World<TypeParam>& world = empty_world<TypeParam>();
    const BodyId id = add(world, platform({1, 1, 1}, {}, {{1, 0, 0}, {0, 1, 0}}));
    (void)add(world, ball(scalar(0.25), {0, 0, scalar(1.3)}));
    BodyDef fixed = ball(scalar(0.25), {0, 9, 0});
    fixed.immovable = true;
    const BodyId wall = add(world, fixed);
    for (int i = 0; i < 3; ++i) (void)step(world, scalar(1) / 60);
    const std::vector<uint8_t> before = bytes_of(world);
    const scalar nan = std::nanf(""), far = limits::position_max * 2, fast = limits::speed_max * 2, spin = limits::spin_max * 2;
    const Matrix one = identity_matrix<scalar>(), none = {{1, 0, 0}, {0, 1, 0}, {0, 0, 2}};
    EXPECT_EQ(world.set_velocity(id, {nan, 0, 0}), Status::not_finite);
    EXPECT_EQ(world.set_velocity(id, {}, {0, nan, 0}), Status::not_finite);
    EXPECT_EQ(world.set_velocity(id, {0, fast, 0}), Status::out_of_range);
    EXPECT_EQ(world.set_velocity(id, {}, {spin, 0, 0}), Status::out_of_range);
    EXPECT_EQ(world.set_velocity(wall, {1, 0, 0}), Status::immovable);
    EXPECT_EQ(world.set_velocity({}, {1, 0, 0}), Status::stale_id);
    EXPECT_EQ(world.move_to(id, {nan, 0, 0}, one), Status::not_finite);
    EXPECT_EQ(world.move_to(id, {far, 0, 0}, one), Status::out_of_range);
    EXPECT_EQ(world.move_to(id, {}, none), Status::not_a_rotation);
    EXPECT_EQ(world.move_to(id, {}, {{nan, 0, 0}, {0, 1, 0}, {0, 0, 1}}), Status::not_finite);
    EXPECT_EQ(world.move_to(wall, {}, one), Status::immovable);
    EXPECT_EQ(world.set_kinematic({}), Status::stale_id);
    EXPECT_EQ(world.set_state(id, {{}, {fast, 0, 0}, one, {}}), Status::out_of_range);
    EXPECT_EQ(world.set_state(id, {{}, {}, one, {0, 0, nan}}), Status::not_finite);
    EXPECT_EQ(world.set_state(id, {{far, 0, 0}, {}, one, {}}), Status::out_of_range);
    EXPECT_EQ(world.set_state(wall, {{}, {1, 0, 0}, one, {}}), Status::immovable);
    EXPECT_EQ(world.set_shape(id, HalfSpace{{0, 0, 1}, 0}), Status::bad_shape);
    EXPECT_EQ(world.set_mass(id, ball(1, {}).mass), Status::immovable);
    BodyDef def = platform({1, 1, 1}, {}, {{fast, 0, 0}, {}});
    EXPECT_EQ(world.add(def).status, Status::out_of_range);
    def = platform({1, 1, 1}, {}, {{}, {nan, 0, 0}});
    EXPECT_EQ(world.add(def).status, Status::not_finite);
    def = platform({1, 1, 1});
    def.shape = HalfSpace{{0, 0, 1}, 0};
    EXPECT_EQ(world.add(def).status, Status::bad_shape);
    def = platform({1, 1, 1});
    def.immovable = true;
    EXPECT_EQ(world.add(def).status, Status::immovable);
    EXPECT_EQ(bytes_of(world), before);
}
struct WithoutKinematic : Swept {
    static constexpr bool kinematic_bodies = false;
};
TEST(KinematicBodies, are_no_bodies_of_a_scene_that_does_not_name_them) {
    World<WithoutKinematic>& world = empty_world<WithoutKinematic>();
    EXPECT_EQ(world.add(platform({1, 1, 1})).status, Status::not_in_scene);
    EXPECT_EQ(world.body_count(), 0);
}
/// At the ends of their ranges: what is far stays there, what spins beyond the cut spins, and nothing is lost.
TYPED_TEST(InWorld, extremes_stay_finite) {
    World<TypeParam>& world = empty_world<TypeParam>();
    const Vector edge = {limits::position_max, 0, 0};
    const BodyId out = add(world, platform({1, 1, 1}, {edge, identity_matrix<scalar>()}, {{limits::speed_max, 0, 0}, {}}));
    const BodyId top = add(world, platform({1, 1, 1}, {}, {{}, {limits::spin_max, limits::spin_max, 0}}));
    const BodyId id = add(world, ball(scalar(0.25), {0, 0, scalar(2.2)}));
    ASSERT_EQ(world.move_to(add(world, platform({1, 1, 1}, {{0, 50, 0}, identity_matrix<scalar>()})), -edge, identity_matrix<scalar>()), Status::ok);
    for (const scalar h : {scalar(1), scalar(1) / 60, limits::step_min, scalar(0.25)}) {
        for (int i = 0; i < 5; ++i) (void)step(world, h);
        EXPECT_EQ(state(world, out).r_CM.x, edge.x);
        EXPECT_LT(orthogonality_error(state(world, top).A), 64 * epsilon);
        EXPECT_TRUE(is_finite(state(world, id).r_CM) || world.is_frozen(id));
    }
}
TYPED_TEST(InWorld, kinematic_and_immovable_bodies_have_no_contacts) {
    World<TypeParam>& world = empty_world<TypeParam>();
    (void)add(world, platform({1, 1, 1}, {}, {{1, 0, 0}, {}}));
    (void)add(world, platform({1, 1, 1}, {{scalar(0.5), 0, 0}, identity_matrix<scalar>()}, {{-1, 0, 0}, {1, 0, 0}}));
    BodyDef fixed = platform({1, 1, 1});
    fixed.kinematic = false;
    fixed.immovable = true;
    (void)add(world, fixed);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(step(world, scalar(1) / 60).contacts, 0);
}
/// A platform that moves where nobody is: the bits of all others are those of a world without it, which has an immovable body in its slot.
TYPED_TEST(InWorld, one_that_is_far_away_changes_no_bit) {
    World<TypeParam>*const worlds[2] = {&empty_world<TypeParam>(0), &empty_world<TypeParam>(1)};
    std::vector<BodyId> ids;
    for (int which = 0; which < 2; ++which) {
        World<TypeParam>& world = *worlds[which];
        BodyDef floor = platform({5, 5, scalar(0.5)}, {{0, 0, scalar(-0.5)}, identity_matrix<scalar>()});
        floor.kinematic = false;
        floor.immovable = true;
        (void)add(world, floor);
        BodyDef far = platform({1, 1, 1}, {{500, 0, 0}, identity_matrix<scalar>()}, {{0, 0, 3}, {1, 2, 3}});
        if (which == 1) far.kinematic = false, far.immovable = true, far.state = BodyState{};
        if (which == 1) far.state.r_CM = {500, 0, 0};
        (void)add(world, far);
        ids.clear();
        for (int i = 0; i < 5; ++i) ids.push_back(add(world, ball(scalar(0.2), {of(0.3 * i), of(0.01 * i), of(0.25 + 0.1 * i)}, {1, 0, 0})));
    }
    for (int i = 0; i < 240; ++i) {
        (void)step(*worlds[0], scalar(1) / 60);
        (void)step(*worlds[1], scalar(1) / 60);
        for (const BodyId id : ids) {
            const BodyState a = state(*worlds[0], id), b = state(*worlds[1], id);
            ASSERT_EQ(std::memcmp(&a, &b, sizeof a), 0) << i;
        }
    }
}
/// Two stacks on one turntable are two islands: each goes as alone on it, to the bit.
TYPED_TEST(InWorld, what_one_platform_carries_stays_apart) {
    World<TypeParam>*const worlds[2] = {&empty_world<TypeParam>(0), &empty_world<TypeParam>(1)};
    BodyId ids[2] = {};
    for (int which = 0; which < 2; ++which) {
        (void)add(*worlds[which], platform({2, 2, scalar(0.1)}, {}, {{0, 0, scalar(0.5)}, {0, scalar(0.01), 1}}));
        for (int i = 0; i < 3; ++i) ids[i % 2] = add(*worlds[which], ball(scalar(0.1), {1, 0, of(0.21 + 0.2 * i)}));
        if (which == 0)
            for (int i = 0; i < 4; ++i) (void)add(*worlds[which], ball(scalar(0.12), {-1, of(0.01 * i), of(0.23 + 0.24 * i)}));
    }
    for (int i = 0; i < 120; ++i) {
        (void)step(*worlds[0], scalar(1) / 60);
        (void)step(*worlds[1], scalar(1) / 60);
        for (const BodyId id : ids) {
            const BodyState a = state(*worlds[0], id), b = state(*worlds[1], id);
            ASSERT_EQ(std::memcmp(&a, &b, sizeof a), 0) << i;
        }
    }
}
/// A world that is saved on the way goes on to the same bits: with a velocity, and from goal to goal.
TYPED_TEST(InWorld, a_snapshot_goes_on_as_if_never_left) {
    World<TypeParam>&world = empty_world<TypeParam>(0), &loaded = empty_world<TypeParam>(1);
    const BodyId lift = add(world, platform({1, 1, scalar(0.1)}, {}, {{0, 0, 1}, {0, 0, 2}}));
    const BodyId swing = add(world, platform({1, 1, scalar(0.1)}, {{5, 0, 0}, identity_matrix<scalar>()}));
    for (int i = 0; i < 6; ++i) (void)add(world, ball(scalar(0.1), {of(i % 2 * 5), 0, of(0.21 + 0.1 * i)}));
    for (int i = 0; i < 90; ++i) {
        const Vector goal = {5 + of(0.001 * i * i), 0, 0};
        ASSERT_EQ(world.move_to(swing, goal, identity_matrix<scalar>()), Status::ok);
        if (i % 10 == 5) {
            const std::vector<uint8_t> bytes = saved(world);
            ASSERT_EQ(load_snapshot(loaded, bytes.data(), bytes.size()), Status::ok);
            ASSERT_EQ(loaded.state_hash(), world.state_hash());
            ASSERT_EQ(saved(loaded), bytes);
        } else if (i > 5) {
            ASSERT_EQ(loaded.move_to(swing, goal, identity_matrix<scalar>()), Status::ok);
        }
        (void)step(world, scalar(1) / 60);
        if (i < 5) continue;
        (void)step(loaded, scalar(1) / 60);
        ASSERT_EQ(loaded.state_hash(), world.state_hash()) << i;
    }
    const uint64_t hash = world.state_hash();
    ASSERT_EQ(world.set_velocity(lift, {0, 0, 2}, {0, 0, 2}), Status::ok);
    EXPECT_NE(world.state_hash(), hash);
}

template <class S>
struct Sleeping : testing::Test {};
using SleepingScenes = testing::Types<SweptAsleep, HybridFast>;
TYPED_TEST_SUITE(Sleeping, SleepingScenes);

TYPED_TEST(Sleeping, one_that_stands_lets_sleep_and_one_that_moves_wakes) {
    World<TypeParam>& world = empty_world<TypeParam>();
    const BodyId lift = add(world, platform({1, 1, scalar(0.1)}));
    const BodyId id = add(world, cube(scalar(0.1), {{0, 0, scalar(0.2)}, identity_matrix<scalar>()}));
    const BodyId door = add(world, platform({scalar(0.1), 1, 1}, {{3, 0, scalar(0.2)}, identity_matrix<scalar>()}));
    for (int i = 0; i < 120; ++i) (void)step(world, scalar(1) / 60);
    EXPECT_TRUE(world.is_asleep(id));
    ASSERT_EQ(world.set_velocity(lift, {0, 0, scalar(0.001)}), Status::ok);  // slower than what sleeps may be
    for (int i = 0; i < 240; ++i) {
        (void)step(world, scalar(1) / 60);
        ASSERT_FALSE(world.is_asleep(id)) << i;
    }
    EXPECT_NEAR(state(world, id).r_CM.z, 0.204, 1e-6);
    ASSERT_EQ(world.set_velocity(lift, {}), Status::ok);
    for (int i = 0; i < 120; ++i) (void)step(world, scalar(1) / 60);
    EXPECT_TRUE(world.is_asleep(id));
    ASSERT_EQ(world.set_velocity(door, {-1, 0, 0}), Status::ok);
    for (int i = 0; i < 60; ++i) (void)step(world, scalar(1) / 60);
    EXPECT_TRUE(world.is_asleep(id));  // it is still a metre away
    for (int i = 0; i < 150; ++i) (void)step(world, scalar(1) / 60);
    EXPECT_FALSE(world.is_asleep(id));
    EXPECT_LT(state(world, id).r_CM.x, -0.3);
}
/// A blade of 60 rad/s, a radian a step, comes by a ball that sleeps: it is woken and hit. (1 + e) omega s, and 2 % as in kinematic_test.
TEST(SleepingFast, a_flipper_wakes_and_throws_what_sleeps_in_its_way) {
    World<HybridFast>& world = empty_world<HybridFast>();
    (void)add(world, platform({2, 2, scalar(0.1)}, {{0, 0, scalar(-0.5)}, identity_matrix<scalar>()}));
    BodyDef blade = platform({1, scalar(0.05), scalar(0.2)}, {{0, 0, scalar(-0.15)}, identity_matrix<scalar>()});
    BodyDef hit = ball(scalar(0.1), {0, scalar(0.8), scalar(-0.3)});
    blade.restitution = scalar(0.75);
    blade.friction = 0;
    const BodyId flipper = add(world, blade), id = add(world, hit);
    for (int i = 0; i < 120; ++i) (void)step(world, scalar(1) / 60);
    ASSERT_TRUE(world.is_asleep(id));
    ASSERT_EQ(world.set_velocity(flipper, {}, {0, 0, 60}), Status::ok);
    for (int i = 0; i < 3; ++i) (void)step(world, scalar(1) / 60);
    const double wanted = 1.75 * 60 * std::sqrt(0.8 * 0.8 - 0.15 * 0.15);
    EXPECT_NEAR(length(state(world, id).v_CM), wanted, 0.02 * wanted);
}

TEST(KinematicBodies, are_told_by_events_sensors_and_queries) {
    World<Rich>& world = empty_world<Rich>();
    const BodyId lift = add(world, platform({1, 1, scalar(0.1)}, {}, {{0, 0, 3}, {}})), id = add(world, ball(scalar(0.1), {0, 0, scalar(1)}));
    BodyDef gate = platform({1, 1, scalar(0.1)}, {{0, 0, scalar(0.5)}, identity_matrix<scalar>()}, {{0, 0, 3}, {}});
    gate.sensor = true;
    const BodyId sensor = add(world, gate);
    int begins = 0, hits = 0, enters = 0;
    for (int i = 0; i < 30; ++i) {
        (void)step(world, scalar(1) / 60);
        for (const Event& event : world.events()) {
            begins += event.kind == EventKind::begin;
            enters += event.kind == EventKind::enter && (event.A == sensor || event.B == sensor);
            if (event.kind != EventKind::hit) continue;
            ++hits;
            EXPECT_NEAR(event.speed, std::sqrt(9 + 2 * 9.8125 * 0.8), 9.8125 / 60);  // 0.8 m were between them; a step is so much of it
        }
    }
    EXPECT_EQ(begins, 1);
    EXPECT_EQ(hits, 1);
    EXPECT_EQ(enters, 1);
    const Result<QueryHit> below = world.cast_ray({0, scalar(0.5), -9}, {0, 0, 20});
    ASSERT_EQ(below.status, Status::ok);
    EXPECT_TRUE(below.value.body == lift);
    EXPECT_NEAR(below.value.P.z, 1.5 - 0.1, 1e-5);  // where it is by now
    EXPECT_TRUE(world.contacts_of(id).begin() != world.contacts_of(id).end());
}

}  // namespace

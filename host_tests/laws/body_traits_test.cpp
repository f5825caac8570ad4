// SPDX-License-Identifier: MIT
// What a body may have beside mass and state: damping, forces in its own axes, a word of its user. Laws of each; kept by snapshots; without a trace
// in scenes that do not name them.
#include <ingot/ingot.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "reference/brief_types.h"
#include "reference/kernel_types.h"
#include "reference/measure.h"
#include "reference/random_input.h"

namespace {

using namespace ingot;
using ingot_reference::RandomInput;
using ingot_reference::to_eigen;
using ingot_reference::to_matrix;
using ingot_reference::to_vector;

constexpr double u = static_cast<double>(ingot_reference::roundoff<scalar>);
constexpr scalar g = scalar(9.8125);

struct Free : Scene {
    static constexpr int max_bodies = 5;
    static constexpr bool translates = true;
};
struct Named : Free {
    static constexpr bool body_forces = true, damping = true, user_data = true;
};
struct Piled : Named {
    static constexpr int max_manifolds = 16;
    using shapes = Shapes<Sphere, Box, HalfSpace>;
};
struct Sleeping : Piled {
    static constexpr bool sleeps = true;
};
struct Light : Piled {
    static constexpr bool bounces = false;
    using solver = SequentialImpulses;
};
struct Direct : Piled {
    using solver = HybridIslands<8>;
};
struct Fast : Piled {
    static constexpr bool continuous = true;
};
struct Bouncing : Named {
    static constexpr int max_contacts = 8;
    using solver = FrictionlessImpacts;
    using shapes = Shapes<Sphere, HalfSpace>;
};
struct InField : Named {
    using force_field = Spring;  // of no stiffness: forces are constant over its step
};

BodyDef ball(const Vector& r_CM, scalar M = 2) {
    BodyDef def;
    def.mass = {M, {M, M, M}, {}, identity_matrix<scalar>()};
    def.state.r_CM = r_CM;
    return def;
}
template <class S>
World<S>& empty_world() {
    static World<S> world;
    std::memset(static_cast<void*>(&world), 0, sizeof world);
    return world;
}
template <class S>
std::vector<uint8_t> saved(const World<S>& world) {
    std::vector<uint8_t> bytes(snapshot_size<S>());
    bytes.resize(save_snapshot(world, bytes.data(), bytes.size()).value);
    return bytes;
}

template <class S>
class BodyTraits : public ::testing::Test {};
using Scenes = ingot_reference::BriefTypes<6, Sleeping, Light, Direct, Fast, Bouncing, InField, Named, Piled>;
TYPED_TEST_SUITE(BodyTraits, Scenes);

TEST(DecayShare, is_one_less_the_exponential) {
    RandomInput random(41);
    for (int i = 0; i < 20000; ++i) {
        const scalar x = static_cast<scalar>(std::abs(random.of_any_size(-60, 7)));
        const long double exact = -std::expm1(-static_cast<long double>(x));
        // Of the series: a division, a product and a difference at each of three terms that count, and y times it. Each of up to eight doublings has
        // two roundings, and carries no more than the error it was given.
        ASSERT_LE(std::abs(static_cast<double>(static_cast<long double>(decay_share(x)) / exact - 1)), 24 * u) << x;
    }
    EXPECT_EQ(decay_share(0), 0);
    EXPECT_EQ(decay_share(limits::damping_max), 1);
}

TYPED_TEST(BodyTraits, damping_is_an_exponential_at_every_step) {
    for (const int rate : {30, 60, 240, 1000})
        for (const Damping damping : {Damping{scalar(0.125), 2}, Damping{8, scalar(0.5)}, Damping{0, 1}, Damping{100, 0}}) {
            World<TypeParam>& world = empty_world<TypeParam>();
            const scalar h = 1 / static_cast<scalar>(rate);
            BodyDef def = ball({1, 2, 3});
            def.state.v_CM = {3, -4, 5};
            def.state.L = {0, 0, 6};
            const BodyId id = world.add(def).value;
            ASSERT_EQ(world.set_damping(id, damping), Status::ok);
            const int steps = rate / 4;
            for (int step_i = 0; step_i < steps; ++step_i) ASSERT_TRUE(step(world, h).clean());
            const BodyState state = world.state(id).value;
            const double t = steps * static_cast<double>(h);
            // A step rounds the sum once. What it takes away is off by 24 u of the share and 6 u more.
            const auto roundings = [&](double rate_of_decay) {
                const double share = 1 - std::exp(-rate_of_decay * static_cast<double>(h));
                return 1.01 * steps * (1 + 30 * share / (1 - share)) * u;
            };
            const double linear = static_cast<double>(damping.linear), angular = static_cast<double>(damping.angular);
            EXPECT_NEAR(static_cast<double>(state.v_CM.y) / (-4 * std::exp(-linear * t)), 1, roundings(linear)) << rate << " " << linear;
            EXPECT_NEAR(static_cast<double>(state.L.z) / (6 * std::exp(-angular * t)), 1, roundings(angular)) << rate << " " << angular;
            // A step moves the body by the mean of its velocities: (c h)^2 / 12 less than the integral, and at most all of it. A place rounds to
            // u of 3 m, and the way of a step to 4 u.
            const double way = linear > 0 ? 5 * (1 - std::exp(-linear * t)) / linear : 5 * t, x = linear * static_cast<double>(h);
            const double least_part = x * x / 12 + 8 * u + roundings(linear);
            EXPECT_NEAR(static_cast<double>(state.r_CM.z), 3 + way, way * least_part + steps * 8 * u) << rate << " " << linear;
        }
}

TYPED_TEST(BodyTraits, damped_bodies_fall_at_a_speed_of_their_own) {
    World<TypeParam>& world = empty_world<TypeParam>();
    (void)world.set_gravity({0, 0, -g});
    const BodyId id = world.add(ball({0, 0, 1000})).value;
    ASSERT_EQ(world.set_damping(id, {4, 0}), Status::ok);
    const scalar h = scalar(1) / 64;
    for (int step_i = 0; step_i < 64 * 8; ++step_i) (void)step(world, h);
    const double speed = static_cast<double>(g * h) / -std::expm1(-4.0 / 64);
    // e^-32 is left of the begin; each step rounds twice, and errors die away within 1 / (c h) = 16 steps.
    EXPECT_NEAR(static_cast<double>(world.state(id).value.v_CM.z), -speed, speed * 16 * 40 * u);
    EXPECT_NEAR(speed / (static_cast<double>(g) / 4), 1 + 4.0 / 64 / 2, (4.0 / 64) * (4.0 / 64) / 12) << "as documented";
}

TEST(Damping, leaves_a_body_at_rest_where_it_is) {
    World<Sleeping>& world = empty_world<Sleeping>();
    (void)world.set_gravity({0, 0, -g});
    BodyDef ground;
    ground.shape = HalfSpace{{0, 0, 1}, 0};
    ground.immovable = true;
    (void)world.add(ground);
    BodyDef crate = ball({0, 0, scalar(0.5)});
    crate.mass.I_body = crate.mass.I_body * (scalar(1) / 6);
    crate.shape = Box{{scalar(0.5), scalar(0.5), scalar(0.5)}};
    const BodyId id = world.add(crate).value;
    ASSERT_EQ(world.set_damping(id, {100, 100}), Status::ok);
    for (int step_i = 0; step_i < 300; ++step_i) (void)step(world, scalar(1) / 60);
    EXPECT_TRUE(world.is_asleep(id));
    // limits::settled_gap, and what a float has at 0.5 m.
    EXPECT_NEAR(static_cast<double>(world.state(id).value.r_CM.z), 0.5, 1e-6);
}

/// Largest error, of A^T L or of v_CM, after half a second in which a ball spins and is pushed along with it.
struct Errors {
    double L, v;
};
template <class S>
Errors errors_of_push(int rate, bool turns_along) {
    World<S>& world = empty_world<S>();
    BodyDef def = ball({});
    const double M = 2, omega = 4;
    def.state.L = {0, 0, static_cast<scalar>(M * omega)};
    const BodyId id = world.add(def).value;
    const BodyId other = world.add(def).value;
    const scalar h = 1 / static_cast<scalar>(rate);
    const Vector tau = {1, scalar(0.5), 0}, F = {3, 0, 0};
    if (world.set_state(other, {{50, 0, 0}, {}, identity_matrix<scalar>(), def.state.L}) != Status::ok) return {1, 1};
    for (int step_i = 0; step_i < rate / 2; ++step_i) {
        const Matrix A = world.state(id).value.A, A_other = world.state(other).value.A;
        bool good = turns_along ? world.add_body_torque(id, tau) == Status::ok && world.add_body_force(other, F, {}) == Status::ok
                                : world.add_torque(id, A * tau) == Status::ok && world.add_central_force(other, A_other * F) == Status::ok;
        good = step(world, h).clean() && good;
        if (!good) return {1, 1};
    }
    const BodyState spun = world.state(id).value, pushed = world.state(other).value;
    // Of a ball omega x L is zero: seen from its own axes L grows by tau t. A force that turns at omega goes about a circle.
    const Eigen::Vector3d L_body = to_eigen(transpose_times(spun.A, spun.L)), exact = to_eigen(def.state.L) + 0.5 * to_eigen(tau);
    const Eigen::Vector3d v = 3 / (M * omega) * Eigen::Vector3d(std::sin(omega / 2), 1 - std::cos(omega / 2), 0);
    return {(L_body - exact).norm(), (to_eigen(pushed.v_CM) - v).norm()};
}

TYPED_TEST(BodyTraits, forces_of_a_body_turn_with_it_to_second_order) {
    const Errors coarse = errors_of_push<TypeParam>(16, true), fine = errors_of_push<TypeParam>(32, true);
    // The middle of a step of angle a stands for its mean to a^2/24 of the force: a = 1/4, 1/8; the way of L has as much again. Of an error of second
    // order a quarter is left; what is between 3.5 and 4.5 is a^2 of it, and rounding, 1e-3 of it in float.
    EXPECT_LE(coarse.L, 2 * 0.25 * 0.25 / 24 * std::sqrt(1.25) * 0.5 * 2);
    EXPECT_LE(coarse.v, 2 * 0.25 * 0.25 / 24 * 1.5 * 0.5);
    EXPECT_NEAR(coarse.L / fine.L, 4, 0.5);
    EXPECT_NEAR(coarse.v / fine.v, 4, 0.5);
    const Errors held = errors_of_push<TypeParam>(16, false);
    EXPECT_GT(held.v, 10 * coarse.v) << "one that is held in the world's axes is of first order";
}

TYPED_TEST(BodyTraits, forces_of_a_body_are_summed_and_gone_after_a_step) {
    World<TypeParam>& world = empty_world<TypeParam>();
    const BodyId by_body = world.add(ball({})).value, by_world = world.add(ball({20, 0, 0})).value;
    const Vector F = {1, 2, 3}, r = {scalar(0.5), 0, -1}, tau = {scalar(0.25), 0, 0};
    for (int i = 0; i < 2; ++i) {
        ASSERT_EQ(world.add_body_force(by_body, F, r), Status::ok);
        ASSERT_EQ(world.add_body_torque(by_body, tau), Status::ok);
        ASSERT_EQ(world.add_force(by_world, F, Vector{20, 0, 0} + r), Status::ok);
        ASSERT_EQ(world.add_torque(by_world, tau), Status::ok);
    }
    ASSERT_TRUE(step(world, scalar(1) / 64).clean());
    const BodyState a = world.state(by_body).value, b = world.state(by_world).value;
    EXPECT_EQ(to_eigen(a.v_CM), to_eigen(b.v_CM)) << "A is 1 as the step begins, and nothing turns yet";
    EXPECT_EQ(to_eigen(a.L), to_eigen(b.L));
    EXPECT_GT(a.v_CM.x, 0);
    ASSERT_TRUE(step(world, scalar(1) / 64).clean());
    EXPECT_EQ(to_eigen(world.state(by_body).value.v_CM), to_eigen(a.v_CM));
}

TYPED_TEST(BodyTraits, are_refused_where_they_are_none) {
    World<TypeParam>& world = empty_world<TypeParam>();
    static World<TypeParam> before;
    const BodyId id = world.add(ball({})).value;
    BodyDef wall;
    wall.immovable = true;
    const BodyId fixed = world.add(wall).value, gone = world.add(ball({3, 0, 0})).value;
    ASSERT_EQ(world.remove(gone), Status::ok);
    ASSERT_EQ(world.add_body_force(id, {limits::force_max, 0, 0}, {}), Status::ok);
    ASSERT_EQ(world.set_damping(id, {1, 2}), Status::ok);
    ASSERT_EQ(world.set_user_data(id, 3), Status::ok);
    std::memcpy(static_cast<void*>(&before), &world, sizeof world);

    const scalar nan = scalar(__builtin_nan("")), inf = scalar(__builtin_inf()), big = 2 * limits::force_max;
    const BodyId foreign = {0, 9, 1};
    EXPECT_EQ(world.set_damping(id, {nan, 0}), Status::not_finite);
    EXPECT_EQ(world.set_damping(id, {0, inf}), Status::not_finite);
    EXPECT_EQ(world.set_damping(id, {-1, 0}), Status::out_of_range);
    EXPECT_EQ(world.set_damping(id, {0, 2 * limits::damping_max}), Status::out_of_range);
    EXPECT_EQ(world.set_damping(gone, {}), Status::stale_id);
    EXPECT_EQ(world.set_damping(foreign, {}), Status::foreign_id);
    EXPECT_EQ(world.damping(gone).status, Status::stale_id);
    EXPECT_EQ(world.add_body_force(id, {nan, 0, 0}, {}), Status::not_finite);
    EXPECT_EQ(world.add_body_force(id, {1, 0, 0}, {0, inf, 0}), Status::not_finite);
    EXPECT_EQ(world.add_body_force(id, {1, 0, 0}, {0, 2 * limits::position_max, 0}), Status::out_of_range);
    EXPECT_EQ(world.add_body_force(id, {0, big, 0}, {}), Status::out_of_range);
    EXPECT_EQ(world.add_body_force(id, {limits::force_max, 0, 0}, {}), Status::out_of_range) << "the sum";
    EXPECT_EQ(world.add_body_torque(id, {0, 0, big}), Status::out_of_range);
    EXPECT_EQ(world.add_body_torque(id, {0, nan, 0}), Status::not_finite);
    EXPECT_EQ(world.add_body_torque(fixed, {1, 0, 0}), Status::immovable);
    EXPECT_EQ(world.add_body_force(gone, {1, 0, 0}, {}), Status::stale_id);
    EXPECT_EQ(world.add_body_force(gone, {1, 0, 0}, {nan, 0, 0}), Status::stale_id);
    EXPECT_EQ(world.add_body_torque(foreign, {1, 0, 0}), Status::foreign_id);
    EXPECT_EQ(world.set_user_data(gone, 1), Status::stale_id);
    EXPECT_EQ(world.user_data(foreign).status, Status::foreign_id);
    EXPECT_EQ(std::memcmp(&world, &before, sizeof world), 0);

    ASSERT_EQ(world.remove(id), Status::ok);
    const BodyId next = world.add(ball({})).value;
    ASSERT_EQ(next.slot, id.slot);
    EXPECT_EQ(world.damping(next).value.linear, 0);
    EXPECT_EQ(world.damping(next).value.angular, 0);
    EXPECT_EQ(world.user_data(next).value, 0u);
    ASSERT_TRUE(step(world, scalar(1) / 64).clean());
    EXPECT_EQ(world.state(next).value.v_CM.x, 0) << "the force of the body before went with it";
}

TYPED_TEST(BodyTraits, are_saved) {
    World<TypeParam>& world = empty_world<TypeParam>();
    static World<TypeParam> restored;
    BodyDef def = ball({0, 0, 100});
    def.state.L = {1, 2, 3};
    const BodyId id = world.add(def).value;
    const uint64_t plain = world.state_hash();
    ASSERT_EQ(world.set_user_data(id, 0xfedcba98u), Status::ok);
    EXPECT_EQ(world.state_hash(), plain) << "a word moves nothing";
    ASSERT_EQ(world.set_damping(id, {scalar(0.5), scalar(0.25)}), Status::ok);
    EXPECT_NE(world.state_hash(), plain);
    ASSERT_EQ(world.add_body_force(id, {1, 2, 3}, {0, 1, 0}), Status::ok);

    const std::vector<uint8_t> bytes = saved(world);
    ASSERT_EQ(load_snapshot(restored, bytes.data(), bytes.size()), Status::ok);
    EXPECT_EQ(restored.user_data(id).value, 0xfedcba98u);
    EXPECT_EQ(restored.damping(id).value.angular, scalar(0.25));
    for (int step_i = 0; step_i < 10; ++step_i) {
        (void)step(world, scalar(1) / 64);
        (void)step(restored, scalar(1) / 64);
        ASSERT_EQ(restored.state_hash(), world.state_hash());
    }
    EXPECT_GT(world.state(id).value.v_CM.x, 0);
}

TEST(BodyTraits, wake_who_sleeps_but_for_a_word) {
    World<Sleeping>& world = empty_world<Sleeping>();
    const BodyId id = world.add(ball({})).value;
    const auto sleeps_again = [&] {
        for (int step_i = 0; step_i < 200 && !world.is_asleep(id); ++step_i) (void)step(world, scalar(1) / 64);
        return world.is_asleep(id);
    };
    ASSERT_TRUE(sleeps_again());
    EXPECT_EQ(world.set_user_data(id, 1), Status::ok);
    EXPECT_TRUE(world.is_asleep(id));
    EXPECT_EQ(world.set_damping(id, {1, 1}), Status::ok);
    EXPECT_FALSE(world.is_asleep(id));
    ASSERT_TRUE(sleeps_again());
    EXPECT_EQ(world.add_body_torque(id, {1, 0, 0}), Status::ok);
    EXPECT_FALSE(world.is_asleep(id));
    (void)step(world, scalar(1) / 64);
    EXPECT_GT(world.state(id).value.L.x, 0);
}

TEST(BodyTraits, unused_are_without_a_trace) {
    World<Free>& plain = empty_world<Free>();
    World<Named>& named = empty_world<Named>();
    BodyDef def = ball({1, 2, 3});
    def.mass.I_body = {1, 2, scalar(2.5)};
    def.state.v_CM = {1, 0, 0};
    def.state.L = {1, 2, 3};
    const BodyId id = plain.add(def).value;
    (void)named.add(def);
    for (int step_i = 0; step_i < 100; ++step_i) {
        (void)step(plain, scalar(1) / 64);
        (void)step(named, scalar(1) / 64);
    }
    const BodyState a = plain.state(id).value, b = named.state(id).value;
    EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
    EXPECT_LE(sizeof(World<Named>), sizeof(World<Free>) + 5 * (2 * sizeof(scalar) + 4) + sizeof(BodyForceTile) * ((5 + lanes - 1) / lanes) +
                                        2 * alignof(World<Named>));
}

}  // namespace

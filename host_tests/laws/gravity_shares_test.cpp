// SPDX-License-Identifier: MIT
// A body's own share of gravity: exact where it can be, kept by snapshots and hashes, and without a trace in scenes that do not name it.
#include <ingot/ingot.h>

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "reference/brief_types.h"

namespace {

using namespace ingot;

constexpr scalar h = scalar(1) / 64, g = scalar(9.8125);

struct Free : Scene {
    static constexpr int max_bodies = 5;
    static constexpr bool translates = true;
};
struct Sharing : Free {
    static constexpr bool gravity_shares = true;
};
struct Piled : Sharing {
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
struct Fast : Piled {
    static constexpr bool continuous = true;
};
struct Bouncing : Sharing {
    static constexpr int max_contacts = 8;
    using solver = ingot::FrictionlessImpacts;
    using shapes = Shapes<Sphere, HalfSpace>;
};

BodyDef ball(const Vector& r_CM, scalar M = 2) {
    BodyDef def;
    def.mass = {M, {M, M, M}, {}, identity_matrix<scalar>()};
    def.state.r_CM = r_CM;
    return def;
}

template <class S>
class GravityShares : public ::testing::Test {};
using Scenes = ingot_reference::BriefTypes<4, Sleeping, Light, Fast, Bouncing, Sharing, Piled>;
TYPED_TEST_SUITE(GravityShares, Scenes);

TYPED_TEST(GravityShares, scale_the_fall) {
    static World<TypeParam> world;
    std::memset(static_cast<void*>(&world), 0, sizeof world);
    ASSERT_EQ(world.set_gravity({0, 0, -g}), Status::ok);
    const scalar shares[] = {0, scalar(0.25), 1, 2, -1};
    for (int body_i = 0; body_i < 5; ++body_i) {
        const BodyId id = world.add(ball({static_cast<scalar>(10 * body_i), 0, 100})).value;
        EXPECT_EQ(world.gravity_share(id).value, 1);
        ASSERT_EQ(world.set_gravity_share(id, shares[body_i]), Status::ok);
        EXPECT_EQ(world.gravity_share(id).value, shares[body_i]);
    }
    for (int step_i = 0; step_i < 64; ++step_i) EXPECT_TRUE(step(world, h).clean());
    for (int body_i = 0; body_i < 5; ++body_i)
        EXPECT_NEAR(world.state(world.body_at(body_i)).value.v_CM.z, -g * shares[body_i], 1e-5) << body_i;
    EXPECT_EQ(world.state(world.body_at(0)).value.r_CM.z, 100) << "mass 2: exact";
}

TYPED_TEST(GravityShares, are_refused_where_they_are_none_and_go_with_the_body) {
    static World<TypeParam> world, before;
    std::memset(static_cast<void*>(&world), 0, sizeof world);
    const BodyId id = world.add(ball({})).value;
    ASSERT_EQ(world.set_gravity_share(id, 3), Status::ok);
    std::memcpy(static_cast<void*>(&before), &world, sizeof world);
    EXPECT_EQ(world.set_gravity_share(id, scalar(__builtin_nan(""))), Status::not_finite);
    EXPECT_EQ(world.set_gravity_share(id, limits::gravity_share_max * 2), Status::out_of_range);
    EXPECT_EQ(world.set_gravity_share({}, 1), Status::stale_id);
    EXPECT_EQ(std::memcmp(&world, &before, sizeof world), 0);
    ASSERT_EQ(world.remove(id), Status::ok);
    EXPECT_EQ(world.gravity_share(world.add(ball({})).value).value, 1);
}

TYPED_TEST(GravityShares, are_hashed_and_saved) {
    static World<TypeParam> world, restored;
    std::memset(static_cast<void*>(&world), 0, sizeof world);
    (void)world.set_gravity({0, 0, -g});
    const BodyId id = world.add(ball({0, 0, 100})).value;
    const uint64_t plain = world.state_hash();
    ASSERT_EQ(world.set_gravity_share(id, scalar(0.5)), Status::ok);
    EXPECT_NE(world.state_hash(), plain);

    std::vector<uint8_t> bytes(snapshot_size<TypeParam>());
    bytes.resize(save_snapshot(world, bytes.data(), bytes.size()).value);
    ASSERT_EQ(load_snapshot(restored, bytes.data(), bytes.size()), Status::ok);
    EXPECT_EQ(restored.gravity_share(id).value, scalar(0.5));
    for (int step_i = 0; step_i < 10; ++step_i) {
        (void)step(world, h);
        (void)step(restored, h);
        ASSERT_EQ(restored.state_hash(), world.state_hash());
    }
}

TEST(GravityShare, of_a_crate_on_the_ground_is_what_it_presses_with) {
    static World<Piled> world;
    (void)world.set_gravity({0, 0, -g});
    BodyDef ground;
    ground.shape = HalfSpace{{0, 0, 1}, 0};
    ground.immovable = true;
    (void)world.add(ground);
    BodyDef crate = ball({0, 0, scalar(0.5)});
    crate.shape = Box{{scalar(0.5), scalar(0.5), scalar(0.5)}};
    const BodyId heavy = world.add(crate).value;
    crate.state.r_CM.x = 5;
    const BodyId floating = world.add(crate).value;
    ASSERT_EQ(world.set_gravity_share(floating, scalar(-0.25)), Status::ok);
    ASSERT_EQ(world.set_gravity_share(heavy, 4), Status::ok);
    for (int step_i = 0; step_i < 64; ++step_i) (void)step(world, h);
    EXPECT_NEAR(world.state(heavy).value.r_CM.z, 0.5, 1e-3);
    EXPECT_GT(world.state(floating).value.r_CM.z, 1.5);
}

TEST(GravityShare, costs_a_number_a_body_where_it_is_named) {
    EXPECT_LE(sizeof(World<Sharing>), sizeof(World<Free>) + 5 * sizeof(scalar) + alignof(World<Free>));
}

}  // namespace

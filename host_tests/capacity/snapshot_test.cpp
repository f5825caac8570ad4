// SPDX-License-Identifier: MIT
// A world is its bytes: copied, kept, restored, zeroed.
#include "capacity/yard.h"

#include <gtest/gtest.h>

#include <new>
#include <type_traits>
#include <vector>

namespace {

using namespace yard;

struct Satellite : ingot::Scene {};
struct PrintedYard : Yard {
    using rotation = ingot::Listing1Euler;
};

template <class T>
constexpr bool is_bytes = std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T> && std::is_default_constructible_v<T> &&
                          !std::is_polymorphic_v<T>;
template <class T>
constexpr bool is_plain = is_bytes<T> && std::is_standard_layout_v<T>;

static_assert(is_bytes<World<Satellite>> && is_bytes<World<Yard>> && is_bytes<World<PrintedYard>>);
static_assert(is_plain<BodyId> && is_plain<BodyState> && is_plain<BodyDef> && is_plain<StepReport> && is_plain<Shape>);
static_assert(is_plain<ingot::ContactInfo> && is_plain<Result<BodyId>> && is_plain<MassProperties>);
static_assert(is_plain<ingot::RotationTile> && is_plain<ingot::CompensationTile> && is_plain<ingot::EnergyTile> && is_plain<ingot::TranslationTile> &&
              is_plain<ingot::Contact>);

/// What one frame of a game does to a world, told by its number: bodies come and go, are pushed, moved, and step.
template <class S>
struct Game {
    World<S>* world;
    std::vector<BodyId> ids;

    void frame(int frame_i) {
        World<S>& w = *world;
        if (frame_i % 5 == 0 && w.body_count() < S::max_bodies) {
            BodyDef def = plain_body({static_cast<scalar>(frame_i % 3), 0, 4}, ingot::Box{{scalar(0.5), scalar(0.25), 1}});
            def.state.L = {1, static_cast<scalar>(frame_i % 7), 2};
            def.restitution = scalar(0.5);
            ids.push_back(w.add(def).value);
        }
        if (frame_i % 11 == 10 && !ids.empty()) {
            (void)w.remove(ids.front());
            ids.erase(ids.begin());
        }
        if (!ids.empty()) {
            const BodyId id = ids[static_cast<size_t>(frame_i) % ids.size()];
            if (frame_i % 3 == 0) (void)w.add_force(id, {3, 2, 1}, {0, 0, 1});
            if (frame_i % 4 == 0) (void)w.apply_angular_impulse(id, {0, scalar(0.1), 0});
            if (frame_i % 13 == 12) (void)w.set_state(id, plain_body({0, 0, 6}).state);
        }
        if (frame_i % 17 == 16) (void)w.set_gravity({0, 1, -9});
        (void)ingot::step(w, frame_i % 19 == 18 ? h / 2 : h);
    }
};

template <class S>
class Snapshot : public ::testing::Test {};
using Scenes = ::testing::Types<Yard, PrintedYard>;
TYPED_TEST_SUITE(Snapshot, Scenes);

TYPED_TEST(Snapshot, what_follows_a_restored_world_is_what_followed_the_kept_one) {
    using S = TypeParam;
    static World<S> world, kept, after;
    for (const int kept_at : {0, 1, 9, 10, 16, 37}) {
        clear(world);
        Game<S> game{&world, {}};
        (void)world.add(ground());
        for (int frame_i = 0; frame_i < kept_at; ++frame_i) game.frame(frame_i);

        copy(kept, world);
        Game<S> replayed = game;
        for (int frame_i = kept_at; frame_i < kept_at + 60; ++frame_i) game.frame(frame_i);
        copy(after, world);
        ASSERT_FALSE(same_bytes(world, kept));

        copy(world, kept);
        for (int frame_i = kept_at; frame_i < kept_at + 60; ++frame_i) replayed.frame(frame_i);
        EXPECT_TRUE(same_bytes(world, after)) << "kept at frame " << kept_at;
        EXPECT_EQ(world.state_hash(), after.state_hash());
        EXPECT_EQ(replayed.ids.size(), game.ids.size());
        for (size_t id_i = 0; id_i < game.ids.size(); ++id_i) EXPECT_EQ(replayed.ids[id_i], game.ids[id_i]);
    }
}

TYPED_TEST(Snapshot, a_world_goes_on_at_any_address) {
    using S = TypeParam;
    static World<S> world;
    alignas(World<S>) static unsigned char elsewhere[sizeof(World<S>) + 4 * alignof(World<S>)];
    clear(world);
    Game<S> game{&world, {}};
    (void)world.add(ground());
    for (int frame_i = 0; frame_i < 20; ++frame_i) game.frame(frame_i);
    memcpy(elsewhere + 3 * alignof(World<S>), &world, sizeof world);
    World<S>& moved = *std::launder(reinterpret_cast<World<S>*>(elsewhere + 3 * alignof(World<S>)));
    Game<S> moved_game{&moved, game.ids};
    for (int frame_i = 20; frame_i < 60; ++frame_i) game.frame(frame_i);
    for (int frame_i = 20; frame_i < 60; ++frame_i) moved_game.frame(frame_i);
    EXPECT_TRUE(same_bytes(world, moved)) << "a world holds no pointer";
}

TYPED_TEST(Snapshot, ids_are_those_of_the_moment_it_was_taken) {
    using S = TypeParam;
    static World<S> world, kept;
    clear(world);
    const BodyId stays = world.add(plain_body({})).value, goes = world.add(plain_body({5, 0, 0})).value;
    copy(kept, world);
    ASSERT_EQ(world.remove(goes), Status::ok);
    const BodyId comes = world.add(plain_body({9, 0, 0})).value;
    copy(world, kept);
    EXPECT_TRUE(world.is_alive(stays));
    EXPECT_TRUE(world.is_alive(goes));
    EXPECT_FALSE(world.is_alive(comes));
}

TYPED_TEST(Snapshot, forces_that_wait_for_the_step_are_in_it) {
    using S = TypeParam;
    static World<S> world, kept;
    clear(world);
    const BodyId id = world.add(plain_body({})).value;
    ASSERT_EQ(world.add_force(id, {1, 2, 3}, {1, 0, 0}), Status::ok);
    copy(kept, world);
    (void)ingot::step(world, h);
    const BodyState pushed = world.state(id).value;
    EXPECT_GT(pushed.v_CM.x, 0);
    copy(world, kept);
    (void)ingot::step(world, h);
    EXPECT_TRUE(same_bits(world.state(id).value, pushed));
}

TYPED_TEST(Snapshot, a_frozen_body_is_frozen_in_it) {
    using S = TypeParam;
    static World<S> world, kept;
    clear(world);
    BodyDef leaving = plain_body({limits::position_max, 0, 0});
    leaving.state.v_CM = {limits::speed_max, 0, 0};
    const BodyId id = world.add(leaving).value;
    (void)ingot::step(world, h);
    ASSERT_TRUE(world.is_frozen(id));
    copy(kept, world);
    ASSERT_EQ(world.remove(id), Status::ok);
    copy(world, kept);
    EXPECT_TRUE(world.is_frozen(id));
}

// Zero bytes.

template <class S>
void expect_empty(World<S>& world) {
    EXPECT_EQ(world.body_count(), 0);
    EXPECT_EQ(world.step_count(), 0u);
    EXPECT_EQ(world.body_at(0), BodyId{});
    EXPECT_FALSE(world.is_alive(BodyId{}));
    EXPECT_EQ(world.kinetic_energy(), 0);
    EXPECT_EQ(world.state_hash(), ingot::state_hash_seed);
    EXPECT_TRUE(ingot::step(world, h).clean());
    EXPECT_EQ(world.step_count(), 1u);
    EXPECT_EQ(world.body_count(), 0);
}

template <class S>
void expect_zero_bytes_are_empty() {
    static World<S> constructed;
    alignas(World<S>) static unsigned char bytes[sizeof(World<S>)];

    // Whatever lay there before, a world that is initialised (World<S> world{};) is all zero, its padding too.
    memset(bytes, 0xa5, sizeof bytes);
    World<S>& initialised = *new (static_cast<void*>(bytes)) World<S>{};
    for (const unsigned char byte : bytes) ASSERT_EQ(byte, 0);
    EXPECT_TRUE(same_bytes(initialised, constructed));

    memset(bytes, 0, sizeof bytes);
    World<S>& zeroed = *std::launder(reinterpret_cast<World<S>*>(bytes));
    EXPECT_TRUE(same_bytes(zeroed, constructed));
    expect_empty(zeroed);
    expect_empty(constructed);
    EXPECT_TRUE(same_bytes(zeroed, constructed));

    const Result<BodyId> first = zeroed.add(plain_body({})), twin = constructed.add(plain_body({}));
    EXPECT_TRUE(first.ok() && first.value == twin.value);
    (void)ingot::step(zeroed, h);
    (void)ingot::step(constructed, h);
    EXPECT_TRUE(same_bits(zeroed.state(first.value).value, constructed.state(twin.value).value));
}

TEST(ZeroBytes, are_a_valid_empty_world) {
    expect_zero_bytes_are_empty<Satellite>();
    expect_zero_bytes_are_empty<Yard>();
    expect_zero_bytes_are_empty<PrintedYard>();
}

}  // namespace

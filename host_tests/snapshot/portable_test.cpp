// SPDX-License-Identifier: MIT
// A world that was saved and loaded, or copied, goes on as if it had never been left.
#include "snapshot/life.h"

#include <gtest/gtest.h>

namespace {

using namespace life;

template <class S>
class Portable : public ::testing::Test {};
using Scenes = ::testing::Types<Yard, PrintedYard, Tops, Tide>;
TYPED_TEST_SUITE(Portable, Scenes);

TYPED_TEST(Portable, random_lives_go_on_from_every_moment_as_if_never_left) {
    using S = TypeParam;
    static World<S> world, restored, copied;
    int frozen = 0, living = 0;
    for (uint64_t seed = 1; seed <= 40; ++seed) {
        clear(world);
        Life life(seed);
        for (int moment = 0; moment < 25; ++moment) {
            for (int call_i = 0; call_i < 10; ++call_i) life.live(world);
            const std::vector<uint8_t> bytes = saved(world);
            ASSERT_FALSE(bytes.empty());
            memset(static_cast<void*>(&restored), 0xa5, sizeof restored);  // nothing of what was there before remains
            ASSERT_EQ(ingot::load_snapshot(restored, bytes.data(), bytes.size()), Status::ok) << "seed " << seed << " moment " << moment;
            copy(copied, world);
            ASSERT_EQ(restored.state_hash(), world.state_hash());
            ASSERT_EQ(saved(restored), bytes) << "what was loaded saves as the same bytes";

            World<S>* const all[] = {&world, &restored, &copied};
            Life lives[] = {life, life, life};
            for (int call_i = 0; call_i < 30; ++call_i) {
                for (int world_i = 0; world_i < 3; ++world_i) lives[world_i].live(*all[world_i]);
                ASSERT_EQ(restored.state_hash(), world.state_hash()) << "seed " << seed << " moment " << moment << " call " << call_i;
                ASSERT_EQ(saved(restored), saved(world)) << "seed " << seed << " moment " << moment << " call " << call_i;
            }
            EXPECT_TRUE(same_bytes(copied, world));
            life = lives[0];
            for (int slot = 0; slot < S::max_bodies; ++slot) {
                ++(world.is_frozen(world.body_at(slot)) ? frozen : living);
                EXPECT_EQ(restored.body_at(slot), world.body_at(slot));
            }
        }
    }
    EXPECT_GT(living, 1000);
    EXPECT_EQ(frozen > 100, S::translates) << "frozen bodies are in it, where bodies can leave the range";
}

TYPED_TEST(Portable, all_readings_are_those_of_the_world_that_was_saved) {
    using S = TypeParam;
    static World<S> world, restored;
    clear(world);
    Life life(7);
    for (int call_i = 0; call_i < 100; ++call_i) life.live(world);
    const std::vector<uint8_t> bytes = saved(world);
    ASSERT_EQ(ingot::load_snapshot(restored, bytes.data(), bytes.size()), Status::ok);
    EXPECT_EQ(restored.body_count(), world.body_count());
    EXPECT_EQ(restored.step_count(), world.step_count());
    EXPECT_EQ(restored.kinetic_energy(), world.kinetic_energy());
    for (int slot = 0; slot < S::max_bodies; ++slot) {
        const BodyId id = world.body_at(slot);
        ASSERT_EQ(restored.body_at(slot), id);
        if (id == BodyId{}) continue;
        EXPECT_TRUE(same_bits(restored.state(id).value, world.state(id).value));
        EXPECT_EQ(restored.omega(id).value.x, world.omega(id).value.x);
        EXPECT_EQ(restored.omega(id).value.y, world.omega(id).value.y);
        EXPECT_EQ(restored.omega(id).value.z, world.omega(id).value.z);
        EXPECT_EQ(restored.is_frozen(id), world.is_frozen(id));
        if constexpr (S::translates) {
            EXPECT_EQ(restored.mass(id).value, world.mass(id).value);
        }
    }
}

TYPED_TEST(Portable, no_room_writes_nothing) {
    using S = TypeParam;
    static World<S> world;
    clear(world);
    Life life(3);
    for (int call_i = 0; call_i < 60; ++call_i) life.live(world);
    const std::vector<uint8_t> bytes = saved(world);
    ASSERT_LE(bytes.size(), ingot::snapshot_size<S>());
    std::vector<uint8_t> to(bytes.size() + 1, 0x5a);
    for (size_t room = 0; room < bytes.size(); ++room) {
        const Result<size_t> refused = ingot::save_snapshot(world, to.data(), room);
        EXPECT_EQ(refused.status, Status::no_room);
        EXPECT_EQ(refused.value, 0u);
    }
    EXPECT_EQ(to, std::vector<uint8_t>(bytes.size() + 1, 0x5a));
    EXPECT_EQ(ingot::save_snapshot(world, static_cast<uint8_t*>(nullptr), 0).status, Status::no_room);

    const Result<size_t> fits = ingot::save_snapshot(world, to.data(), bytes.size());
    ASSERT_TRUE(fits.ok());
    EXPECT_EQ(fits.value, bytes.size());
    EXPECT_EQ(to.back(), 0x5a) << "not a byte beyond";
    to.pop_back();
    EXPECT_EQ(to, bytes);
}

TYPED_TEST(Portable, a_full_world_takes_the_size_that_is_promised_and_an_empty_one_loads) {
    using S = TypeParam;
    static World<S> world, restored;
    clear(world);
    const std::vector<uint8_t> empty = saved(world);
    clear(restored);
    while (restored.add(plain_body({})).ok()) {
    }
    EXPECT_EQ(saved(restored).size(), ingot::snapshot_size<S>());
    ASSERT_EQ(ingot::load_snapshot(restored, empty.data(), empty.size()), Status::ok);
    EXPECT_TRUE(same_bytes(restored, world)) << "an empty world is all zero";
}

TEST(Portable, numbers_go_from_the_lowest_byte_up) {
    static World<Tops> world;
    clear(world);
    ASSERT_EQ(world.set_tag(0x1234), Status::ok);
    for (int step_i = 0; step_i < 0x102; ++step_i) (void)ingot::step(world, h);
    const std::vector<uint8_t> bytes = saved(world);
    const uint8_t magic[] = {0x89, 'i', 'n', 'g', 'o', 't', 0x0d, 0x0a};
    ASSERT_GT(bytes.size(), 36u);
    EXPECT_EQ(memcmp(bytes.data(), magic, sizeof magic), 0);
    EXPECT_EQ(bytes[20], bytes.size() & 0xff);
    EXPECT_EQ(bytes[21], bytes.size() >> 8);
    const uint8_t tag_and_steps[] = {0x34, 0x12, 0x02, 0x01, 0x00, 0x00};
    EXPECT_EQ(memcmp(bytes.data() + 32, tag_and_steps, sizeof tag_and_steps), 0);
}

/// One body in a field of force.
template <class Field>
struct InField : ingot::Scene {
    static constexpr int max_bodies = 8;
    static constexpr bool translates = true;
    using force_field = Field;
    using flight = ingot::CommutatorFree4;
};
template <class Field>
class PortableField : public ::testing::Test {};
using Fields = ::testing::Types<ingot::PointMassGravity, ingot::GravityGradient, ingot::LinearDrag, ingot::QuadraticDrag, ingot::Spring,
                                ingot::SpringDamper, ingot::MagneticDipole, ingot::WeightAboutPoint, ingot::ThrusterTable<2, 8>>;
TYPED_TEST_SUITE(PortableField, Fields);

TYPED_TEST(PortableField, each_of_its_numbers_is_saved_and_comes_back) {
    using S = InField<TypeParam>;
    static World<S> world, restored;
    constexpr size_t count = sizeof(TypeParam) / sizeof(scalar);
    clear(world);
    ASSERT_TRUE(world.add(plain_body({1, 2, 3})).ok());
    const std::vector<uint8_t> before = saved(world);
    scalar numbers[count];
    memcpy(numbers, &world.force_field(), sizeof numbers);
    for (size_t i = 0; i < count; ++i) {
        const scalar kept = numbers[i];
        numbers[i] = scalar(0.5);
        memcpy(static_cast<void*>(&world.force_field()), numbers, sizeof numbers);
        const std::vector<uint8_t> bytes = saved(world);
        EXPECT_FALSE(bytes == before) << i;
        clear(restored);
        ASSERT_EQ(ingot::load_snapshot(restored, bytes.data(), bytes.size()), Status::ok);
        EXPECT_EQ(memcmp(&restored.force_field(), numbers, sizeof numbers), 0) << i;
        numbers[i] = kept;
    }
}

template <class... Field>
std::vector<uint64_t> signatures_of(::testing::Types<Field...>) {
    return {ingot::scene_signature<InField<Field>>()...};
}
TEST(PortableFields, are_no_two_of_them_alike) {
    const std::vector<uint64_t> signatures = signatures_of(Fields{});
    for (size_t i = 0; i < signatures.size(); ++i)
        for (size_t k = 0; k < i; ++k) EXPECT_NE(signatures[i], signatures[k]) << i << " " << k;
}

}  // namespace

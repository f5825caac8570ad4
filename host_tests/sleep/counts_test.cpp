// SPDX-License-Identifier: MIT
// How many bodies and islands are awake or asleep, against a look at each of them, whoever has which slot.
#include <gtest/gtest.h>

#include <ingot/ingot.h>

#include <memory>
#include <numeric>
#include <vector>

#include "reference/draws.h"
#include "reference/kernel_types.h"
#include "reference/random_input.h"

namespace {

using Eigen::Vector3d;
using ingot::BodyDef;
using ingot::BodyId;
using ingot::scalar;
using ingot::Status;
using ingot_reference::RandomInput;

struct Dormitory : ingot::Scene {
    static constexpr int max_bodies = 24, max_manifolds = 120;
    static constexpr bool translates = true, sleeps = true, reads_contacts = true, kinematic_bodies = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};
using World = ingot::World<Dormitory>;

BodyDef ground() {
    BodyDef def;
    def.immovable = true;
    def.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    return def;
}
BodyDef box(const Vector3d& r) {
    BodyDef def;
    def.mass = ingot::principal(ingot::solid_box(1000, {scalar(0.5), scalar(0.5), scalar(0.5)})).value;
    def.shape = ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.5)}};
    def.state.r_CM = ingot_reference::to_vector(r);
    return def;
}

/// Counted one by one: who moves and sleeps or not, and the sets of them that touch.
struct Counted {
    int awake = 0, asleep = 0, awake_islands = 0, asleep_islands = 0;
};
Counted count(const World& world) {
    Counted counted;
    std::vector<int> set(Dormitory::max_bodies);
    std::iota(set.begin(), set.end(), 0);
    const auto root = [&set](int i) {
        while (set[static_cast<size_t>(i)] != i) i = set[static_cast<size_t>(i)];
        return i;
    };
    const auto moves = [&world](int slot) { return world.is_movable(world.body_at(slot)) && !world.is_kinematic(world.body_at(slot)); };
    for (const ingot::ContactInfo& contact : world.contacts())
        if (moves(contact.A.slot) && moves(contact.B.slot)) set[static_cast<size_t>(root(contact.A.slot))] = root(contact.B.slot);
    for (int slot = 0; slot < Dormitory::max_bodies; ++slot) {
        if (!world.is_alive(world.body_at(slot)) || !moves(slot)) continue;
        const bool sleeps = world.is_asleep(world.body_at(slot));
        ++(sleeps ? counted.asleep : counted.awake);
        if (root(slot) == slot) ++(sleeps ? counted.asleep_islands : counted.awake_islands);
    }
    return counted;
}

/// Columns of one to three boxes, ground and kinematic bodies in any slots, and some that have gone: as they come to rest, sleep and are woken.
TEST(Counts, are_of_all_who_are_awake_or_asleep) {
    RandomInput random(1);
    int first_awake = 0, first_asleep = 0, first_is_ground = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(48); ++run_i) {
        const auto world = std::make_unique<World>();
        ASSERT_EQ(world->set_gravity({0, 0, scalar(-9.81)}), Status::ok);
        const int ground_at = run_i % 3 == 0 ? 0 : random.integer(1, 12);
        std::vector<BodyId> ids, leaving;
        int column = 0, height = 0;
        for (int i = 0; i < 14; ++i) {
            if (i == ground_at) {
                ASSERT_TRUE(world->add(ground()).ok());
                first_is_ground += i == 0 ? 1 : 0;
                continue;
            }
            ids.push_back(world->add(box({3.0 * column, 0, 0.5 + height + random.real(0, 0.02)})).value);
            if (random.integer(0, 9) == 0 && height == 0) {
                ASSERT_EQ(world->set_kinematic(ids.back()), Status::ok);
            }
            if (++height == random.integer(1, 3)) height = 0, ++column;
            if (random.integer(0, 5) == 0) leaving.push_back(world->add(box({-5.0 * i - 5, 9, 0.5})).value);
        }
        for (const BodyId id : leaving) ASSERT_EQ(world->remove(id), Status::ok);
        for (int step_i = 0; step_i < 120; ++step_i) {
            (void)ingot::step(*world, scalar(1) / 60);
            if (random.integer(0, 39) == 0) (void)world->wake(ids[static_cast<size_t>(random.integer(0, static_cast<int>(ids.size()) - 1))]);
            const Counted due = count(*world);
            ASSERT_EQ(world->awake_count(), due.awake) << run_i << ", " << step_i;
            ASSERT_EQ(world->asleep_count(), due.asleep) << run_i << ", " << step_i;
            ASSERT_EQ(world->awake_island_count(), due.awake_islands) << run_i << ", " << step_i;
            ASSERT_EQ(world->asleep_island_count(), due.asleep_islands) << run_i << ", " << step_i;
            if (ground_at == 0) continue;
            ++(world->is_asleep(world->body_at(0)) ? first_asleep : first_awake);
        }
    }
    EXPECT_GT(first_awake, 60);
    EXPECT_GT(first_asleep, 60);
    EXPECT_GT(first_is_ground, 0);
}

}  // namespace

// SPDX-License-Identifier: MIT
// A slot that is given out again has nothing of who had it: no trait of bodies lives on in the next, as it is read and as it moves.
#include <gtest/gtest.h>

#include <ingot/ingot.h>

#include <memory>
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
using ingot::Vector;
using ingot_reference::RandomInput;
using ingot_reference::to_vector;

struct Hotel : ingot::Scene {
    static constexpr int max_bodies = 10, max_manifolds = 60, max_shapes_of_body = 2;
    static constexpr bool translates = true, gravity_shares = true, damping = true, axis_locks = true, user_data = true, filters = true;
    static constexpr bool rolling_resistance = true, surface_velocities = true, kinematic_bodies = true, sleeps = true;
    static constexpr int max_overlaps = 20;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};
using World = ingot::World<Hotel>;

BodyDef guest(RandomInput& random) {
    BodyDef def;
    const auto size = static_cast<scalar>(random.real(0.2, 0.4));
    def.shape = ingot::Box{{size, size, size}};
    def.mass = ingot::principal(ingot::solid_box(1000, {size, size, size})).value;
    def.friction = scalar(0.5);
    def.state.r_CM = to_vector(Vector3d(random.vector(3) + Vector3d(0, 0, 4)));
    def.state.A = ingot_reference::to_matrix(random.rotation());
    def.state.v_CM = to_vector(random.vector(2));
    return def;
}

/// Each of its traits other than by default, some of them.
void furnish(World& world, RandomInput& random, BodyId id) {
    const auto some = [&random] { return random.integer(0, 3) != 0; };
    const auto real = [&random](double low, double high) { return static_cast<scalar>(random.real(low, high)); };
    if (some()) {
        EXPECT_EQ(world.set_gravity_share(id, real(-1, 3)), Status::ok);
    }
    if (some()) {
        EXPECT_EQ(world.set_damping(id, {real(0.1, 2), real(0.1, 2)}), Status::ok);
    }
    if (some()) {
        EXPECT_EQ(world.set_locks(id, static_cast<unsigned>(random.integer(1, 63))), Status::ok);
    }
    if (some()) {
        EXPECT_EQ(world.set_user_data(id, static_cast<std::uint32_t>(random.integer(1, 1000))), Status::ok);
    }
    if (some()) {
        EXPECT_EQ(world.set_rolling_resistance(id, real(0.01, 0.1)), Status::ok);
    }
    if (some()) {
        EXPECT_EQ(world.set_surface_velocity(id, to_vector(random.vector(1))), Status::ok);
    }
    if (some()) {
        EXPECT_EQ(world.set_sensor(id, random.integer(0, 1) == 1), Status::ok);
    }
    if (some()) {
        EXPECT_EQ(world.set_filter(id, {2, 4}), Status::ok);
    }
    if (random.integer(0, 3) == 0) {
        EXPECT_EQ(world.set_kinematic(id), Status::ok);
    }
}

template <class T>
void expect_same(const ingot::Result<T>& a, const ingot::Result<T>& b) {
    ASSERT_TRUE(a.ok() && b.ok());
    EXPECT_EQ(a.value, b.value);
}
void expect_same(const Vector& a, const Vector& b, int run_i) {
    ASSERT_TRUE(a.x == b.x && a.y == b.y && a.z == b.z) << run_i;
}

TEST(UsedSlots, have_nothing_of_who_was_there) {
    int reused = 0;
    for (int run_i = 0; run_i < ingot_reference::draws(160); ++run_i) {
        RandomInput random(static_cast<std::uint64_t>(run_i));
        const auto used = std::make_unique<World>(), fresh = std::make_unique<World>();
        BodyDef ground;
        ground.immovable = true;
        ground.friction = scalar(0.5);
        ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        for (auto* const world : {used.get(), fresh.get()}) {
            ASSERT_EQ(world->set_gravity({0, 0, scalar(-9.81)}), Status::ok);
            ASSERT_TRUE(world->add(ground).ok());
        }
        std::vector<BodyId> leaving;
        for (int i = 0; i < 9; ++i) {
            leaving.push_back(used->add(guest(random)).value);
            furnish(*used, random, leaving.back());
        }
        // Both have taken as many steps: by their number rotations are made orthonormal again.
        for (int step_i = random.integer(0, 30); step_i > 0; --step_i)
            for (auto* const world : {used.get(), fresh.get()}) (void)ingot::step(*world, scalar(1) / 60);
        for (const BodyId id : leaving) ASSERT_EQ(used->remove(id), Status::ok);
        std::vector<BodyId> of_used, of_fresh;
        for (int i = 0; i < 9; ++i) {
            const BodyDef def = guest(random);
            of_used.push_back(used->add(def).value);
            of_fresh.push_back(fresh->add(def).value);
            reused += of_used.back().slot == leaving[static_cast<size_t>(i)].slot ? 1 : 0;
        }
        for (size_t i = 0; i < of_used.size(); ++i) {
            const BodyId a = of_used[i], b = of_fresh[i];
            expect_same(used->gravity_share(a), fresh->gravity_share(b));
            EXPECT_EQ(used->damping(a).value.linear, fresh->damping(b).value.linear);
            EXPECT_EQ(used->damping(a).value.angular, fresh->damping(b).value.angular);
            expect_same(used->locks(a), fresh->locks(b));
            expect_same(used->user_data(a), fresh->user_data(b));
            expect_same(used->rolling_resistance(a), fresh->rolling_resistance(b));
            expect_same(used->surface_velocity(a).value, fresh->surface_velocity(b).value, run_i);
            expect_same(used->is_sensor(a), fresh->is_sensor(b));
            EXPECT_EQ(used->filter(a).value.category, fresh->filter(b).value.category);
            EXPECT_EQ(used->filter(a).value.mask, fresh->filter(b).value.mask);
            EXPECT_EQ(used->is_kinematic(a), fresh->is_kinematic(b));
            EXPECT_EQ(used->is_asleep(a), fresh->is_asleep(b));
        }
        for (int step_i = 0; step_i < 60; ++step_i) {
            (void)ingot::step(*used, scalar(1) / 60);
            (void)ingot::step(*fresh, scalar(1) / 60);
            for (size_t i = 0; i < of_used.size(); ++i) {
                expect_same(used->state(of_used[i]).value.r_CM, fresh->state(of_fresh[i]).value.r_CM, run_i);
                expect_same(used->state(of_used[i]).value.L, fresh->state(of_fresh[i]).value.L, run_i);
            }
            ASSERT_FALSE(HasFailure()) << run_i << ", step " << step_i;
        }
    }
    EXPECT_GT(reused, ingot_reference::draws(160) * 4);
}

}  // namespace

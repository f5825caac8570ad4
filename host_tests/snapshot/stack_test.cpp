// SPDX-License-Identifier: MIT
// Nothing of the stack gets into a world. Found by fuzz_friction: points that a manifold does not have were kept as they lay there, in
// the world and in its snapshots, and one with a NaN among them was refused when it was loaded.
#include <ingot/ingot.h>

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

namespace {

using ingot::BodyDef;
using ingot::scalar;
using ingot::Status;

struct Pen : ingot::Scene {
    static constexpr int max_bodies = 4;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 6;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::HalfSpace>;
};
using PenWorld = ingot::World<Pen>;

constexpr std::size_t depth = 16384;

/// Leaves bytes where the frames of the next call will be.
[[gnu::noinline]] void fill_stack(unsigned char with) {
    unsigned char stack[depth];
    std::memset(stack, with, sizeof stack);
    asm volatile("" : : "r"(stack) : "memory");  // it is written, although nobody reads it
}

[[gnu::noinline]] ingot::StepReport step(PenWorld& world) { return ingot::step(world, scalar(1) / 60); }

/// A ball, a leaning capsule and the ground: manifolds of one point.
std::unique_ptr<PenWorld> furnished() {
    auto world = std::make_unique<PenWorld>();
    EXPECT_EQ(world->set_gravity({0, 0, -10}), Status::ok);
    BodyDef ground, ball, capsule;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    ball.mass = capsule.mass = {1, {1, 1, 1}, {}, ingot::identity_matrix<scalar>()};
    ball.shape = ingot::Sphere{1};
    ball.state.r_CM = {0, 0, 1};
    capsule.shape = ingot::Capsule{scalar(0.5), 1};
    capsule.state.A = ingot::axis_angle({1, 0, 0}, scalar(0.5));
    capsule.state.r_CM = {scalar(1.5), 0, scalar(1.377)};
    for (const BodyDef& def : {ground, ball, capsule}) EXPECT_TRUE(world->add(def).ok());
    return world;
}

TEST(Stack, is_not_in_the_world) {
    const auto zeros = furnished(), ones = furnished();
    for (int step_i = 0; step_i < 30; ++step_i) {
        fill_stack(0);
        const ingot::StepReport report = step(*zeros);
        fill_stack(0xff);  // NaN, as a number
        ASSERT_EQ(step(*ones).contacts, report.contacts);
        ASSERT_GE(report.contacts, 2);
        ASSERT_EQ(std::memcmp(zeros.get(), ones.get(), sizeof(PenWorld)), 0) << "step " << step_i;
    }
}

TEST(Stack, is_not_in_a_snapshot) {
    const auto world = furnished(), loaded = furnished();
    static std::uint8_t bytes[ingot::snapshot_size<Pen>()], again[ingot::snapshot_size<Pen>()];
    for (int step_i = 0; step_i < 30; ++step_i) {
        fill_stack(0xff);
        ASSERT_GE(step(*world).contacts, 2);
        const auto saved = ingot::save_snapshot(*world, bytes, sizeof bytes);
        ASSERT_TRUE(saved.ok());
        ASSERT_EQ(ingot::load_snapshot(*loaded, bytes, saved.value), Status::ok) << "step " << step_i;
        fill_stack(0);
        ASSERT_GE(step(*loaded).contacts, 2);
        fill_stack(0xff);
        ASSERT_GE(step(*world).contacts, 2);
        const auto of_world = ingot::save_snapshot(*world, bytes, sizeof bytes);
        const auto of_loaded = ingot::save_snapshot(*loaded, again, sizeof again);
        ASSERT_EQ(of_world.value, of_loaded.value);
        ASSERT_EQ(std::memcmp(bytes, again, of_world.value), 0) << "step " << step_i;
    }
}

}  // namespace

// SPDX-License-Identifier: MIT
// What a field is to a world: one cause among others, of no consequence to bodies it does not reach, kept by a snapshot.
#include <ingot/ingot.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "reference/kernel_types.h"

namespace {

using ingot::scalar;
using ingot::Vector;

constexpr double eps = static_cast<double>(ingot::epsilon);

template <class Field, class Flight = ingot::KickDriftKick>
struct Crowd : ingot::Scene {
    static constexpr int max_bodies = 2 * ingot::lanes + 3;
    static constexpr bool translates = true;
    using force_field = Field;
    using flight = Flight;
};

ingot::BodyDef body(int body_i) {
    ingot::BodyDef def{};
    def.mass = {2, {1, 2, scalar(2.5)}, {}, ingot::identity_matrix<scalar>()};
    def.state.r_CM = {1 + static_cast<scalar>(body_i), scalar(0.5), -1};
    def.state.v_CM = {0, 1, scalar(0.25)};
    def.state.L = {1, scalar(0.5), static_cast<scalar>(body_i)};
    return def;
}

bool same_bits(const ingot::BodyState& a, const ingot::BodyState& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

using Everything = ingot::BothFields<ingot::BothFields<ingot::PointMassGravity, ingot::GravityGradient>, ingot::SpringDamper>;

Everything everything() {
    Everything field{};
    field.first.first.mu = 3;
    field.first.second.mu = 3;
    field.second.k = 2;
    field.second.c = scalar(0.5);
    field.second.r_body = {0, scalar(0.5), 0};
    return field;
}

template <class Flight>
struct FieldInWorld : ::testing::Test {};
using Flights = ::testing::Types<ingot::KickDriftKick, ingot::CommutatorFree4>;
TYPED_TEST_SUITE(FieldInWorld, Flights);

TYPED_TEST(FieldInWorld, body_moves_among_others_as_it_moves_alone) {
    using W = ingot::World<Crowd<Everything, TypeParam>>;
    static W crowd, alone;
    std::memset(static_cast<void*>(&crowd), 0, sizeof crowd);
    crowd.force_field() = everything();
    ingot::BodyId ids[W::max_bodies];
    for (int body_i = 0; body_i < W::max_bodies; ++body_i) ids[body_i] = crowd.add(body(body_i)).value;
    for (int step_i = 0; step_i < 50; ++step_i) ASSERT_TRUE(ingot::step(crowd, scalar(1) / 60).clean());
    for (int body_i = 0; body_i < W::max_bodies; ++body_i) {
        std::memset(static_cast<void*>(&alone), 0, sizeof alone);
        alone.force_field() = everything();
        const ingot::BodyId id = alone.add(body(body_i)).value;
        for (int step_i = 0; step_i < 50; ++step_i) (void)ingot::step(alone, scalar(1) / 60);
        EXPECT_TRUE(same_bits(crowd.state(ids[body_i]).value, alone.state(id).value)) << body_i;
    }
}

TYPED_TEST(FieldInWorld, immovable_body_is_not_moved_by_a_bit) {
    ingot::World<Crowd<Everything, TypeParam>> world{};
    world.force_field() = everything();
    ingot::BodyDef def = body(0);
    def.immovable = true;
    def.state.v_CM = {};
    def.state.L = {};
    def.state.A = ingot::axis_angle({0, 0, 1}, scalar(0.3));
    const ingot::BodyId id = world.add(def).value;
    const ingot::BodyState before = world.state(id).value;
    for (int step_i = 0; step_i < 40; ++step_i) ASSERT_TRUE(ingot::step(world, scalar(1) / 60).clean());
    EXPECT_TRUE(same_bits(world.state(id).value, before));
}

/// A field that gives NaN near one body freezes that body and no other.
struct Pit : ingot::ForceField {
    ingot::Wrench operator()(const ingot::BodyMotion& motion) const {
        const ingot::lane x = motion.r_CM.x - ingot::splat<ingot::lane>(3);
        const ingot::lane none{}, bad = ingot::splat<ingot::lane>(std::numeric_limits<scalar>::quiet_NaN());
        return ingot::Wrench::torque({none, ingot::select(ingot::abs(x) < ingot::splat<ingot::lane>(scalar(0.25)), bad, none), none});
    }
};

TYPED_TEST(FieldInWorld, body_that_meets_nan_freezes_alone) {
    ingot::World<Crowd<Pit, TypeParam>> world{};
    ingot::BodyId ids[4];
    for (int body_i = 0; body_i < 4; ++body_i) ids[body_i] = world.add(body(body_i)).value;
    EXPECT_EQ(ingot::step(world, scalar(1) / 60).bodies_frozen, 1);
    for (int body_i = 0; body_i < 4; ++body_i) {
        EXPECT_EQ(world.is_frozen(ids[body_i]), body_i == 2) << body_i;
        EXPECT_TRUE(ingot::is_finite(world.state(ids[body_i]).value.A) && ingot::is_finite(world.state(ids[body_i]).value.L));
    }
}

/// Forces, torques and gravity of the world act beside the field: a body of no field falls and spins as in a world without.
struct Calm : ingot::ForceField {
    ingot::Wrench operator()(const ingot::BodyMotion&) const { return ingot::Wrench{}; }
};

TYPED_TEST(FieldInWorld, gravity_and_forces_act_beside_it) {
    ingot::World<Crowd<Calm, TypeParam>> world{};
    ASSERT_EQ(world.set_gravity({0, 0, -8}), ingot::Status::ok);
    ingot::BodyDef def = body(0);
    def.state = {};
    const ingot::BodyId id = world.add(def).value;
    for (int step_i = 0; step_i < 64; ++step_i) {
        ASSERT_EQ(world.add_central_force(id, {4, 0, 0}), ingot::Status::ok);
        ASSERT_EQ(world.add_torque(id, {0, scalar(0.5), 0}), ingot::Status::ok);
        ASSERT_TRUE(ingot::step(world, scalar(1) / 64).clean());
    }
    const ingot::BodyState s = world.state(id).value;
    EXPECT_NEAR(static_cast<double>(s.v_CM.z), -8, 64 * 8 * eps);
    EXPECT_NEAR(static_cast<double>(s.r_CM.z), -4, 64 * 8 * eps);
    EXPECT_NEAR(static_cast<double>(s.r_CM.x), 1, 64 * 8 * eps);
    EXPECT_NEAR(static_cast<double>(s.L.y), 0.5, 64 * eps);
    EXPECT_NEAR(static_cast<double>(s.A.c2.x), std::sin(0.5 / 2 / 2), 1e-6);
}

struct Free : ingot::Scene {
    static constexpr bool translates = true;
};

/// A field without torque leaves the spin to the free method, to the bit.
TEST(Field, of_forces_alone_does_not_touch_the_spin) {
    ingot::World<Crowd<ingot::PointMassGravity>> orbiting{};
    ingot::World<Free> free{};
    orbiting.force_field().mu = 3;
    const ingot::BodyId a = orbiting.add(body(0)).value, b = free.add(body(0)).value;
    for (int step_i = 0; step_i < 200; ++step_i) {
        ASSERT_TRUE(ingot::step(orbiting, scalar(1) / 60).clean());
        ASSERT_TRUE(ingot::step(free, scalar(1) / 60).clean());
    }
    const ingot::BodyState in_orbit = orbiting.state(a).value, alone = free.state(b).value;
    EXPECT_EQ(std::memcmp(&in_orbit.A, &alone.A, sizeof alone.A), 0);
    EXPECT_EQ(std::memcmp(&in_orbit.L, &alone.L, sizeof alone.L), 0);
    EXPECT_NE(in_orbit.r_CM.x, alone.r_CM.x);
}

/// A world that collides takes the field as a force of mid-step, of second order; Listing 1 takes that of the begin, of first.
template <class Rotation, int contacts>
struct Falling : ingot::Scene {
    static constexpr bool translates = true;
    static constexpr int max_bodies = 2, max_contacts = contacts;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;
    using rotation = Rotation;
    using force_field = ingot::SpringDamper;
};

template <class S>
double error_of_spring(int steps) {
    ingot::World<S> world{};
    world.force_field().k = 10;
    world.force_field().c = 4;
    ingot::BodyDef def = body(0);
    def.state = {};
    def.state.r_CM = {1, 0, 0};
    def.shape = ingot::Sphere{scalar(0.5)};
    if (!ingot::collides<S>) def.shape = {};
    const ingot::BodyId id = world.add(def).value;
    const double h = 2.0 / steps;
    double worst = 0;
    for (int step_i = 1; step_i <= steps; ++step_i) {
        EXPECT_TRUE(ingot::step(world, static_cast<scalar>(h)).clean());
        const double t = step_i * h, exact = std::exp(-t) * (std::cos(2 * t) + 0.5 * std::sin(2 * t));
        worst = std::max(worst, std::abs(static_cast<double>(world.state(id).value.r_CM.x) - exact));
    }
    return worst;
}

TEST(Field, has_the_order_of_the_step_that_takes_it) {
    if (eps > 1e-10) GTEST_SKIP() << "float reaches its floor first";
    const auto order = [](double coarse, double fine) { return std::log2(coarse / fine); };
    using Colliding = Falling<ingot::MoserVeselov, 4>;
    using Printed = Falling<ingot::Listing1Euler, 0>;
    EXPECT_NEAR(order(error_of_spring<Colliding>(128), error_of_spring<Colliding>(256)), 2, 0.3);
    EXPECT_NEAR(order(error_of_spring<Printed>(1024), error_of_spring<Printed>(2048)), 1, 0.3);
}

/// Listing 1 takes a torque of the field as one that was given: that of the begin of the step, for the whole of it. Of a body that only turns, too.
struct Winding : ingot::ForceField {
    static constexpr bool depends_on_velocity = false;
    ingot::Wrench operator()(const ingot::BodyMotion& at) const {
        return ingot::Wrench::torque(ingot::splat(ingot::Vector{at.t, 2, 0}));
    }
};
struct Wound : ingot::Scene {
    using rotation = ingot::Listing1Euler;
    using force_field = Winding;
};
TEST(Field, of_torque_is_that_of_the_begin_for_listing_1) {
    ingot::World<Wound> world{};
    ingot::BodyDef def = body(0);
    def.state = {};
    const ingot::BodyId id = world.add(def).value;
    const double h = 1.0 / 64;  // and its multiples: no roundings
    for (int step_i = 0; step_i < 64; ++step_i) ASSERT_TRUE(ingot::step(world, static_cast<scalar>(h)).clean());
    const ingot::Vector L = world.state(id).value.L;
    EXPECT_EQ(static_cast<double>(L.x), h * h * 64 * 63 / 2);
    EXPECT_EQ(static_cast<double>(L.y), 2);
    EXPECT_EQ(static_cast<double>(L.z), 0);
}

/// Drag brings a falling ball to its final speed and the ground stops it: contacts and the field in one step.
struct Pool : ingot::Scene {
    static constexpr bool translates = true;
    static constexpr int max_bodies = 2, max_contacts = 4;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;
    using force_field = ingot::LinearDrag;
};

TEST(Field, and_contacts_act_in_one_step) {
    ingot::World<Pool> world{};
    ASSERT_EQ(world.set_gravity({0, 0, -10}), ingot::Status::ok);
    world.force_field().c = 20;  // of 2 kg: final speed 1 m/s
    ingot::BodyDef ground{};
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    ASSERT_TRUE(world.add(ground).ok());
    ingot::BodyDef ball = body(0);
    ball.state = {};
    ball.state.r_CM = {0, 0, scalar(3.5)};
    ball.shape = ingot::Sphere{scalar(0.5)};
    const ingot::BodyId id = world.add(ball).value;
    for (int step_i = 0; step_i < 120; ++step_i) ASSERT_TRUE(ingot::step(world, scalar(1) / 60).clean());
    EXPECT_NEAR(static_cast<double>(world.state(id).value.v_CM.z), -1, 1e-3);
    for (int step_i = 0; step_i < 240; ++step_i) ASSERT_TRUE(ingot::step(world, scalar(1) / 60).clean());
    EXPECT_NEAR(static_cast<double>(world.state(id).value.r_CM.z), 0.5, 1.0 / 60 + 1e-4);  // it stops within the step in which it lands
    EXPECT_NEAR(static_cast<double>(world.state(id).value.v_CM.z), 0, 1e-4);
}

/// In a world that collides a field is a force of mid-step: what brakes a spin is foreseen to first order, and acts to second. With a = c_turn / I a
/// step multiplies L by 1 - a h + (a h)^2 / 2, which is e^(-a h) but for (a h)^3 / 6.
TEST(Field, that_brakes_a_spin_acts_at_mid_step) {
    ingot::World<Pool> world{};
    world.force_field().c_turn = scalar(2.5);  // of I = 2.5: a = 1 / s
    ingot::BodyDef def = body(0);
    def.state = {};
    def.state.L = {0, 0, 2};
    def.shape = ingot::Sphere{scalar(0.5)};
    const ingot::BodyId id = world.add(def).value;
    constexpr int steps = 32;
    constexpr double h = 1.0 / steps;
    for (int step_i = 0; step_i < steps; ++step_i) ASSERT_TRUE(ingot::step(world, static_cast<scalar>(h)).clean());
    EXPECT_NEAR(static_cast<double>(world.state(id).value.L.z), 2 * std::exp(-1.0), 2 * steps * (h * h * h / 6 + 2 * eps));
}

/// Time is the sum of all steps without their roundings: 10^6 of 1/60 s.
TEST(Field, time_does_not_drift) {
    ingot::World<Crowd<Calm>> world{};
    const scalar h = scalar(1) / 60;
    for (int step_i = 0; step_i < 1000000; ++step_i) (void)ingot::step(world, h);
    const double exact = 1e6 * static_cast<double>(h);
    EXPECT_NEAR(static_cast<double>(world.time()), exact, eps * exact);
}

TEST(Field, is_kept_by_a_snapshot) {
    using W = ingot::World<Crowd<Everything>>;
    static W world, copy, loaded;
    std::memset(static_cast<void*>(&world), 0, sizeof world);
    std::memset(static_cast<void*>(&loaded), 0, sizeof loaded);
    world.force_field() = everything();
    const ingot::BodyId id = world.add(body(0)).value;
    for (int step_i = 0; step_i < 10; ++step_i) (void)ingot::step(world, scalar(1) / 60);
    std::memcpy(static_cast<void*>(&copy), &world, sizeof world);
    static uint8_t bytes[ingot::snapshot_size<Crowd<Everything>>()];
    const ingot::Result<size_t> size = ingot::save_snapshot(world, bytes, sizeof bytes);
    ASSERT_EQ(ingot::load_snapshot(loaded, bytes, size.value), ingot::Status::ok);
    for (W* each : {&world, &copy, &loaded})
        for (int step_i = 0; step_i < 10; ++step_i) (void)ingot::step(*each, scalar(1) / 60);
    EXPECT_TRUE(same_bits(world.state(id).value, copy.state(id).value));
    EXPECT_TRUE(same_bits(world.state(id).value, loaded.state(id).value));
    EXPECT_EQ(world.time(), copy.time());
    EXPECT_EQ(world.time(), loaded.time());
}

}  // namespace

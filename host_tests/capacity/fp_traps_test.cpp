// SPDX-License-Identifier: MIT
// Legal scenes raise no floating-point exception: with traps switched on, nothing traps. Empty lanes count too.
//
// Not among them: a body that leaves the range, which is found out by the infinity it runs into (see frozen_test.cpp).
#include "capacity/yard.h"

#include <fenv.h>
#include <gtest/gtest.h>

#include <csignal>

namespace {

using namespace yard;

constexpr int trapped = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;

class Traps {
public:
    Traps() {
        feclearexcept(FE_ALL_EXCEPT);
        feenableexcept(trapped);
    }
    ~Traps() {
        fedisableexcept(trapped);
        EXPECT_EQ(fetestexcept(trapped), 0);
    }
    Traps(const Traps&) = delete;
    Traps& operator=(const Traps&) = delete;
};

void do_what_traps(scalar numerator, scalar denominator) {
    const Traps traps;
    volatile scalar a = numerator, b = denominator, c = a / b;
    (void)c;
}

TEST(FpTrapsDeathTest, are_on) {
    EXPECT_EXIT(do_what_traps(0, 0), ::testing::KilledBySignal(SIGFPE), "");
    EXPECT_EXIT(do_what_traps(1, 0), ::testing::KilledBySignal(SIGFPE), "");
    EXPECT_EXIT(do_what_traps(scalar(1e30), scalar(1e-300) + scalar(1e-30) * (sizeof(scalar) == 4)), ::testing::KilledBySignal(SIGFPE), "");
    do_what_traps(1, 3);
}

template <class Rotation, int bodies>
struct Turning : ingot::Scene {
    static constexpr int max_bodies = bodies;
    using rotation = Rotation;
};

template <class Rotation, int bodies>
struct Everything : ingot::Scene {
    static constexpr int max_bodies = bodies;
    static constexpr bool translates = true;
    static constexpr int max_contacts = 8 * bodies;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    using rotation = Rotation;
};

template <class Rotation>
class FpTraps : public ::testing::Test {};
using Rotations = ::testing::Types<ingot::MoserVeselov, ingot::DiscreteMoserVeselov<4, false, false, 2>, ingot::Listing1Euler, ingot::LieMidpoint,
                                   ingot::Rk4Polar, ingot::SymmetricTop, ingot::SymmetricTopSplitting<6>, ingot::ExactElliptic>;
TYPED_TEST_SUITE(FpTraps, Rotations);

TYPED_TEST(FpTraps, none_in_any_number_of_lanes) {
    constexpr int most = 2 * ingot::lanes + 1;
    static World<Turning<TypeParam, most>> world;
    for (int count = 0; count <= most; ++count) {
        clear(world);
        const Traps traps;
        for (int body_i = 0; body_i < count; ++body_i) {
            BodyDef def = plain_body({});
            def.state.L = {1, static_cast<scalar>(body_i), 3};
            ASSERT_TRUE(world.add(def).ok());
        }
        for (int step_i = 0; step_i < 100; ++step_i) (void)ingot::step(world, h);
        (void)world.kinetic_energy();
        (void)world.angular_momentum();
    }
}

TYPED_TEST(FpTraps, none_in_lanes_that_bodies_have_left) {
    constexpr int most = 2 * ingot::lanes + 1;
    static World<Everything<TypeParam, most>> world;
    clear(world);
    const Traps traps;
    BodyId ids[most];
    for (int body_i = 0; body_i < most; ++body_i) {
        BodyDef def = plain_body({static_cast<scalar>(3 * body_i), 0, 2}, ingot::Sphere{1});
        def.state.L = {1, 2, 3};
        ids[body_i] = world.add(def).value;
    }
    ASSERT_EQ(world.set_gravity({0, 0, -10}), Status::ok);
    for (int body_i = 0; body_i < most; ++body_i) {
        (void)ingot::step(world, h);
        ASSERT_EQ(world.remove(ids[(body_i * 2) % most]), Status::ok);
    }
    for (int step_i = 0; step_i < 10; ++step_i) (void)ingot::step(world, h);
    EXPECT_EQ(world.body_count(), 0);
}

TYPED_TEST(FpTraps, none_in_a_heap_that_falls_and_settles) {
    static World<Everything<TypeParam, 12>> world;
    clear(world);
    const Traps traps;
    ASSERT_TRUE(world.add(ground()).ok());
    for (int body_i = 0; body_i < 10; ++body_i) {
        const scalar x = static_cast<scalar>(body_i % 3), z = static_cast<scalar>(body_i) + 1;
        BodyDef def = body_i % 2 != 0 ? plain_body({4 * x, 0, 2 * z}, ingot::Box{{1, scalar(0.5), scalar(0.25)}})
                                      : plain_body({4 * x, scalar(0.25), 2 * z}, ingot::Sphere{scalar(0.5)});
        def.state.L = {x, 1, z};
        def.restitution = scalar(body_i % 5) / 4;
        ASSERT_TRUE(world.add(def).ok());
    }
    ASSERT_EQ(world.set_gravity({0, 0, -10}), Status::ok);
    uint32_t contacts = 0;
    for (int step_i = 0; step_i < 600; ++step_i) contacts += ingot::step(world, h).contacts;
    EXPECT_GT(contacts, 100u);
    for (int contact_i = 0; contact_i < world.contact_count(); ++contact_i) (void)world.contact(contact_i);
    (void)world.state_hash();
}

TYPED_TEST(FpTraps, none_where_shapes_coincide) {
    static World<Everything<TypeParam, 6>> world;
    clear(world);
    const Traps traps;
    ASSERT_TRUE(world.add(ground()).ok());
    for (int body_i = 0; body_i < 2; ++body_i) {
        ASSERT_TRUE(world.add(plain_body({}, ingot::Sphere{1})).ok());
        ASSERT_TRUE(world.add(plain_body({}, ingot::Box{{1, 1, 1}})).ok());
    }
    for (int step_i = 0; step_i < 60; ++step_i) (void)ingot::step(world, h);
}

TYPED_TEST(FpTraps, none_in_calls_from_outside) {
    static World<Everything<TypeParam, 3>> world;
    clear(world);
    const Traps traps;
    BodyDef def = plain_body({0, 0, 5}, ingot::Sphere{1});
    def.state.A = ingot::rotation_about({scalar(0.6), 0, scalar(0.8)}, 1).value;
    const BodyId a = world.add(def).value;
    def.state.r_CM = {0, 0, 7};
    def.state.v_CM = {0, 0, -1};
    const BodyId b = world.add(def).value, wall = world.add(ground()).value;
    EXPECT_EQ(world.add_force(a, {1, 2, 3}, {1, 1, 1}), Status::ok);
    EXPECT_EQ(world.add_torque(b, {1, 2, 3}), Status::ok);
    EXPECT_EQ(world.apply_impulse(a, {1, 0, 0}, {0, 0, 6}), Status::ok);
    EXPECT_EQ(world.apply_angular_impulse(b, {1, 0, 0}), Status::ok);
    EXPECT_GT(world.collide(b, a, {0, 0, 6}, {0, 0, 1}, 1).value, 0);
    EXPECT_TRUE(world.collide(a, wall, {0, 0, 0}, {0, 0, 1}, scalar(0.5)).ok());
    EXPECT_EQ(world.set_state(a, def.state), Status::ok);
    for (const BodyId id : {a, b, wall}) {
        (void)world.kinetic_energy(id);
        (void)world.angular_momentum(id);
        (void)world.linear_momentum(id);
    }
    (void)ingot::step(world, h);
}

/// Methods without a largest angle of a step.
template <class Rotation>
class FpTrapsOfAnySpin : public ::testing::Test {};
using RotationsOfAnySpin = ::testing::Types<ingot::MoserVeselov, ingot::DiscreteMoserVeselov<4, false, false, 2>, ingot::Listing1Euler>;
TYPED_TEST_SUITE(FpTrapsOfAnySpin, RotationsOfAnySpin);

TYPED_TEST(FpTrapsOfAnySpin, none_at_the_ends_of_the_ranges) {
    static World<Everything<TypeParam, 8>> world;
    const scalar r = limits::position_max / 2, low = limits::inertia_min, high = limits::inertia_max;
    for (const scalar step : {limits::step_min, h, limits::step_max}) {
        clear(world);
        const Traps traps;
        BodyDef def = plain_body({-r, r, -r}, ingot::Sphere{limits::size_max});
        def.state.v_CM = Vector{1, -1, 1} * limits::speed_max;
        ASSERT_TRUE(world.add(def).ok());
        def = plain_body({r, r, r}, ingot::Sphere{limits::size_min});
        def.mass = mass_of(limits::mass_min, {low, low, low});
        def.state.L = {0, low * limits::spin_max * scalar(0.99), 0};
        ASSERT_TRUE(world.add(def).ok());
        def = plain_body({-r, -r, r}, ingot::Box{Vector{1, 1, 1} * limits::size_max});
        def.mass = mass_of(limits::mass_max, {high, high, high});
        def.state.L = {0, 0, high * limits::spin_max * scalar(0.99)};
        ASSERT_TRUE(world.add(def).ok());
        def = plain_body({-r, -r, r}, ingot::Box{Vector{1, 1, 1} * limits::size_min});
        ASSERT_TRUE(world.add(def).ok());
        BodyDef wall = ground();
        wall.shape = ingot::HalfSpace{{0, 0, -1}, limits::position_max};
        ASSERT_TRUE(world.add(wall).ok());
        for (int step_i = 0; step_i < 20; ++step_i) ASSERT_EQ(ingot::step(world, step).bodies_frozen, 0);
        (void)world.kinetic_energy();
        (void)world.linear_momentum();
        (void)world.angular_momentum();
    }
}

TYPED_TEST(FpTrapsOfAnySpin, none_with_spins_that_must_be_clamped) {
    static World<Everything<TypeParam, 2>> world;
    clear(world);
    const Traps traps;
    BodyDef def = plain_body({});
    def.state.L = {limits::spin_max / 2, limits::spin_max / 4, 0};
    ASSERT_TRUE(world.add(def).ok());
    for (int step_i = 0; step_i < 100; ++step_i) (void)ingot::step(world, limits::step_max);
}

/// Contacts with friction, all shapes that step, and what may be named beside them.
template <class BroadPhase, bool renews>
struct Pile : ingot::Scene {
    static constexpr int max_bodies = 26;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 120;
    static constexpr int max_overlaps = 26;
    static constexpr int max_events = 100;
    static constexpr bool recycles_manifolds = renews;
    using broad_phase = BroadPhase;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::Cylinder, ingot::HalfSpace>;
};

template <class S>
class FpTrapsOfFriction : public ::testing::Test {
protected:
    static Shape shape(int kind) {
        switch (kind % 4) {
            case 0: return ingot::Sphere{scalar(0.5)};
            case 1: return ingot::Box{{scalar(0.5), scalar(0.375), scalar(0.25)}};
            case 2: return ingot::Capsule{scalar(0.25), scalar(0.5)};
            default: return ingot::Cylinder{scalar(0.5), scalar(0.25)};
        }
    }
    static void put_ground() {
        clear(world_);
        BodyDef floor = ground();
        floor.friction = scalar(0.5);
        ASSERT_TRUE(world_.add(floor).ok());
        ASSERT_EQ(world_.set_gravity({0, 0, -10}), Status::ok);
    }
    static World<S> world_;
};
template <class S>
World<S> FpTrapsOfFriction<S>::world_;
using Piles = ::testing::Types<Pile<ingot::AllPairs, true>, Pile<ingot::SortedTree, true>, Pile<ingot::AllPairs, false>,
                               Pile<ingot::QueryTree, true>>;
TYPED_TEST_SUITE(FpTrapsOfFriction, Piles);

TYPED_TEST(FpTrapsOfFriction, none_in_a_heap_that_falls_and_settles) {
    auto& world = this->world_;
    this->put_ground();
    const Traps traps;
    BodyDef sensor = plain_body({0, 0, 1}, ingot::Box{{2, 2, 1}});
    sensor.immovable = sensor.sensor = true;
    ASSERT_TRUE(world.add(sensor).ok());
    for (int body_i = 0; body_i < 24; ++body_i) {
        BodyDef def = plain_body({scalar(body_i % 3) * scalar(0.75), scalar(body_i % 2) * scalar(0.5), scalar(body_i) + 1}, this->shape(body_i));
        def.state.L = {scalar(body_i % 5), 1, scalar(body_i % 3)};
        def.friction = scalar(body_i % 4) / 3;
        def.restitution = scalar(body_i % 5) / 4;
        ASSERT_TRUE(world.add(def).ok());
    }
    uint32_t contacts = 0;
    for (int step_i = 0; step_i < 400; ++step_i) contacts += ingot::step(world, h).contacts;
    EXPECT_GT(contacts, 1000u);
    (void)world.state_hash();
}

TYPED_TEST(FpTrapsOfFriction, none_where_shapes_coincide) {
    auto& world = this->world_;
    for (int kind = 0; kind < 16; ++kind) {
        this->put_ground();
        const Traps traps;
        for (const int one : {kind % 4, kind / 4}) {
            BodyDef def = plain_body({0, 0, 0}, this->shape(one));
            def.friction = 1;
            ASSERT_TRUE(world.add(def).ok());
        }
        for (int step_i = 0; step_i < 60; ++step_i) (void)ingot::step(world, h);
    }
}

/// Rays of a micrometre and of the whole world, square to axes and not; before there is a tree, and in one that is half empty.
TYPED_TEST(FpTrapsOfFriction, none_in_queries_at_the_ends_of_the_ranges) {
    auto& world = this->world_;
    this->put_ground();
    const Traps traps;
    const scalar far = limits::position_max / 2, near = 2 * limits::size_min;
    for (int body_i = 0; body_i < 10; ++body_i) {
        const scalar place = body_i == 9 ? far : scalar(body_i);
        ASSERT_TRUE(world.add(plain_body({place, scalar(body_i % 3), 1}, this->shape(body_i))).ok());
    }
    int found = 0;
    for (int step_i = 0; step_i < 3; ++step_i) {
        for (const scalar length : {near, scalar(1), 2 * far})
            for (const scalar z : {scalar(1), -far, near})
                for (int towards = 1; towards < 27; ++towards) {
                    const Vector way = Vector{scalar(towards % 3 - 1), scalar(towards / 3 % 3 - 1), scalar(towards / 9 - 1)} * length;
                    const ingot::PlacedShape ball = {ingot::Sphere{near}, {0, 0, z}, ingot::identity_matrix<scalar>(), nullptr};
                    BodyId ids[4];
                    if (towards != 13) found += world.cast_ray(ball.r, way).value.found() + world.cast_shape(ball, way).value.found();
                    found += world.find_nearest(ball.r, length).value.found() + world.find_overlaps(ball, ids, 4).value;
                }
        (void)ingot::step(world, h);
    }
    EXPECT_GT(found, 200);
}

TYPED_TEST(FpTrapsOfFriction, none_of_masses_and_frictions_at_the_ends_of_the_ranges) {
    auto& world = this->world_;
    for (const scalar friction : {scalar(0), limits::friction_max}) {
        for (const scalar M : {scalar(1e-6), scalar(1e6)}) {
            this->put_ground();
            const Traps traps;
            for (int body_i = 0; body_i < 6; ++body_i) {
                BodyDef def = plain_body({0, 0, scalar(body_i) + scalar(0.5)}, ingot::Box{{scalar(0.5), scalar(0.5), scalar(0.5)}});
                const scalar mass = body_i % 2 == 0 ? M : 1 / M;
                def.mass = mass_of(mass, Vector{1, 1, 1} * (mass / 6));
                def.friction = friction;
                ASSERT_TRUE(world.add(def).ok());
            }
            for (int step_i = 0; step_i < 120; ++step_i) (void)ingot::step(world, h);
        }
    }
}

}  // namespace

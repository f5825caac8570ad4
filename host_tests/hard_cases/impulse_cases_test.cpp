// SPDX-License-Identifier: MIT
// Impulses, cases I1 to I9: Fig. 4 of the article, and what the world makes of it. I10 asks for friction, I11 and I12 for fast bodies that meet what
// they would fly past.
#include "hard_cases/flown_by.h"

#include <gtest/gtest.h>

#include <random>

#include "reference/impulse_table.h"

namespace {

using namespace hard_cases;
using Vector3 = Eigen::Vector3d;

template <int bodies>
struct Yard : ingot::Scene {
    static constexpr int max_bodies = bodies, max_contacts = 8 * bodies;
    using solver = ingot::FrictionlessImpacts;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};

ingot::BodyDef ball(double M, double radius, double x, double v_x, double e) {
    const double I = 0.4 * M * radius * radius;
    ingot::BodyDef def = definition(M, Vector3(I, I, I));
    def.state.r_CM = {static_cast<scalar>(x), 0, 0};
    def.state.v_CM = {static_cast<scalar>(v_x), 0, 0};
    def.shape = ingot::Sphere{static_cast<scalar>(radius)};
    def.restitution = static_cast<scalar>(e);
    return def;
}

ingot::BodyDef ground(double e) {
    ingot::BodyDef def{};
    def.immovable = true;
    def.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    def.restitution = static_cast<scalar>(e);
    return def;
}

ingot::CollidingBody colliding(double inv_M, const Vector3& inv_I, const Vector3& v, const Vector3& r) {
    return {static_cast<scalar>(inv_M), {static_cast<scalar>(inv_I.x()), static_cast<scalar>(inv_I.y()), static_cast<scalar>(inv_I.z()), 0, 0, 0},
            to_vector(v), {}, to_vector(r)};
}

/// I1 and I2 row by row stand in stages/impulse_test.cpp; this is the sum of momentum they leave.
TEST(HardCases, I02_mass_ratios_keep_the_momentum) {
    for (const double ratio : {1.0, 1e3, 1e6}) {
        ingot::World<Yard<2>> world{};
        const ingot::BodyId a = world.add(ball(1, 0.5, 0, 1, 1)).value, b = world.add(ball(ratio, 0.5, 1, -0.5, 1)).value;
        const double before = static_cast<double>(world.linear_momentum().x);
        const ingot::Result<scalar> j = world.collide(a, b, {scalar(0.5), 0, 0}, {-1, 0, 0}, 1);
        ASSERT_TRUE(j.ok());
        const double exact = 2 * 1.5 / (1 + 1 / ratio);
        EXPECT_NEAR(static_cast<double>(j.value), exact, exact * bound(1e-13, 1e-5));
        EXPECT_NEAR(static_cast<double>(world.linear_momentum().x), before, 2 * eps * 0.5 * ratio + 2 * eps);
    }
}

/// Grazing: the impulse goes to zero with the speed, and never changes its sign.
TEST(HardCases, I03_grazing) {
    for (double speed = 1e-3; speed > 1e-13; speed /= 10) {
        const ingot::CollidingBody A = colliding(1, {1, 1, 1}, {100, 0, -speed}, {0.5, 0, -0.5}), B = colliding(0, {0, 0, 0}, {0, 0, 0}, {0, 0, 0});
        const double j = static_cast<double>(ingot::collision_impulse(A, B, {0, 0, 1}, scalar(0.5)));
        const double K = 1 + 0.25, exact = 1.5 * speed / K;
        EXPECT_NEAR(j, exact, exact * bound(1e-13, 1e-5) + 4 * eps * 100 * eps) << speed;
        EXPECT_GT(j, 0);
    }
}

TEST(HardCases, I04_elastic_pairs_keep_the_energy) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int pair_i = 0; pair_i < 500; ++pair_i) {
        ingot::World<Yard<2>> world{};
        const auto direction = [&] { return Vector3(unit(random), unit(random), unit(random)); };
        ingot::BodyId ids[2];
        for (ingot::BodyId& id : ids) {
            ingot::BodyDef def = definition(std::pow(10, unit(random)), Vector3(1, 1.5, 2) * std::pow(10, unit(random)));
            def.state.v_CM = to_vector(direction());
            def.state.L = to_vector(direction());
            id = world.add(def).value;
        }
        const Vector3 n = direction().normalized();
        const double before = static_cast<double>(world.kinetic_energy());
        const ingot::Result<scalar> j = world.collide(ids[0], ids[1], to_vector(direction()), to_vector(n), 1);
        ASSERT_TRUE(j.ok());
        EXPECT_NEAR(static_cast<double>(world.kinetic_energy()), before, before * bound(1e-13, 1e-5)) << pair_i;
    }
}

/// e = 1: the impact is where the ball meets the ground, within the step.
TEST(HardCases, I05_elastic_ball) {
    ingot::World<Yard<2>> world{};
    ASSERT_EQ(world.set_gravity({0, 0, -10}), ingot::Status::ok);
    ASSERT_TRUE(world.add(ground(1)).ok());
    ingot::BodyDef def = ball(1, 0.5, 0, 0, 1);
    def.state.r_CM = {0, 0, scalar(2.5)};
    const ingot::BodyId id = world.add(def).value;
    double worst = 0;
    for (int step_i = 0; step_i < 60 * 25; ++step_i) {
        ASSERT_TRUE(ingot::step(world, scalar(1) / 60).clean());
        const ingot::BodyState s = world.state(id).value;
        const double energy = 10 * static_cast<double>(s.r_CM.z) + 0.5 * static_cast<double>(s.v_CM.z) * static_cast<double>(s.v_CM.z);
        worst = std::max(worst, std::abs(energy / 25 - 1));
    }
    std::printf("    energy within %.1e\n", worst);
    EXPECT_LE(worst, bound(1e-12, 2e-5));
}

/// e = 1/2: bounces without end come to an end in the right time, and nothing trembles after it.
TEST(HardCases, I06_zeno) {
    ingot::World<Yard<2>> world{};
    ASSERT_EQ(world.set_gravity({0, 0, -10}), ingot::Status::ok);
    ASSERT_TRUE(world.add(ground(0.5)).ok());
    ingot::BodyDef def = ball(1, 0.5, 0, 0, 0.5);
    def.state.r_CM = {0, 0, scalar(2.5)};
    const ingot::BodyId id = world.add(def).value;
    const double fall = std::sqrt(2 * 2 / 10.0), exact = fall * (1 + 2 * 0.5 / (1 - 0.5));
    int last = 0;
    double speed = 0;
    for (int step_i = 1; step_i <= 600; ++step_i) {
        ASSERT_TRUE(ingot::step(world, scalar(1) / 60).clean());
        speed = std::abs(static_cast<double>(world.state(id).value.v_CM.z));
        if (speed > 1e-6) last = step_i;
    }
    std::printf("    at rest after %.3f s, exact %.3f s\n", last / 60.0, exact);
    EXPECT_LE(speed, 1e-6);
    // The last bounces, slower than 2 g h, are left out: 2 v / g (1 + e + e^2 ...) of them, and each impact waits for its step.
    EXPECT_NEAR(last / 60.0, exact, 2 * (2 * 10 / 60.0) / 10 / (1 - 0.5) + 6 / 60.0);
}

/// Balls in a row that touch: the last one leaves with the speed of the first, for any number of them.
TEST(HardCases, I07_newtons_cradle) {
    for (int balls = 2; balls <= 5; ++balls) {
        ingot::World<Yard<5>> world{};
        ingot::BodyId ids[5];
        for (int ball_i = 0; ball_i < balls; ++ball_i)
            ids[ball_i] = world.add(ball(1, 0.5, ball_i == 0 ? -0.01 : ball_i, ball_i == 0 ? 1 : 0, 1)).value;
        for (int step_i = 0; step_i < 30; ++step_i) ASSERT_TRUE(ingot::step(world, scalar(1) / 60).clean());
        for (int ball_i = 0; ball_i < balls; ++ball_i)
            EXPECT_NEAR(static_cast<double>(world.state(ids[ball_i]).value.v_CM.x), ball_i == balls - 1 ? 1 : 0, 16 * eps)
                << balls << " balls, " << ball_i;
        EXPECT_NEAR(static_cast<double>(world.kinetic_energy()), 0.5, 16 * eps);
    }
}

TEST(HardCases, I08_box_dropped_flat) {
    for (const double e : {0.0, 0.5}) {
        ingot::World<Yard<2>> world{};
        ASSERT_EQ(world.set_gravity({0, 0, -10}), ingot::Status::ok);
        ASSERT_TRUE(world.add(ground(e)).ok());
        ingot::BodyDef def = definition(3, Vector3(0.5, 0.625, 0.75));
        def.state.r_CM = {0, 0, 2};
        def.shape = ingot::Box{{scalar(0.5), scalar(0.75), scalar(0.25)}};
        def.restitution = static_cast<scalar>(e);
        const ingot::BodyId id = world.add(def).value;
        double spin = 0, impulse = 0;
        for (int step_i = 0; step_i < 120; ++step_i) {
            ASSERT_TRUE(ingot::step(world, scalar(1) / 60).clean());
            if (impulse == 0 && world.contact_count() == 4) {
                for (int contact_i = 0; contact_i < 4; ++contact_i) {
                    const double j = static_cast<double>(world.contact(contact_i).value.j);
                    const double exact = 3 * std::sqrt(2 * 10 * 1.75) * (1 + e) / 4;  // it falls 1.75 m
                    impulse += j;
                    if (e > 0) { EXPECT_NEAR(j, exact, exact * bound(1e-12, 1e-4)); }
                }
            }
            spin = std::max(spin, length_of(to_eigen(world.omega(id).value)));
        }
        EXPECT_GT(impulse, 0);
        EXPECT_LE(spin, bound(1e-10, 1e-4));
    }
}

/// A rod that meets the ground at an angle, by one corner of its end or by an edge (two): Fig. 4 in closed form.
TEST(HardCases, I09_rod_and_edge) {
    for (const double angle : {0.3, 0.8, 1.2}) {
        ingot::World<Yard<2>> world{};
        ASSERT_TRUE(world.add(ground(0.5)).ok());
        const Vector3 half(0.02, 0.02, 0.5);
        const double M = 2, I = M / 3 * (half.z() * half.z() + half.x() * half.x());
        ingot::BodyDef def = definition(M, Vector3(I, I, M / 3 * 2 * half.x() * half.x()));
        def.state.A = ingot::axis_angle({0, 1, 0}, static_cast<scalar>(angle));
        // The edge along y at body (+-x, *, -z) that is lowest.
        const Vector3 edge(half.x(), 0, -half.z());
        const double drop = std::cos(angle) * edge.z() - std::sin(angle) * edge.x(), lever = std::cos(angle) * edge.x() + std::sin(angle) * edge.z();
        def.state.r_CM = {0, 0, static_cast<scalar>(-drop)};
        def.state.v_CM = {0, 0, -2};
        def.shape = ingot::Box{to_vector(half)};
        def.restitution = scalar(0.5);
        const ingot::BodyId id = world.add(def).value;
        ASSERT_TRUE(ingot::step(world, scalar(1e-6)).clean());
        const double j = 1.5 * 2 / (1 / M + lever * lever / I);
        EXPECT_NEAR(static_cast<double>(world.state(id).value.v_CM.z), -2 + j / M, bound(1e-9, 1e-4));
        EXPECT_NEAR(static_cast<double>(world.omega(id).value.y), -lever * j / I, bound(1e-9, 2e-3));
        EXPECT_NEAR(static_cast<double>(world.omega(id).value.x), 0, bound(1e-9, 2e-3));
    }
}

}  // namespace

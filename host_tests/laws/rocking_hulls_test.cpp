// SPDX-License-Identifier: MIT
// Hulls that rock and roll from corner to corner: a half of an ellipsoid, as rattlebacks are.
#include <gtest/gtest.h>

#include <ingot/ingot.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>

#include "reference/draws.h"
#include "reference/kernel_types.h"
#include "reference/random_input.h"

namespace {

using ingot::scalar;
using ingot::Vector;

constexpr int corners = 25;
struct Half {
    Vector corner[corners];
};
/// Flat on top: three rings of eight corners, the second turned by half of what is between two, and one below.
constexpr Half half_ellipsoid(double a, double b, double c) {
    constexpr double cosine[] = {1, 0.92388, 0.70711, 0.38268, 0, -0.38268, -0.70711, -0.92388, -1, -0.92388, -0.70711, -0.38268, 0, 0.38268, 0.70711,
                                 0.92388};
    constexpr double wide[] = {1, 0.86603, 0.5}, deep[] = {0, 0.5, 0.86603};
    Half half{};
    for (int i = 0; i < corners - 1; ++i) {
        const int ring = i / 8, at = 2 * (i % 8) + ring % 2;
        half.corner[i] = {static_cast<scalar>(a * wide[ring] * cosine[at]), static_cast<scalar>(b * wide[ring] * cosine[(at + 12) % 16]),
                          static_cast<scalar>(-c * deep[ring])};
    }
    half.corner[corners - 1] = {0, 0, static_cast<scalar>(-c)};
    return half;
}

template <int i>
struct Rattleback {
    static constexpr double sizes[3][3] = {{0.25, 0.1, 0.05}, {0.1, 0.1, 0.1}, {0.4, 0.15, 0.12}};
    static constexpr Half half = half_ellipsoid(sizes[i][0], sizes[i][1], sizes[i][2]);
    static constexpr auto hull = ingot::convex_hull<corners>(half.corner);
    static_assert(hull.ok());
    static constexpr auto mass = ingot::principal(ingot::solid_hull(1000, hull.value.view()).value);
    static constexpr auto of_body = ingot::convex_hull_of_body<corners>(half.corner, mass.value);
    static_assert(of_body.ok());
};

struct Table : ingot::Scene {
    static constexpr int max_bodies = 2, max_manifolds = 2;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Box, ingot::Hull, ingot::HalfSpace>;
    static constexpr ingot::ConvexHull hulls[] = {Rattleback<0>::of_body.value.view(), Rattleback<1>::of_body.value.view(),
                                                  Rattleback<2>::of_body.value.view()};
};

/// Spun and tilted where it stands, with friction and without: what all steps of four seconds give, together, lifts it by less than
/// limits::touching_gap, the depth of what counts as touching. On a half space and on a box.
TEST(Energy, of_a_hull_that_rocks_does_not_grow) {
    constexpr double g = 9.81, rates[] = {60, 120, 240, 1000};
    const ingot::MassProperties masses[] = {Rattleback<0>::mass.value, Rattleback<1>::mass.value, Rattleback<2>::mass.value};
    double worst = 0;
    for (int case_i = 0; case_i < ingot_reference::draws(240); ++case_i) {
        ingot_reference::RandomInput random(static_cast<uint64_t>(case_i));
        const double rate = rates[case_i % 4], mu = case_i % 3 == 0 ? 0 : random.real(0.1, 1);
        const int hull_i = random.integer(0, 2);
        const auto world = std::make_unique<ingot::World<Table>>();
        ASSERT_EQ(world->set_gravity({0, 0, scalar(-g)}), ingot::Status::ok);
        ingot::BodyDef table;
        table.immovable = true;
        table.friction = scalar(mu);
        table.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        if (random.integer(0, 3) == 0) {
            table.shape = ingot::Box{{5, 5, 1}};
            table.state.r_CM = {0, 0, -1};
        }
        ASSERT_TRUE(world->add(table).ok());
        ingot::BodyDef def;
        def.mass = masses[hull_i];
        def.shape = ingot::hull_of<Table>(hull_i);
        def.friction = scalar(mu);
        def.state.A = def.mass.A_principal;
        const double c = hull_i == 0 ? 0.05 : hull_i == 1 ? 0.1 : 0.12;
        def.state.r_CM = {0, 0, static_cast<scalar>(c) + def.mass.r_CM.z};
        const ingot::BodyId id = world->add(def).value;
        const auto h = static_cast<scalar>(1 / rate);
        for (int step_i = 0; step_i < rate / 4; ++step_i) (void)ingot::step(*world, h);
        // At most 8 rad/s: what turns by more than a tenth in a step sinks by the sagittas of its arcs, and is lifted by them.
        const Eigen::Vector3d omega = random.vector(3) + random.real(-5, 5) * Eigen::Vector3d::UnitZ();
        const Eigen::Vector3d kick = ingot_reference::to_eigen(def.mass.I_body).cwiseProduct(omega);
        ASSERT_EQ(world->apply_angular_impulse(id, ingot_reference::to_vector(kick)), ingot::Status::ok);
        const double M = static_cast<double>(def.mass.M);
        const auto energy = [&] { return static_cast<double>(world->kinetic_energy()) + M * g * static_cast<double>(world->state(id).value.r_CM.z); };
        double before = energy(), given = 0;
        for (int step_i = 0; step_i < 4 * rate; ++step_i) {
            (void)ingot::step(*world, h);
            const double now = energy();
            given += std::max(now - before, 0.0);
            before = now;
        }
        const double rounding = 4 * rate * 16 * static_cast<double>(ingot::epsilon) * before;
        const double lift = M * g * static_cast<double>(ingot::limits::touching_gap) + rounding;
        EXPECT_LE(given, lift) << "case " << case_i << ", " << rate << " Hz, mu " << mu << ", hull " << hull_i;
        worst = std::max(worst, given / lift);
    }
    std::printf("    given by all steps of four seconds, at most %.3g of what lifts it by touching_gap\n", worst);
}

}  // namespace

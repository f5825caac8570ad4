// SPDX-License-Identifier: MIT
// The order of the default rotation method: 10 (double) or 6 (float) for free bodies, 2 for driven ones.
#include <gtest/gtest.h>
#include <ingot/ingot.h>

#include <cstdio>

#include "reference/eigen_driven_body.h"
#include "reference/eigen_free_body.h"
#include "reference/kernel_types.h"
#include "reference/measure.h"

namespace {

using namespace ingot_reference;
using ingot::scalar;
using Column = Eigen::Matrix<long double, 3, 1>;
using Square = Eigen::Matrix<long double, 3, 3>;

struct Flyer : ingot::Scene {};

const Column I(1, 2, 3);

/// Attitude error after t seconds in steps of h, which are exact in float.
double free_error(const Column& L, long double t, long double h) {
    ingot::World<Flyer> world{};
    ingot::BodyDef def = definition(1, I);
    def.state.L = to_vector(L);
    const ingot::BodyId id = world.add(def).value;
    for (long step_i = 0; step_i < std::lround(t / h); ++step_i) EXPECT_TRUE(ingot::step(world, static_cast<scalar>(h)).clean());
    FreeBody exact(I, Square::Identity(), L);
    exact.advance(t);
    return attitude_error(to_eigen<long double>(world.state(id).value.A), exact.A());
}

/// No substeps are taken below |omega| h = 1/2, and the spin goes up to 1.92 rad/s: steps of 1/4 s at most. In float the error of
/// the finer run is 5e-6 rad and rounding adds 1.5e-6, which is 0.4 of the order; in double rounding, 1e-14, is far below.
TEST(RotationOrder, free_bodies) {
    constexpr double order = INGOT_DOUBLE ? 10 : 6, margin = INGOT_DOUBLE ? 0.3 : 0.5;
    const long double h = INGOT_DOUBLE ? 3.0L / 16 : 1.0L / 4;
    const Column L(0.5L, 3, 3);  // w = (0.5, 1.5, 1) at the begin
    const double coarse = free_error(L, 63, h), fine = free_error(L, 63, h / 2);
    std::printf("    error %.1e at h = %.3f s, %.1e at half of it: order %.2f\n", coarse, static_cast<double>(h), fine, std::log2(coarse / fine));
    EXPECT_NEAR(std::log2(coarse / fine), order, margin);
}

/// Torque that changes with time, tau(t) = c cos(nu t) + s sin(nu t), given at the middle of each step: kick, drift, kick.
Column torque_at(long double t) { return Column(0.5L, -0.25L, 1) * std::cos(2 * t) + Column(0.25L, 0.75L, -0.5L) * std::sin(2 * t); }

double driven_error(int steps, const Square& A_exact) {
    const long double t = 4;
    ingot::World<Flyer> world{};
    ingot::BodyDef def = definition(1, I);
    def.state.L = {scalar(0.5), 2, scalar(2.25)};
    const ingot::BodyId id = world.add(def).value;
    for (int step_i = 0; step_i < steps; ++step_i) {
        EXPECT_EQ(world.add_torque(id, to_vector(torque_at((step_i + 0.5L) * t / steps))), ingot::Status::ok);
        EXPECT_TRUE(ingot::step(world, static_cast<scalar>(t / steps)).clean());
    }
    return attitude_error(to_eigen<long double>(world.state(id).value.A), A_exact);
}

TEST(RotationOrder, driven_bodies) {
    DrivenBody exact(I, Square::Identity(), Column(0.5L, 2, 2.25L));
    exact.advance(4, 4096, [](long double t, const Square&) { return torque_at(t); });
    const double coarse = driven_error(64, exact.A()), fine = driven_error(128, exact.A()), finest = driven_error(256, exact.A());
    std::printf("    error %.1e, %.1e, %.1e: orders %.2f and %.2f\n", coarse, fine, finest, std::log2(coarse / fine),
                std::log2(fine / finest));
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.3);
    EXPECT_NEAR(std::log2(fine / finest), 2, 0.3);
}

/// A constant torque about a principal axis turns the body by tau t^2 / (2 I): exact but for roundings, because the momentum
/// at the middle of a step is its mean. 400 steps add up 4 roundings each of angles up to 12 rad.
TEST(RotationOrder, constant_torque_about_a_principal_axis_is_exact) {
    constexpr double u = static_cast<double>(roundoff<scalar>);
    ingot::World<Flyer> world{};
    const ingot::BodyId id = world.add(definition(1, Eigen::Vector3d(1, 2, 3))).value;
    for (int step_i = 0; step_i < 256; ++step_i) {
        ASSERT_EQ(world.add_torque(id, {0, 0, scalar(1.5)}), ingot::Status::ok);
        ASSERT_TRUE(ingot::step(world, scalar(1) / 64).clean());
    }
    const Square expected = Eigen::AngleAxis<long double>(1.5L * 16 / (2 * 3), Column::UnitZ()).toRotationMatrix();
    const Eigen::Vector3d L = to_eigen(world.state(id).value.L);
    EXPECT_EQ(L, Eigen::Vector3d(0, 0, 6));  // exact in binary
    EXPECT_LE(attitude_error(to_eigen<long double>(world.state(id).value.A), expected), 256 * 4 * u);
}

}  // namespace

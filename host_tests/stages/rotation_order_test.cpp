// SPDX-License-Identifier: MIT
// The orders of the rotation methods for free bodies, and of the default one for driven bodies.
#include <gtest/gtest.h>
#include <ingot/ingot.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <type_traits>

#include "reference/eigen_driven_body.h"
#include "reference/eigen_free_body.h"
#include "reference/kernel_types.h"
#include "reference/measure.h"
#include "reference/random_input.h"
#include "tiles.h"

namespace {

using namespace ingot_reference;
using ingot::scalar;
using Column = Eigen::Matrix<long double, 3, 1>;
using Square = Eigen::Matrix<long double, 3, 3>;

struct Flyer : ingot::Scene {};

template <class Rotation>
struct FlyerWith : ingot::Scene {
    using rotation = Rotation;
};

const Column I(1, 2, 3);

/// Attitude error after t seconds in steps of h, which are exact in float.
template <class Scene>
double free_error(const Column& moments, const Column& L, long double t, long double h) {
    ingot::World<Scene> world{};
    ingot::BodyDef def = definition(1, moments);
    def.state.L = to_vector(L);
    const ingot::BodyId id = world.add(def).value;
    for (long step_i = 0; step_i < std::lround(t / h); ++step_i)
        EXPECT_TRUE(ingot::step(world, static_cast<scalar>(h)).clean());
    FreeBody exact(moments, Square::Identity(), L);
    exact.advance(t);
    return attitude_error(to_eigen<long double>(world.state(id).value.A), exact.A());
}

template <class Rotation>
class RotationOrder : public ::testing::Test {};

// In float what the orders from 6 up leave out drowns in rounding at any step that needs no substeps; see the next test.
using Methods = ::testing::Types<ingot::LieMidpoint, ingot::SymmetricTopSplitting<2>, ingot::DiscreteMoserVeselov<2>,
                                 ingot::DiscreteMoserVeselov<4>
#if INGOT_DOUBLE
                                 ,
                                 ingot::Rk4Polar, ingot::SymmetricTopSplitting<6>, ingot::DiscreteMoserVeselov<6>,
                                 ingot::DiscreteMoserVeselov<8>, ingot::DiscreteMoserVeselov<10>
#endif
                                 >;
struct MethodName {
    template <class Rotation>
    static std::string GetName(int) {
        std::string name = Rotation::name;
        if (name.find("symmetric") == std::string::npos) name += "_order_" + std::to_string(Rotation::order);
        return name;
    }
};
TYPED_TEST_SUITE(RotationOrder, Methods, MethodName);

/// R17: half the step, 2^-order of the error, from steps so short that the next term is below a tenth (the spin goes up to
/// 1.92 rad/s, and no substeps are taken below 1/2 rad a step) and so long that the error is far above rounding: |omega| h
/// between 0.36 and 0.18 for order 10, shorter for lower orders.
TYPED_TEST(RotationOrder, free_bodies) {
    const Column L(0.5L, 3, 3);  // w = (0.5, 1.5, 1) at the begin
    // The polar step takes away most of the fifth-order term of Runge-Kutta, the part of it that is no rotation: above 1/100 s
    // the sixth order shows, and the slope is 5 and more.
    const bool runge_kutta = std::is_same<TypeParam, ingot::Rk4Polar>::value;
    const long double h = runge_kutta             ? 3.0L / 512
                          : TypeParam::order >= 8 ? 3.0L / 16
                          : TypeParam::order >= 4 ? 3.0L / 32
                                                  : 3.0L / 64;
    using Scene = FlyerWith<TypeParam>;
    const long double t = TypeParam::order <= 2 ? 3 : 12;
    const double coarse = free_error<Scene>(I, L, t, h), fine = free_error<Scene>(I, L, t, h / 2);
    std::printf("    error %.1e at h = %.3f s, %.1e at half of it: order %.2f\n", coarse, static_cast<double>(h), fine,
                std::log2(coarse / fine));
    EXPECT_NEAR(std::log2(coarse / fine), TypeParam::order, 0.3);
}

/// The default method of float, order 6, as far as float shows it: between |omega| h = 0.48 and 0.24 the next term takes half
/// an order off (and so it does in double), and rounding, 1e-6 of 1e-5, adds or takes 0.1.
TEST(DefaultRotation, order_6_shows_in_float_too) {
    const Column L(0.5L, 3, 3);
    using Scene = FlyerWith<ingot::DiscreteMoserVeselov<6>>;
    const double coarse = free_error<Scene>(I, L, 63, 0.25L), fine = free_error<Scene>(I, L, 63, 0.125L);
    std::printf("    error %.1e at h = 1/4 s, %.1e at 1/8 s: order %.2f\n", coarse, fine, std::log2(coarse / fine));
    EXPECT_NEAR(std::log2(coarse / fine), 5.5, 0.2);
}

template <class Rotation>
class HighOrder : public ::testing::Test {};
using HighOrders = ::testing::Types<ingot::Rk4Polar, ingot::SymmetricTopSplitting<6>, ingot::DiscreteMoserVeselov<4>, ingot::DiscreteMoserVeselov<6>,
                                    ingot::DiscreteMoserVeselov<8>, ingot::DiscreteMoserVeselov<10>, ingot::ExactElliptic>;
TYPED_TEST_SUITE(HighOrder, HighOrders);

/// In float too, as far as it shows: what order 4 leaves out of a step is below (|omega| h)^5 / 120, with |omega| h = 0.06 below a rounding of A.
/// To the radian and to the step, a few roundings: 8.
TYPED_TEST(HighOrder, leaves_out_less_than_rounding_at_short_steps) {
    constexpr double u = static_cast<double>(roundoff<float>);
    const Column L(0.5L, 3, 3);
    const double turned = 4 * 1.92, steps = 4 * 32;
    EXPECT_LE(free_error<FlyerWith<TypeParam>>(I, L, 4, 1.0L / 32), 8 * u * (turned + steps));
}

/// The closed form for two equal moments: right to rounding at any step, 4 to the radian and to the step.
TEST(SymmetricTop, is_exact_at_any_step) {
    constexpr double u = static_cast<double>(roundoff<scalar>);
    for (const Column& moments : {Column(1, 1, 1.75L), Column(2, 2, 0.25L), Column(0.5L, 1.5L, 1.5L), Column(1, 1, 1)}) {
        for (const long double h : {1.0L / 64, 0.25L, 1.0L}) {
            const Column L(1, -0.5L, 2);
            const double turned = 16 * static_cast<double>((L.norm() / moments.minCoeff()));
            EXPECT_LE(free_error<FlyerWith<ingot::SymmetricTop>>(moments, L, 16, h),
                      4 * u * (turned + 16 / static_cast<double>(h)))
                << "h = " << static_cast<double>(h);
        }
    }
}

/// Torque that changes with time, tau(t) = c cos(nu t) + s sin(nu t), given at the middle of each step: kick, drift, kick.
Column torque_at(long double t) {
    return Column(0.5L, -0.25L, 1) * std::cos(2 * t) + Column(0.25L, 0.75L, -0.5L) * std::sin(2 * t);
}

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

TEST(DefaultRotation, driven_bodies_are_met_with_order_2) {
    DrivenBody exact(I, Square::Identity(), Column(0.5L, 2, 2.25L));
    exact.advance(4, 4096, [](long double t, const Square&) { return torque_at(t); });
    const double coarse = driven_error(64, exact.A()), fine = driven_error(128, exact.A()),
                 finest = driven_error(256, exact.A());
    std::printf("    error %.1e, %.1e, %.1e: orders %.2f and %.2f\n", coarse, fine, finest, std::log2(coarse / fine),
                std::log2(fine / finest));
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.3);
    EXPECT_NEAR(std::log2(fine / finest), 2, 0.3);
}

/// A constant torque about a principal axis turns the body by tau t^2 / (2 I): exact but for roundings, because the momentum
/// at the middle of a step is its mean. 400 steps add up 4 roundings each of angles up to 12 rad.
TEST(DefaultRotation, constant_torque_about_a_principal_axis_is_exact) {
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

template <class Rotation>
class KickAhead : public ::testing::Test {};
using Kicked = ::testing::Types<ingot::LieMidpoint, ingot::Rk4Polar, ingot::SymmetricTop, ingot::SymmetricTopSplitting<2>,
                                ingot::SymmetricTopSplitting<6>, ingot::DiscreteMoserVeselov<2>, ingot::DiscreteMoserVeselov<4>,
                                ingot::DiscreteMoserVeselov<6>, ingot::DiscreteMoserVeselov<8>, ingot::DiscreteMoserVeselov<10>,
                                ingot::ExactElliptic>;
TYPED_TEST_SUITE(KickAhead, Kicked);

/// A turn goes by the L of before the kick, whatever has kicked: as that of a body that has it, to the bit; and keeps its own.
TYPED_TEST(KickAhead, is_taken_back) {
    RandomInput random(132);
    constexpr bool is_top = std::is_same<TypeParam, ingot::SymmetricTop>::value;
    for (int run_i = 0; run_i < 40; ++run_i) {
        const double side = random.real(1, 2);
        const Eigen::Vector3d moments(side, is_top ? side : random.real(1, 2), random.real(1, 2));
        const ingot::Vector L = to_vector(random.direction() * random.real(0.1, 4)), tau_T = to_vector(random.direction() * random.real(0.1, 40));
        const auto ahead = static_cast<scalar>(random.real(-0.1, 0.1));
        ingot_stages::Tiles kicked(1), before(1);
        ingot::BodyDef def = definition(1, moments);
        def.state.A = to_matrix(random.rotation());
        def.state.L = L;
        kicked.write(0, def);
        set_lane(kicked.rotation(0).tau_T, 0, tau_T);
        def.state.L = L - tau_T * ahead;
        before.write(0, def);
        (void)TypeParam::integrate_A(kicked.view(), scalar(1) / 64, {1, 1, ahead});
        (void)TypeParam::integrate_A(before.view(), scalar(1) / 64, {1, 1, 0});
        const ingot::Matrix A = kicked.state(0).A, as = before.state(0).A;
        EXPECT_EQ(to_eigen<double>(A), to_eigen<double>(as)) << run_i;
        EXPECT_EQ(to_eigen<double>(kicked.state(0).L), to_eigen<double>(L)) << run_i;
    }
}

/// The last Newton step leaves 3/4 of a defect whose square is 4 epsilon at most; each number of A is rounded once, and each entry of A^T A twice as
/// the error is measured. The defect of a body that tumbles is of either sign, along the diagonal and beside it: all of its entries count.
TEST(Rk4Polar, leaves_a_rotation_however_a_body_tumbles) {
    RandomInput random(318);
    int settled = 0;
    for (int run_i = 0; run_i < 20000; ++run_i) {
        const double a = random.real(0.05, 1), b = random.real(0.05, 1), c = random.real(0, 1) * std::min(a, b);
        const Eigen::Vector3d moments(b + c, c + a, a + b);
        ingot_stages::Tiles tiles(1);
        ingot::BodyDef def = definition(1, moments);
        const Eigen::Matrix3d A_0 = random.rotation();
        def.state.A = to_matrix(A_0);
        const Eigen::Vector3d spin = random.direction() * random.real(0.1, 2);  // rad a step
        def.state.L = to_vector(Eigen::Vector3d(A_0 * moments.cwiseProduct(A_0.transpose() * spin)));
        tiles.write(0, def);
        (void)ingot::Rk4Polar::integrate_A(tiles.view(), 1, {});
        const ingot::Matrix A = tiles.state(0).A;
        if (to_eigen<double>(A) == to_eigen<double>(def.state.A)) continue;  // the step was too long
        ++settled;
        ASSERT_LE(ingot::orthogonality_error(A), (3 + 1 + 2) * ingot::epsilon) << run_i;
    }
    EXPECT_GT(settled, 15000);
}

}  // namespace

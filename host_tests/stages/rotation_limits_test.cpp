// SPDX-License-Identifier: MIT
// Where the default rotation method ends: substeps, the clamp, changing steps, spins of nothing and of everything.
#include <gtest/gtest.h>
#include <ingot/ingot.h>

#include <limits>
#include <string>

#include "flown_case.h"
#include "reference/eigen_free_body.h"
#include "reference/random_input.h"

namespace {

using namespace ingot_reference;
using ingot::scalar;
using ingot_stages::twice_energy;
using Column = Eigen::Matrix<long double, 3, 1>;
using Square = Eigen::Matrix<long double, 3, 3>;
using World = ingot::World<ingot_stages::Flyer>;

constexpr bool is_double = INGOT_DOUBLE != 0;
constexpr double u = static_cast<double>(roundoff<scalar>);

struct Spinner {
    World world{};
    ingot::BodyId id;
    Column I;

    Spinner(const Eigen::Vector3d& moments, const Eigen::Matrix3d& A, const Eigen::Vector3d& L)
        : I(to_eigen<long double>(to_vector(moments))) {
        ingot::BodyDef def = definition(1, moments);
        def.state.A = to_matrix(A);
        def.state.L = to_vector(L);
        id = world.add(def).value;
    }
    ingot::BodyState state() const { return world.state(id).value; }
    FreeBody exact() const { return {I, rotation_of(state()), to_eigen<long double>(state().L)}; }
    static Square rotation_of(const ingot::BodyState& s) {
        Square A = to_eigen<long double>(s.A);
        A += A * (Square::Identity() - A.transpose() * A) / 2;  // what it is but for its own rounding
        return A;
    }
};

/// Spins of up to 8 rad a step, in substeps of at most 1/2 rad: the error of a substep is that of the order test, 5e-12
/// (double) or 1.3e-5 (float) at the most, 16 of them a step; the motion of a body of ratio 3 carries it on at most 10 times.
TEST(Substeps, spins_up_to_8_rad_a_step_are_followed) {
    RandomInput random(131);
    for (const double angle : {0.3, 0.49, 0.51, 0.99, 1.01, 1.99, 2.01, 3.99, 4.01, 6.0, 7.5}) {
        for (int i = 0; i < 4; ++i) {
            const Eigen::Matrix3d A = random.rotation();
            const Eigen::Vector3d moments(1, 2, 2.5), w = random.direction();
            const double h = 1.0 / 64;
            // The spin of a free body grows by at most sqrt(2 E / I_min) / |w|: stay below the clamp all along.
            const double peak = std::sqrt(w.dot(moments.cwiseProduct(w)) / moments.minCoeff());
            const Eigen::Vector3d spin = w * (angle / h) / (angle > 4 ? peak : 1);
            Spinner body(moments, A, A * moments.cwiseProduct(spin));
            FreeBody exact = body.exact();
            const long double energy = twice_energy(body.state(), body.I);
            for (int step_i = 0; step_i < 16; ++step_i) {
                ASSERT_TRUE(ingot::step(body.world, static_cast<scalar>(h)).clean()) << angle;
                exact.advance(static_cast<long double>(h));
            }
            EXPECT_LE(attitude_error(to_eigen<long double>(body.state().A), exact.A()),
                      16 * 16 * 10 * (is_double ? 5e-12 : 1.3e-5))
                << angle;
            EXPECT_LE(static_cast<double>(std::abs(twice_energy(body.state(), body.I) / energy - 1)), 16 * u) << angle;
        }
    }
}

struct FinelyCut : ingot::Scene {
    using rotation = ingot::DiscreteMoserVeselov<(is_double ? 10 : 6), true, true, (is_double ? 64 : 32)>;
};

/// Fast spins in substeps of 1/8 rad (double) or 1/4 rad (float) at most. In double what the series leaves out of a substep is below 5e-12 / 4^11 =
/// 1e-18 of 1/8 rad (see above), of up to 64 in each of 1920 steps 1e-13; ratios of 3 and of 5 carry it on 100 times: 1e-11. In float roundings are
/// more: u of each turn, in a random walk of n substeps whose steps the phase carries on n times.
TEST(Substeps, finer_ones_follow_fast_spins_to_rounding) {
    RandomInput random(138);
    for (const double angle : {0.26, 0.9, 7.5}) {
        for (const double ratio : {1.0, 4.0}) {
            const Eigen::Vector3d moments(1, ratio, ratio + random.real(0.2, 1)), w = random.direction();
            const double peak = std::sqrt(w.dot(moments.cwiseProduct(w)) / moments.minCoeff());  // of |omega|: stay below the clamp
            const Eigen::Matrix3d A = random.rotation();
            ingot::World<FinelyCut> world{};
            ingot::BodyDef def = definition(1, moments);
            def.state.A = to_matrix(A);
            def.state.L = to_vector(Eigen::Vector3d(A * moments.cwiseProduct(w * (angle * 64 / peak))));
            const ingot::BodyId id = world.add(def).value;
            FreeBody exact(to_eigen<long double>(to_vector(moments)), Spinner::rotation_of(world.state(id).value),
                           to_eigen<long double>(world.state(id).value.L));
            const int seconds = angle < 1 ? 30 : 4, steps = seconds * 64;  // the series is slow
            for (int step_i = 0; step_i < steps; ++step_i) ASSERT_TRUE(ingot::step(world, scalar(1) / 64).clean()) << angle;
            exact.advance(seconds);
            const double substeps = steps * std::max(1.0, 2 * angle / (is_double ? 0.125 : 0.25));
            const double error = attitude_error(to_eigen<long double>(world.state(id).value.A), exact.A());
            std::printf("    %.2f rad a step, ratio %.0f: %.1e rad\n", angle, ratio, error);
            EXPECT_LE(error, is_double ? 1e-11 : std::pow(substeps, 1.5) * u * 0.25) << angle;
        }
    }
}

/// Beyond 8 rad a step the turn is 8 rad about the same axis, and the report says so.
TEST(Substeps, spins_beyond_8_rad_a_step_are_clamped_and_reported) {
    RandomInput random(132);
    for (const double angle : {8.1, 20.0, 1000.0}) {
        const Eigen::Matrix3d A = random.rotation();
        const Eigen::Vector3d axis = random.direction();
        Spinner body(Eigen::Vector3d(1, 1, 1), A, axis * angle * 64);
        const ingot::BodyState begin = body.state();
        const ingot::StepReport report = ingot::step(body.world, scalar(1) / 64);
        EXPECT_EQ(report.spins_clamped, 1) << angle;
        EXPECT_FALSE(report.clean());
        EXPECT_EQ(report.bodies_frozen, 0);
        const Square expected =
            Eigen::AngleAxis<long double>(8, axis.cast<long double>()).toRotationMatrix() * Spinner::rotation_of(begin);
        // A sphere, 16 turns of 1/2 rad: each lacks angle^(order + 1) / (order + 1)!, and rounds like any.
        const double lacking = 16 * (is_double ? std::pow(0.5, 11) / 39916800 : std::pow(0.5, 7) / 5040);
        EXPECT_LE(attitude_error(to_eigen<long double>(body.state().A), expected), 1.3 * lacking + 64 * u) << angle;
        EXPECT_TRUE(ingot_stages::same_L(body.state(), begin));
        EXPECT_EQ(ingot::step(body.world, scalar(1) / 1024).spins_clamped, angle / 16 > 8 ? 1 : 0) << "a smaller step ends it";
    }
}

/// R12.
TEST(Substeps, huge_spin_stays_a_rotation) {
    RandomInput random(133);
    const Eigen::Vector3d moments(1, 2, 2.5);
    Spinner body(moments, random.rotation(), Eigen::Vector3d(6e5, -5e5, 3e5));
    const ingot::BodyState begin = body.state();
    for (int step_i = 0; step_i < 600; ++step_i) {
        const ingot::StepReport report = ingot::step(body.world, scalar(1) / 60);
        ASSERT_EQ(report.spins_clamped, 1);
        ASSERT_EQ(report.bodies_frozen, 0);
        ASSERT_LE(orthogonality_defect(to_eigen(body.state().A)), 1e-6);
    }
    EXPECT_TRUE(ingot_stages::same_L(body.state(), begin));
}

/// R11, and spins down to where the energy underflows: nothing moves, nothing is lost, nothing is NaN.
TEST(Substeps, vanishing_spin_leaves_the_attitude_alone) {
    const double tiny = is_double ? 1e-310 : 1e-40;
    for (const double spin : {tiny, std::sqrt(static_cast<double>(std::numeric_limits<scalar>::min())), 1e-3 * u}) {
        Spinner body(Eigen::Vector3d(1, 2, 2.5), Eigen::Matrix3d::Identity(), Eigen::Vector3d(spin, -spin, spin));
        const ingot::BodyState begin = body.state();
        for (int step_i = 0; step_i < 1000; ++step_i) ASSERT_TRUE(ingot::step(body.world, scalar(1) / 64).clean());
        EXPECT_LE(largest_difference(to_eigen(body.state().A), to_eigen(begin.A)), 1000.0 / 64 * spin + 2 * u) << spin;
        EXPECT_TRUE(ingot_stages::same_L(body.state(), begin));
    }
}

/// R15: an A that is off by 1e-3 becomes the rotation next to it at the door, and stays one.
TEST(Door, an_attitude_that_is_not_orthonormal_becomes_its_polar_factor) {
    RandomInput random(136);
    for (int i = 0; i < 50; ++i) {
        Eigen::Matrix3d A = random.rotation();
        for (int column = 0; column < 3; ++column) A.col(column) += random.vector(1e-3);
        Spinner body(Eigen::Vector3d(1, 2, 2.5), A, Eigen::Vector3d(1, 1, 1));
        const Eigen::JacobiSVD<Square> svd(to_eigen<long double>(to_matrix(A)), Eigen::ComputeFullU | Eigen::ComputeFullV);
        ASSERT_LE(largest_difference(to_eigen(body.state().A), Square(svd.matrixU() * svd.matrixV().transpose())), 8 * u);
        for (int step_i = 0; step_i < 3; ++step_i) ASSERT_TRUE(ingot::step(body.world, scalar(1) / 60).clean());
        ASSERT_LE(orthogonality_defect(to_eigen(body.state().A)), 8 * u);  // 4 eps
        ASSERT_NEAR(to_eigen(body.state().A).determinant(), 1, 12 * u);
    }
}

TEST(Substeps, a_body_at_rest_rests) {
    RandomInput random(134);
    Spinner body(Eigen::Vector3d(1, 2, 2.5), random.rotation(), Eigen::Vector3d::Zero());
    // The polar step takes off what rounding left in A at the begin.
    for (int step_i = 0; step_i < 16; ++step_i) ASSERT_TRUE(ingot::step(body.world, scalar(1) / 60).clean());
    const ingot::BodyState begin = body.state();
    for (int step_i = 0; step_i < 1000; ++step_i) ASSERT_TRUE(ingot::step(body.world, scalar(1) / 60).clean());
    EXPECT_LE(largest_difference(to_eigen(body.state().A), to_eigen(begin.A)), 2 * u);
}

/// A4: the smallest step and the largest.
TEST(Steps, from_a_nanosecond_to_a_second) {
    Spinner body(Eigen::Vector3d(1, 2, 2.5), Eigen::Matrix3d::Identity(), Eigen::Vector3d(0.5, 1, 2));
    FreeBody exact = body.exact();
    for (const scalar h : {ingot::limits::step_min, ingot::limits::step_max}) {
        for (int step_i = 0; step_i < 100; ++step_i) ASSERT_TRUE(ingot::step(body.world, h).clean());
        exact.advance(100 * static_cast<long double>(h));
        // at a second |omega| h <= 1, in substeps of at most 1/2 rad: 200 of them, 5e-12 or 1.3e-5 each (see above)
        ASSERT_LE(attitude_error(to_eigen<long double>(body.state().A), exact.A()),
                  h < 1 ? 8 * u : 200 * 10 * (is_double ? 5e-12 : 1.3e-5));
    }
    for (const scalar h : {scalar(0), scalar(-1), std::numeric_limits<scalar>::quiet_NaN(), scalar(1.01)})
        EXPECT_EQ(ingot::step(body.world, h).status, ingot::Status::bad_step);
}

/// What is kept in units of h is kept in those of the first step.
TEST(Steps, may_change_at_any_time) {
    RandomInput random(135);
    Spinner body(Eigen::Vector3d(1, 2, 3), Eigen::Matrix3d::Identity(), Eigen::Vector3d(0.5, 2, 2.25));
    FreeBody exact = body.exact();
    const long double energy = twice_energy(body.state(), body.I);
    double turned = 0;
    for (int step_i = 0; step_i < 3600; ++step_i) {
        const scalar h = static_cast<scalar>(std::ldexp(random.integer(8, 24), -10));  // 1/128 .. 3/128 s, exact
        ASSERT_TRUE(ingot::step(body.world, h).clean());
        exact.advance(static_cast<long double>(h));
        turned += 1.5 * static_cast<double>(h);
        // the bar of the book case, by the radian: 1e-9 (double) or 1e-5 (float) for 81 rad
        if (step_i % 60 == 0) {
            ASSERT_LE(attitude_error(to_eigen<long double>(body.state().A), exact.A()),
                      (1 + turned / 81) * (is_double ? 1e-12 : 1e-5));
        }
    }
    EXPECT_LE(static_cast<double>(std::abs(twice_energy(body.state(), body.I) / energy - 1)), 4 * std::sqrt(3600.0) * u);
}

/// Largest error of the energy in 2000 steps; `h_of` gives the length of each.
template <class StepLength>
double energy_error(const Eigen::Vector3d& moments, const Eigen::Matrix3d& A, const Eigen::Vector3d& L, const StepLength& h_of) {
    Spinner body(moments, A, L);
    const long double energy = twice_energy(body.state(), body.I);
    double worst = 0;
    for (int step_i = 0; step_i < 2000; ++step_i) {
        EXPECT_TRUE(ingot::step(body.world, static_cast<scalar>(h_of(step_i))).clean());
        worst = std::max(worst, static_cast<double>(std::abs(twice_energy(body.state(), body.I) / energy - 1)));
    }
    return worst;
}

/// The energy return remembers its energy whatever h is: a flight whose h changes is as exact as flights of constant h of the same lengths. Twice the
/// worst of these, because the largest of 2000 errors of random sign is one thing here and another there; and 4 roundings of the energy that
/// is returned to, taken to the h of a step: two of the ratio and its square, two of products.
TEST(Steps, change_without_a_loss_of_energy) {
    RandomInput random(137);
    for (int i = 0; i < 24; ++i) {
        const double ratio = i % 6 == 0 ? 1 : std::pow(10, random.real(0, 4.5)), rate = 30 * std::pow(10, random.real(0, 1.5));
        const Eigen::Vector3d moments(1 / ratio, 1, 1 + random.real(0, 1) / ratio);
        const Eigen::Matrix3d A = random.rotation();
        const Eigen::Vector3d L = A * moments.cwiseProduct(random.direction() * random.real(0.5, 6));
        const double h = 1 / rate;
        double constant = 0;
        for (const double times : {0.5, 1.0, 1.5}) constant = std::max(constant, energy_error(moments, A, L, [=](int) { return times * h; }));
        const double bound = 2 * constant + 4 * u;
        SCOPED_TRACE(std::to_string(ratio) + " at " + std::to_string(rate) + " Hz");
        EXPECT_LE(energy_error(moments, A, L, [&](int) { return h * random.real(0.5, 1.5); }), bound);
        EXPECT_LE(energy_error(moments, A, L, [=](int step_i) { return h * (step_i % 2 == 0 ? 0.7 : 1.3); }), bound);
        EXPECT_LE(energy_error(moments, A, L, [=](int step_i) { return h * (step_i < 1000 ? 0.5 : 1.5); }), bound);
    }
}

}  // namespace

// SPDX-License-Identifier: MIT
// The cart with its pole and the robot on two wheels beside their exact sampled loops: the linear motion over a step of held force, and the gains of
// an LQR for just that. Source: Franklin, Powell, Workman, "Digital Control of Dynamic Systems", 1998, chapters 4 and 9.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <memory>

#include "scenes/balancing.h"

namespace {

using Eigen::Matrix2d;
using Eigen::Matrix4d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector4d;
using ingot::scalar;
using ingot::Status;

/// d/dt (x, tilt, v, tilt_rate) = A s + B u.
struct Linear {
    Matrix4d A = Matrix4d::Zero();
    Vector4d B = Vector4d::Zero();

    /// M (x, tilt)'' = (0, stiffness tilt) + input u.
    Linear(const Matrix2d& M, double stiffness, const Vector2d& input) {
        A.topRightCorner<2, 2>().setIdentity();
        A.block<2, 1>(2, 1) = M.inverse() * Vector2d(0, stiffness);
        B.tail<2>() = M.inverse() * input;
    }
};
struct Sampled {
    Matrix4d A;
    Vector4d B;
};
/// By the series of the exponential.
Sampled sampled(const Linear& of, double h) {
    MatrixXd generator = MatrixXd::Zero(5, 5), sum = MatrixXd::Identity(5, 5), term = sum;
    generator.topLeftCorner<4, 4>() = of.A * h;
    generator.topRightCorner<4, 1>() = of.B * h;
    for (int k = 1; k < 30; ++k) {
        term = term * generator / k;
        sum += term;
    }
    return {sum.topLeftCorner<4, 4>(), sum.topRightCorner<4, 1>()};
}
/// Riccati's equation, until it stands.
Eigen::RowVector4d lqr(const Sampled& of) {
    const Matrix4d Q = Vector4d(1, 10, 1, 1).asDiagonal();
    const double R = 0.1;
    Matrix4d P = Q;
    Eigen::RowVector4d K = Eigen::RowVector4d::Zero();
    for (int i = 0; i < 200000; ++i) {
        const Eigen::RowVector4d next = of.B.transpose() * P * of.A / (R + of.B.dot(P * of.B));
        P = Q + of.A.transpose() * P * (of.A - of.B * next);
        const bool stands = (next - K).norm() <= 1e-13 * K.norm();
        K = next;
        if (stands) break;
    }
    return K;
}
scenes::BalanceGains gains_of(const Eigen::RowVector4d& K) {
    return {static_cast<scalar>(K(0)), static_cast<scalar>(K(1)), static_cast<scalar>(K(2)), static_cast<scalar>(K(3))};
}

Linear cart_and_pole() {
    using namespace scenes::cart_pole;
    Matrix2d M;
    M << cart_M + pole_M, pole_M * length, pole_M * length, pole_I + pole_M * length * length;
    return {M, static_cast<double>(pole_M * g * length), Vector2d(1, 0)};
}
Linear body_on_wheels() {
    using namespace scenes::two_wheels;
    Matrix2d M;
    M << body_M + 2 * wheel_M + 2 * wheel_I / (radius * radius), body_M * length, body_M * length, body_I + body_M * length * length;
    return {M, static_cast<double>(body_M * g * length), Vector2d(1 / static_cast<double>(radius), -1)};
}

struct Course {
    double rate, tilt;   ///< 1/s; rad, at the begin
    bool of_one_moment;  ///< else the law takes all as it is read
    double h() const { return 1 / rate; }

    template <class Scene>
    scenes::Balance seen(const scenes::Balance& at, const ingot::World<Scene>&) const {
        return of_one_moment ? scenes::of_one_moment(at, static_cast<scalar>(h() / Scene::effort.substeps)) : at;
    }
};
/// Of a machine for 10 s: the largest departure from the exact loop, as a share of the largest motion, of place and tilt.
template <class Step>
double off_exact_loop(const Linear& linear, const Course& course, const Step& step) {
    const Sampled of = sampled(linear, course.h());
    const Eigen::RowVector4d K = lqr(of);
    Vector4d exact(0, course.tilt, 0, 0);
    Vector2d off = Vector2d::Zero(), most = Vector2d::Zero();
    for (int step_i = 0; step_i < static_cast<int>(10 * course.rate); ++step_i) {
        exact = of.A * exact + of.B * -K.dot(exact.transpose());
        const scenes::Balance at = step(gains_of(K));
        off = off.cwiseMax(Vector2d(static_cast<double>(at.x) - exact(0), static_cast<double>(at.tilt) - exact(1)).cwiseAbs());
        most = most.cwiseMax(exact.head<2>().cwiseAbs());
    }
    return off.cwiseQuotient(most).maxCoeff();
}

double off_of_cart(const Course& course) {
    const auto world = std::make_unique<ingot::World<scenes::CartPole>>();
    scenes::CartPoleIds ids;
    const auto tilt = static_cast<scalar>(course.tilt);
    EXPECT_EQ(set_up(*world, ids, tilt), Status::ok);
    return off_exact_loop(cart_and_pole(), course, [&](const scenes::BalanceGains& K) {
        EXPECT_EQ(push_cart(*world, ids, answer(K, course.seen(balance_of(*world, ids, tilt), *world))), Status::ok);
        (void)ingot::step(*world, static_cast<scalar>(course.h()));
        return course.seen(balance_of(*world, ids, tilt), *world);
    });
}
double off_of_wheels(const Course& course) {
    const auto world = std::make_unique<ingot::World<scenes::TwoWheels>>();
    scenes::TwoWheelsIds ids;
    EXPECT_EQ(set_up(*world, ids, static_cast<scalar>(course.tilt)), Status::ok);
    return off_exact_loop(body_on_wheels(), course, [&](const scenes::BalanceGains& K) {
        EXPECT_EQ(turn_wheels(*world, ids, answer(K, course.seen(balance_of(*world, ids), *world))), Status::ok);
        (void)ingot::step(*world, static_cast<scalar>(course.h()));
        return course.seen(balance_of(*world, ids), *world);
    });
}

}  // namespace

/// From 0.01 rad at 60 Hz to a thousandth, and to second order, where the tilt is so small that its sine is not in the way.
TEST(Balance, cart_goes_as_its_exact_sampled_loop) {
    EXPECT_LE(off_of_cart({60, 0.01, true}), 1e-3);
    EXPECT_NEAR(std::log2(off_of_cart({30, 0.001, true}) / off_of_cart({60, 0.001, true})), 2, 0.2);
}
TEST(Balance, robot_on_two_wheels_goes_as_its_exact_sampled_loop) {
    EXPECT_LE(off_of_wheels({60, 0.01, true}), 2e-3);
    EXPECT_NEAR(std::log2(off_of_wheels({30, 0.001, true}) / off_of_wheels({60, 0.001, true})), 2, 0.2);
}
/// With all as it is read the places are ahead by half a substep, in the law and beside the loop: it balances, to first order.
TEST(Balance, of_numbers_of_two_moments_is_of_first_order) {
    EXPECT_NEAR(std::log2(off_of_cart({60, 0.001, false}) / off_of_cart({120, 0.001, false})), 1, 0.2);
    EXPECT_NEAR(std::log2(off_of_wheels({60, 0.001, false}) / off_of_wheels({120, 0.001, false})), 1, 0.2);
}

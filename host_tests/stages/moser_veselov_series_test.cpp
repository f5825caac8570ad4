// SPDX-License-Identifier: MIT
// The series of the modified moments, power by power, against those moments with which the discrete step is the exact flight: solved for in
// long double, and expanded by interpolation. Every order is seen in float too, where a flight would not show it.
#include <gtest/gtest.h>
#include <ingot/motion/moser_veselov_series.h>

#include <array>

#include "reference/eigen_free_body.h"
#include "reference/random_input.h"

namespace {

using ingot::scalar;
using Real = long double;
using V = Eigen::Matrix<Real, 3, 1>;
using Pair = Eigen::Matrix<Real, 2, 1>;  // S and D

/// What c = (1 + c.c) q + k (c2 c3, c3 c1, c1 c2) leaves over for the modified moments a = S j + D: the top of moser_veselov_stage.h.
V left_over(const V& c, const V& j, const V& y, const Pair& S_and_D) {
    const V a = S_and_D(0) * j + V::Constant(S_and_D(1));
    const V q = a.cwiseProduct(y) / 2, differences(j.z() - j.y(), j.x() - j.z(), j.y() - j.x());
    const V k = a.cwiseProduct(a).cwiseProduct(differences) * (S_and_D(0) / a.prod());
    return (1 + c.squaredNorm()) * q + k.cwiseProduct(V(c.y() * c.z(), c.z() * c.x(), c.x() * c.y())) - c;
}

/// The S and D that take a body with inverse moments j and momentum y, in its own axes, to where it is one unit of time later.
Pair exact_S_and_D(const V& j, const V& y) {
    ingot_reference::FreeBody body(j.cwiseInverse(), ingot_reference::FreeBody::Matrix3::Identity(), y);
    body.advance(1);
    const auto& R = body.A();
    const V c = V(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1)) / (1 + R.trace());
    Pair x(1, 0);
    for (int turn_i = 0; turn_i < 30; ++turn_i) {  // Gauss and Newton: three equations, which agree
        Eigen::Matrix<Real, 3, 2> slope;
        for (int i = 0; i < 2; ++i) {
            const Pair aside = Pair::Unit(i) * 1e-6L;
            slope.col(i) = (left_over(c, j, y, x + aside) - left_over(c, j, y, x - aside)) / 2e-6L;
        }
        x -= (slope.transpose() * slope).ldlt().solve(slope.transpose() * left_over(c, j, y, x));
    }
    EXPECT_LE(static_cast<double>(left_over(c, j, y, x).norm()), 1e-17) << "two numbers meet three equations";
    return x;
}

struct Power {
    Pair value, size;
};

/// Powers 0 .. 4 of t in S and D of a body whose momentum is sqrt(t) y, both being functions of energies; and how well they are known.
///
/// The powers fall by 1/50 and more each, so what nine nodes leave out is below 1e-5 of the last one here. Each value is known to `rounding`,
/// which the inverse of the system enlarges.
std::array<Power, 5> expansion(const V& j, const V& y) {
    constexpr int nodes = 9;
    constexpr Real rounding = 4e-18L;
    Eigen::Matrix<Real, nodes, nodes> powers;
    Eigen::Matrix<Real, nodes, 2> values;
    for (int node_i = 0; node_i < nodes; ++node_i) {
        const Real t = (1.05L - std::cos(3.14159265358979L * (node_i + 0.5L) / nodes)) / 2;  // Chebyshev's, and not at rest
        values.row(node_i) = exact_S_and_D(j, std::sqrt(t) * y).transpose();
        for (int power = 0; power < nodes; ++power) powers(node_i, power) = std::pow(t, static_cast<Real>(power));
    }
    const Eigen::Matrix<Real, nodes, nodes> inverse = powers.fullPivLu().inverse();
    std::array<Power, 5> of{};
    for (int power = 0; power < 5; ++power)
        of[static_cast<std::size_t>(power)] = {(inverse.row(power) * values).transpose(),
                                               Pair::Constant(inverse.row(power).cwiseAbs().sum() * rounding)};
    return of;
}

/// A number that only grows: the series of it is the sum of the sizes of all terms, which roundings are relative to.
struct Size {
    Real x = 0;
};
Size operator+(Size a, Size b) { return {a.x + b.x}; }
Size operator-(Size a, Size b) { return {a.x + b.x}; }
Size operator*(Size a, Size b) { return {a.x * b.x}; }
Size operator-(scalar a, Size b) { return {std::abs(static_cast<Real>(a)) + b.x}; }
Size& operator+=(Size& a, Size b) { return a = a + b; }

/// What the last two orders of a method add to S and D, looked at where it is far above what is before it.
template <int order>
Power last_power(const V& j, Real H, Real C) {
    const Real far = 4096, scale = std::pow(far, static_cast<Real>(order / 2 - 1));
    const auto as = [](Real x) { return static_cast<scalar>(x); };
    const ingot::Vec3<scalar> j_of = {as(j.x()), as(j.y()), as(j.z())};
    const ingot::Vec3<Size> j_size = {{j.x()}, {j.y()}, {j.z()}};
    const auto with = ingot::modified_inertia<order>(j_of, as(H * far), as(C * far)),
               without = ingot::modified_inertia<order - 2>(j_of, as(H * far), as(C * far));
    const auto size = ingot::modified_inertia<order>(j_size, Size{H * far}, Size{C * far});
    return {Pair(static_cast<Real>(with.S_minus_1) - static_cast<Real>(without.S_minus_1), static_cast<Real>(with.D) - static_cast<Real>(without.D)) /
                scale,
            Pair(size.S_minus_1.x, size.D.x) / scale};
}

TEST(ModifiedInertia, is_what_makes_the_discrete_step_exact_power_by_power) {
    ingot_reference::RandomInput random(311);
    for (int case_i = 0; case_i < 40; ++case_i) {
        V j(random.real(0.1, 1), random.real(0.1, 1), random.real(0.1, 1));
        j = (j / (j.sum() * 1.1L)).cast<float>().cast<Real>();  // the kernel's numbers in either scalar
        const V y = random.direction().cast<Real>() * 1.2L;
        const Real H = y.dot(j.cwiseProduct(y)) / 2, C = y.squaredNorm() / 2;
        const std::array<Power, 5> exact = expansion(j, y);
        EXPECT_LE(static_cast<double>((exact[0].value - Pair(1, 0)).norm()), 1e-15);
        const Power kernel[5] = {{}, last_power<4>(j, H, C), last_power<6>(j, H, C), last_power<8>(j, H, C), last_power<10>(j, H, C)};
        for (std::size_t power = 1; power < 5; ++power) {
            for (int i = 0; i < 2; ++i) {
                // A term has at most a dozen roundings, and their sum half a dozen.
                const Real size = kernel[power].size(i), unsure = exact[power].size(i);
                EXPECT_LE(static_cast<double>(std::abs(kernel[power].value(i) - exact[power].value(i))),
                          static_cast<double>(20 * static_cast<Real>(ingot::epsilon) * size + unsure))
                    << (i == 0 ? "S" : "D") << ", power " << power << ", case " << case_i;
                EXPECT_LE(static_cast<double>(unsure), 1e-5 * static_cast<double>(size)) << "a wrong coefficient would be seen";
            }
        }
    }
}

/// Order 2 is the method as it is; each order has what is below it.
TEST(ModifiedInertia, of_order_2_is_the_inertia) {
    const auto modified = ingot::modified_inertia<2, scalar>({scalar(0.25), scalar(0.25), scalar(0.375)}, 1, 2);
    EXPECT_EQ(modified.S_minus_1, 0);
    EXPECT_EQ(modified.D, 0);
}

}  // namespace

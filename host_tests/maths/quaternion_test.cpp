// SPDX-License-Identifier: MIT
// Quaternions and matrices are two names of one rotation; between two of them the way is the shorter one, at a constant rate.
#include <gtest/gtest.h>
#include <ingot/math/quaternion.h>

#include <algorithm>

#include "reference/kernel_types.h"
#include "reference/measure.h"
#include "reference/random_input.h"

namespace {

using ingot::Quaternion;
using ingot::scalar;
using ingot::Status;
using ingot_reference::largest_difference;
using ingot_reference::RandomInput;
using ingot_reference::to_eigen;
using ingot_reference::to_matrix;
using ingot_reference::to_vector;
using Real = long double;
using Square = Eigen::Matrix<Real, 3, 3>;
using Exact = Eigen::Quaternion<Real>;

constexpr int samples = 5000;
constexpr double u = static_cast<double>(ingot_reference::roundoff<scalar>);

Exact exact(const Quaternion& q) {
    return {static_cast<Real>(q.w), static_cast<Real>(q.x), static_cast<Real>(q.y), static_cast<Real>(q.z)};
}

/// Largest difference of a component, of q or -q.
double apart(const Quaternion& p, const Exact& q) {
    const Real as_q = (exact(p).coeffs() - q.coeffs()).cwiseAbs().maxCoeff(), as_minus_q = (exact(p).coeffs() + q.coeffs()).cwiseAbs().maxCoeff();
    return static_cast<double>(std::min(as_q, as_minus_q));
}

Quaternion random_quaternion(RandomInput& random) {
    const Exact q(random.rotation().cast<Real>());
    return {static_cast<scalar>(q.w()), static_cast<scalar>(q.x()), static_cast<scalar>(q.y()), static_cast<scalar>(q.z())};
}

/// Turns of half a turn or nearly, about axes in a coordinate plane or nearly: where w and one of the others are zero or tiny.
Quaternion at_a_corner(RandomInput& random) {
    Eigen::Vector4d q(0, random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
    for (int i = 0; i < 4; ++i)
        if (random.integer(0, 1) == 0) q(i) = random.integer(0, 1) == 0 ? 0 : random.of_any_size(-40, -10);
    if (q.norm() < 0.01) q(random.integer(1, 3)) = 1;
    q.normalize();
    return {static_cast<scalar>(q(0)), static_cast<scalar>(q(1)), static_cast<scalar>(q(2)), static_cast<scalar>(q(3))};
}

// |q|^2 of four squares is off by 4 u, 2/|q|^2 by 5 u; times a sum of two products, 2 u, by 8 u of at most 2; and 1 less that is rounded once.
constexpr double entry_of_matrix = 17 * u;
// The largest of 4 w^2 .. 4 z^2 is at least 1 and off by the sums 2, 3 and 4 that it went through: 9 u, half of it after the root, and its
// rounding; the others have three roundings more, of a difference, 1/root and a product.
constexpr double component_of_quaternion = (4.5 + 1 + 3) * u;

TEST(Quaternions, are_the_matrices_that_eigen_makes_of_them) {
    RandomInput random(31);
    for (int i = 0; i < samples; ++i) {
        const Quaternion q = i % 2 == 0 ? random_quaternion(random) : at_a_corner(random);
        const ingot::Result<ingot::Matrix> A = ingot::rotation_of(q);
        ASSERT_EQ(A.status, Status::ok);
        ASSERT_LE(largest_difference(to_eigen(A.value), exact(q).normalized().toRotationMatrix()), entry_of_matrix);
    }
}

TEST(Quaternions, come_back_from_their_matrix) {
    RandomInput random(32);
    for (int i = 0; i < samples; ++i) {
        const Quaternion q = i % 2 == 0 ? random_quaternion(random) : at_a_corner(random);
        const ingot::Result<Quaternion> back = ingot::quaternion_of(ingot::rotation_of(q).value);
        ASSERT_EQ(back.status, Status::ok);
        // The matrix is off by 17 u an entry. Of the root that is 3 of 17 u, halved twice, relative; of the others 2 of 17 u over twice a root of at
        // least 1. A component is at most 1.
        ASSERT_LE(apart(back.value, exact(q).normalized()), component_of_quaternion + (3.0 / 2 + 1) * entry_of_matrix);
        ASSERT_GE(back.value.w, 0);
        if (back.value.w == 0) {
            const scalar others[3] = {back.value.x, back.value.y, back.value.z};
            const auto smaller = [](scalar a, scalar b) { return std::abs(a) < std::abs(b); };
            ASSERT_GT(*std::max_element(others, others + 3, smaller), 0) << "one name for one turn";
        }
    }
}

TEST(Quaternions, of_a_matrix_give_the_matrix_back) {
    RandomInput random(33);
    for (int i = 0; i < samples; ++i) {
        const ingot::Matrix A = i % 2 == 0 ? to_matrix(random.rotation()) : ingot::rotation_of(at_a_corner(random)).value;
        const ingot::Matrix back = ingot::rotation_of(ingot::quaternion_of(A).value).value;
        // A is a rotation to 17 u an entry. By the lines above the quaternion is off by 51 u a component, its direction by no more than twice that,
        // and a rotation turns by twice the angle of its quaternion.
        ASSERT_LE(largest_difference(to_eigen(back), to_eigen(A)), 2 * 2 * (component_of_quaternion + 2.5 * entry_of_matrix) + 2 * entry_of_matrix);
        // The formula itself, on the same matrix: the error of each entry is that of its own roundings, as if q were exact.
        ASSERT_LE(largest_difference(to_eigen(back), exact(ingot::quaternion_of(A).value).normalized().toRotationMatrix()), entry_of_matrix);
    }
}

TEST(Quaternions, of_quarter_turns_are_exact) {
    const ingot::Matrix half_turns[3] = {
        {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}, {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}};
    for (int i = 0; i < 3; ++i) {
        const Quaternion q = ingot::quaternion_of(half_turns[i]).value;
        EXPECT_EQ(q.w, 0);
        EXPECT_EQ(q.x, i == 0 ? 1 : 0);
        EXPECT_EQ(q.y, i == 1 ? 1 : 0);
        EXPECT_EQ(q.z, i == 2 ? 1 : 0);
        EXPECT_EQ(to_eigen(ingot::rotation_of(q).value), to_eigen(half_turns[i]));
    }
    EXPECT_EQ(to_eigen(ingot::rotation_of({}).value), to_eigen(ingot::identity_matrix<scalar>()));
    EXPECT_EQ(ingot::quaternion_of(ingot::identity_matrix<scalar>()).value.w, 1);
    // A quarter turn about z takes x to y: the convention, once.
    const scalar half = std::sqrt(scalar(0.5));
    const ingot::Vector y = ingot::rotation_of({half, 0, 0, half}).value * ingot::Vector{1, 0, 0};
    EXPECT_NEAR(y.y, 1, entry_of_matrix);
    EXPECT_NEAR(y.x, 0, entry_of_matrix);
}

TEST(Quaternions, that_are_no_rotation_are_refused) {
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN(), inf = std::numeric_limits<scalar>::infinity();
    for (int i = 0; i < 4; ++i)
        for (const scalar bad : {nan, inf, -inf}) {
            scalar q[4] = {1, 0, 0, 0};
            q[i] = bad;
            EXPECT_EQ(ingot::rotation_of({q[0], q[1], q[2], q[3]}).status, Status::not_finite);
        }
    EXPECT_EQ(ingot::rotation_of({0, 0, 0, 0}).status, Status::not_a_rotation);
    EXPECT_EQ(ingot::rotation_of({scalar(1.1), 0, 0, 0}).status, Status::not_a_rotation);
    EXPECT_EQ(ingot::rotation_of({ingot::scalar_max, 0, 0, 0}).status, Status::not_a_rotation) << "its square overflows";
    EXPECT_EQ(ingot::rotation_of({scalar(1.004), 0, 0, 0}).status, Status::ok) << "of three digits";
    const ingot::Matrix upright = ingot::identity_matrix<scalar>();
    EXPECT_EQ(ingot::quaternion_of(upright * nan).status, Status::not_finite);
    EXPECT_EQ(ingot::quaternion_of(upright * scalar(1.1)).status, Status::not_a_rotation);
    EXPECT_EQ(ingot::quaternion_of(upright * scalar(-1)).status, Status::not_a_rotation);
    EXPECT_EQ(ingot::quaternion_of({{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}).status, Status::not_a_rotation);
}

// A weight of slerp: each factor of a term has six roundings, and no term is more than half of the one before, so the sum has 12 u of them; up to 26
// additions (55 in double) of a rounding each; and cos(phi) is off by 4 u.
constexpr double weight = (12 + ingot::limits::slerp_terms_max + 4) * u;

TEST(Slerp, is_the_sine_of_the_share_over_the_sine) {
    RandomInput random(34);
    for (int i = 0; i < samples; ++i) {
        const scalar t = static_cast<scalar>(random.real(0, 1)), x = static_cast<scalar>(random.real(0, 1));
        const Real phi = std::acos(static_cast<Real>(x)), sine = std::sin(phi);
        const Real share = sine > 0 ? std::sin(static_cast<Real>(t) * phi) / sine : static_cast<Real>(t);
        // The reference takes an angle from a cosine: its own rounding is 2^-64 over the square of the sine, and x is at most 1 - u.
        ASSERT_NEAR(static_cast<double>(ingot::quaternions::slerp_weight(t, x)), static_cast<double>(share), weight);
    }
    for (const scalar x : {scalar(0), scalar(0.5), scalar(1)}) {
        EXPECT_EQ(ingot::quaternions::slerp_weight(0, x), 0);
        EXPECT_EQ(ingot::quaternions::slerp_weight(1, x), 1);
    }
}

TEST(Slerp, goes_the_shorter_way_of_eigen) {
    RandomInput random(35);
    for (int i = 0; i < samples; ++i) {
        const Quaternion p = random_quaternion(random), q = i % 2 == 0 ? random_quaternion(random) : Quaternion{p.w, p.x, -p.y, -p.z};
        const scalar t = static_cast<scalar>(random.real(0, 1));
        const Exact there = exact(p).normalized().slerp(static_cast<Real>(t), exact(q).normalized());
        // p and q are of length 1 to 2 u. The weights of both sum to 1.42 at most; a component has a product and a sum more.
        if (std::abs(ingot::quaternions::dot(p, q)) < 16 * u) continue;  // both ways are as short
        ASSERT_LE(apart(ingot::quaternions::slerp(p, q, t), there), 1.42 * (weight + 2 * u) + 3 * u);
    }
}

}  // namespace

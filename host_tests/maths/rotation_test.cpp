// SPDX-License-Identifier: MIT
// The tilde operator, Eq. 6, and what keeps a matrix a rotation.
#include <gtest/gtest.h>
#include <ingot/math/rotation.h>

#include "reference/eigen_listing1.h"
#include "reference/kernel_types.h"
#include "reference/measure.h"
#include "reference/random_input.h"

namespace {

using ingot::scalar;
using ingot_reference::gamma;
using ingot_reference::largest_difference;
using ingot_reference::orthogonality_defect;
using ingot_reference::RandomInput;
using ingot_reference::roundoff;
using ingot_reference::to_eigen;
using ingot_reference::to_matrix;
using ingot_reference::to_vector;
using Column = Eigen::Matrix<long double, 3, 1>;
using Square = Eigen::Matrix<long double, 3, 3>;

constexpr int samples = 2000;
constexpr double u = static_cast<double>(roundoff<scalar>);

TEST(Tilde, is_the_matrix_of_the_cross_product) {
    RandomInput random(11);
    for (int i = 0; i < samples; ++i) {
        const ingot::Vector w = to_vector(random.vector(3)), r = to_vector(random.vector(3));
        // The third product of each row is with an exact zero: the same roundings as the cross product's.
        ASSERT_EQ(to_eigen(ingot::tilde(w) * r), to_eigen(cross(w, r)));
        ASSERT_EQ(to_eigen(ingot::tilde(w)), ingot_reference::tilde_matrix(to_eigen(w)));
        ASSERT_EQ(to_eigen(transposed(ingot::tilde(w))), to_eigen(ingot::tilde(-w)));
    }
}

/// Eq. 2 for the tensor tilde(w): seen from another frame it is the tilde of w seen from there.
TEST(Tilde, turns_with_its_vector) {
    RandomInput random(12);
    for (int i = 0; i < samples; ++i) {
        const ingot::Matrix A = to_matrix(random.rotation());
        const ingot::Vector w = to_vector(random.direction());
        // Two products of three terms on the left, one on the right, of entries below 1: 3 (3 + 3) + 3 roundings; and A is a
        // rotation to 2 roundings an entry.
        ASSERT_LE(largest_difference(to_eigen(A * ingot::tilde(w) * transposed(A)), to_eigen(ingot::tilde(A * w))), 27 * u);
    }
}

TEST(AxisAngle, agrees_with_eigen) {
    RandomInput random(13);
    for (int i = 0; i < samples; ++i) {
        const ingot::Vector n = to_vector(random.direction());
        const scalar angle = static_cast<scalar>(random.real(-10, 10));
        const Square exact =
            Eigen::AngleAxis<long double>(static_cast<long double>(angle), to_eigen<long double>(n)).toRotationMatrix();
        // 2 u for a sine or cosine of 1 ulp, 4 roundings of numbers below 2, and n of unit length to 1.5 u: 2 + 8 + 2.
        ASSERT_LE(largest_difference(to_eigen(ingot::axis_angle(n, angle)), exact), 12 * u);
    }
}

TEST(AxisAngle, is_orthonormal_and_right_handed) {
    RandomInput random(14);
    for (int i = 0; i < samples; ++i) {
        const ingot::Vector n = to_vector(random.direction());
        const ingot::Matrix R = ingot::axis_angle(n, static_cast<scalar>(random.real(-1000, 1000)));
        ASSERT_LE(orthogonality_defect(to_eigen(R)), 24 * u);  // twice the error of the entries, which is 12 u
        ASSERT_NEAR(to_eigen(R).determinant(), 1, 36 * u);     // the sum of the defects of three columns, halved
    }
}

TEST(AxisAngle, fixes_its_axis) {
    RandomInput random(15);
    for (int i = 0; i < samples; ++i) {
        const ingot::Vector n = to_vector(random.direction());
        const ingot::Vector turned = ingot::axis_angle(n, static_cast<scalar>(random.real(-10, 10))) * n;
        ASSERT_LE(largest_difference(to_eigen(turned), to_eigen(n)), 24 * u);  // 12 u an entry times |n|_1 <= 1.74, and 3 u
    }
}

TEST(AxisAngle, turns_compose) {
    RandomInput random(16);
    for (int i = 0; i < samples; ++i) {
        const ingot::Vector n = to_vector(random.direction());
        // Multiples of 2^-20 add exactly in float.
        const scalar a = static_cast<scalar>(std::ldexp(random.integer(-1048576, 1048576), -20));
        const scalar b = static_cast<scalar>(std::ldexp(random.integer(-1048576, 1048576), -20));
        const ingot::Matrix product = ingot::axis_angle(n, a) * ingot::axis_angle(n, b);
        // 12 u an entry in each of the three matrices, times |row|_1 <= 1.74 in two of them, and 3 roundings of the product.
        ASSERT_LE(largest_difference(to_eigen(product), to_eigen(ingot::axis_angle(n, a + b))), (12 + 2 * 1.74 * 12 + 6) * u);
        const ingot::Matrix back = ingot::axis_angle(n, -a);
        // Sine and cosine are the same bits; a product of three numbers below 2 is rounded twice in either order, and a sum
        // once.
        ASSERT_LE(largest_difference(to_eigen(back), to_eigen(transposed(ingot::axis_angle(n, a)))), 8 * u);
    }
}

TEST(RotationAbout, refuses_what_is_no_rotation) {
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN(), inf = std::numeric_limits<scalar>::infinity();
    EXPECT_EQ(ingot::rotation_about({0, 0, 1}, 1).status, ingot::Status::ok);
    EXPECT_EQ(to_eigen(ingot::rotation_about({0, 0, 1}, 1).value), to_eigen(ingot::axis_angle({0, 0, 1}, 1)));
    EXPECT_EQ(ingot::rotation_about({0, nan, 1}, 1).status, ingot::Status::not_finite);
    EXPECT_EQ(ingot::rotation_about({0, 0, 1}, inf).status, ingot::Status::not_finite);
    EXPECT_EQ(ingot::rotation_about({0, 0, 0}, 1).status, ingot::Status::bad_direction);
    EXPECT_EQ(ingot::rotation_about({0, scalar(0.01), 1}, 1).status, ingot::Status::bad_direction);
    EXPECT_EQ(ingot::rotation_about({0, 0, 1}, scalar(1000.5)).status, ingot::Status::out_of_range);
    EXPECT_EQ(ingot::rotation_about({1, 0, 0}, -1000).status, ingot::Status::ok);
}

/// A rotation with its columns changed by up to `size`.
Square near_rotation(RandomInput& random, double size) {
    Square A = random.rotation().cast<long double>();
    for (int column = 0; column < 3; ++column) A.col(column) += random.vector(size).cast<long double>();
    return A;
}

/// With E = A^T A - 1, one step leaves exactly -3/4 E^2 + 1/4 E^3.
TEST(PolarStep, converges_quadratically) {
    RandomInput random(17);
    for (const double size : {0.1, 0.01, 1e-3, 1e-4}) {
        for (int i = 0; i < samples / 4; ++i) {
            const ingot::Matrix A = to_matrix(near_rotation(random, size));
            const ingot::Matrix next = A + ingot::polar_correction(A);
            const Square E = to_eigen<long double>(A).transpose() * to_eigen<long double>(A) - Square::Identity();
            const Square after = to_eigen<long double>(next).transpose() * to_eigen<long double>(next) - Square::Identity();
            // The correction is rounded where it is small; the sum is rounded once, and E follows with twice its row sums.
            const double slack = 2 * 1.8 * (1 + 12 * size) * u * 2;
            ASSERT_LE(largest_difference(after, Square(-0.75L * E * E + 0.25L * E * E * E)), slack) << "size " << size;
        }
    }
}

TEST(PolarStep, leads_to_the_polar_factor) {
    RandomInput random(18);
    for (int i = 0; i < samples / 4; ++i) {
        ingot::Matrix A = to_matrix(near_rotation(random, 0.05));
        const Eigen::JacobiSVD<Square> svd(to_eigen<long double>(A), Eigen::ComputeFullU | Eigen::ComputeFullV);
        const Square nearest = svd.matrixU() * svd.matrixV().transpose();
        for (int step_i = 0; step_i < 5; ++step_i) A = A + ingot::polar_correction(A);
        // 0.3, 0.07, 4e-3, 1e-5, 7e-11, 4e-21: five steps reach rounding; each leaves 2 u in an entry, the last ones count.
        ASSERT_LE(largest_difference(to_eigen(A), nearest), 8 * u);
        ASSERT_NEAR(to_eigen(A).determinant(), 1, 12 * u);  // the sum of the defects of three columns, halved
    }
}

TEST(PolarStep, leaves_a_rotation_alone) {
    RandomInput random(19);
    for (int i = 0; i < samples; ++i) {
        const ingot::Matrix A = to_matrix(random.rotation());
        // The defect of a rounded rotation is 2 * 1.74 * u, half of which is taken off; its own rounding is of second order.
        ASSERT_LE(largest_difference(to_eigen(A + ingot::polar_correction(A)), to_eigen(A)), 8 * u);
    }
}

TEST(OrthogonalityError, is_the_largest_entry_of_the_defect) {
    RandomInput random(20);
    for (const double size : {1.0, 0.1, 1e-3}) {
        for (int i = 0; i < samples / 4; ++i) {
            const Eigen::Matrix3d A = to_eigen(to_matrix(near_rotation(random, size)));
            // Three squares up to |column|^2 summed, and 1 taken off: 4 roundings of them.
            ASSERT_NEAR(orthogonality_error(to_matrix(A)), orthogonality_defect(A), 4 * u * (1 + A.squaredNorm()));
        }
    }
}

TEST(Reorthogonalized, is_gram_schmidt_in_the_order_of_the_columns) {
    RandomInput random(21);
    for (const double size : {0.2, 0.01, 1e-6}) {
        for (int i = 0; i < samples / 4; ++i) {
            const ingot::Matrix A = to_matrix(near_rotation(random, size));
            const ingot::Matrix R = reorthogonalized(A);
            const Square exact = ingot_reference::reorthogonalised(to_eigen<long double>(A));
            // c0: 3/2 + 3 roundings; c1: those of c0 twice, a dot product and its own norm, relative to |p1| >= 1/2;
            // c2 is made of both: below 40 in all.
            ASSERT_LE(largest_difference(to_eigen(R), exact), 40 * u) << "size " << size;
            ASSERT_LE(orthogonality_defect(to_eigen(R)), 80 * u);
            ASSERT_GT(to_eigen(R).determinant(), 0.9);
        }
    }
}

}  // namespace

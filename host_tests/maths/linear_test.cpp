// SPDX-License-Identifier: MIT
// Vec3, Mat3 and Sym3 against Eigen in long double. Tolerances count roundings: the longest path from an input to the
// result, times half an ulp of the sum of the magnitudes of the terms (Higham 2002, 3.1).
#include <gtest/gtest.h>
#include <ingot/math/sym3.h>

#include "reference/kernel_types.h"
#include "reference/measure.h"
#include "reference/random_input.h"

namespace {

using ingot::scalar;
using ingot_reference::gamma;
using ingot_reference::RandomInput;
using ingot_reference::to_eigen;
using ingot_reference::worst_relative_error;
using Column = Eigen::Matrix<long double, 3, 1>;
using Square = Eigen::Matrix<long double, 3, 3>;

constexpr int samples = 2000;

ingot::Vector random_vector(RandomInput& random) {
    const auto number = [&] { return static_cast<scalar>(random.of_any_size(-12, 12)); };
    const scalar x = number(), y = number();
    return {x, y, number()};
}

ingot::Matrix random_matrix(RandomInput& random) {
    const ingot::Vector c0 = random_vector(random), c1 = random_vector(random);
    return {c0, c1, random_vector(random)};
}

ingot::SymmetricMatrix random_symmetric(RandomInput& random) {
    const ingot::Vector diagonal = random_vector(random), rest = random_vector(random);
    return {diagonal.x, diagonal.y, diagonal.z, rest.x, rest.y, rest.z};
}

/// Eigen's view of a kernel value, exactly.
template <class T>
auto exact(const T& value) {
    return to_eigen<long double>(value);
}

long double off(scalar computed, long double exact) { return std::abs(static_cast<long double>(computed) - exact); }

Column abs_of(const ingot::Vector& v) { return exact(v).cwiseAbs(); }
template <class M>
Square abs_of(const M& m) {
    return exact(m).cwiseAbs();
}

TEST(Vec3, sums_and_multiples_are_rounded_once) {
    RandomInput random(1);
    for (int i = 0; i < samples; ++i) {
        const ingot::Vector a = random_vector(random), b = random_vector(random);
        const scalar s = static_cast<scalar>(random.of_any_size(-8, 8));
        const long double once = gamma<scalar>(1);
        const Column sum = exact(a) + exact(b), difference = exact(a) - exact(b),
                     multiple = exact(a) * static_cast<long double>(s);
        ASSERT_LE(worst_relative_error(exact(a + b), sum, sum.cwiseAbs()), once);
        ASSERT_LE(worst_relative_error(exact(a - b), difference, difference.cwiseAbs()), once);
        ASSERT_LE(worst_relative_error(exact(a * s), multiple, multiple.cwiseAbs()), once);
        ASSERT_EQ(exact(s * a), exact(a * s));
        ASSERT_EQ(exact(-a), Column(-exact(a)));
        const Column product = exact(a).cwiseProduct(exact(b));
        ASSERT_LE(worst_relative_error(exact(scaled(a, b)), product, product.cwiseAbs()), once);

        ingot::Vector c = a;
        c += b;
        ASSERT_EQ(exact(c), exact(a + b));
        c = a;
        c -= b;
        ASSERT_EQ(exact(c), exact(a - b));
    }
}

TEST(Vec3, dot_and_cross_agree_with_eigen) {
    RandomInput random(2);
    for (int i = 0; i < samples; ++i) {
        const ingot::Vector a = random_vector(random), b = random_vector(random);
        // dot: a product and two sums on the longest path
        ASSERT_LE(off(dot(a, b), exact(a).dot(exact(b))), gamma<scalar>(3) * abs_of(a).dot(abs_of(b)));
        ASSERT_LE(off(length_sq(a), exact(a).squaredNorm()), gamma<scalar>(3) * exact(a).squaredNorm());
        // cross: a product and a difference
        const Column u = abs_of(a), w = abs_of(b);
        const Column terms{u(1) * w(2) + u(2) * w(1), u(2) * w(0) + u(0) * w(2), u(0) * w(1) + u(1) * w(0)};
        ASSERT_LE(worst_relative_error(exact(cross(a, b)), Column(exact(a).cross(exact(b))), terms), gamma<scalar>(2));
        ASSERT_EQ(exact(cross(a, b)), exact(-cross(b, a)));
        ASSERT_EQ(exact(cross(a, a)), Column(Column::Zero()));
    }
}

TEST(Mat3, products_agree_with_eigen) {
    RandomInput random(3);
    for (int i = 0; i < samples; ++i) {
        const ingot::Matrix a = random_matrix(random), b = random_matrix(random);
        const ingot::Vector v = random_vector(random);
        const long double bound = gamma<scalar>(3);  // three products summed
        ASSERT_LE(worst_relative_error(exact(a * v), Column(exact(a) * exact(v)), Column(abs_of(a) * abs_of(v))), bound);
        ASSERT_LE(worst_relative_error(exact(a * b), Square(exact(a) * exact(b)), Square(abs_of(a) * abs_of(b))), bound);
        ASSERT_LE(worst_relative_error(exact(transpose_times(a, v)), Column(exact(a).transpose() * exact(v)),
                                       Column(abs_of(a).transpose() * abs_of(v))),
                  bound);
        ASSERT_EQ(exact(transposed(a)), Square(exact(a).transpose()));
        const Square sum = exact(a) + exact(b), difference = exact(a) - exact(b);
        ASSERT_LE(worst_relative_error(exact(a + b), sum, sum.cwiseAbs()), gamma<scalar>(1));
        ASSERT_LE(worst_relative_error(exact(a - b), difference, difference.cwiseAbs()), gamma<scalar>(1));
        ASSERT_LE(worst_relative_error(exact(a * v.x), Square(exact(a) * static_cast<long double>(v.x)),
                                       Square(abs_of(a) * std::abs(static_cast<long double>(v.x)))),
                  gamma<scalar>(1));
    }
}

TEST(Mat3, determinant_agrees_with_eigen) {
    RandomInput random(4);
    for (int i = 0; i < samples; ++i) {
        const ingot::Matrix a = random_matrix(random);
        const Square m = abs_of(a);
        const Column c1 = m.col(1), c2 = m.col(2);
        const Column terms{c1(1) * c2(2) + c1(2) * c2(1), c1(2) * c2(0) + c1(0) * c2(2), c1(0) * c2(1) + c1(1) * c2(0)};
        // a cross product (2) inside a dot product (3)
        ASSERT_LE(off(determinant(a), exact(a).determinant()), gamma<scalar>(5) * m.col(0).dot(terms));
    }
    EXPECT_EQ(determinant(ingot::identity_matrix<scalar>()), 1);
}

TEST(Sym3, products_agree_with_eigen) {
    RandomInput random(5);
    for (int i = 0; i < samples; ++i) {
        const ingot::SymmetricMatrix s = random_symmetric(random), t = random_symmetric(random);
        const ingot::Matrix a = random_matrix(random);
        const ingot::Vector v = random_vector(random);
        const long double bound = gamma<scalar>(3);  // three products summed
        ASSERT_LE(worst_relative_error(exact(s * v), Column(exact(s) * exact(v)), Column(abs_of(s) * abs_of(v))), bound);
        ASSERT_LE(worst_relative_error(exact(a * s), Square(exact(a) * exact(s)), Square(abs_of(a) * abs_of(s))), bound);
        ASSERT_LE(worst_relative_error(exact(gram(a)), Square(exact(a).transpose() * exact(a)),
                                       Square(abs_of(a).transpose() * abs_of(a))),
                  bound);
        const Square sum = exact(s) + exact(t), difference = exact(s) - exact(t);
        ASSERT_LE(worst_relative_error(exact(s + t), sum, sum.cwiseAbs()), gamma<scalar>(1));
        ASSERT_LE(worst_relative_error(exact(s - t), difference, difference.cwiseAbs()), gamma<scalar>(1));
        ASSERT_LE(worst_relative_error(exact(s * v.x), Square(exact(s) * static_cast<long double>(v.x)),
                                       Square(abs_of(s) * std::abs(static_cast<long double>(v.x)))),
                  gamma<scalar>(1));
    }
    EXPECT_EQ(exact(ingot::identity_sym3<scalar>()), Square(Square::Identity()));
}

/// Eq. 2 for any matrix A, not only rotations.
TEST(Sym3, similarity_transform_agrees_with_eigen) {
    RandomInput random(6);
    for (int i = 0; i < samples; ++i) {
        const ingot::Matrix a = random_matrix(random);
        const ingot::Vector d = random_vector(random);
        const ingot::SymmetricMatrix b = random_symmetric(random);
        // A diag(d) A^T: a product, then three products summed
        ASSERT_LE(
            worst_relative_error(exact(rotated_diagonal(a, d)), Square(exact(a) * exact(d).asDiagonal() * exact(a).transpose()),
                                 Square(abs_of(a) * abs_of(d).asDiagonal() * abs_of(a).transpose())),
            gamma<scalar>(4));
        // A B A^T: three products summed, twice
        ASSERT_LE(worst_relative_error(exact(rotated(a, b)), Square(exact(a) * exact(b) * exact(a).transpose()),
                                       Square(abs_of(a) * abs_of(b) * abs_of(a).transpose())),
                  gamma<scalar>(6));
    }
}

/// One entry at a time, in every kind of bad number.
TEST(Mat3, is_finite_sees_every_entry) {
    const scalar bad_numbers[] = {std::numeric_limits<scalar>::quiet_NaN(), std::numeric_limits<scalar>::infinity(),
                                  -std::numeric_limits<scalar>::infinity()};
    const scalar max = std::numeric_limits<scalar>::max();
    EXPECT_TRUE(is_finite(ingot::Vector{max, max, max})) << "the sum of the components is infinite, they are not";
    EXPECT_TRUE(is_finite(ingot::Matrix{{max, max, max}, {max, max, max}, {max, max, max}}));
    EXPECT_TRUE(is_finite(ingot::SymmetricMatrix{max, max, max, max, max, max}));
    for (const scalar bad : bad_numbers) {
        for (int entry_i = 0; entry_i < 9; ++entry_i) {
            scalar e[9] = {1, 2, 3, 4, 5, 6, 7, 8, 9};
            e[entry_i] = bad;
            EXPECT_FALSE(is_finite(ingot::Matrix{{e[0], e[1], e[2]}, {e[3], e[4], e[5]}, {e[6], e[7], e[8]}}));
            EXPECT_EQ(is_finite(ingot::Vector{e[0], e[1], e[2]}), entry_i >= 3);
            EXPECT_EQ(is_finite(ingot::SymmetricMatrix{e[0], e[1], e[2], e[3], e[4], e[5]}), entry_i >= 6);
        }
    }
}

}  // namespace

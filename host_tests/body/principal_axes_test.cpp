// SPDX-License-Identifier: MIT
// Principal axes against Eigen's solver in long double, over tensors of every kind that Jacobi rotations may find hard.
#include <ingot/body/mass_properties.h>

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "reference/kernel_types.h"
#include "reference/measure.h"
#include "reference/random_input.h"

namespace {

using ingot::scalar;
using ingot::Status;
using ingot::SymmetricMatrix;
using ingot_reference::RandomInput;
using ingot_reference::to_eigen;
using Real = long double;
using Matrix3 = Eigen::Matrix<Real, 3, 3>;
using Vector3 = Eigen::Matrix<Real, 3, 1>;

constexpr Real epsilon = static_cast<Real>(ingot::epsilon);

// What principal_axes promises. A turn of a plane costs each entry that it changes a product and a sum: two roundings, one
// epsilon of the largest moment. Three sweeps of three turns reach the rounding level (the convergence is quadratic, the fourth
// changes nothing): nine turns.
constexpr Real moments_bound = 9 * epsilon;
// Moments that count as equal leave products of inertia of at most 4 epsilon of their sum, 8 of the largest moment; a matrix
// with three such off the diagonal has no eigenvalue beyond 16.
constexpr Real equal_moments_bound = moments_bound + 16 * epsilon;
// The polar step ends in a sum that rounds each entry of A by u = epsilon / 2 of itself, which A^T A shows twice, and it takes
// away half of a defect that three roundings of dot products of unit columns have hidden: 2 u and 3 u.
constexpr Real orthogonality_bound = 2.5L * epsilon;

SymmetricMatrix tensor_of(const Eigen::Matrix3d& S) {
    const auto s = [](double x) { return static_cast<scalar>(x); };
    return {s(S(0, 0)), s(S(1, 1)), s(S(2, 2)), s(S(0, 1)), s(S(0, 2)), s(S(1, 2))};
}

/// The tensor of these moments, turned at will.
SymmetricMatrix turned(const Eigen::Vector3d& moments, RandomInput& random) {
    const Eigen::Matrix3d A = random.rotation();
    return tensor_of(A * moments.asDiagonal() * A.transpose());
}

Vector3 sorted(Vector3 v) {
    std::sort(v.data(), v.data() + 3);
    return v;
}

/// What principal_axes makes of a tensor, measured.
struct Errors {
    Real moments;         ///< against Eigen's, of the largest
    Real tensor;          ///< largest entry of S - A diag(moments) A^T, of the largest moment
    Real orthogonality;   ///< largest entry of |A^T A - 1|
    Real determinant;
};

Errors errors_of(const SymmetricMatrix& S, const ingot::PrincipalAxes& axes) {
    const Matrix3 exact = to_eigen<Real>(S), A = to_eigen<Real>(axes.A);
    const Vector3 moments = to_eigen<Real>(axes.moments);
    const Vector3 eigenvalues = Eigen::SelfAdjointEigenSolver<Matrix3>(exact, Eigen::EigenvaluesOnly).eigenvalues();
    const Real largest = std::max(eigenvalues.cwiseAbs().maxCoeff(), std::numeric_limits<Real>::min());
    return {(sorted(moments) - sorted(eigenvalues)).cwiseAbs().maxCoeff() / largest,
            (exact - A * moments.asDiagonal() * A.transpose()).cwiseAbs().maxCoeff() / largest,
            (A.transpose() * A - Matrix3::Identity()).cwiseAbs().maxCoeff(), A.determinant()};
}

/// Largest trace that any of the 24 right-handed signed orders of the columns has.
Real best_trace(const Matrix3& A) {
    int order[3] = {0, 1, 2};
    Real best = -4;
    do {
        for (int signs = 0; signs < 8; ++signs) {
            Matrix3 other;
            for (int k = 0; k < 3; ++k) other.col(k) = A.col(order[k]) * ((signs >> k & 1) != 0 ? -1 : 1);
            if (other.determinant() > 0) best = std::max(best, other.trace());
        }
    } while (std::next_permutation(order, order + 3));
    return best;
}

class Worst {
public:
    Worst(const char* family, Real bound) : family_(family), bound_(bound) {}
    ~Worst() {
        record("moments", moments_);
        record("tensor", tensor_);
        record("orthogonality", orthogonality_);
    }

    void check(const SymmetricMatrix& S) {
        const ingot::Result<ingot::PrincipalAxes> axes = ingot::principal_axes(S);
        ASSERT_EQ(axes.status, Status::ok) << family_;
        const Errors errors = errors_of(S, axes.value);
        EXPECT_LE(errors.moments, bound_) << family_;
        EXPECT_LE(errors.tensor, bound_) << family_;
        EXPECT_LE(errors.orthogonality, orthogonality_bound) << family_;
        EXPECT_GT(errors.determinant, 0) << family_;
        const Matrix3 A = to_eigen<Real>(axes.value.A);
        EXPECT_GE(A.trace(), best_trace(A) - orthogonality_bound) << family_;
        moments_ = std::max(moments_, errors.moments);
        tensor_ = std::max(tensor_, errors.tensor);
        orthogonality_ = std::max(orthogonality_, errors.orthogonality);
    }

private:
    void record(const std::string& what, Real error) const {
        ::testing::Test::RecordProperty(what + "_in_epsilon", std::to_string(static_cast<double>(error / epsilon)));
    }

    const char* family_;
    Real bound_;
    Real moments_ = 0, tensor_ = 0, orthogonality_ = 0;
};

constexpr int many = 5000;

TEST(PrincipalAxes, of_random_solids_are_eigen_s) {
    RandomInput random(1);
    Worst worst("random", moments_bound);
    for (int i = 0; i < many; ++i)
        worst.check(turned(random.moments(std::ldexp(1.0, random.integer(-20, 20))), random));
}

TEST(PrincipalAxes, of_random_symmetric_matrices_are_eigen_s) {
    RandomInput random(2);
    Worst worst("symmetric", moments_bound);
    for (int i = 0; i < many; ++i) {
        const Eigen::Vector3d d = random.vector(1), o = random.vector(1);
        Eigen::Matrix3d S;
        S << d(0), o(0), o(1), o(0), d(1), o(2), o(1), o(2), d(2);
        worst.check(tensor_of(S));
    }
}

TEST(PrincipalAxes, of_two_or_three_equal_moments_are_eigen_s) {
    RandomInput random(3);
    Worst worst("degenerate", equal_moments_bound);
    for (int i = 0; i < many; ++i) {
        const double I = random.real(0.5, 2);
        Eigen::Vector3d moments(I, I, i % 3 == 0 ? I : random.real(0.1, 1.9) * I);
        if (i % 2 == 0) std::swap(moments(random.integer(0, 2)), moments(2));
        worst.check(turned(moments, random));
    }
}

TEST(PrincipalAxes, of_nearly_equal_moments_are_eigen_s) {
    RandomInput random(4);
    Worst worst("nearly_equal", equal_moments_bound);
    for (int i = 0; i < many; ++i) {
        const double I = random.real(0.5, 2);
        const auto near_I = [&] { return I * (1 + random.of_any_size(-56, -4)); };
        worst.check(turned({near_I(), near_I(), i % 2 == 0 ? near_I() : I * random.real(0.5, 1.5)}, random));
    }
}

TEST(PrincipalAxes, of_rods_and_plates_1000_to_1_are_eigen_s) {
    RandomInput random(5);
    Worst worst("sliver", equal_moments_bound);
    for (int i = 0; i < many; ++i) {
        const double a = random.real(900, 1100), b = i % 2 == 0 ? random.real(900, 1100) : random.real(0.9, 1.1),
                     c = random.real(0.9, 1.1);
        worst.check(turned({b * b + c * c, a * a + c * c, a * a + b * b}, random));
    }
}

TEST(PrincipalAxes, of_nearly_diagonal_tensors_are_eigen_s) {
    RandomInput random(6);
    Worst worst("nearly_diagonal", moments_bound);
    for (int i = 0; i < many; ++i) {
        Eigen::Matrix3d S = random.moments(1).asDiagonal();
        for (int r = 0; r < 3; ++r) {
            const int p = (r + 1) % 3, q = (r + 2) % 3;
            S(p, q) = S(q, p) = random.of_any_size(-60, -3) * std::min(S(p, p), S(q, q));
        }
        worst.check(tensor_of(S));
    }
}

TEST(PrincipalAxes, of_singular_and_structured_matrices_are_eigen_s) {
    Worst worst("structured", equal_moments_bound);
    constexpr int values[4] = {-1, 0, 1, 3};
    for (int code = 0; code < 4096; ++code) {
        const auto entry = [&](int digit) { return static_cast<scalar>(values[code >> 2 * digit & 3]); };
        worst.check({entry(0), entry(1), entry(2), entry(3), entry(4), entry(5)});
    }
}

TEST(PrincipalAxes, scale_with_the_tensor_by_powers_of_two_to_the_bit) {
    RandomInput random(7);
    for (int i = 0; i < many; ++i) {
        const SymmetricMatrix S = turned(random.moments(1), random);
        const scalar factor = static_cast<scalar>(std::ldexp(1.0, random.integer(-55, 55)));
        const ingot::PrincipalAxes a = ingot::principal_axes(S).value, b = ingot::principal_axes(S * factor).value;
        EXPECT_EQ(to_eigen(a.A), to_eigen(b.A));
        EXPECT_EQ(to_eigen(a.moments * factor), to_eigen(b.moments));
    }
}

TEST(PrincipalAxes, of_a_diagonal_tensor_are_the_user_s_to_the_bit) {
    RandomInput random(8);
    for (int i = 0; i < many; ++i) {
        const auto any = [&] { return static_cast<scalar>(std::abs(random.of_any_size(-50, 50))); };
        const scalar zero = i % 2 == 0 ? scalar(0) : -scalar(0);
        const SymmetricMatrix S = {any(), any(), any(), zero, zero, zero};
        const ingot::Result<ingot::PrincipalAxes> axes = ingot::principal_axes(S);
        ASSERT_EQ(axes.status, Status::ok);
        EXPECT_EQ(to_eigen(axes.value.A), Eigen::Matrix3d::Identity());
        EXPECT_EQ(to_eigen(axes.value.moments), Eigen::Vector3d(S.xx, S.yy, S.zz));
    }
}

TEST(PrincipalAxes, of_a_ball_or_cube_turned_at_will_stay_the_user_s) {
    RandomInput random(9);
    for (int i = 0; i < many; ++i) {
        const ingot::Matrix A = ingot_reference::to_matrix(random.rotation());
        const ingot::MassDistribution cube =
            ingot::placed(ingot::solid_box(3, {scalar(0.7), scalar(0.7), scalar(0.7)}), A, {1, 2, 3});
        const ingot::Result<ingot::MassProperties> mass = ingot::principal(cube);
        ASSERT_EQ(mass.status, Status::ok);
        EXPECT_EQ(to_eigen(mass.value.A_principal), Eigen::Matrix3d::Identity());
        EXPECT_EQ(to_eigen(mass.value.I_body), Eigen::Vector3d(cube.I.xx, cube.I.yy, cube.I.zz));
    }
}

TEST(PrincipalAxes, of_a_turn_below_45_degrees_about_an_axis_are_that_turn) {
    RandomInput random(10);
    const ingot::MassDistribution box = ingot::solid_box(1, {1, 2, 3});
    for (int i = 0; i < many; ++i) {
        const double angle = random.real(-0.78, 0.78);
        const ingot::Vector n = {i % 3 == 0 ? scalar(1) : scalar(0), i % 3 == 1 ? scalar(1) : scalar(0),
                                 i % 3 == 2 ? scalar(1) : scalar(0)};
        const ingot::Matrix A = ingot::axis_angle(n, static_cast<scalar>(angle));
        const ingot::Result<ingot::MassProperties> mass = ingot::principal(ingot::placed(box, A, {}));
        ASSERT_EQ(mass.status, Status::ok);
        // The axes turn by the error of the tensor, below 9 epsilon of the largest moment (208), over the smallest gap (48).
        EXPECT_LE(ingot_reference::largest_difference(to_eigen(mass.value.A_principal), to_eigen(A)), moments_bound * 208 / 48);
        EXPECT_LE(ingot_reference::largest_difference(to_eigen(mass.value.I_body), Eigen::Vector3d(208, 160, 80)),
                  moments_bound * 208);
    }
}

TEST(PrincipalAxes, of_what_is_no_number_or_too_large_are_refused) {
    const scalar infinity = std::numeric_limits<scalar>::infinity(), nan = std::numeric_limits<scalar>::quiet_NaN();
    for (int entry_i = 0; entry_i < 6; ++entry_i) {
        const auto with = [&](scalar value) {
            scalar e[6] = {1, 1, 1, 0, 0, 0};
            e[entry_i] = value;
            return ingot::principal_axes({e[0], e[1], e[2], e[3], e[4], e[5]}).status;
        };
        EXPECT_EQ(with(nan), Status::not_finite);
        EXPECT_EQ(with(infinity), Status::not_finite);
        EXPECT_EQ(with(-infinity), Status::not_finite);
        EXPECT_EQ(with(2 * ingot::limits::inertia_max), Status::bad_inertia);
        EXPECT_EQ(with(-2 * ingot::limits::inertia_max), Status::bad_inertia);
        EXPECT_EQ(with(std::numeric_limits<scalar>::max()), Status::bad_inertia);
        EXPECT_EQ(with(std::numeric_limits<scalar>::denorm_min()), Status::ok);
    }
}

constexpr SymmetricMatrix skewed = {3, 4, 5, scalar(0.5), scalar(0.25), scalar(-0.125)};
constexpr ingot::Result<ingot::PrincipalAxes> known_to_the_compiler = ingot::principal_axes(skewed);
static_assert(known_to_the_compiler.ok(), "principal axes are a constant expression");

TEST(PrincipalAxes, at_compile_time_are_those_at_run_time_to_the_bit) {
    SymmetricMatrix volatile_copy = skewed;
    volatile scalar xx = skewed.xx;
    volatile_copy.xx = xx;
    const ingot::PrincipalAxes axes = ingot::principal_axes(volatile_copy).value;
    EXPECT_EQ(to_eigen(axes.A), to_eigen(known_to_the_compiler.value.A));
    EXPECT_EQ(to_eigen(axes.moments), to_eigen(known_to_the_compiler.value.moments));
}

TEST(PrincipalAxes, roots_of_the_turns_are_within_an_ulp) {
    RandomInput random(11);
    for (int i = 0; i < 100 * many; ++i) {
        const scalar x = std::min(scalar(2), static_cast<scalar>(random.real(1, 2.0001)));
        EXPECT_LE(ingot_reference::ulps_off(ingot::jacobi::sqrt_of_1_to_2(x), std::sqrt(static_cast<Real>(x))), 1);
    }
}

}  // namespace

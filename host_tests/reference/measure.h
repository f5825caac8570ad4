// SPDX-License-Identifier: MIT
// How far a computed value is from the exact one: in roundings, in ulps, as an angle.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace ingot_reference {

template <class T>
inline constexpr long double smallest_normal = static_cast<long double>(std::numeric_limits<T>::min());

/// Half an ulp of 1: the largest relative error of one rounding of T.
template <class T>
inline constexpr long double roundoff = static_cast<long double>(std::numeric_limits<T>::epsilon()) / 2;

/// The relative error that n roundings in a row can reach, n u / (1 - n u), and a hundredth more for the reference's own
/// (Higham, "Accuracy and Stability of Numerical Algorithms", 3.1).
template <class T>
long double gamma(int n) {
    const long double nu = n * roundoff<T>;
    return 1.01L * nu / (1 - nu);
}

/// Spacing of the numbers of T at |x|; of those at `floor` where |x| is smaller.
template <class T>
long double ulp_at(long double x, long double floor = smallest_normal<T>) {
    int exponent = 0;
    std::frexp(std::max(std::abs(x), floor), &exponent);
    return std::ldexp(1.0L, exponent - std::numeric_limits<T>::digits);
}

/// Error of `computed` in ulps of the exact value, or of `floor` where that is smaller.
template <class T>
long double ulps_off(T computed, long double exact, long double floor = smallest_normal<T>) {
    return std::abs(static_cast<long double>(computed) - exact) / ulp_at<T>(exact, floor);
}

/// Largest over the entries of |computed - exact| / magnitude; `magnitude` holds what the roundings of each entry are
/// relative to, as a rule the sum of the magnitudes of its terms. An error where the magnitude is zero is infinite.
template <class Computed, class Exact, class Magnitude>
long double worst_relative_error(const Computed& computed, const Exact& exact, const Magnitude& magnitude) {
    long double worst = 0;
    for (Eigen::Index i = 0; i < exact.size(); ++i) {
        const long double error = std::abs(static_cast<long double>(computed(i)) - static_cast<long double>(exact(i)));
        if (!(error == 0)) worst = std::max(worst, error / static_cast<long double>(magnitude(i)));
        if (std::isnan(error)) return std::numeric_limits<long double>::infinity();
    }
    return worst;
}

/// Euclidean (or Frobenius) length, in double.
template <class V>
double length_of(const V& v) {
    return static_cast<double>(v.norm());
}

/// Largest entry of |A - B|.
template <class A, class B>
double largest_difference(const A& a, const B& b) {
    return static_cast<double>((a.template cast<long double>() - b.template cast<long double>()).cwiseAbs().maxCoeff());
}

/// The angle of the rotation between two orientations, rad: 2 asin(|A - A_ref|_F / (2 sqrt 2)).
template <class A, class B>
double attitude_error(const A& a, const B& a_ref) {
    const long double norm = (a.template cast<long double>() - a_ref.template cast<long double>()).norm();
    return static_cast<double>(2 * std::asin(std::min(1.0L, norm / (2 * std::sqrt(2.0L)))));
}

/// Largest entry of |A^T A - 1|.
template <class A>
double orthogonality_defect(const A& a) {
    const Eigen::Matrix<long double, 3, 3> wide = a.template cast<long double>();
    return largest_difference(wide.transpose() * wide, Eigen::Matrix<long double, 3, 3>::Identity());
}

}  // namespace ingot_reference

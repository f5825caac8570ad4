// SPDX-License-Identifier: MIT
// The torque-free body to the last digits of long double: Euler's equations and dA/dt = A tilde(w) in the body frame,
//
//     I w' = (I w) x w,    a' = a x w for each row a of A,
//
// are quadratic, so the coefficients of their Taylor series follow from each other by products alone. The series converges
// for |w| t up to about 1; with 24 terms and steps of |w| t <= 1/8 what is left out is below 8^-24 = 2e-22. Checked against
// the 32-digit tables in stages/reference_test.cpp. It shares no code with the kernel.
#pragma once

#include <Eigen/Dense>
#include <cmath>

namespace ingot_reference {

class FreeBody {
public:
    using Real = long double;
    using Vector3 = Eigen::Matrix<Real, 3, 1>;
    using Matrix3 = Eigen::Matrix<Real, 3, 3>;

    /// I: principal moments; A: body to world; L: world axes.
    FreeBody(const Vector3& I, const Matrix3& A, const Vector3& L) : I_(I), A_(A), L_(L) { refresh_w(); }

    const Matrix3& A() const { return A_; }
    const Vector3& L() const { return L_; }
    const Vector3& w_body() const { return w_; }
    Vector3 omega() const { return A_ * w_; }
    Real energy() const { return w_.dot(I_.cwiseProduct(w_)) / 2; }

    /// Lets the body turn freely for t seconds; t may be negative.
    void advance(Real t) {
        const Real turn = std::abs(t) * std::sqrt(2 * energy() / I_.minCoeff());  // at least |w| t all along the polhode
        const int steps = 1 + static_cast<int>(turn / turn_per_step);
        for (int step_i = 0; step_i < steps; ++step_i) step(t / steps);
    }

private:
    static constexpr int terms = 24;
    static constexpr Real turn_per_step = 0.125L;

    static void add_cross(const Real (&a)[3], const Real (&b)[3], Real (&sum)[3]) {
        sum[0] += a[1] * b[2] - a[2] * b[1];
        sum[1] += a[2] * b[0] - a[0] * b[2];
        sum[2] += a[0] * b[1] - a[1] * b[0];
    }

    void refresh_w() { w_ = (A_.transpose() * L_).cwiseQuotient(I_); }

    /// One step of the series, in plain numbers: Eigen without optimisation would take ten times as long.
    void step(Real h) {
        // x[k] holds the k-th Taylor coefficients of w, I w and the rows of A, three numbers each.
        Real w[terms + 1][3], y[terms + 1][3], row[3][terms + 1][3];
        for (int i = 0; i < 3; ++i) {
            w[0][i] = w_(i);
            y[0][i] = I_(i) * w_(i);
            for (int r = 0; r < 3; ++r) row[r][0][i] = A_(r, i);
        }
        for (int k = 0; k < terms; ++k) {
            Real y_sum[3] = {}, row_sum[3][3] = {};
            for (int i = 0; i <= k; ++i) {
                add_cross(y[i], w[k - i], y_sum);
                for (int r = 0; r < 3; ++r) add_cross(row[r][i], w[k - i], row_sum[r]);
            }
            for (int i = 0; i < 3; ++i) {
                y[k + 1][i] = y_sum[i] / (k + 1);
                w[k + 1][i] = y[k + 1][i] / I_(i);
                for (int r = 0; r < 3; ++r) row[r][k + 1][i] = row_sum[r][i] / (k + 1);
            }
        }
        for (int r = 0; r < 3; ++r) {
            for (int i = 0; i < 3; ++i) {
                Real sum = 0;
                for (int k = terms; k >= 0; --k) sum = sum * h + row[r][k][i];
                A_(r, i) = sum;
            }
        }
        A_ += A_ * (Matrix3::Identity() - A_.transpose() * A_) / 2;  // keeps A A^T = 1; what it takes off is rounding
        refresh_w();
    }

    Vector3 I_;
    Matrix3 A_;
    Vector3 L_, w_;
};

}  // namespace ingot_reference

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

    void refresh_w() { w_ = (A_.transpose() * L_).cwiseQuotient(I_); }

    void step(Real h) {
        // x[k] is the k-th Taylor coefficient: w, I w, and the rows of A.
        Vector3 w[terms + 1], y[terms + 1], row[3][terms + 1];
        w[0] = w_;
        y[0] = I_.cwiseProduct(w_);
        for (int r = 0; r < 3; ++r) row[r][0] = A_.row(r).transpose();
        for (int k = 0; k < terms; ++k) {
            Vector3 y_sum = Vector3::Zero(), row_sum[3] = {Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
            for (int i = 0; i <= k; ++i) {
                y_sum += y[i].cross(w[k - i]);
                for (int r = 0; r < 3; ++r) row_sum[r] += row[r][i].cross(w[k - i]);
            }
            const Real next = k + 1;
            y[k + 1] = y_sum / next;
            w[k + 1] = y[k + 1].cwiseQuotient(I_);
            for (int r = 0; r < 3; ++r) row[r][k + 1] = row_sum[r] / next;
        }
        for (int r = 0; r < 3; ++r) {
            Vector3 sum = Vector3::Zero();
            for (int k = terms; k >= 0; --k) sum = sum * h + row[r][k];
            A_.row(r) = sum.transpose();
        }
        A_ += A_ * (Matrix3::Identity() - A_.transpose() * A_) / 2;  // keeps A A^T = 1; what it takes off is rounding
        refresh_w();
    }

    Vector3 I_;
    Matrix3 A_;
    Vector3 L_, w_;
};

}  // namespace ingot_reference

// SPDX-License-Identifier: MIT
// A body turned by a torque: dA/dt = tilde(omega) A, dL/dt = tau, by the classical Runge-Kutta method of order 4 in long
// double with steps as small as it takes. It shares no code with the kernel.
#pragma once

#include <Eigen/Dense>

namespace ingot_reference {

class DrivenBody {
public:
    using Real = long double;
    using Vector3 = Eigen::Matrix<Real, 3, 1>;
    using Matrix3 = Eigen::Matrix<Real, 3, 3>;

    /// I: principal moments; A: body to world; L: world axes.
    DrivenBody(const Vector3& I, const Matrix3& A, const Vector3& L) : inv_I_(I.cwiseInverse()), A_(A), L_(L) {}

    const Matrix3& A() const { return A_; }
    const Vector3& L() const { return L_; }
    Real t() const { return t_; }

    /// t seconds in so many steps; torque(t, A) in world axes, N m.
    template <class Torque>
    void advance(Real t, int steps, Torque torque) {
        const Real h = t / steps;
        const auto rate_of = [&](Real time, const Matrix3& A, const Vector3& L) -> Rate {
            const Vector3 omega = A * inv_I_.cwiseProduct(A.transpose() * L);
            Matrix3 A_rate;
            for (int column = 0; column < 3; ++column) A_rate.col(column) = omega.cross(A.col(column));
            return {A_rate, torque(time, A)};
        };
        const Real t_0 = t_;
        for (int step_i = 0; step_i < steps; ++step_i) {
            t_ = t_0 + step_i * h;
            const Rate k1 = rate_of(t_, A_, L_);
            const Rate k2 = rate_of(t_ + h / 2, A_ + h / 2 * k1.A, L_ + h / 2 * k1.L);
            const Rate k3 = rate_of(t_ + h / 2, A_ + h / 2 * k2.A, L_ + h / 2 * k2.L);
            const Rate k4 = rate_of(t_ + h, A_ + h * k3.A, L_ + h * k3.L);
            A_ += h / 6 * (k1.A + 2 * k2.A + 2 * k3.A + k4.A);
            L_ += h / 6 * (k1.L + 2 * k2.L + 2 * k3.L + k4.L);
            A_ += A_ * (Matrix3::Identity() - A_.transpose() * A_) / 2;  // keeps A A^T = 1
        }
        t_ = t_0 + t;
    }

private:
    struct Rate {
        Matrix3 A;
        Vector3 L;
    };

    Vector3 inv_I_;
    Matrix3 A_;
    Vector3 L_;
    Real t_ = 0;
};

}  // namespace ingot_reference

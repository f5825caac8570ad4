// SPDX-License-Identifier: MIT
// Listing 1 of Hecker, "Physics, Part 4: The Third Dimension", 1997, exactly as printed, with Eigen. It shares no code with
// the kernel. Real is double; long double tells how much of a difference is rounding.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace ingot_reference {

/// A force F, N, at r, m, from the centre of mass, world axes.
template <class Real>
struct ForceAtPoint {
    Eigen::Matrix<Real, 3, 1> F, r;
};

/// Gram-Schmidt on the columns in their order: each column loses its parts along those before it (taken one after the
/// other, "modified" Gram-Schmidt) and is then given unit length. The first column keeps its direction. A matrix near a
/// rotation stays right-handed, so its third column is the cross product of the other two.
template <class Real>
Eigen::Matrix<Real, 3, 3> reorthogonalised(Eigen::Matrix<Real, 3, 3> A) {
    for (int column = 0; column < 3; ++column) {
        for (int before = 0; before < column; ++before) A.col(column) -= A.col(before).dot(A.col(column)) * A.col(before);
        A.col(column) /= A.col(column).norm();
    }
    return A;
}

/// The skew-symmetric matrix with tilde(w) r = w x r (Eq. 9).
template <class Real>
Eigen::Matrix<Real, 3, 3> tilde_matrix(const Eigen::Matrix<Real, 3, 1>& w) {
    Eigen::Matrix<Real, 3, 3> m;
    m << 0, -w(2), w(1), w(2), 0, -w(0), -w(1), w(0), 0;
    return m;
}

template <class Real = double>
struct Listing1Body {
    using Vector3 = Eigen::Matrix<Real, 3, 1>;
    using Matrix3 = Eigen::Matrix<Real, 3, 3>;

    // body constants
    Real M;
    Matrix3 inv_I_body;
    // primary state
    Vector3 r, v;
    Matrix3 A;
    Vector3 L;
    // auxiliary
    Matrix3 inv_I_world;
    Vector3 omega;

    void compute_auxiliary() {
        inv_I_world = A * inv_I_body * A.transpose();  // Eq. 20
        omega = inv_I_world * L;                       // Eq. 18
    }

    static Listing1Body initialised(Real M, const Vector3& I_body, const Vector3& r, const Vector3& v, const Matrix3& A,
                                    const Vector3& L) {
        Listing1Body body;
        body.M = M;
        body.inv_I_body = I_body.cwiseInverse().asDiagonal();
        body.r = r;
        body.v = v;
        body.A = A;
        body.L = L;
        body.compute_auxiliary();
        return body;
    }

    /// One explicit Euler step: every right-hand side is of step n.
    void step(Real h, const std::vector<ForceAtPoint<Real>>& forces) {
        Vector3 F = Vector3::Zero(), tau = Vector3::Zero();
        for (const ForceAtPoint<Real>& force : forces) {
            F += force.F;                   // Eq. 14
            tau += force.r.cross(force.F);  // Eq. 16
        }
        const Vector3 r_n = r, v_n = v, L_n = L, omega_n = omega;
        const Matrix3 A_n = A;

        r = r_n + h * v_n;
        v = v_n + h * F / M;
        A = A_n + h * tilde_matrix(omega_n) * A_n;  // Eq. 10
        L = L_n + h * tau;
        A = reorthogonalised(A);
        compute_auxiliary();
    }
};

}  // namespace ingot_reference

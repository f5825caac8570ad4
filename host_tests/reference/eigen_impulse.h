// SPDX-License-Identifier: MIT
// Figure 4 of Hecker 1997, term by term as printed, with Eigen. It shares no code with the kernel.
#pragma once

#include <Eigen/Dense>

namespace ingot_reference {

/// A body that collides at P. One that is fixed has inv_M = 0 and inv_I_world = 0.
template <class Real = double>
struct ImpulseBody {
    Real inv_M;
    Eigen::Matrix<Real, 3, 3> inv_I_world;
    Eigen::Matrix<Real, 3, 1> v, omega;
    Eigen::Matrix<Real, 3, 1> r_P;  ///< from the centre of mass to P

    Eigen::Matrix<Real, 3, 1> velocity_at_P() const { return v + omega.cross(r_P); }

    /// Takes an impulse J at P: v += J / M, omega += I^-1 (r_P x J).
    void receive(const Eigen::Matrix<Real, 3, 1>& J) {
        v += inv_M * J;
        omega += inv_I_world * r_P.cross(J);
    }
};

/// j of Figure 4; n is the unit normal from B to A. Zero where the points separate.
template <class Real>
Real figure4_impulse(const ImpulseBody<Real>& A, const ImpulseBody<Real>& B, const Eigen::Matrix<Real, 3, 1>& n, Real e) {
    const Real v_n = (A.velocity_at_P() - B.velocity_at_P()).dot(n);
    if (v_n >= 0) return 0;
    const Eigen::Matrix<Real, 3, 1> turn_A = (A.inv_I_world * A.r_P.cross(n)).cross(A.r_P);
    const Eigen::Matrix<Real, 3, 1> turn_B = (B.inv_I_world * B.r_P.cross(n)).cross(B.r_P);
    return -(1 + e) * v_n / (A.inv_M + B.inv_M + (turn_A + turn_B).dot(n));
}

}  // namespace ingot_reference

// SPDX-License-Identifier: MIT
#include "check_body.h"

#include "../base/limits.h"
#include "kinematics.h"

namespace ingot { inline namespace INGOT_ABI {

Status check_vector(const Vector& v, scalar limit) {
    if (!is_finite(v)) return Status::not_finite;
    return abs(v.x) <= limit && abs(v.y) <= limit && abs(v.z) <= limit ? Status::ok : Status::out_of_range;
}

Status check_mass_properties(const MassProperties& mass) { return solids::check_moments(mass.M, mass.I_body); }

Status check_rotation(const Matrix& A) {
    if (!is_finite(A)) return Status::not_finite;
    // Written so that an overflow of A^T A, which gives NaN or infinity, is refused too.
    if (!(orthogonality_error(A) <= limits::orthogonality) || !(determinant(A) > 0)) return Status::not_a_rotation;
    return Status::ok;
}

Status check_state(const BodyState& state, const Vector& inv_I_body) {
    Status status = check_vector(state.r_CM, limits::position_max);
    if (status == Status::ok) status = check_vector(state.v_CM, limits::speed_max);
    if (status == Status::ok) status = check_rotation(state.A);
    if (status != Status::ok) return status;
    if (!is_finite(state.L)) return Status::not_finite;
    const Vector omega_body = scaled(inv_I_body, transpose_times(state.A, state.L));
    return is_finite(omega_body) ? check_vector(omega_body, limits::spin_max) : Status::out_of_range;
}

Matrix nearest_rotation(const Matrix& A) {
    Matrix R = A;
    // From limits::orthogonality three steps reach rounding: 1e-2, 7.5e-5, 4e-9, 1e-17.
    for (int step_i = 0; step_i < 4 && orthogonality_error(R) > 4 * epsilon; ++step_i) R = R + polar_correction(R);
    return R + Matrix{};  // x + 0 turns -0 into +0
}

Matrix correction_of_rotation(const Matrix& A) { return polar_correction(A); }

ScaledInverseInertia scaled_inverse_inertia(const Vector& I_body) {
    const Vector J = {1 / I_body.x, 1 / I_body.y, 1 / I_body.z};
    const scalar sum = J.x + J.y + J.z;
    scalar scale = 1;  // bounded: inertia_min .. inertia_max keeps the sum within 2^-62 .. 2^63
    // bound: 63: the sum is within 2^-62 .. 2^63: inertia_min .. inertia_max
    while (scale < sum) scale *= 2;
    // bound: 62: the sum is within 2^-62 .. 2^63: inertia_min .. inertia_max
    while (scale * scalar(0.5) >= sum) scale *= scalar(0.5);
    return {J * (1 / scale), scale};
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#include "impulse.h"

#include "../body/kinematics.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// 1/M + [(I^-1 (r x n)) x r] . n = 1/M + (I^-1 (r x n)) . (r x n): a sum of squares, which cannot cancel.
scalar compliance(const CollidingBody& body, const Vector& n) {
    const Vector lever = cross(body.r_P, n);
    return body.inv_M + dot(body.inv_I_world * lever, lever);
}

}  // namespace

scalar collision_impulse(const CollidingBody& A, const CollidingBody& B, const Vector& n, scalar e) {
    const Vector v_AP = point_velocity(A.v_CM, A.omega, A.r_P), v_BP = point_velocity(B.v_CM, B.omega, B.r_P);
    const scalar v_n = dot(v_AP - v_BP, n);
    if (!(v_n < 0)) return 0;
    return -(1 + e) * v_n / (compliance(A, n) + compliance(B, n));
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#include "rk4_polar.h"

#include "../body/kinematics.h"
#include "turn.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Newton steps to the rotation next to A, until what a step leaves, 3/4 of the defect squared, is rounding; `fallback` where that takes too
/// long, or ends at a reflection: beyond the valid range the sum of the slopes is no rotation, nor near one.
INGOT_INLINE Mat3<lane> nearest_rotation(Mat3<lane> A, const Mat3<lane>& fallback) {
    mask unsettled = splat<lane>(1) > lane{};
    for (int step_i = 0; step_i < limits::polar_steps_max && any(unsettled); ++step_i) {
        const Sym3<lane> off = identity_sym3<lane>() - gram(A);
        A = select(unsettled, A + A * (off * splat<lane>(scalar(0.5))), A);
        const lane defect = abs(off.xx) + abs(off.yy) + abs(off.zz) + abs(off.xy) + abs(off.xz) + abs(off.yz);
        unsettled = both(unsettled, opposite(defect * defect <= splat<lane>(4 * epsilon)));
    }
    return select(both(opposite(unsettled), determinant(A) > lane{}), A, fallback);
}

}  // namespace

int Rk4Polar::integrate_A(const BodyView& bodies, scalar h, const FlightClock& clock) {
    const lane step = splat<lane>(h), half_step = splat<lane>(h * scalar(0.5)), sixth = splat<lane>(h / 6);
    integrate_tiles(bodies, clock, [&](const Mat3<lane>& A, const Vec3<lane>& inv_I_body, const Vec3<lane>& L) {
        const auto rate = [&](const Mat3<lane>& at) { return orientation_rate(spin_of(at, inv_I_body, L), at); };
        const Mat3<lane> k1 = rate(A);
        const Mat3<lane> k2 = rate(A + k1 * half_step);
        const Mat3<lane> k3 = rate(A + k2 * half_step);
        const Mat3<lane> k4 = rate(A + k3 * step);
        const Mat3<lane> A_next = A + ((k1 + k4) + (k2 + k3) * splat<lane>(2)) * sixth;
        return nearest_rotation(A_next, A);
    });
    return 0;
}

} }  // namespace ingot

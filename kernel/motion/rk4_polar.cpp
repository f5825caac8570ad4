// SPDX-License-Identifier: MIT
#include "rk4_polar.h"

#include "../body/kinematics.h"
#include "turn.h"

namespace ingot { inline namespace INGOT_ABI {

int Rk4Polar::integrate_A(const BodyView& bodies, scalar h, const FlightClock& clock) {
    const lane step = splat<lane>(h), half_step = splat<lane>(h * scalar(0.5)), sixth = splat<lane>(h / 6);
    integrate_tiles(bodies, clock, [&](const Mat3<lane>& A, const Vec3<lane>& inv_I_body, const Vec3<lane>& L) {
        const auto rate = [&](const Mat3<lane>& at) { return orientation_rate(spin_of(at, inv_I_body, L), at); };
        const Mat3<lane> k1 = rate(A);
        const Mat3<lane> k2 = rate(A + k1 * half_step);
        const Mat3<lane> k3 = rate(A + k2 * half_step);
        const Mat3<lane> k4 = rate(A + k3 * step);
        const Mat3<lane> A_next = A + ((k1 + k4) + (k2 + k3) * splat<lane>(2)) * sixth;
        const Mat3<lane> polar = A_next + polar_correction(A_next);
        // Beyond the valid range one polar step does not reach a rotation: A then stays what it was.
        const Sym3<lane> off = gram(polar) - identity_sym3<lane>();
        const lane defect = abs(off.xx) + abs(off.yy) + abs(off.zz) + abs(off.xy) + abs(off.xz) + abs(off.yz);
        return select(defect <= splat<lane>(16 * epsilon), polar, A);
    });
    return 0;
}

} }  // namespace ingot

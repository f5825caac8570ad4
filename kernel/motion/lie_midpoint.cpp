// SPDX-License-Identifier: MIT
#include "lie_midpoint.h"

#include "turn.h"

namespace ingot { inline namespace INGOT_ABI {

int LieMidpoint::integrate_A(const BodyView& bodies, scalar h, const FlightClock& clock) {
    const lane step = splat<lane>(h), half_step = splat<lane>(h * scalar(0.5));
    const bool polar_step = clock.steps % limits::polar_interval == 0;
    integrate_tiles(bodies, clock, [&](const Mat3<lane>& A, const Vec3<lane>& inv_I_body, const Vec3<lane>& L) {
        const Mat3<lane> A_mid = A + world_turn(A, rodrigues(spin_of(A, inv_I_body, L) * half_step));
        const Mat3<lane> A_next = A + world_turn(A, rodrigues(spin_of(A_mid, inv_I_body, L) * step));
        return polar_step ? A_next + polar_correction(A_next) : A_next;
    });
    return 0;
}

} }  // namespace ingot

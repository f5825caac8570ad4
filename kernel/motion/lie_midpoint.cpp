// SPDX-License-Identifier: MIT
#include "lie_midpoint.h"

#include "turn.h"

namespace ingot { inline namespace INGOT_ABI {

int LieMidpoint::integrate_A(const BodyView& bodies, scalar h, const FlightClock& clock) {
    const lane part_of_step[2] = {splat<lane>(h * scalar(0.5)), splat<lane>(h)};
    const bool polar_step = clock.steps % limits::polar_interval == 0;
    integrate_tiles(bodies, clock, [&](const Mat3<lane>& A, const Vec3<lane>& inv_I_body, const Vec3<lane>& L) {
        Mat3<lane> at = A;  // where the spin is read: at the begin, then in the middle
        for (const lane part : part_of_step) at = A + world_turn(A, rodrigues(spin_of(at, inv_I_body, L) * part));
        return polar_step ? at + polar_correction(at) : at;
    });
    return 0;
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "../body/body_tiles.h"
#include "flight_clock.h"

namespace ingot { inline namespace INGOT_ABI {

/// The explicit midpoint rule on the rotation group: half a turn about omega, then the whole turn about the omega found there.
///
/// Order:      2. Keeps L; the energy drifts with h^2 (book case, 60 Hz, one minute: 2e-5).
/// Valid for:  |omega| h < 2 rad, the range of the tangent; beyond it A stays a rotation, of no meaning.
/// Cost:       about 250 flops, 16 divisions a body, no root, no trigonometry.
/// Source:     Krysl and Endres 2005 (LIEMID[EA]).
struct LieMidpoint {
    static constexpr const char* name = "lie_midpoint";
    static constexpr int order = 2;  ///< of the error in h
    static constexpr bool as_printed = false, compensates = false, returns_energy = false;
    static int integrate_A(const BodyView& bodies, scalar h, const FlightClock& clock);
};

} }  // namespace ingot

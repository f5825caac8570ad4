// SPDX-License-Identifier: MIT
#pragma once

#include "../body/body_tiles.h"
#include "flight_clock.h"

namespace ingot { inline namespace INGOT_ABI {

/// The classical Runge-Kutta method of order 4 on the nine numbers of A (Eq. 10), then polar steps back to a rotation: one,
/// rarely two.
///
/// Order:      4. Keeps L; the energy drifts with h^5.
/// Valid for:  |omega| h < 1 rad; beyond it, where limits::polar_steps_max do not reach a rotation, the body does not turn.
/// Cost:       444 flops a body, no division, no root, no trigonometry.
/// Source:     Kutta 1901; Eq. 10 of Hecker 1997.
struct Rk4Polar {
    static constexpr const char* name = "rk4_polar";
    static constexpr int order = 4;  ///< of the error in h
    static constexpr bool as_printed = false, compensates = false, returns_energy = false;
    static int integrate_A(const BodyView& bodies, scalar h, const FlightClock& clock);
};

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "../body/body_tiles.h"
#include "flight_clock.h"

namespace ingot { inline namespace INGOT_ABI {

/// The exact motion of a free body over the step, by Jacobi's elliptic functions: what other methods are measured against.
///
/// Keeps:      everything: L bitwise; the energy and A A^T = 1 to rounding.
/// Valid for:  turns of up to limits::elliptic_turn_max of elliptic argument a step, which is at least as many radians; beyond it the turn is
///             clamped to that, and reported. For all bodies, whatever their symmetry, and h of either sign. The angle about L is a sum
///             of 12 values of a function without a singularity near, for each half radian: exact to rounding.
/// Cost:       about 3000 flops, 100 divisions and 25 sines a body at |omega| h <= 0.5; bodies are taken one by one in every lane count.
///             Meant for double: in float, roundings of a step are five times those of the default method.
/// Source:     van Zon and Schofield 2007; Celledoni, Fasso, Safstrom, Zanna 2008. Written for one step from the state at hand: addition
///             theorems in place of a phase since a beginning, and the quotient of two sums of squares as the rate about L, which loses no digits
///             beside a separatrix, an axis or a symmetry.
struct ExactElliptic {
    static constexpr const char* name = "exact_elliptic";
    static constexpr bool as_printed = false, compensates = false, returns_energy = false;
    static int integrate_A(const BodyView& bodies, scalar h, const FlightClock& clock);
};

} }  // namespace ingot

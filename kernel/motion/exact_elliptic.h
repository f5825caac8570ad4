// SPDX-License-Identifier: MIT
#pragma once

#include "../body/body_tiles.h"
#include "flight_clock.h"

namespace ingot { inline namespace INGOT_ABI {

/// The exact motion of a free body over the step, by Jacobi's elliptic functions: what other methods are measured against.
///
/// Keeps:      everything: L bitwise; the energy and A A^T = 1 to rounding. A is summed with the bits it loses: 36 bytes a body in float.
/// Valid for:  all bodies, whatever their symmetry and however slender, and h of either sign. A body that at its fastest spins by more than
///             limits::elliptic_turn_max / h has its turn clamped, and reported. The angle about L is a sum of 12 values of a function
///             without a singularity near, for each half radian: exact to rounding.
/// Error:      a few epsilon of the turn, and of |L| h / I_min: by so much a rounding of A^T L changes the spin of a slender body. Where these are
///             small, in float too, what is left after any number of steps is the rounding of A, 4e-8 rad.
/// Cost:       about 1300 flops, 170 divisions and 26 roots and sines a body at |omega| h <= 0.5, as much again for each radian more; bodies are
///             taken one by one in every lane count.
/// Source:     van Zon and Schofield 2007; Celledoni, Fasso, Safstrom, Zanna 2008. Written for one step from the state at hand: addition
///             theorems in place of a phase since a beginning, differences formed as such, and the quotient of two sums of squares as the rate
///             about L, which loses no digits beside a separatrix, an axis or a symmetry.
struct ExactElliptic {
    static constexpr const char* name = "exact_elliptic";
    static constexpr bool as_printed = false, compensates = true, returns_energy = false;
    static int integrate_A(const BodyView& bodies, scalar h, const FlightClock& clock);
};

} }  // namespace ingot

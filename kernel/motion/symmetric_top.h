// SPDX-License-Identifier: MIT
#pragma once

#include "../body/body_tiles.h"
#include "flight_clock.h"

namespace ingot { inline namespace INGOT_ABI {

/// The free motion of a body with two equal principal moments, in closed form: a turn about its axis, then about L.
///
///     A <- exp(h [L] / I_t) A exp(h (1/I_s - 1/I_t) L_s [e_s])
///
/// For scenes of balls, cylinders, cones, square boxes: half the cost of the default method. A body whose three moments differ
/// turns as if the two nearest were equal to their mean: a wrong motion, of which the kernel says nothing.
///
/// Order:      exact for symmetric and spherical bodies. Keeps L, and their energy.
/// Valid for:  angles of a step up to 1000 rad; a body beyond that is marked bad.
/// Cost:       about 210 flops, 1 division, 1 root a body; sine and cosine by polynomials.
/// Source:     Euler; stated so in Dullweber, Leimkuhler and McLachlan 1997.
struct SymmetricTop {
    static constexpr const char* name = "symmetric_top";
    static constexpr int order = 0;  ///< exact
    static constexpr bool as_printed = false, compensates = false, returns_energy = false;
    static int integrate_A(const BodyView& bodies, scalar h, const FlightClock& clock);
};

/// Symmetric-top splitting: a symmetric top and what remains of the body in turn, each in closed form; the turn about L comes
/// once, at the end. The path for fast spin: it has no fixed point and no series to leave.
///
/// Order:      2 (Strang) or 6 (Yoshida's composition of 7). Symplectic: keeps L, and the energy without drift.
/// Valid for:  angles of a step up to 1000 rad, with an error that grows with the asymmetry times (|omega| h)^(order + 1).
/// Cost:       order 2: about 330 flops, 1 division, 1 root; order 6: about 980. Sine and cosine by polynomials.
/// Source:     Fasso 2003; composition: Yoshida 1990, solution A of order 6.
template <int order_>
struct SymmetricTopSplitting {
    static_assert(order_ == 2 || order_ == 6, "the splitting comes in orders 2 and 6");
    static constexpr const char* name = order_ == 2 ? "symmetric_top_splitting_2" : "symmetric_top_splitting_6";
    static constexpr int order = order_;  ///< of the error in h
    static constexpr bool as_printed = false, compensates = false, returns_energy = false;
    static int integrate_A(const BodyView& bodies, scalar h, const FlightClock& clock);
};

} }  // namespace ingot

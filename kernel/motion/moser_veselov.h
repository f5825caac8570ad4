// SPDX-License-Identifier: MIT
#pragma once

#include "../body/body_tiles.h"

namespace ingot { inline namespace INGOT_ABI {

/// What the method knows of the steps before this one.
struct FlightClock {
    uint32_t steps;  ///< taken so far; the polar step is due every limits::polar_interval of them
    bool h_changed;  ///< since the last step: energies kept in units of h begin anew
};

/// Turns every body as it would turn freely with the angular momentum of mid-step, L - h/2 tau_T: the preprocessed
/// discrete Moser-Veselov method. With integrate_L before it, the driven step is kick-drift-kick, of second order.
///
/// Order:      6 in float, 10 in double, for free bodies; one path for asymmetric, symmetric, spherical and immovable ones.
/// Keeps:      L bitwise, the energy to rounding (it is returned to the value at the last kick), A A^T = 1 to rounding.
/// Valid for:  |omega| h up to substeps_max * angle_per_substep = 8 rad; faster bodies take 2 to 16 substeps above 0.5 rad,
///             beyond 8 rad the turn is clamped to 8 rad about the same axis. A body whose A would not be finite keeps it
///             and is marked bad.
/// Cost:       about 460 flops and 3 divisions a body and substep, no square root, no trigonometry.
/// Returns:    the number of bodies whose turn was clamped.
/// Source:     McLachlan and Zanna 2005; Hairer and Vilmart 2006; the scaled form and the energy return are ours.
int integrate_A_moser_veselov(const BodyView& bodies, scalar h, const FlightClock& clock);

/// Names the default rotation method: `using rotation = MoserVeselov;`.
struct MoserVeselov {
    static constexpr bool as_printed = false;
    static constexpr bool keeps_flight = true;
    static constexpr const char* name = "moser_veselov";
};

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "../base/limits.h"
#include "../body/body_tiles.h"
#include "flight_clock.h"

namespace ingot { inline namespace INGOT_ABI {

/// See DiscreteMoserVeselov. for_size: the same bits, from a file that microcontrollers compile for size.
template <int order, bool compensate, bool energy_return, bool for_size>
int integrate_A_moser_veselov(const BodyView& bodies, scalar h, const FlightClock& clock, int substeps_max, scalar angle_sq_max);

/// The preprocessed discrete Moser-Veselov method: `using rotation = DiscreteMoserVeselov<4, false>;`. One path for
/// asymmetric, symmetric, spherical and immovable bodies.
///
/// order          2, 4, 6, 8, 10 for free bodies. In float 6 is at the floor from 15 Hz up; 10 in double.
/// compensate     A is summed with the bits it loses: 36 bytes a body in float. Ten times less error over an hour.
/// energy_return  a tiny turn each step takes back the energy's drift since the last kick: 4 bytes a body. The missing digit
///                of float over an hour. h may change from step to step: the energy is remembered all the same.
/// substeps_max   1, 2, 4, 8 or 16. Bodies faster than limits::angle_per_substep a step take 2, 4 ... substeps_max substeps;
///                the worst case of a step grows with it. Beyond substeps_max * angle_per_substep the turn is clamped to
///                that angle about the same axis, and reported. 32 and 64 reach no further than 16, but cut finer: into substeps of
///                1/4 and 1/8 rad at most, for fast spins that have to be right to the last digits.
///
/// Error:      rounding, of the default, while a body turns by no more than 0.2 rad a step: 3e-12 rad in 10 s in double, 2e-5 in float. With the
///             turn of a substep what the series leaves out grows, by its tenth power in double and its sixth in float: 5e-11 rad at
///             1/4 rad, 1e-7 to 8e-7 (float: 2e-3 to 1e-2) at 1/2. With 64 substeps at most it is 1e-11 rad in 30 s up to 8 rad a step (double).
/// Keeps:      L bitwise; the energy of the modified body exactly, so that of the body to rounding, without drift; A A^T = 1
///             to rounding (a polar step every limits::polar_interval steps).
/// Cost:       flops and divisions a body and substep at 4 sweeps of the fixed point: 330 + 4 (order 6, nothing else),
///             and 63 for compensate, 32 + 1 for energy_return, 0 to 160 for the series of other orders.
///             No square root unless clamped, no trigonometry.
/// Source:     McLachlan and Zanna 2005; Hairer and Vilmart 2006. The scaled form and the energy return are ours.
template <int order_ = (INGOT_DOUBLE ? 10 : 6), bool compensate = true, bool energy_return = true,
          int substeps_max = limits::substeps_max>
struct DiscreteMoserVeselov {
    static_assert(order_ == 2 || order_ == 4 || order_ == 6 || order_ == 8 || order_ == 10, "the orders are 2, 4, 6, 8 and 10");
    static_assert(substeps_max >= 1 && substeps_max <= 64 && (substeps_max & (substeps_max - 1)) == 0,
                  "substeps_max is 1, 2, 4, 8, 16, 32 or 64");
    static constexpr const char* name = "moser_veselov";
    static constexpr int order = order_, substeps = substeps_max;  ///< of the error in h
    static constexpr bool as_printed = false;
    static constexpr bool compensates = compensate;
    static constexpr bool returns_energy = energy_return;

    /// rad; of a substep, at most.
    static constexpr scalar angle = limits::angle_per_substep / (substeps_max > limits::substeps_max ? substeps_max / limits::substeps_max : 1);

    static int integrate_A(const BodyView& bodies, scalar h, const FlightClock& clock) {
        return integrate_A_moser_veselov<order_, compensate, energy_return, false>(bodies, h, clock, substeps_max, angle * angle);
    }
    /// The same in a step with contacts, of which to turn is little.
    static int integrate_A_beside_contacts(const BodyView& bodies, scalar h, const FlightClock& clock) {
        constexpr bool for_size = order_ == (INGOT_DOUBLE ? 10 : 6);  // that of the default: moser_veselov_for_size.cpp
        return integrate_A_moser_veselov<order_, compensate, energy_return, for_size>(bodies, h, clock, substeps_max, angle * angle);
    }
};

/// The default rotation method, with all its options.
using MoserVeselov = DiscreteMoserVeselov<>;

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// Does the floating-point unit round as the bits of every result suppose? What can be seen when compiling is refused there
// (config.h); this is about control registers, which start-up code and other libraries set, and about flags of the user's units.
#pragma once

#include "status.h"

namespace ingot { inline namespace INGOT_ABI {

/// The part of check_floating_point() that the kernel was compiled with.
Status check_floating_point_of_kernel();

/// Asks the unit, as it is set now and in this thread. Call it once at start-up, from a unit that steps worlds.
///
/// Errors:  flushes_denormals: numbers below the smallest normal one come out, or are taken in, as zero. Clear FTZ and DAZ of
///          MXCSR (x86), FZ of FPCR or FPSCR (Arm), FS of FCSR (MIPS), DN of FPSCR (SH-4).
///          wrong_rounding: not to nearest, ties to even; or products are not rounded before they are added, because this unit
///          or the kernel was compiled without -ffp-contract=off.
/// Cost:    a few dozen operations. Changes nothing and raises at most the flags underflow and inexact.
INGOT_ALWAYS_INLINE Status check_floating_point() {
    // Always inlined, to be compiled with the flags of the user's unit. Fused, the sum is -epsilon^2; rounded twice it is 0.
    volatile scalar a = 1 + epsilon, minus_a_sq = -(1 + 2 * epsilon);
    const scalar twice_rounded = a * a + minus_a_sq;
    return twice_rounded == 0 ? check_floating_point_of_kernel() : Status::wrong_rounding;
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#pragma once

#include "../body/body_tiles.h"

namespace ingot { inline namespace INGOT_ABI {

/// A += h tilde(omega) A, then A is made orthonormal again, for every body.
///
/// Order:     1. Keeps L; gains energy at every rate (book case, 60 Hz, one minute: 91 %).
/// Valid for: |omega| h < 1, where the columns stay independent; beyond it A stays a rotation, of no meaning.
/// Cost:      108 flops, 2 divisions, 2 square roots a body.
/// Source:    Hecker 1997, Eq. 10 and Listing 1. The baseline that other methods are measured against.
void integrate_A_listing1(const BodyView& bodies, scalar h);

/// Names the explicit Euler step of Listing 1 exactly as printed, for translation too: `using rotation = Listing1Euler;`.
struct Listing1Euler {
    static constexpr bool as_printed = true;    ///< every right-hand side is of step n
    static constexpr bool compensates = false;
    static constexpr bool returns_energy = false;
    static constexpr int order = 1;  ///< of the error in h
    static constexpr const char* name = "listing1_euler";
};

} }  // namespace ingot

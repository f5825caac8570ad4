// SPDX-License-Identifier: MIT
// How much of some impulses a figure may have, by the energy that it would have with shares of them: E(s) = E_0 + D s + Q s^2.
#pragma once

#include "../base/limits.h"
#include "../math/sqrt.h"

namespace ingot { inline namespace INGOT_ABI {

/// J; what there is with all of the impulses, a half and a fourth of them.
struct ThreeEnergies {
    scalar all, half, fourth;

    scalar Q() const { return ((all - half) - 2 * (half - fourth)) * (scalar(8) / 3); }
    scalar D() const { return 2 * (all - half) - Q() * scalar(1.5); }
    /// The share to take. 1: as it is.
    scalar share() const {
        if (!is_finite(all)) return 0;
        const scalar d = D(), q = Q(), without = all - d - q;
        if (!(all > without * (1 + limits::figure_gain_allowed)) || !(q > 0)) return 1;
        return d < 0 ? min(-d / (2 * q), scalar(1)) : scalar(0);
    }
    /// The largest with which it has no more than that, J; where it has with any, that with which it has least.
    scalar share_up_to(scalar most) const {
        if (!is_finite(all)) return 0;
        const scalar d = D(), q = Q(), gain = most - (all - d - q);
        if (!(d + q > gain) || !(q > 0)) return 1;
        return max(min((sqrt(max(d * d + 4 * q * gain, 0)) - d) / (2 * q), scalar(1)), scalar(0));
    }
};

} }  // namespace ingot

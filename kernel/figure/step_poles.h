// SPDX-License-Identifier: MIT
// What swings by hertz and damping ratio, in a substep: see joint_drives.h.
#pragma once

#include "../math/decay_share.h"

namespace ingot { inline namespace INGOT_ABI {

/// 1 - p and 1 + p - s of the poles of a substep, p their product and s their sum. Over twice the time both follow from those before, and nothing
/// cancels.
struct Poles {
    scalar lost, moved;
};
INGOT_INLINE Poles poles_of(scalar phase, scalar damping_ratio) {
    constexpr int doublings = 10;
    const scalar x = phase / (1 << doublings), d = 2 * damping_ratio * x;
    Poles poles = {decay_share(d), (1 - decay_share(d / 2)) * (x * x) * (1 + (d * d - 2 * x * x) / 24)};
    for (int i = 0; i < doublings; ++i) {  // bound: 10: doublings
        poles.moved = poles.moved * (4 - 2 * poles.lost - poles.moved);
        poles.lost = poles.lost * (2 - poles.lost);
    }
    return poles;
}

} }  // namespace ingot

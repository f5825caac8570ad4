// SPDX-License-Identifier: MIT
// What a world keeps of a rod or a rope.
#pragma once

#include "joints.h"

namespace ingot { inline namespace INGOT_ABI {

struct TieRecord {
    scalar length{};  ///< m; 0: of another kind
    scalar reeled{};  ///< m, how long it is at the end of the step: on its way to `length`, where that was changed
    // Of the step at hand.
    scalar begin{};   ///< m, how long it is as it begins
    uint8_t slack{};  ///< 1: a rope that does not come to its end; a gear one of whose joints does nothing

    /// elapsed: s, of a step of h seconds.
    scalar length_at(scalar elapsed, scalar h) const { return begin == reeled ? reeled : begin + (reeled - begin) * (elapsed / h); }
};

} }  // namespace ingot

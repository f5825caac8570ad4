// SPDX-License-Identifier: MIT
// What a world keeps of a gear.
#pragma once

#include "joint_record.h"
#include "limit_record.h"

namespace ingot { inline namespace INGOT_ABI {

/// [0]: of joint A, [1]: of joint B. A JointRecord has beside it a body of each, by which they hang together; its frames are of no meaning.
struct GearRecord {
    Index joint[2]{};      ///< slots of the joints that it couples
    scalar ratio{};        ///< of B's way to A's; 0: of another kind
    scalar begin[2]{};     ///< rad, m: where they were as they were coupled
    AngleRecord value[2]{};  ///< rad, m, and whole turns since: where they were last
};

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// What a world keeps of a joint.
#pragma once

#include "joints.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where a joint is on one of its bodies, in the body's axes; on the world, in the world's.
struct JointFrame {
    Vector anchor{};        ///< m, from the centre of mass
    Vector axis{}, side{};  ///< unit, at right angles
};

struct JointRecord {
    JointFrame frame_A{}, frame_B{};
    Vector j{};             ///< N s, world, that B got in the last substep, scaled to one of Effort::substeps
    Index body_A{}, body_B{};  ///< slots; no_body: the world
    JointKind kind{};       ///< none: nothing is in the slot
    uint8_t resolved{};     ///< 1: the spins of its figure changed little in the last substep
    uint8_t doublings{};    ///< of the substeps that the next step is cut into, for its figure's sake
    uint8_t bodies_meet{};  ///< 1: they may touch each other
};

inline constexpr Index no_body = index_max;
inline constexpr Index no_joint = index_max;

} }  // namespace ingot

// SPDX-License-Identifier: MIT
#include "visit_positions.h"

namespace ingot { inline namespace INGOT_ABI {

void visit_off_centre(const BallView& solver, ContactBlock& block, uint16_t lane_bits, scalar h) {
    (void)visit_positions<1>(solver, block, lane_bits, h, false);
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// Of balls: one row a contact, so to prepare it is little of a step, and on a microcontroller its code is small.
#include "prepare_block.h"

namespace ingot { inline namespace INGOT_ABI {

template void prepare_blocks(const BallView&, const BodyView&);
template void remember_impulses(const BallView&);

} }  // namespace ingot

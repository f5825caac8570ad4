// SPDX-License-Identifier: MIT
#include "level_walk.h"

namespace ingot { inline namespace INGOT_ABI {

LevelTriangle triangle_of(const LevelTable& level, uint32_t number) {
    return level.is_mesh() ? triangle_of_mesh(level, number) : triangle_of_heights(level, number);
}

}}  // namespace ingot::INGOT_ABI

// SPDX-License-Identifier: MIT
// A level with friction and restitution for each of its materials.
#pragma once

#include "level_checksum.h"

namespace ingot { inline namespace INGOT_ABI {

/// A level whose materials are to touch as these are, by their number. They have static storage, as its tables: it points to them.
///
/// Valid:   count 0 .. LevelMaterial::count_max, of a level that has none yet; friction and restitution as in BodyDef; add_level looks.
/// Cost:    no RAM; a body that stands on several materials has a contact with each, up to level_patches.
constexpr LevelTable with_materials(const LevelTable& level, const LevelMaterial* materials, int count) {
    LevelTable made = level;
    made.materials = materials;
    made.material_count = count;
    LevelChecksum sum{level.checksum};
    sum.all_of(materials, count);
    made.checksum = sum.value;
    return made;
}
/// The same, of an array.
template <unsigned N>
constexpr LevelTable with_materials(const LevelTable& level, const LevelMaterial (&materials)[N]) {
    static_assert(N <= LevelMaterial::count_max, "a level has up to 256 materials");
    return with_materials(level, materials, static_cast<int>(N));
}

}}  // namespace ingot::INGOT_ABI

// SPDX-License-Identifier: MIT
#pragma once

#include "../base/config.h"

namespace ingot { inline namespace INGOT_ABI {

/// Whom a body meets: two bodies meet when each is of a category that the other's mask names.
struct BodyFilter {
    uint32_t category{};  ///< bits: what the body is
    uint32_t mask{};    ///< bits: what it meets
};

/// Bodies that say nothing else are of the first category and meet all.
inline constexpr BodyFilter meets_all = {1u, 0xffffffffu};

/// Each is of a category that the other's mask names.
INGOT_INLINE constexpr bool meet(const BodyFilter& A, const BodyFilter& B) {
    return (A.category & B.mask) != 0 && (B.category & A.mask) != 0;
}

/// The filters of all bodies of a scene that has them, asked for by slot; where a body has several shapes, by the slot of a shape.
template <int shapes_of_body = 1>
struct FilterView {
    const BodyFilter* filters;
    const BodyFilter& of(int slot) const { return filters[slot / shapes_of_body]; }
    bool let_meet(int slot_A, int slot_B) const { return meet(of(slot_A), of(slot_B)); }
};

/// The filters of a scene that has none. It answers the same questions, when the scene is compiled.
struct NoFilters {
    static constexpr BodyFilter of(int) { return meets_all; }
    static constexpr bool let_meet(int, int) { return true; }
};

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// Which normals of a manifold are equations.
#pragma once

#include "island_rows.h"

namespace ingot { inline namespace INGOT_ABI {

inline constexpr int normals_max = 3;  ///< of a manifold that are active: points of one plane have no more independent normals

inline bool has(uint8_t bits, int row) { return (bits >> row & 1u) != 0; }
inline void set_bit(uint8_t& bits, int row, bool on) { bits = static_cast<uint8_t>(on ? bits | 1u << row : bits & ~(1u << row)); }

inline int active_normals(const DirectManifold& manifold) {
    int count = 0;
    for (int row = 0; row < manifold.points; ++row) count += has(manifold.active, row) ? 1 : 0;
    return count;
}

/// Takes the least loaded out; what it carried is for the others to carry.
template <bool displaces>
void drop_least(const DirectView& island, DirectManifold& manifold, DirectRow* rows) {
    int least = -1;
    for (int row = 0; row < manifold.points; ++row)
        if (has(manifold.active, row) && (least < 0 || rows[row].j <= rows[least].j)) least = row;
    if (least < 0) return;
    set_bit(manifold.active, least, false);
    give<displaces>(island, manifold, rows[least], -rows[least].j);
}

/// Normals that pull leave, those that approach enter; true if the set changed. `slack` is a speed or a length.
template <bool displaces>
bool change_normals(const DirectView& island, DirectManifold& manifold, DirectRow* rows, double slack) {
    const uint8_t before = manifold.active;
    for (int row = 0; row < manifold.points; ++row) {
        if (!has(manifold.rows, row)) continue;
        if (has(manifold.active, row)) {
            if (has(manifold.pulls, row) || rows[row].j * rows[row].K >= -slack) continue;
            set_bit(manifold.active, row, false);
            give<displaces>(island, manifold, rows[row], -rows[row].j);
        } else if (!has(manifold.pulls, row) && row_motion<displaces>(island, manifold, rows[row]) - rows[row].target < -slack) {
            if (active_normals(manifold) == normals_max) drop_least<displaces>(island, manifold, rows);
            set_bit(manifold.active, row, true);
        }
    }
    return manifold.active != before;
}

} }  // namespace ingot

// SPDX-License-Identifier: MIT
// Which normals of a manifold are equations.
#pragma once

#include "../base/limits.h"
#include "island_rows.h"

namespace ingot { inline namespace INGOT_ABI {

inline constexpr int normals_max = 3;  ///< of a manifold that are active: points of one plane have no more independent normals

inline double larger(double a, double b) { return a > b ? a : b; }
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

/// The load of a manifold of four points spread evenly, along the one change of its normals that moves nothing. A load between four points need not
/// lie between the three that are active: this way it is no reason to change them.
inline void spread_load(const DirectView& island, const DirectManifold& manifold, DirectRow* rows) {
    if ((manifold.rows & 15u) != 15u || manifold.points != block_rows || active_normals(manifold) < normals_max) return;
    const int side = manifold.body[0] != 0 ? 0 : 1;
    const auto corner = [&](int row) { return rows[row].J[side]; };
    const auto area = [&](int a, int b, int c) { return dot(rows[0].d, cross(corner(b) - corner(a), corner(c) - corner(a))); };
    const double shift[block_rows] = {area(1, 2, 3), -area(0, 2, 3), area(0, 1, 3), -area(0, 1, 2)};
    double along = 0, size = 0;
    for (int row = 0; row < block_rows; ++row) {
        along += rows[row].j * shift[row];
        size += shift[row] * shift[row];
    }
    if (!(size > 0)) return;
    double share = -along / size, low = -1e300, high = 1e300;
    for (int row = 0; row < block_rows; ++row) {  // as long as none pulls
        if (shift[row] > 0 && -rows[row].j / shift[row] > low) low = -rows[row].j / shift[row];
        if (shift[row] < 0 && -rows[row].j / shift[row] < high) high = -rows[row].j / shift[row];
    }
    share = share < low ? low : share > high ? high : share;
    for (int row = 0; row < block_rows; ++row) give<false>(island, manifold, rows[row], share * shift[row]);
}

/// An impulse that rounding makes of nothing, where the manifold carries as much as it does.
inline double rounding_of_load(const DirectManifold& manifold, const DirectRow* rows) {
    double N = 0;
    for (int row = 0; row < manifold.points; ++row)
        if (has(manifold.rows, row)) N += larger(rows[row].j, -rows[row].j);
    return limits::direct_roundings * N;
}

/// Normals that pull leave, those that approach enter; true if the set changed. `slack` is a speed or a length.
template <bool displaces>
bool change_normals(const DirectView& island, DirectManifold& manifold, DirectRow* rows, double slack) {
    const uint8_t before = manifold.active;
    if (!displaces) spread_load(island, manifold, rows);
    const double pull = rounding_of_load(manifold, rows);
    for (int row = 0; row < manifold.points; ++row) {
        if (!has(manifold.rows, row)) continue;
        if (has(manifold.active, row)) {
            if (has(manifold.pulls, row) || rows[row].j >= -larger(slack / rows[row].K, pull)) continue;
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

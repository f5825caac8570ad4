// SPDX-License-Identifier: MIT
// Which normals of a manifold are equations.
#pragma once

#include "../../base/limits.h"
#include "island_rows.h"

namespace ingot { inline namespace INGOT_ABI {

inline constexpr int normals_max = 3;  ///< of a manifold that are active: points of one plane have no more independent normals

template <class Bits>
inline void set_bit(Bits& bits, int row, bool on) {
    bits = static_cast<Bits>(on ? bits | 1u << row : bits & ~(1u << row));
}

template <class OfIsland>
inline int active_normals(const OfIsland& manifold) {
    int count = 0;
    // bound: 4: block_rows
    for (int row = 0; row < manifold.points; ++row) count += has(manifold.active, row) ? 1 : 0;
    return count;
}

/// Takes the least loaded out; what it carried is for the others to carry.
template <bool displaces, class Direct>
void drop_least(const Direct& island, ManifoldOf<Direct>& manifold, DirectRow* rows) {
    int least = -1;
    for (int row = 0; row < manifold.points; ++row)
        if (has(manifold.active, row) && (least < 0 || rows[row].j <= rows[least].j)) least = row;
    if (least < 0) return;
    set_bit(manifold.active, least, false);
    give<displaces>(island, manifold, rows[least], -rows[least].j);
}

/// The one change of four normals that moves nothing: impulses in proportion to it cancel. False: there are not four points, or no three are active.
struct IdleChange {
    wide_scalar at[block_rows];
};
template <class OfIsland>
inline bool idle_change(const OfIsland& manifold, const DirectRow* rows, IdleChange& idle) {
    if (manifold.points != block_rows || (manifold.rows & 15u) != 15u || active_normals(manifold) < normals_max) return false;
    const int side = manifold.body[0] != 0 ? 0 : 1;
    const auto area = [&](int a, int b, int c) {  // of a triangle, twice; J = r x n lies as r does, turned by a right angle
        return dot(rows[0].d, cross(rows[b].J[side] - rows[a].J[side], rows[c].J[side] - rows[a].J[side]));
    };
    idle = {{area(1, 2, 3), -area(0, 2, 3), area(0, 1, 3), -area(0, 1, 2)}};
    return true;
}

/// Spreads the load of four points as evenly as it can without one of them pulling. A load between four points need not lie between the three that
/// are active; spread so, it is no reason to change the set. The fourth then has an impulse and no equation: its impulse follows from the others.
template <class Direct>
inline void spread_load(const Direct& island, const ManifoldOf<Direct>& manifold, DirectRow* rows) {
    IdleChange idle;
    if (!idle_change(manifold, rows, idle)) return;
    wide_scalar along = 0, size = 0, low = -1e300, high = 1e300;
    for (int row = 0; row < block_rows; ++row) {
        along += rows[row].j * idle.at[row];
        size += idle.at[row] * idle.at[row];
        if (idle.at[row] > 0) low = max(low, -rows[row].j / idle.at[row]);
        if (idle.at[row] < 0) high = -max(-high, rows[row].j / idle.at[row]);
    }
    if (!(size > 0)) return;
    const wide_scalar even = -along / size, share = even < low ? low : even > high ? high : even;
    for (int row = 0; row < block_rows; ++row) give<false>(island, manifold, rows[row], share * idle.at[row]);
}

/// Takes the load back from the point that is no equation, before the set changes.
template <class Direct>
inline void gather_load(const Direct& island, const ManifoldOf<Direct>& manifold, DirectRow* rows) {
    IdleChange idle;
    if (!idle_change(manifold, rows, idle)) return;
    for (int row = 0; row < block_rows; ++row) {
        if (has(manifold.active, row) || idle.at[row] == 0) continue;
        const wide_scalar share = -rows[row].j / idle.at[row];
        for (int other = 0; other < block_rows; ++other) give<false>(island, manifold, rows[other], share * idle.at[other]);
        rows[row].j = 0;
    }
}

/// What normals push and pull.
template <class OfIsland>
inline wide_scalar size_of_load(const OfIsland& manifold, const DirectRow* rows) {
    wide_scalar N = 0;
    for (int row = 0; row < manifold.points; ++row)
        if (has(manifold.rows, row)) N += max(rows[row].j, -rows[row].j);
    return N;
}

template <class OfIsland>
inline bool pulls_back(const OfIsland& manifold, const DirectRow* rows, int row, wide_scalar slack, wide_scalar pull) {
    return !has(manifold.pulls, row) && rows[row].j < -max(slack / rows[row].K, pull);
}
template <class OfIsland>
inline bool some_pull(const OfIsland& manifold, const DirectRow* rows, wide_scalar slack, wide_scalar pull) {
    bool some = false;
    for (int row = 0; row < manifold.points; ++row)
        some = some || (has(manifold.rows, row) && pulls_back(manifold, rows, row, slack, pull));
    return some;
}

/// Normals that pull leave, those that approach enter; true if the set changed. `slack` is a speed or a length.
template <bool displaces, class Direct>
bool change_normals(const Direct& island, ManifoldOf<Direct>& manifold, DirectRow* rows, wide_scalar slack) {
    const auto before = manifold.active;
    if (!displaces) spread_load(island, manifold, rows);
    // An impulse that rounding makes of nothing, and one whose speed is nothing: where the manifold carries as much as it does.
    const wide_scalar N = size_of_load(manifold, rows), pull = limits::direct_roundings * N, grain = 4 * limits::direct_grain * N;
    if (!displaces && some_pull(manifold, rows, slack, pull)) gather_load(island, manifold, rows);
    for (int row = 0; row < manifold.points; ++row) {
        if (!has(manifold.rows, row)) continue;
        if (has(manifold.active, row)) {
            if (!pulls_back(manifold, rows, row, slack, pull)) continue;
            set_bit(manifold.active, row, false);
            give<displaces>(island, manifold, rows[row], -rows[row].j);
        } else if (!has(manifold.pulls, row) &&
                   row_motion<displaces>(island, manifold, rows[row]) - rows[row].target < -slack - grain * rows[row].K) {
            if (active_normals(manifold) == normals_max) drop_least<displaces>(island, manifold, rows);
            set_bit(manifold.active, row, true);
        }
    }
    return manifold.active != before;
}

} }  // namespace ingot

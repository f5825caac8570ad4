// SPDX-License-Identifier: MIT
#include "factor_rows.h"

#include "../base/limits.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// The speed along row i of manifold m that a unit impulse along row c of manifold p gives.
double coupling(const DirectView& island, const DirectManifold& m, const DirectManifold& p, const DirectRow& i, const DirectRow& c) {
    double sum = 0;
    for (int side = 0; side < 2; ++side) {
        if (m.body[side] == 0) continue;
        for (int other = 0; other < 2; ++other) {
            if (m.body[side] != p.body[other]) continue;
            const double linear = dot(i.d, c.d) * island.bodies[m.body[side]].inv_M;
            sum += (side == other ? linear : -linear) + dot(i.k[side], c.J[other]);
        }
    }
    return sum;
}

/// Lists active rows and where their entries begin; false: no room.
bool list_rows(DirectView& island) {
    int count = 0;
    uint32_t entry_count = 0;
    for (int manifold_i = 0; manifold_i < island.manifold_count; ++manifold_i) {
        DirectManifold& manifold = island.manifolds[manifold_i];
        manifold.factored = manifold.active;
        manifold.active_begin = static_cast<uint16_t>(count);
        const int begin = island.manifolds[manifold.first].active_begin;
        for (int row = 0; row < direct_rows; ++row) {
            if ((manifold.active >> row & 1u) == 0) continue;
            DirectActive& active = island.active[count];
            active.row = static_cast<uint16_t>(manifold_i * direct_rows + row);
            active.begin = static_cast<uint16_t>(begin);
            active.offset = entry_count;
            entry_count += static_cast<uint32_t>(count - begin);
            if (entry_count > static_cast<uint32_t>(island.entry_capacity)) return false;
            ++count;
        }
    }
    island.active_count = count;
    return true;
}

/// sum over k of a_k b_k, in four sums: a chain of additions would wait for each.
double sum_of_products(const double* a, const double* b, int count) {
    double sums[4] = {};
    int i = 0;
    for (; i + 4 <= count; i += 4)
        for (int k = 0; k < 4; ++k) sums[k] += a[i + k] * b[i + k];
    for (; i < count; ++i) sums[0] += a[i] * b[i];
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// The matrix of the same rows, within the step, is the same.
bool is_factored(const DirectView& island) {
    bool same = island.factored;
    for (int manifold_i = 0; manifold_i < island.manifold_count && same; ++manifold_i)
        same = island.manifolds[manifold_i].active == island.manifolds[manifold_i].factored;
    return same;
}

}  // namespace

bool factor_rows(DirectView& island) {
    if (is_factored(island)) return true;
    island.factored = list_rows(island);
    if (!island.factored) return false;
    for (int i = 0; i < island.active_count; ++i) {
        DirectActive& active = island.active[i];
        const DirectRow& row = island.rows[active.row];
        const DirectManifold& manifold = island.manifolds[active.row / direct_rows];
        double* const u = island.entries + active.offset;  // u[c - begin]
        for (int c = active.begin; c < i; ++c) {
            const DirectActive& before = island.active[c];
            const DirectManifold& other = island.manifolds[before.row / direct_rows];
            const int first = active.begin > before.begin ? active.begin : before.begin;
            const double known = sum_of_products(u + (first - active.begin), island.entries + before.offset + (first - before.begin), c - first);
            u[c - active.begin] = coupling(island, manifold, other, row, island.rows[before.row]) - known;
        }
        double pivot = row.K * (1 + limits::direct_diagonal);
        for (int c = active.begin; c < i; ++c) {
            const double scaled = u[c - active.begin] * island.active[c].inv_pivot;
            pivot -= scaled * u[c - active.begin];
            u[c - active.begin] = scaled;
        }
        active.inv_pivot = pivot > row.K * limits::direct_diagonal / 2 ? 1 / pivot : 0;
    }
    return true;
}

void solve_factored(const DirectView& island) {
    for (int i = 0; i < island.active_count; ++i) {
        DirectActive& active = island.active[i];
        const double* const l = island.entries + active.offset;
        for (int c = active.begin; c < i; ++c) active.x -= l[c - active.begin] * island.active[c].x;
    }
    for (int i = 0; i < island.active_count; ++i) island.active[i].x *= island.active[i].inv_pivot;
    for (int i = island.active_count - 1; i > 0; --i) {
        const DirectActive& active = island.active[i];
        const double* const l = island.entries + active.offset;
        for (int c = active.begin; c < i; ++c) island.active[c].x -= l[c - active.begin] * active.x;
    }
}

} }  // namespace ingot
